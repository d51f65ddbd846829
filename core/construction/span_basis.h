// The basis functions of a B-spline on one of its spans: the factors of its poles in the point of
// the curve; private to this floor.
#pragma once

#include "osculate/bezier/bspline_curve.h"

namespace osculate {

/// Bernstein polynomials of a degree and their derivatives at the nodes of a Gauss-Legendre rule
/// over [0, 1].
struct BernsteinTable {
  Eigen::MatrixXd values;       ///< a row for each node
  Eigen::MatrixXd derivatives;  ///< likewise
  Eigen::VectorXd weights;      ///< of the rule, their sum 1
};
BernsteinTable bernsteinTable(int degree);

/// The functions R_i with P(t) = sum_i R_i(t) P_i over t in [0, 1] on a span, of the poles first ..
/// first + degree; of a rational curve R_i = w_i N_i / sum_j w_j N_j.
class SpanBasis {
 public:
  SpanBasis(const BSplineCurve& curve, int span);

  int first() const { return first_; }
  /// A row for each node, a column for each function.
  Eigen::MatrixXd values(const BernsteinTable& table) const;
  /// |P'(t)| at each node.
  Eigen::VectorXd speeds(const BernsteinTable& table) const;
  /// Taylor coefficients 0..order of each function at an end, in the direction of t: a row for each
  /// function.
  Eigen::MatrixXd taylor(CurveEnd end, int order) const;
  /// Taylor coefficients 0..order of the denominator at the start.
  Eigen::VectorXd weightTaylor(int order) const;

 private:
  int degree_;
  int first_;
  BezierCurve segment_;
  Eigen::MatrixXd coefficients_;  ///< column i: w_i N_i in Bernstein form
  Eigen::VectorXd weights_;       ///< of the segment
};

}  // namespace osculate
