// A curve's own continuation, against the curve itself beyond its end.
#include "osculate/construction/natural.h"

#include <gtest/gtest.h>

#include <numbers>

#include "construction/extend_curves.h"
#include "osculate/construction/contact_error.h"
#include "osculate/construction/extend_curve.h"
#include "osculate/differential/arc_length.h"

namespace osculate {
namespace {

constexpr double kPi = std::numbers::pi;

double largestWeightRatio(const BSplineCurve& curve) {
  const auto& weights = curve.data().weights;
  const auto [least, most] = std::minmax_element(weights.begin(), weights.end());
  return *most / *least;
}

TEST(Natural, ACircleGoesOnAsTheSameCircle) {
  // up to three times around, far beyond where the arc's own weights turn negative
  for (const double turn : {0.1, 0.5, 1.0, 1.5, 2.0, 6.0}) {
    const double lengthMm = 10.0 * turn * kPi;
    const BSplineCurve curve = naturalContinuation(test::quarterCircle(), CurveEnd::kEnd, lengthMm);
    EXPECT_EQ(curve.degree(), 2);
    EXPECT_LE(largestWeightRatio(curve), 2.0 + 1e-9);
    EXPECT_NEAR(length(curve), lengthMm, 1e-9);
    for (int i = 0; i <= 100; ++i)
      EXPECT_NEAR(curve.evaluate(i / 100.0).norm(), 10.0, 1e-12) << turn;
    const double angle = 0.5 * kPi + turn * kPi;
    const Vector3 end(10.0 * std::cos(angle), 10.0 * std::sin(angle), 0.0);
    EXPECT_LE((curve.endPoint(CurveEnd::kEnd) - end).norm(), 1e-9) << turn;
  }
}

TEST(Natural, TakesAsFewEvenArcsAsCan) {
  const auto spans = [](double turn) {
    return naturalContinuation(test::quarterCircle(), CurveEnd::kEnd, 10.0 * turn * kPi)
        .spanCount();
  };
  EXPECT_EQ(spans(0.5), 1);
  EXPECT_EQ(spans(2.0 / 3.0), 1);  // 120 degrees
  EXPECT_EQ(spans(0.7), 2);
  EXPECT_EQ(spans(1.5), 3);
}

TEST(Natural, BothEndsAndEveryWeightOfACircle) {
  const BSplineCurve quarter = test::quarterCircle();
  const BSplineCurve back = naturalContinuation(quarter, CurveEnd::kStart, 5.0 * kPi);
  EXPECT_LE((back.endPoint(CurveEnd::kEnd) - Vector3(0, -10, 0)).norm(), 1e-9);
  // the same arc by another parameter (weights times powers) and of a higher degree
  const BSplineCurve skewed =
      test::bezier({{10, 0, 0}, {10, 10, 0}, {0, 10, 0}}, {1.0, 3.0 * std::sqrt(0.5), 9.0});
  for (const BSplineCurve& same : {skewed, quarter.elevated(2), skewed.elevated(1)}) {
    const BSplineCurve curve = naturalContinuation(same, CurveEnd::kEnd, 15.0 * kPi);
    for (int i = 0; i <= 50; ++i)
      EXPECT_NEAR(curve.evaluate(i / 50.0).norm(), 10.0, 1e-9);
    EXPECT_LE((curve.endPoint(CurveEnd::kEnd) - Vector3(10, 0, 0)).norm(), 1e-8);
  }
}

TEST(Natural, PiecesJoinSmoothlyWithOneSpeed) {
  const BSplineCurve curve = naturalContinuation(test::quarterCircle(), CurveEnd::kEnd, 15.0 * kPi);
  const AnalysisOptions options{.order = 4, .tolerances = Tolerances::preset("exact")};
  const auto joins = analyzeInnerJoins(curve, options);
  ASSERT_EQ(joins.size(), 2U);
  for (const CurveJoin& join : joins) {
    EXPECT_EQ(join.report.order, 4);
    EXPECT_GE(join.report.parametricOrder, 1);
  }
}

TEST(Natural, APolynomialGoesOnInOneSegment) {
  for (const BSplineCurve& own : {test::twistedCubic(), test::twistedQuintic(), test::line()}) {
    for (const double lengthMm : {0.5, 20.0, 400.0}) {
      const BSplineCurve curve = naturalContinuation(own, CurveEnd::kEnd, lengthMm);
      EXPECT_EQ(curve.spanCount(), 1);
      EXPECT_FALSE(curve.isRational());
      EXPECT_EQ(curve.degree(), own.degree());
      EXPECT_NEAR(length(curve), lengthMm, 1e-10 * lengthMm);
      // affine in the parameter: the end is P(1 + h), h from the ratio of speeds
      const double h = curve.derivatives(0.0, 1)[1].norm() / own.derivatives(1.0, 1)[1].norm();
      const Vector3 end = own.segment(0).curve.evaluate(1.0 + h);
      EXPECT_LE((end - curve.endPoint(CurveEnd::kEnd)).norm(), 1e-9 * lengthMm);
    }
  }
}

TEST(Natural, EqualWeightsAreAPolynomial) {
  const BSplineCurve own =
      test::bezier({{0, 0, 0}, {10, 0, 0}, {20, 10, 0}, {20, 20, 10}}, {1.0, 2.0, 4.0, 8.0});
  const BSplineCurve curve = naturalContinuation(own, CurveEnd::kEnd, 50.0);
  EXPECT_FALSE(curve.isRational());
  EXPECT_NEAR(length(curve), 50.0, 1e-9);
}

TEST(Natural, OfABSplineIsThatOfItsEndSegment) {
  const BSplineCurve own = test::spline();
  for (const CurveEnd end : {CurveEnd::kStart, CurveEnd::kEnd}) {
    const BSplineCurve curve = naturalContinuation(own, end, 5.0);
    const BSplineCurve segment =
        naturalContinuation(BSplineCurve(own.endSegment(end).curve), end, 5.0);
    EXPECT_EQ(curve.data().poles, segment.data().poles);
  }
}

TEST(Natural, AHyperbolaRunsToInfinityAlongItsOwnBranch) {
  // x y = 100 from (2, 50) to (50, 2): w_1 > 1
  const double m = 200.0 / 52.0;
  const double w = 0.5 * 52.0 / std::sqrt(100.0);
  const BSplineCurve own = test::bezier({{2, 50, 0}, {m, m, 0}, {50, 2, 0}}, {1.0, w, 1.0});
  for (const double lengthMm : {10.0, 1e3, 1e6}) {
    const BSplineCurve curve = naturalContinuation(own, CurveEnd::kEnd, lengthMm);
    EXPECT_NEAR(length(curve), lengthMm, 1e-9 * lengthMm);
    for (int i = 0; i <= 20; ++i) {
      const Vector3 point = curve.evaluate(i / 20.0);
      EXPECT_NEAR(point.x() * point.y(), 100.0, 1e-9 + 1e-10 * lengthMm);
      EXPECT_GE(point.x(), 50.0 - 1e-9);
    }
  }
}

TEST(Natural, ReportsItsContactAndReach) {
  const Construction construction = extendNaturally(test::rationalQuartic(), CurveEnd::kStart, 8);
  EXPECT_EQ(construction.joins[0].report.order, 8);
  EXPECT_EQ(construction.beta[0].size(), 8U);
  EXPECT_EQ(construction.freeNumbers, 0);
  EXPECT_NEAR(length(construction.curve), reachFrom(test::rationalQuartic(), CurveEnd::kStart),
              1e-9);
  // a full turn has no chord
  EXPECT_TRUE(
      extendNaturally(test::quarterCircle(), CurveEnd::kEnd, 4, 20.0 * kPi).beta[0].empty());
}

TEST(Natural, RefusesBadInput) {
  const BSplineCurve quarter = test::quarterCircle();
  for (const double bad : {0.0, -1.0, std::numeric_limits<double>::infinity(), std::nan("")})
    EXPECT_THROW(naturalContinuation(quarter, CurveEnd::kEnd, bad), std::invalid_argument);
  EXPECT_THROW(naturalContinuation(quarter, CurveEnd::kEnd, 1e5), ContactError);
  EXPECT_THROW(naturalContinuation(test::doublePole(), CurveEnd::kEnd, 5.0), ContactError);
  EXPECT_THROW(extendNaturally(quarter, CurveEnd::kEnd, 9), std::invalid_argument);
}

}  // namespace
}  // namespace osculate
