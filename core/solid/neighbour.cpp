#include "osculate/solid/neighbour.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "osculate/bezier/index.h"
#include "osculate/construction/contact_error.h"
#include "osculate/solid/every_row.h"

namespace osculate {

namespace {

void checkArguments(const BezierTetrahedron& solid, int face, const Barycentric<4>& apex, int order,
                    const NeighbourOptions& options) {
  if (face < 0 || face > 3) {
    throw std::invalid_argument("face: must be 0 to 3, the number of the opposite corner, got " +
                                std::to_string(face));
  }
  if (!apex.allFinite() || std::abs(apex.sum() - 1.0) > 1e-9) {
    throw std::invalid_argument("apex: barycentric coordinates must be finite with the sum 1");
  }
  if (!(apex[face] < 0.0)) {
    throw std::invalid_argument(
        "apex: must lie beyond the face, with a negative coordinate at corner " +
        std::to_string(face) + ", got " + std::to_string(apex[face]));
  }
  if (order < 0 || order > solid.degree()) {
    throw std::invalid_argument("order: must be 0 to the degree " + std::to_string(solid.degree()) +
                                ", got " + std::to_string(order));
  }
  if (options.apexPoint &&
      (options.apexPoint->size() != solid.dimension() || !options.apexPoint->allFinite())) {
    throw std::invalid_argument("apexPoint: needs " + std::to_string(solid.dimension()) +
                                " finite coordinates");
  }
}

/// A quadratic energy of values at the points of a net: sums of squares of stencils.
class NetEnergy {
 public:
  explicit NetEnergy(Eigen::Index size) : matrix_(Eigen::MatrixXd::Zero(size, size)) {}

  void add(const std::vector<std::pair<int, double>>& stencil) {
    for (const auto& [i, a] : stencil) {
      for (const auto& [j, b] : stencil)
        matrix_(i, j) += a * b;
    }
  }

  /// Fills the unknown columns of the values so that the energy is least.
  void minimize(Eigen::MatrixXd& values, const std::vector<int>& unknown,
                const std::vector<int>& known) const {
    if (unknown.empty()) return;
    const Eigen::MatrixXd knownValues = values(everyRow(values), known);
    const Eigen::MatrixXd across = matrix_(unknown, known);
    const Eigen::MatrixXd right = -across * knownValues.transpose();
    const Eigen::MatrixXd solved = matrix_(unknown, unknown).ldlt().solve(right);
    values(everyRow(values), unknown) = solved.transpose();
  }

