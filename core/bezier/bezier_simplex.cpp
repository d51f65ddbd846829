#include "osculate/bezier/bezier_simplex.h"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace osculate {

namespace {

template <int Corners>
void checkNet(int degree, const Eigen::MatrixXd& points) {
  if (degree < 1 || degree > kMaxSimplexDegree) {
    throw std::invalid_argument("degree: must be 1 to " + std::to_string(kMaxSimplexDegree) +
                                ", got " + std::to_string(degree));
  }
  if (points.rows() != 3 && points.rows() != 4) {
    throw std::invalid_argument("points: must have 3 coordinates (E3) or 4 (E4), got " +
                                std::to_string(points.rows()));
  }
  if (points.cols() != netSize<Corners>(degree)) {
    throw std::invalid_argument("points: a net of degree " + std::to_string(degree) + " has " +
                                std::to_string(netSize<Corners>(degree)) + " points, got " +
                                std::to_string(points.cols()));
  }
  if (!points.allFinite()) {
    throw std::invalid_argument("points: every coordinate must be finite (found NaN or infinity)");
  }
}

void checkSimplexWeights(const std::vector<double>& weights, Eigen::Index count) {
  if (weights.empty()) return;
  if (static_cast<Eigen::Index>(weights.size()) != count) {
    throw std::invalid_argument("weights: one for each point is needed, got " +
                                std::to_string(weights.size()) + " for " + std::to_string(count) +
                                " points");
  }
  bool anyPositive = false;
  for (const double weight : weights) {
    if (!(std::isfinite(weight) && weight >= 0.0)) {
      throw std::invalid_argument("weights: every weight must be finite and >= 0, got " +
                                  std::to_string(weight));
    }
    anyPositive = anyPositive || weight > 0.0;
  }
  if (!anyPositive) throw std::invalid_argument("weights: at least one must be > 0, all are 0");
}

template <int Corners>
void checkCorner(const Barycentric<Corners>& corner) {
  if (!corner.allFinite() || std::abs(corner.sum() - 1.0) > 1e-9) {
    throw std::invalid_argument(
        "corners: barycentric coordinates must be finite with the sum 1, got the sum " +
        std::to_string(corner.sum()));
  }
}

}  // namespace

template <int Corners>
BezierSimplex<Corners>::BezierSimplex(int degree, Eigen::MatrixXd points,
                                      std::vector<double> weights)
    : degree_(degree), points_(std::move(points)), weights_(std::move(weights)) {
  checkNet<Corners>(degree_, points_);
  checkSimplexWeights(weights_, points_.cols());
}

template <int Corners>
bool BezierSimplex<Corners>::operator==(const BezierSimplex& other) const {
  return degree_ == other.degree_ && dimension() == other.dimension() && points_ == other.points_ &&
         weights_ == other.weights_;
}

template <int Corners>
SimplexNet BezierSimplex<Corners>::homogeneous() const {
  return isRational() ? homogeneousWithWeights() : points_;
}

template <int Corners>
SimplexNet BezierSimplex<Corners>::homogeneousWithWeights() const {
  SimplexNet net(dimension() + 1, size());
  for (int i = 0; i < size(); ++i)
    net.col(i) << weight(i) * points_.col(i), weight(i);
  return net;
}

template <int Corners>
BezierSimplex<Corners> BezierSimplex<Corners>::fromHomogeneous(int degree, int dimension,
                                                               const SimplexNet& net) {
  if (net.rows() == dimension) return BezierSimplex(degree, net);
  std::vector<double> weights(static_cast<std::size_t>(net.cols()));
  Eigen::MatrixXd points = Eigen::MatrixXd::Zero(dimension, net.cols());
  SpacePoint sum = SpacePoint::Zero(dimension);
  int positive = 0;
  for (Eigen::Index i = 0; i < net.cols(); ++i) {
    weights[static_cast<std::size_t>(i)] = net(dimension, i);
    if (!(net(dimension, i) > 0.0)) continue;
    points.col(i) = net.col(i).head(dimension) / net(dimension, i);
    sum += points.col(i);
    ++positive;
  }
  for (Eigen::Index i = 0; i < net.cols() && positive > 0; ++i) {
    if (net(dimension, i) == 0.0) points.col(i) = sum / positive;
  }
  return BezierSimplex(degree, std::move(points), std::move(weights));
}

