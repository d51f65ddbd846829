#include "osculate/differential/arc_length.h"

#include <chrono>
#include <limits>
#include <numbers>

#include "support/errors.h"
#include "support/spline_samples.h"

namespace osculate::test {
namespace {

BSplineCurve bezier(const std::vector<Vector3>& poles, const std::vector<double>& weights = {}) {
  return BSplineCurve(BezierCurve(poles, weights));
}

void expectLength(const BSplineCurve& curve, double expected, double relativeError = 2e-12) {
  EXPECT_NEAR(length(curve), expected, relativeError * expected);
}

TEST(Length, OfALineOfUnevenSpeedIsItsChord) {
  expectLength(bezier({{0, 0, 0}, {1, 2, 2}, {5, 10, 10}, {10, 20, 20}}), 30.0);
}

TEST(Length, OfARationalCircleIsTwoPiRadius) {
  const double root = std::sqrt(0.5);
  const BSplineCurve quarter = bezier({{5, 0, 0}, {5, 5, 0}, {0, 5, 0}}, {1.0, root, 1.0});
  expectLength(quarter, 2.5 * std::numbers::pi);
}

TEST(Length, OfAParabolaIsItsClosedForm) {
  // (u, u^2), u in [0, 1]: sqrt(5)/2 + asinh(2)/4
  expectLength(bezier({{0, 0, 0}, {0.5, 0, 0}, {1, 1, 0}}),
               std::sqrt(5.0) / 2.0 + std::asinh(2.0) / 4.0);
}

TEST(Length, OfACurveWithACuspInsideIsItsClosedForm) {
  // (t^2, t^3), t in [-1, 1]: 2 (13^(3/2) - 8) / 27
  expectLength(bezier({{1, -1, 0}, {-1.0 / 3, 1, 0}, {-1.0 / 3, -1, 0}, {1, 1, 0}}),
               2.0 * (std::pow(13.0, 1.5) - 8.0) / 27.0);
}

TEST(Length, OfALineThatTurnsBackCountsBothWays) {
  // x = 2t - 3/2 t^2 turns at t = 2/3, x = 2/3, and ends at 1/2
  expectLength(bezier({{0, 0, 0}, {1, 0, 0}, {0.5, 0, 0}}), 2.0 / 3.0 + (2.0 / 3.0 - 0.5), 1e-11);
}

TEST(Length, OfManySpansIsTheSumOfItsParts) {
  for (const SplineSample& sample : splineSamples(170)) {
    SCOPED_TRACE(sample.name);
    const BSplineCurve curve(sample.data);
    const double whole = length(curve);
    const double middle = 0.4 * curve.first() + 0.6 * curve.last();
    EXPECT_NEAR(length(curve, curve.first(), middle) + length(curve, middle, curve.last()), whole,
                1e-11 * whole);
    EXPECT_EQ(length(curve, middle, middle), 0.0);
    EXPECT_GE(whole * (1 + 1e-12),
              (curve.endPoint(CurveEnd::kEnd) - curve.endPoint(CurveEnd::kStart)).norm());
  }
}

TEST(Length, DoesNotCountTheJumpOfABrokenCurve) {
  const BSplineData data{.poles = columns({{0, 0, 0}, {1, 0, 0}, {5, 5, 0}, {6, 5, 0}}),
                         .weights = {},
                         .knots = {{0, 1, 2}, {2, 2, 2}},
                         .degree = 1,
                         .periodic = false,
                         .poleError = 0.0};
  expectLength(BSplineCurve(data), 2.0);
}

TEST(Length, IsUnchangedByReversalElevationAndScaledByScaling) {
  Random random(171);
  const BSplineCurve curve(randomSplineData(random, 4, {{0, 1, 2, 5}, {5, 2, 1, 5}}, true));
  const double whole = length(curve);
  expectLength(curve.reversed(), whole);
  expectLength(curve.elevated(3), whole);
  expectLength(curve.reparametrised(10.0, 1000.0), whole);
  expectLength(curve.transformed(Eigen::Affine3d(Eigen::Scaling(1e-6))), 1e-6 * whole);
}

TEST(Length, NamesRangesThatAreNone) {
  const BSplineCurve curve = bezier({{0, 0, 0}, {1, 0, 0}});
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  EXPECT_ERROR(length(curve, -0.1, 0.5), "length: needs first <= a <= b <= last");
  EXPECT_ERROR(length(curve, 0.5, 1.1), "length: needs first <= a <= b <= last");
  EXPECT_ERROR(length(curve, 0.6, 0.5), "length: needs first <= a <= b <= last");
  EXPECT_ERROR(length(curve, kNaN, 0.5), "length: needs first <= a <= b <= last");
}

TEST(ParameterAtLength, IsTheInverseOfLength) {
  Random random(172);
  for (const SplineSample& sample : splineSamples(172)) {
    SCOPED_TRACE(sample.name);
    const BSplineCurve curve(sample.data);
    const double whole = length(curve);
    for (int round = 0; round < 4; ++round) {
      const double s = random.uniform(0.0, whole);
      EXPECT_NEAR(length(curve, curve.first(), parameterAtLength(curve, s)), s, 1e-10 * whole);
    }
  }
}

TEST(ParameterAtLength, OfNothingAndOfAllAreTheEnds) {
  for (const SplineSample& sample : splineSamples(173)) {
    SCOPED_TRACE(sample.name);
    const BSplineCurve curve(sample.data);
    EXPECT_EQ(parameterAtLength(curve, 0.0), curve.first());
    EXPECT_EQ(parameterAtLength(curve, length(curve)), curve.last());
  }
}

TEST(ParameterAtLength, CloseToTheStartIsFoundAtOnce) {
  const double root = std::sqrt(0.5);
  const BSplineCurve quarter = bezier({{5, 0, 0}, {5, 5, 0}, {0, 5, 0}}, {1.0, root, 1.0});
  const auto start = std::chrono::steady_clock::now();
  for (double s = 1e-16; s < 1e-6; s *= 10.0) {
    EXPECT_NEAR(parameterAtLength(quarter, s) * 10.0 * root, s, 1e-6 * s);
    EXPECT_NEAR(length(quarter, 0.0, s / (10.0 * root)), s, 1e-6 * s);
  }
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
  EXPECT_LT(passed.count(), 1.0);  // where intervals are halved without end, each takes as long
}

TEST(ParameterAtLength, NamesLengthsBeyondTheCurve) {
  const BSplineCurve curve = bezier({{0, 0, 0}, {4, 0, 0}});
  EXPECT_ERROR(parameterAtLength(curve, -1.0), "length: must be from 0 to the curve's length 4.0");
  EXPECT_ERROR(parameterAtLength(curve, 4.001), "length: must be from 0 to the curve's length 4.0");
  EXPECT_ERROR(parameterAtLength(curve, std::numeric_limits<double>::quiet_NaN()),
               "length: must be from 0");
}

}  // namespace
}  // namespace osculate::test
