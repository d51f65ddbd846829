#include "osculate/solid/primitives.h"

#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string>

namespace osculate {

namespace {

/// Corner 1 and corner 2 exchanged.
constexpr MultiIndex<4> kMirror{0, 2, 1, 3};

void checkPositive(double value, const char* name) {
  if (!(std::isfinite(value) && value > 0.0)) {
    throw std::invalid_argument(std::string(name) + ": must be finite and > 0, got " +
                                std::to_string(value));
  }
}

void checkFinitePoint(const Vector3& point, const char* name) {
  if (!point.allFinite())
    throw std::invalid_argument(std::string(name) + ": coordinates must be finite");
}

double orientation(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d) {
  return (b - a).cross(c - a).dot(d - a);
}

/// A net under construction in homogeneous coordinates.
template <int Corners>
class NetBuilder {
 public:
  explicit NetBuilder(int degree) : degree_(degree), net_(4, netSize<Corners>(degree)) {}
  void set(const MultiIndex<Corners>& index, const Vector3& point, double weight) {
    net_.col(netIndex<Corners>(index)) << weight * point, weight;
  }
  BezierSimplex<Corners> build() const {
    return BezierSimplex<Corners>::fromHomogeneous(degree_, 3, net_);
  }

 private:
  int degree_;
  SimplexNet net_;
};

}  // namespace

BezierTetrahedron linearTetrahedron(const Vector3& a, const Vector3& b, const Vector3& c,
                                    const Vector3& d) {
  Eigen::MatrixXd points(3, 4);
  points << a, b, c, d;
  if (points.allFinite()) {
    const double size = (points.colwise() - Eigen::VectorXd(a)).colwise().norm().maxCoeff();
    if (!(std::abs(orientation(a, b, c, d)) > 1e-14 * size * size * size)) {
      throw std::invalid_argument("tetrahedron: the corners lie in one plane");
    }
  }
  return BezierTetrahedron(1, points);
}

BezierTetrahedron ellipticCone(double radiusX, double radiusY, const Vector3& apex) {
  checkPositive(radiusX, "radius");
  checkPositive(radiusY, "radius");
  checkFinitePoint(apex, "apex");
  if (apex.z() == 0.0)
    throw std::invalid_argument("apex: must lie off the plane z = 0 of the base (height 0)");
  const double half = std::sqrt(3.0) / 2.0;
  const Vector3 a(radiusX, 0.0, 0.0);
  const Vector3 b(-0.5 * radiusX, half * radiusY, 0.0);
  const Vector3 c(-0.5 * radiusX, -half * radiusY, 0.0);
  NetBuilder<4> net(2);
  net.set({2, 0, 0, 0}, a, 1.0);
  net.set({0, 2, 0, 0}, b, 1.0);
  net.set({0, 0, 2, 0}, c, 1.0);
  net.set({1, 1, 0, 0}, -2.0 * c, 0.5);
  net.set({0, 1, 1, 0}, -2.0 * a, 0.5);
  net.set({1, 0, 1, 0}, -2.0 * b, 0.5);
  for (const MultiIndex<4>& index :
       {MultiIndex<4>{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}, {0, 0, 0, 2}})
    net.set(index, apex, 1.0);
  return apex.z() > 0.0 ? net.build() : net.build().relabelled(kMirror);
}

BezierTetrahedron cone(double radius, double height) {
  if (!std::isfinite(height) || height == 0.0) {
    throw std::invalid_argument("height: must be finite and not 0, got " + std::to_string(height));
  }
  return ellipticCone(radius, radius, {0.0, 0.0, height});
}

BezierTetrahedron wedgeOver(const BezierTriangle& base, const Vector3& apex) {
  checkFinitePoint(apex, "apex");
  if (base.dimension() != 3) throw std::invalid_argument("base: must be a surface in E3");
  const int n = base.degree();
  NetBuilder<4> net(n);
  for (const MultiIndex<4>& i : multiIndices<4>(n)) {
    const MultiIndex<3> onBase{i[0], i[1], i[2]};
    if (i[3] == 0) {
      net.set(i, base.point(onBase), base.weight(onBase));
    } else {
      net.set(i, apex, 1.0);
    }
  }
  return net.build();
}

namespace {

/// A sector of the disc: corner 0 at the axis, the arc from angle a to angle b opposite.
SimplexNet sector(double radius, double z, double a, double b) {
  const double middle = 0.5 * (a + b);
  const double weight = std::cos(0.5 * (b - a));
  const auto at = [&](double r, double angle) {
    return Vector3(r * std::cos(angle), r * std::sin(angle), z);
  };
  SimplexNet net(4, 6);
  const auto set = [&](const MultiIndex<3>& index, const Vector3& point, double w) {
    net.col(netIndex<3>(index)) << w * point, w;
  };
  set({2, 0, 0}, at(0.0, a), 1.0);
  set({1, 1, 0}, at(0.5 * radius, a), 1.0);
  set({1, 0, 1}, at(0.5 * radius, b), 1.0);
  set({0, 2, 0}, at(radius, a), 1.0);
  set({0, 1, 1}, at(radius / weight, middle), weight);
  set({0, 0, 2}, at(radius, b), 1.0);
  return net;
}

/// A point of the prism (triangle) x [0, 1].
struct PrismPoint {
  Barycentric<3> onTriangle;
  double height;
};

/// Part of the prism (1-s) lower(p) + s upper(p), of degree 2 in p: its blossom of degree 3 is the
/// mean of the products of the blossoms in p and s over the argument given to s.
BezierTetrahedron prismPart(const SimplexNet& lower, const SimplexNet& upper,
                            const std::array<PrismPoint, 4>& corners) {
  SimplexNet net(4, netSize<4>(3));
  for (const MultiIndex<4>& index : multiIndices<4>(3)) {
    std::vector<PrismPoint> arguments;
    for (std::size_t c = 0; c < 4; ++c)
      arguments.insert(arguments.end(), static_cast<std::size_t>(index[c]), corners[c]);
    Eigen::Vector4d sum = Eigen::Vector4d::Zero();
    for (std::size_t k = 0; k < 3; ++k) {
      const PrismPoint& first = arguments[(k + 1) % 3];
      const PrismPoint& second = arguments[(k + 2) % 3];
      SimplexNet at = (1.0 - arguments[k].height) * lower + arguments[k].height * upper;
      reduceNet<3>(at, 2, first.onTriangle);
      reduceNet<3>(at, 1, second.onTriangle);
      sum += at.col(0) / 3.0;
    }
    net.col(netIndex<4>(index)) = sum;
  }
  return BezierTetrahedron::fromHomogeneous(3, 3, net);
}

}  // namespace

std::vector<BezierTetrahedron> frustumWedge(double lowerRadius, double upperRadius, double height,
                                            double angle) {
  checkPositive(lowerRadius, "lower radius");
  checkPositive(upperRadius, "upper radius");
  checkPositive(height, "height");
  checkPositive(angle, "angle");
  constexpr double kFullTurn = 2.0 * std::numbers::pi;
  if (angle > kFullTurn * (1.0 + 1e-12)) {
    throw std::invalid_argument("angle: must be at most 2 pi (360 degrees), got " +
                                std::to_string(angle));
  }
  const int count = std::max(1, static_cast<int>(std::ceil(angle / (0.25 * kFullTurn) - 1e-9)));
  const auto corner = [](int c, double s) { return PrismPoint{Barycentric<3>::Unit(c), s}; };
  // the prism of corners 0 (axis), 1, 2 in three parts; diagonals agree between neighbouring
  // sectors as each side's runs from the axis below to the arc above or along the axis
  std::vector<BezierTetrahedron> solids;
  for (int i = 0; i < count; ++i) {
    const double from = angle * i / count;
    const double to = angle * (i + 1) / count;
    const SimplexNet lower = sector(lowerRadius, 0.0, from, to);
    const SimplexNet upper = sector(upperRadius, height, from, to);
    solids.push_back(
        prismPart(lower, upper, {corner(0, 0), corner(1, 0), corner(2, 0), corner(2, 1)}));
    solids.push_back(
        prismPart(lower, upper, {corner(0, 0), corner(1, 0), corner(2, 1), corner(1, 1)}));
    solids.push_back(
        prismPart(lower, upper, {corner(0, 0), corner(1, 1), corner(2, 1), corner(0, 1)}));
  }
  return solids;
}

BezierTetrahedron randomTetrahedron(int degree, std::uint64_t seed, int dimension) {
  if (dimension != 3 && dimension != 4) {
    throw std::invalid_argument("dimension: must be 3 or 4, got " + std::to_string(dimension));
  }
  if (degree < 1 || degree > kMaxSimplexDegree) {
    throw std::invalid_argument("degree: must be 1 to 12, got " + std::to_string(degree));
  }
  std::mt19937_64 engine(seed);
  // std::uniform_real_distribution differs between standard libraries
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(engine() >> 11U) * 0x1p-53;
  };
  const double edge = 100.0;
  Eigen::Matrix<double, 3, 4> corners;                   // of the regular tetrahedron
  corners << 0.0, 1.0, 0.5, 0.5,                         //
      0.0, 0.0, std::sqrt(0.75), std::sqrt(1.0 / 12.0),  //
      0.0, 0.0, 0.0, std::sqrt(2.0 / 3.0);
  Eigen::MatrixXd points(dimension, netSize<4>(degree));
  std::vector<double> weights;
  Eigen::Index position = 0;
  for (const MultiIndex<4>& i : multiIndices<4>(degree)) {
    const Vector3 place = corners * Eigen::Vector4d(i[0], i[1], i[2], i[3]) * (edge / degree);
    for (int row = 0; row < dimension; ++row) {
      const double shake = 0.2 * edge / degree * uniform(-1.0, 1.0);
      points(row, position) = row < 3 ? place[row] + shake : 2.0 * shake;
    }
    weights.push_back(uniform(0.7, 1.4));
    ++position;
  }
  return BezierTetrahedron(degree, points, weights);
}

}  // namespace osculate