template <int Corners>
SpacePoint BezierSimplex<Corners>::evaluate(const Bary& u) const {
  SimplexNet net = homogeneous();
  for (int d = degree_; d > 0; --d)
    reduceNet<Corners>(net, d, u);
  if (!isRational()) return net.col(0);
  return net.col(0).head(dimension()) / net(dimension(), 0);
}

template <int Corners>
BezierSimplex<Corners> BezierSimplex<Corners>::elevated(int times) const {
  if (times < 0 || degree_ + times > kMaxSimplexDegree) {
    throw std::invalid_argument(
        "times: the degree " + std::to_string(degree_) + " can be raised by 0 to " +
        std::to_string(kMaxSimplexDegree - degree_) + ", got " + std::to_string(times));
  }
  if (times == 0) return *this;
  SimplexNet net = homogeneous();
  for (int step = 0; step < times; ++step)
    net = elevateNet<Corners>(net, degree_ + step);
  return fromHomogeneous(degree_ + times, dimension(), net);
}

template <int Corners>
BezierSimplex<Corners> BezierSimplex<Corners>::part(const PartCorners& corners) const {
  for (const Bary& corner : corners)
    checkCorner<Corners>(corner);
  return fromHomogeneous(degree_, dimension(),
                         partNet<Corners, Corners>(homogeneous(), degree_, corners));
}

template <int Corners>
std::vector<BezierSimplex<Corners>> BezierSimplex<Corners>::subdivided(const Bary& at) const {
  std::vector<BezierSimplex> parts;
  for (std::size_t c = 0; c < Corners; ++c) {
    PartCorners corners = unitCorners<Corners>();
    corners[c] = at;
    parts.push_back(part(corners));
  }
  return parts;
}

template <int Corners>
std::pair<BezierSimplex<Corners>, BezierSimplex<Corners>> BezierSimplex<Corners>::bisected(
    int a, int b) const {
  if (a < 0 || b < 0 || a >= Corners || b >= Corners || a == b) {
    throw std::invalid_argument("bisected: needs two different corners from 0 to " +
                                std::to_string(Corners - 1));
  }
  SimplexNet first = homogeneous();
  const SimplexNet second = bisectNet<Corners>(first, degree_, a, b);
  return {fromHomogeneous(degree_, dimension(), first),
          fromHomogeneous(degree_, dimension(), second)};
}

namespace {

/// Corners as pairs: (a, a) is corner a, (a, b) the middle of that edge.
using Pairs3 = std::array<std::array<int, 2>, 3>;
using Pairs4 = std::array<std::array<int, 2>, 4>;

constexpr std::array<Pairs3, 4> kRefinedTriangle{{{{{0, 0}, {0, 1}, {0, 2}}},
                                                  {{{0, 1}, {1, 1}, {1, 2}}},
                                                  {{{0, 2}, {1, 2}, {2, 2}}},
                                                  {{{1, 2}, {0, 2}, {0, 1}}}}};
// Bey 1995: four corner tetrahedra, the inner octahedron cut along the diagonal from the middle of
// 0-2 to that of 1-3.
constexpr std::array<Pairs4, 8> kRefinedTetrahedron{{{{{0, 0}, {0, 1}, {0, 2}, {0, 3}}},
                                                     {{{0, 1}, {1, 1}, {1, 2}, {1, 3}}},
                                                     {{{0, 2}, {1, 2}, {2, 2}, {2, 3}}},
                                                     {{{0, 3}, {1, 3}, {2, 3}, {3, 3}}},
                                                     {{{0, 1}, {0, 2}, {0, 3}, {1, 3}}},
                                                     {{{0, 1}, {0, 2}, {1, 3}, {1, 2}}},
                                                     {{{0, 2}, {0, 3}, {1, 3}, {2, 3}}},
                                                     {{{0, 2}, {1, 2}, {2, 3}, {1, 3}}}}};

template <int Corners>
PartCornersOf<Corners> cornersFrom(const std::array<std::array<int, 2>, Corners>& pairs) {
  PartCornersOf<Corners> corners;
  for (std::size_t c = 0; c < Corners; ++c)
    corners[c] =
        0.5 * (Barycentric<Corners>::Unit(pairs[c][0]) + Barycentric<Corners>::Unit(pairs[c][1]));
  return corners;
}

}  // namespace

