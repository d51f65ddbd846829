#include "osculate/construction/span_basis.h"

#include <gtest/gtest.h>

#include "osculate/bezier/bernstein.h"
#include "support/random_curves.h"
#include "support/spline_samples.h"

namespace osculate::test {
namespace {

/// The poles that a basis belongs to.
Poles polesUnder(const BSplineCurve& curve, const SpanBasis& basis) {
  return curve.data().poles.middleCols(basis.first(), curve.degree() + 1);
}

TEST(SpanBasis, GivesThePointsAndSpeedsOfTheCurve) {
  for (const SplineSample& sample : splineSamples(340)) {
    const BSplineCurve curve(sample.data);
    if (curve.isPeriodic()) continue;
    const double size = curve.data().poles.colwise().norm().maxCoeff();
    const BernsteinTable table = bernsteinTable(curve.degree());
    for (int span = 0; span < curve.spanCount(); ++span) {
      const SpanBasis basis(curve, span);
      const Eigen::MatrixXd values = basis.values(table);
      const Eigen::VectorXd speeds = basis.speeds(table);
      const BezierCurve segment = curve.segment(span).curve;
      double length = 0.0;
      for (Eigen::Index i = 0; i < values.rows(); ++i) {
        EXPECT_NEAR(values.row(i).sum(), 1.0, 1e-12);
        const Vector3 point = polesUnder(curve, basis) * values.row(i).transpose();
        // the node: the mean of the Bernstein polynomials' abscissae i/n
        const double t =
            table.values.row(i).dot(Eigen::RowVectorXd::LinSpaced(curve.degree() + 1, 0.0, 1.0));
        const auto expected = segment.derivatives(t, 1);
        EXPECT_LE((point - expected[0]).norm(), 1e-10 * size) << sample.name;
        EXPECT_NEAR(speeds[i], expected[1].norm(), 1e-9 * size) << sample.name;
        length += table.weights[i] * speeds[i];
      }
      EXPECT_GT(length, 0.0);
    }
  }
}

TEST(SpanBasis, TaylorCoefficientsGiveTheDerivativesAtBothEnds) {
  Random random(341);
  for (const bool rational : {false, true}) {
    const BSplineCurve curve(randomSplineData(random, 4, {{0, 1, 1.5, 4}, {5, 1, 3, 5}}, rational));
    for (int span = 0; span < curve.spanCount(); ++span) {
      const SpanBasis basis(curve, span);
      for (const CurveEnd end : {CurveEnd::kStart, CurveEnd::kEnd}) {
        const Poles taylor = polesUnder(curve, basis) * basis.taylor(end, 6);
        const auto expected =
            curve.segment(span).curve.derivatives(end == CurveEnd::kStart ? 0.0 : 1.0, 6);
        double factorial = 1.0;
        for (int k = 0; k <= 6; ++k) {
          factorial *= std::max(k, 1);
          const Vector3 derivative = factorial * taylor.col(k);
          const Vector3& own = expected[static_cast<std::size_t>(k)];
          EXPECT_LE((derivative - own).norm(), 1e-8 * (1.0 + own.norm())) << k;
        }
      }
    }
  }
}

TEST(BernsteinTable, IntegratesAndDifferentiates) {
  for (const int degree : {1, 4, 25}) {
    const BernsteinTable table = bernsteinTable(degree);
    // int B_i^n = 1/(n+1), int (B_i^n)' = B_i^n(1) - B_i^n(0)
    const Eigen::RowVectorXd integrals = table.weights.transpose() * table.values;
    const Eigen::RowVectorXd changes = table.weights.transpose() * table.derivatives;
    for (int i = 0; i <= degree; ++i) {
      EXPECT_NEAR(integrals[i], 1.0 / (degree + 1), 1e-15);
      EXPECT_NEAR(changes[i], i == 0 ? -1.0 : i == degree ? 1.0 : 0.0, 1e-13);
    }
  }
}

}  // namespace
}  // namespace osculate::test
