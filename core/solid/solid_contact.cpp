#include "osculate/solid/solid_contact.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "osculate/bezier/index.h"
#include "osculate/solid/neighbour.h"

namespace osculate {

namespace {

constexpr int kMaxLattice = 48;

/// The second solid laid on the first: same corners on the face, its free corner in place of
/// `face`.
struct Pair {
  BezierTetrahedron first;
  BezierTetrahedron second;
  int face;
};

/// The three directions that span the domain: to the corner opposite to the face from the middle of
/// the face, and along two edges of the face.
Eigen::Matrix<double, 4, 3> directionsOf(int face, const Barycentric<4>& middle) {
  const int p = (face + 1) % 4;
  const int q = (face + 2) % 4;
  const int s = (face + 3) % 4;
  Eigen::Matrix<double, 4, 3> directions;
  directions.col(0) = Barycentric<4>::Unit(face) - middle;
  directions.col(1) = Barycentric<4>::Unit(p) - Barycentric<4>::Unit(q);
  directions.col(2) = Barycentric<4>::Unit(p) - Barycentric<4>::Unit(s);
  return directions;
}

Barycentric<4> middleOf(int face) {
  return (Barycentric<4>::Ones() - Barycentric<4>::Unit(face)) / 3.0;
}

/// Layer r of a homogeneous net at one corner.
SimplexNet layer(const SimplexNet& net, int degree, int face, int r) {
  SimplexNet result(net.rows(), netSize<3>(degree - r));
  Eigen::Index position = 0;
  Eigen::Index to = 0;
  for (const MultiIndex<4>& i : multiIndices<4>(degree)) {
    if (i[index(face)] == r) result.col(to++) = net.col(position);
    ++position;
  }
  return result;
}

/// Homogeneous points moved so that the face's middle is the origin, the weight as a length.
SimplexNet centred(const BezierTetrahedron& solid, const SpacePoint& centre, double size) {
  SimplexNet net = solid.homogeneousWithWeights();
  const Eigen::Index d = solid.dimension();
  net.topRows(d) -= centre * net.row(d);
  net.row(d) *= size;
  return net;
}

double sizeOf(const BezierTetrahedron& solid) {
  const auto [low, high] = solid.box();
  return std::max((high - low).norm(), 1e-300);
}

double growthOf(const Barycentric<4>& apex) { return std::max(1.0, apex.cwiseAbs().sum()); }

void countOrders(ContactOrders& orders, double tolerance) {
  double allowed = tolerance;
  orders.order = -1;
  for (const double residual : orders.residualsMm) {
    if (!(residual <= allowed)) return;
    ++orders.order;
    allowed *= growthOf(orders.apex);
  }
}

/// Theorem 1.5.1 on homogeneous nets.
ContactOrders homogeneousContact(const Pair& pair, int maxOrder,
                                 const SolidContactOptions& options) {
  const int n = pair.first.degree();
  const double size = sizeOf(pair.first);
  const SpacePoint centre = pair.first.evaluate(middleOf(pair.face));
  const SimplexNet a = centred(pair.first, centre, size);
  SimplexNet b = centred(pair.second, centre, size);
  const double meanWeight = a.row(a.rows() - 1).mean() / size;
  const SimplexNet a0 = layer(a, n, pair.face, 0);
  const SimplexNet b0 = layer(b, n, pair.face, 0);
  b *= a0.cwiseProduct(b0).sum() / b0.squaredNorm();
  ContactOrders result;
  result.apex = options.apex.value_or(Barycentric<4>::Zero());
  if (!options.apex) {
    // layer 1 is linear in the apex: V^1_(0,j,k,l)(middle + directions x)
    const auto directions = directionsOf(pair.face, middleOf(pair.face));
    const auto layerAt = [&](const Barycentric<4>& at) {
      const SimplexNet net = layer(forcedLayers(a, n, pair.face, at, 1), n, pair.face, 1);
      return Eigen::VectorXd(net.reshaped());
    };
    Eigen::MatrixXd matrix(a.rows() * netSize<3>(n - 1), 3);
    for (int k = 0; k < 3; ++k)
      matrix.col(k) = layerAt(directions.col(k));
    const Eigen::VectorXd wanted =
        Eigen::VectorXd(layer(b, n, pair.face, 1).reshaped()) - layerAt(middleOf(pair.face));
    result.apex =
        middleOf(pair.face) + directions * matrix.completeOrthogonalDecomposition().solve(wanted);
  }
  const SimplexNet forced = forcedLayers(a, n, pair.face, result.apex, maxOrder);
  for (int r = 0; r <= maxOrder; ++r) {
    const SimplexNet difference = layer(b, n, pair.face, r) - layer(forced, n, pair.face, r);
    result.residualsMm.push_back(difference.colwise().norm().maxCoeff() / meanWeight);
  }
  return result;
}

/// Derivatives 0 .. count along one direction, all by one quotient of series.
std::vector<SpacePoint> alongDirection(const BezierTetrahedron& solid, const SimplexNet& net,
                                       const Barycentric<4>& u, const Barycentric<4>& direction,
                                       int count) {
  const int n = solid.degree();
  const Eigen::Index d = solid.dimension();
  std::vector<SpacePoint> homogeneous;
  SimplexNet derivative = net;
  double factor = 1.0;
  for (int k = 0; k <= std::min(count, n); ++k) {
    if (k > 0) {
      factor *= n - k + 1;
      reduceNet<4>(derivative, n - k + 1, direction);
    }
    SimplexNet at = derivative;
    for (int rest = n - k; rest > 0; --rest)
      reduceNet<4>(at, rest, u);
    homogeneous.emplace_back(factor * at.col(0));
  }
  std::vector<SpacePoint> result;
  for (int k = 0; k <= count; ++k) {
    SpacePoint sum =
        k <= n ? SpacePoint(homogeneous[index(k)].head(d)) : SpacePoint(SpacePoint::Zero(d));
    double choose = 1.0;
    for (int j = 1; j <= std::min(k, n); ++j) {
      choose = choose * (k - j + 1) / j;
      sum -= choose * homogeneous[index(j)][d] * result[index(k - j)];
    }
    result.emplace_back(sum / homogeneous[0][d]);
  }
  return result;
}

/// The points of the face's lattice where both solids have a point.
std::vector<Barycentric<4>> latticeOf(const Pair& pair, int m) {
  std::vector<Barycentric<4>> points;
  for (const MultiIndex<3>& i : multiIndices<3>(m)) {
    Barycentric<4> u = Barycentric<4>::Zero();
    for (int c = 0, next = 0; c < 4; ++c) {
      if (c != pair.face) u[c] = static_cast<double>(i[index(next++)]) / m;
    }
    if (pair.first.evaluate(u).allFinite() && pair.second.evaluate(u).allFinite())
      points.push_back(u);
  }
  return points;
}

Barycentric<4> fittedApex(const Pair& pair, const std::vector<Barycentric<4>>& lattice) {
  const auto directions = directionsOf(pair.face, middleOf(pair.face));
  const SimplexNet netA = pair.first.homogeneousWithWeights();
  const SimplexNet netB = pair.second.homogeneousWithWeights();
  const Eigen::Index d = pair.first.dimension();
  Eigen::MatrixXd matrix(d * static_cast<Eigen::Index>(lattice.size()), 3);
  Eigen::VectorXd wanted(matrix.rows());
  Eigen::Index row = 0;
  for (const Barycentric<4>& u : lattice) {
    for (int k = 0; k < 3; ++k)
      matrix.block(row, k, d, 1) = alongDirection(pair.first, netA, u, directions.col(k), 1)[1];
    wanted.segment(row, d) = alongDirection(pair.second, netB, u, directions.col(0), 1)[1];
    row += d;
  }
  return middleOf(pair.face) + directions * matrix.completeOrthogonalDecomposition().solve(wanted);
}

/// Derivatives across the face along the direction from its middle to the second solid's corner.
ContactOrders cartesianContact(const Pair& pair, int maxOrder, const SolidContactOptions& options) {
  const int n = pair.first.degree();
  const std::vector<Barycentric<4>> lattice =
      latticeOf(pair, std::min(kMaxLattice, 2 * n * (maxOrder + 1)));
  ContactOrders result;
  result.apex = options.apex ? *options.apex : fittedApex(pair, lattice);
  result.residualsMm.assign(index(maxOrder + 1), 0.0);
  const Barycentric<4> middle = middleOf(pair.face);
  const SimplexNet netA = pair.first.homogeneousWithWeights();
  const SimplexNet netB = pair.second.homogeneousWithWeights();
  for (const Barycentric<4>& u : lattice) {
    const auto a = alongDirection(pair.first, netA, u, result.apex - middle, maxOrder);
    const auto b =
        alongDirection(pair.second, netB, u, Barycentric<4>::Unit(pair.face) - middle, maxOrder);
    double factor = 1.0;  // (n-r)!/n!: a derivative as a difference of control points
    for (int r = 0; r <= maxOrder; ++r) {
      result.residualsMm[index(r)] =
          std::max(result.residualsMm[index(r)], factor * (a[index(r)] - b[index(r)]).norm());
      factor /= std::max(1, n - r);
    }
  }
  return result;
}

/// The largest distance of points of the two faces with the same coordinates.
double gapOf(const Pair& pair) {
  double gap = 0.0;
  for (const Barycentric<4>& u : latticeOf(pair, 2 * pair.first.degree()))
    gap = std::max(gap, (pair.first.evaluate(u) - pair.second.evaluate(u)).norm());
  return gap;
}

std::vector<FaceMatch> allMatches() {
  std::vector<FaceMatch> matches;
  MultiIndex<4> order{0, 1, 2, 3};
  do {
    for (int face = 0; face < 4; ++face)
      matches.push_back({face, order[index(face)], order});
  } while (std::next_permutation(order.begin(), order.end()));
  return matches;
}

/// How far the corners of the two faces are apart, at most.
double cornerGap(const BezierTetrahedron& first, const BezierTetrahedron& second,
                 const FaceMatch& match) {
  double gap = 0.0;
  for (int c = 0; c < 4; ++c) {
    if (c == match.first) continue;
    MultiIndex<4> a{};
    MultiIndex<4> b{};
    a[index(c)] = first.degree();
    b[index(match.corners[index(c)])] = second.degree();
    gap = std::max(gap, (first.point(a) - second.point(b)).norm());
  }
  return gap;
}

SolidContact contactOf(const Pair& pair, const FaceMatch& match, double gap,
                       const SolidContactOptions& options) {
  SolidContact result;
  result.faces = match;
  result.gapMm = gap;
  result.degree = pair.first.degree();
  result.meets = gap <= options.toleranceMm;
  if (!result.meets) return result;
  const int maxOrder = std::min(options.maxOrder, result.degree);
  result.homogeneous = homogeneousContact(pair, maxOrder, options);
  countOrders(result.homogeneous, options.toleranceMm);
  const bool polynomial = !pair.first.isRational() && !pair.second.isRational();
  result.cartesian = polynomial ? result.homogeneous : cartesianContact(pair, maxOrder, options);
  countOrders(result.cartesian, options.toleranceMm);
  result.overlaps = result.cartesian.apex[match.first] > 0.0;
  return result;
}

bool isBetter(const SolidContact& a, const SolidContact& b) {
  if (a.meets != b.meets) return a.meets;
  if (a.cartesian.order != b.cartesian.order) return a.cartesian.order > b.cartesian.order;
  if (a.homogeneous.order != b.homogeneous.order) return a.homogeneous.order > b.homogeneous.order;
  return a.gapMm < b.gapMm;
}

void checkOptions(const BezierTetrahedron& first, const BezierTetrahedron& second,
                  const SolidContactOptions& options) {
  if (first.dimension() != second.dimension()) {
    throw std::invalid_argument("contact: one solid is in E3, the other in E4");
  }
  if (!(std::isfinite(options.toleranceMm) && options.toleranceMm > 0.0)) {
    throw std::invalid_argument("tolerance: must be finite and > 0");
  }
  if (options.maxOrder < 0) throw std::invalid_argument("order: must be >= 0");
}

}  // namespace

SolidContact contact(const BezierTetrahedron& first, const BezierTetrahedron& second,
                     const SolidContactOptions& options) {
  checkOptions(first, second, options);
  const int degree = std::max(first.degree(), second.degree());
  const BezierTetrahedron a = first.elevated(degree - first.degree());
  const BezierTetrahedron b = second.elevated(degree - second.degree());
  std::optional<SolidContact> best;
  double nearestCorners = std::numeric_limits<double>::infinity();
  for (const FaceMatch& match : allMatches()) {
    const double corners = cornerGap(a, b, match);
    // corners further apart than those of a pair already seen cannot give a better one
    if (corners > std::max(options.toleranceMm, nearestCorners)) continue;
    nearestCorners = corners;
    const Pair pair{a, b.relabelled(match.corners), match.first};
    const SolidContact found = contactOf(pair, match, gapOf(pair), options);
    if (!best || isBetter(found, *best)) best = found;
  }
  return *best;
}

}  // namespace osculate
