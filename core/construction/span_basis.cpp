#include "osculate/construction/span_basis.h"

#include <boost/math/quadrature/gauss.hpp>

#include "osculate/bezier/bernstein.h"

namespace osculate {

namespace {

/// Taylor coefficients of polynomials in Bernstein form (columns of Bézier ordinates) at an end in
/// the direction of t: C(n,k) times the k-th forward difference at the start, backward at the end.
Eigen::MatrixXd taylorOf(Eigen::MatrixXd ordinates, CurveEnd end, int order) {
  const auto degree = static_cast<int>(ordinates.rows()) - 1;
  Eigen::MatrixXd taylor = Eigen::MatrixXd::Zero(ordinates.cols(), order + 1);
  for (int k = 0; k <= std::min(order, degree); ++k) {
    const int left = degree - k;  // rows 0..left hold the k-th differences
    taylor.col(k) = binomial(degree, k) * ordinates.row(end == CurveEnd::kStart ? 0 : left);
    ordinates.topRows(left) = (ordinates.middleRows(1, left) - ordinates.topRows(left)).eval();
  }
  return taylor;
}

}  // namespace

BernsteinTable bernsteinTable(int degree) {
  constexpr int kNodes =
      30;  // exact to degree 59: products of functions of degree 25, and to spare
  using Rule = boost::math::quadrature::gauss<double, kNodes>;  // lists the nodes x > 0 of [-1, 1]
  BernsteinTable table{Eigen::MatrixXd(kNodes, degree + 1),
                       Eigen::MatrixXd::Zero(kNodes, degree + 1), Eigen::VectorXd(kNodes)};
  for (int i = 0; i < kNodes; ++i) {
    const auto k = static_cast<std::size_t>(i % (kNodes / 2));
    const double t = 0.5 + (i < kNodes / 2 ? -0.5 : 0.5) * Rule::abscissa()[k];
    table.weights[i] = 0.5 * Rule::weights()[k];
    table.values.row(i) = bernstein(degree, t);
    const Eigen::RowVectorXd lower = degree * bernstein(degree - 1, t).transpose();
    table.derivatives.row(i).head(degree) -= lower;
    table.derivatives.row(i).tail(degree) += lower;
  }
  return table;
}

SpanBasis::SpanBasis(const BSplineCurve& curve, int span)
    : degree_(curve.degree()),
      first_(0),
      segment_(curve.segment(span).curve),
      weights_(Eigen::VectorXd::Ones(degree_ + 1)) {
  const SpanExtraction extraction = curve.extraction(span);
  first_ = extraction.firstPole;
  coefficients_ = extraction.factors.transpose();
  if (!curve.isRational()) return;
  for (int i = 0; i <= degree_; ++i) {
    coefficients_.col(i) *= curve.data().weights[static_cast<std::size_t>(first_ + i)];
    weights_[i] = segment_.weight(i);
  }
}

Eigen::MatrixXd SpanBasis::values(const BernsteinTable& table) const {
  const Eigen::ArrayXd inverse = (table.values * weights_).array().inverse();
  return inverse.matrix().asDiagonal() * (table.values * coefficients_);
}

Eigen::VectorXd SpanBasis::speeds(const BernsteinTable& table) const {
  const Eigen::Map<const Poles> poles(segment_.view().poles, 3, degree_ + 1);
  // measured from a pole: a rational derivative is a difference of products with the point
  const Eigen::MatrixX3d numerators =
      weights_.asDiagonal() * (poles.colwise() - poles.col(0)).transpose();
  const Eigen::ArrayXd inverse = (table.values * weights_).array().inverse();
  const Eigen::VectorXd change = table.derivatives * weights_;
  const Eigen::MatrixX3d points =
      inverse.matrix().asDiagonal() * (table.values * numerators).eval();
  const Eigen::MatrixX3d derivatives =
      table.derivatives * numerators - change.asDiagonal() * points;
  return derivatives.rowwise().norm().array() * inverse;
}

Eigen::MatrixXd SpanBasis::taylor(CurveEnd end, int order) const {
  Eigen::MatrixXd numerators = taylorOf(coefficients_, end, order);
  const Eigen::RowVectorXd weight = taylorOf(weights_, end, order).row(0);
  // c_k = (a_k - sum_{j>=1} w_j c_{k-j}) / w_0 (Leibniz)
  for (int k = 0; k <= order; ++k) {
    for (int j = 1; j <= k; ++j)
      numerators.col(k) -= weight[j] * numerators.col(k - j);
    numerators.col(k) /= weight[0];
  }
  return numerators;
}

Eigen::VectorXd SpanBasis::weightTaylor(int order) const {
  return taylorOf(weights_, CurveEnd::kStart, order).row(0);
}

}  // namespace osculate