 private:
  Eigen::MatrixXd matrix_;
};

/// Differences of neighbours in the net: the discrete membrane, whose minimum lies between the
/// known values.
NetEnergy membrane(int degree) {
  NetEnergy energy(netSize<4>(degree));
  for (const MultiIndex<4>& j : multiIndices<4>(degree - 1)) {
    for (int p = 0; p < 4; ++p) {
      for (int q = p + 1; q < 4; ++q)
        energy.add({{netIndex<4>(shifted<4>(j, p)), 1.0}, {netIndex<4>(shifted<4>(j, q)), -1.0}});
    }
  }
  return energy;
}

/// Second differences along the six edges, which determine every second difference.
NetEnergy thinPlate(int degree) {
  NetEnergy energy(netSize<4>(degree));
  if (degree < 2) return energy;
  for (const MultiIndex<4>& j : multiIndices<4>(degree - 2)) {
    for (int p = 0; p < 4; ++p) {
      for (int q = p + 1; q < 4; ++q) {
        energy.add({{netIndex<4>(shifted<4>(j, p, 2)), 1.0},
                    {netIndex<4>(shifted<4>(shifted<4>(j, p), q)), -2.0},
                    {netIndex<4>(shifted<4>(j, q, 2)), 1.0}});
      }
    }
  }
  return energy;
}

struct Layers {
  std::vector<int> forced;
  std::vector<int> free;
};

Layers layersOf(int degree, int face, int order) {
  Layers layers;
  int position = 0;
  for (const MultiIndex<4>& i : multiIndices<4>(degree))
    (i[index(face)] <= order ? layers.forced : layers.free).push_back(position++);
  return layers;
}

/// Cartesian points and weights of the forced columns.
void split(const SimplexNet& net, int dimension, const std::vector<int>& forced,
           Eigen::MatrixXd& points, Eigen::MatrixXd& weights) {
  for (const int i : forced) {
    const double weight = net(dimension, i);
    if (!(weight > 0.0)) {
      throw ContactError(
          "apex: this contact forces a weight of " + std::to_string(weight) +
          " on the neighbour, and a solid has weights >= 0; choose the apex nearer to the face, a "
          "lower order, or raise the degree");
    }
    points.col(i) = net.col(i).head(dimension) / weight;
    weights(0, i) = weight;
  }
}

/// Where the corners of the solid send the new one: an affine map of the domain.
SpacePoint apexFromCorners(const BezierTetrahedron& solid, const Barycentric<4>& apex) {
  SpacePoint sum = SpacePoint::Zero(solid.dimension());
  for (int c = 0; c < 4; ++c) {
    MultiIndex<4> corner{};
    corner[index(c)] = solid.degree();
    sum += apex[c] * solid.point(corner);
  }
  return sum;
}

void fillPoints(const BezierTetrahedron& solid, int face, const Barycentric<4>& apex, int order,
                const NeighbourOptions& options, Layers layers, Eigen::MatrixXd& points) {
  const int degree = solid.degree();
  if (order < degree && (options.apexPoint || order == 0)) {
    MultiIndex<4> corner{};
    corner[index(face)] = degree;
    const int position = netIndex<4>(corner);
    points.col(position) = options.apexPoint.value_or(apexFromCorners(solid, apex));
    layers.forced.push_back(position);
    std::erase(layers.free, position);
  }
  thinPlate(degree).minimize(points, layers.free, layers.forced);
}

}  // namespace

SimplexNet forcedLayers(const SimplexNet& net, int degree, int face, const Barycentric<4>& apex,
                        int order) {
  SimplexNet result =
      SimplexNet::Constant(net.rows(), net.cols(), std::numeric_limits<double>::quiet_NaN());
  SimplexNet reduced = net;
  for (int r = 0; r <= order; ++r) {
    if (r > 0) reduceNet<4>(reduced, degree - r + 1, apex);
    Eigen::Index position = 0;
    for (MultiIndex<4> i : multiIndices<4>(degree - r)) {
      const Eigen::Index from = position++;
      if (i[index(face)] != 0) continue;
      i[index(face)] = r;
      result.col(netIndex<4>(i)) = reduced.col(from);
    }
  }
  return result;
}

BezierTetrahedron neighbour(const BezierTetrahedron& solid, int face, const Barycentric<4>& apex,
                            int order, const NeighbourOptions& options) {
  checkArguments(solid, face, apex, order, options);
  const int degree = solid.degree();
  const int dimension = solid.dimension();
  const SimplexNet forced = forcedLayers(solid.homogeneousWithWeights(), degree, face, apex, order);
  const Layers layers = layersOf(degree, face, order);
  Eigen::MatrixXd points(dimension, solid.size());
  Eigen::MatrixXd weights = Eigen::MatrixXd::Ones(1, solid.size());
  if (solid.isRational()) {
    split(forced, dimension, layers.forced, points, weights);
    membrane(degree).minimize(weights, layers.free, layers.forced);
  } else {
    const Eigen::MatrixXd all = forced.topRows(dimension);
    points(everyRow(points), layers.forced) = all(everyRow(all), layers.forced);
  }
  fillPoints(solid, face, apex, order, options, layers, points);
  if (!solid.isRational()) return BezierTetrahedron(degree, points);
  return BezierTetrahedron(degree, points, {weights.data(), weights.data() + weights.size()});
}

std::vector<BezierTetrahedron> chain(const BezierTetrahedron& solid,
                                     std::span<const ChainLink> links) {
  std::vector<BezierTetrahedron> solids{solid};
  for (const ChainLink& link : links)
    solids.push_back(neighbour(solids.back(), link.face, link.apex, link.order, link.options));
  return solids;
}

}  // namespace osculate
