// What a Bézier triangle and a Bézier tetrahedron have in common: a net of control points, with
// weights where it is rational, as an immutable value.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "osculate/bezier/simplex_net.h"

namespace osculate {

/// A point or vector of E3 or E4, in mm.
using SpacePoint = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 5, 1>;

/// A Bézier triangle (3 corners) or tetrahedron (4 corners) of degree 1 to kMaxSimplexDegree in E3
/// or E4, polynomial or rational.
///
/// B(u) = sum w_i V_i B_i^n(u) / sum w_i B_i^n(u), u barycentric. Everything is computed with the
/// homogeneous points (w_i V_i, w_i): a point of weight 0 contributes nothing.
template <int Corners>
class BezierSimplex {
 public:
  using Bary = Barycentric<Corners>;
  using Index = MultiIndex<Corners>;
  using PartCorners = PartCornersOf<Corners>;

  /// points: 3 or 4 rows, a column for each point of the net in its order; weights: none, or one a
  /// point. Throws std::invalid_argument that names the argument and the rule: degree 1 to 12, the
  /// right number of finite points, weights finite, >= 0 and not all 0.
  BezierSimplex(int degree, Eigen::MatrixXd points, std::vector<double> weights = {});

  int degree() const { return degree_; }
  /// 3 or 4: the dimension of the space it is in.
  int dimension() const { return static_cast<int>(points_.rows()); }
  int size() const { return static_cast<int>(points_.cols()); }
  bool isRational() const { return !weights_.empty(); }
  const Eigen::MatrixXd& points() const { return points_; }
  const std::vector<double>& weights() const { return weights_; }
  double weight(int i) const { return isRational() ? weights_[static_cast<std::size_t>(i)] : 1.0; }
  auto point(const Index& index) const { return points_.col(netIndex<Corners>(index)); }
  double weight(const Index& index) const { return weight(netIndex<Corners>(index)); }
  bool operator==(const BezierSimplex& other) const;

  /// (w V, w) as columns; the points themselves for a polynomial net.
  SimplexNet homogeneous() const;
  /// (w V, w) with weights of 1 for a polynomial net.
  SimplexNet homogeneousWithWeights() const;
  /// From homogeneous points: `dimension` rows make a polynomial net, one more a rational one. A
  /// point of weight 0 goes to the mean of the others. Throws as the constructor does.
  static BezierSimplex fromHomogeneous(int degree, int dimension, const SimplexNet& net);

  /// The point at u, by de Casteljau (any u; nothing is checked). NaN where the weight vanishes.
  SpacePoint evaluate(const Bary& u) const;
  /// The mixed derivative along the directions (sums 0; any number), in mm per unit of each.
  /// Directions that occur again may be repeated or not; at most 12 different ones.
  SpacePoint derivative(const Bary& u, std::span<const Bary> directions) const;
  /// The partial derivative of B as a function of independent variables u, v, ..: of the
  /// polynomial, or of the quotient of polynomials, without the condition that they sum to 1.
  SpacePoint partial(const Bary& u, const Index& orders) const;

  /// The same map with the degree raised.
  BezierSimplex elevated(int times = 1) const;
  /// The part with these corners, as a whole of its own. Throws std::invalid_argument for
  /// coordinates that are not finite or do not sum to 1, and where a rational one is left so far
  /// that a weight of the part is negative.
  BezierSimplex part(const PartCorners& corners) const;
  /// The parts that `at` makes with the faces: corner c of part c is replaced by it.
  std::vector<BezierSimplex> subdivided(const Bary& at) const;
  /// Halves cut at the middle of the edge between two corners; the first keeps corner a.
  std::pair<BezierSimplex, BezierSimplex> bisected(int a, int b) const;
  /// 4 triangles or 8 tetrahedra with the middles of the edges as new corners, oriented as this.
  std::vector<BezierSimplex> refined() const;
  /// Corner c of the result is corner order[c] of this.
  BezierSimplex relabelled(const Index& order) const;
  /// The edge from corner a to corner b: its homogeneous points as columns, weight last.
  SimplexNet edgeNet(int a, int b) const;

  /// x -> linear x + translation, into E3 or E4; linear has dimension() columns.
  BezierSimplex transformed(const Eigen::MatrixXd& linear, const SpacePoint& translation) const;
  /// The image under the projective map of homogeneous coordinates (x, 1): rows and columns with
  /// the weight last. Throws std::invalid_argument unless it keeps all weights of one sign.
  BezierSimplex mapped(const Eigen::MatrixXd& projective) const;
  /// Lower and upper corner of the box around the points of positive weight, which contains it all.
  std::pair<SpacePoint, SpacePoint> box() const;

 private:
  BezierSimplex() = default;

  int degree_ = 0;
  Eigen::MatrixXd points_;
  std::vector<double> weights_;
};

extern template class BezierSimplex<3>;
extern template class BezierSimplex<4>;

}  // namespace osculate