template <int Corners>
std::vector<BezierSimplex<Corners>> BezierSimplex<Corners>::refined() const {
  std::vector<BezierSimplex> parts;
  if constexpr (Corners == 3) {
    for (const Pairs3& pairs : kRefinedTriangle)
      parts.push_back(part(cornersFrom<3>(pairs)));
  } else {
    for (const Pairs4& pairs : kRefinedTetrahedron)
      parts.push_back(part(cornersFrom<4>(pairs)));
  }
  return parts;
}

template <int Corners>
BezierSimplex<Corners> BezierSimplex<Corners>::relabelled(const Index& order) const {
  std::array<bool, Corners> used{};
  for (const int corner : order) {
    if (corner < 0 || corner >= Corners ||
        std::exchange(used[static_cast<std::size_t>(corner)], true)) {
      throw std::invalid_argument("order: must be a permutation of 0 to " +
                                  std::to_string(Corners - 1));
    }
  }
  BezierSimplex result = *this;
  Eigen::Index position = 0;
  for (const Index& index : multiIndices<Corners>(degree_)) {
    Index old{};
    for (std::size_t c = 0; c < Corners; ++c)
      old[static_cast<std::size_t>(order[c])] = index[c];
    const int from = netIndex<Corners>(old);
    result.points_.col(position) = points_.col(from);
    if (isRational()) result.weights_[static_cast<std::size_t>(position)] = weight(from);
    ++position;
  }
  return result;
}

template <int Corners>
SimplexNet BezierSimplex<Corners>::edgeNet(int a, int b) const {
  if (a < 0 || b < 0 || a >= Corners || b >= Corners || a == b) {
    throw std::invalid_argument("edge: needs two different corners from 0 to " +
                                std::to_string(Corners - 1));
  }
  SimplexNet edge(dimension() + 1, degree_ + 1);
  for (int i = 0; i <= degree_; ++i) {
    Index index{};
    index[static_cast<std::size_t>(a)] = degree_ - i;
    index[static_cast<std::size_t>(b)] = i;
    edge.col(i) << weight(index) * point(index), weight(index);
  }
  return edge;
}

template <int Corners>
BezierSimplex<Corners> BezierSimplex<Corners>::transformed(const Eigen::MatrixXd& linear,
                                                           const SpacePoint& translation) const {
  if (linear.cols() != dimension() || linear.rows() != translation.size()) {
    throw std::invalid_argument("transformed: the matrix must have a column for each of the " +
                                std::to_string(dimension()) +
                                " coordinates and a row for each of the new ones");
  }
  const Eigen::MatrixXd moved = (linear * points_).colwise() + Eigen::VectorXd(translation);
  return BezierSimplex(degree_, moved, weights_);
}

template <int Corners>
BezierSimplex<Corners> BezierSimplex<Corners>::mapped(const Eigen::MatrixXd& projective) const {
  if (projective.cols() != dimension() + 1) {
    throw std::invalid_argument("mapped: the matrix must have " + std::to_string(dimension() + 1) +
                                " columns");
  }
  SimplexNet net = projective * homogeneousWithWeights();
  const auto weights = net.row(net.rows() - 1).array();
  if ((weights > 0.0).any() && (weights < 0.0).any()) {
    throw std::invalid_argument(
        "mapped: some points go through infinity (their new weights differ in sign)");
  }
  if ((weights < 0.0).any()) net = -net;
  return fromHomogeneous(degree_, static_cast<int>(net.rows()) - 1, net);
}

template <int Corners>
std::pair<SpacePoint, SpacePoint> BezierSimplex<Corners>::box() const {
  SpacePoint low = SpacePoint::Constant(dimension(), std::numeric_limits<double>::infinity());
  SpacePoint high = -low;
  for (int i = 0; i < size(); ++i) {
    if (weight(i) == 0.0) continue;
    low = low.cwiseMin(points_.col(i));
    high = high.cwiseMax(points_.col(i));
  }
  return {low, high};
}

template class BezierSimplex<3>;
template class BezierSimplex<4>;

}  // namespace osculate
