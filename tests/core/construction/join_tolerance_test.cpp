// Joins with a tolerance: gaps closed and knots lowered (joined_net.cpp).
#include <gtest/gtest.h>

#include "construction/join_checks.h"
#include "osculate/construction/join.h"

namespace osculate {
namespace {

using namespace test;

/// Every pole of every piece moved by up to `amount` in each coordinate.
std::vector<BSplineCurve> shaken(Random& random, const std::vector<BSplineCurve>& parts,
                                 double amount) {
  std::vector<BSplineCurve> result;
  for (const BSplineCurve& part : parts) {
    BSplineData data = part.data();
    for (Eigen::Index i = 0; i < data.poles.cols(); ++i)
      data.poles.col(i) += random.vector(amount);
    result.emplace_back(data);
  }
  return result;
}

int poleCount(const Construction& result) {
  return static_cast<int>(result.curve.data().poles.cols());
}

/// Within the tolerance, and the displacement is that of the points, from above and not idle.
void expectWithin(const Construction& result, const std::vector<BSplineCurve>& parts,
                  double toleranceMm) {
  const double traced = tracedDistance(result, parts, toleranceMm);
  EXPECT_LE(*result.maxDisplacementMm, toleranceMm * (1.0 + 1e-9));
  EXPECT_GE(*result.maxDisplacementMm, traced * (1.0 - 1e-9));
  EXPECT_LE(*result.maxDisplacementMm, 1.2 * traced);  // 51 points miss the maximum by little
}

TEST(JoinTolerance, ClosesGapsHalfWayEach) {
  const std::vector<BSplineCurve> parts{segment({0, 0, 0}, {1, 0, 0}),
                                        segment({1, 0.002, 0}, {1, 5, 0})};
  EXPECT_THROW(joinCurves(parts), ContactError);
  EXPECT_THROW(joinCurves(parts, 0.0009), ContactError);
  const Construction result = joinCurves(parts, 0.001);
  EXPECT_NEAR(*result.maxDisplacementMm, 0.001, 2e-6);
  EXPECT_GE(*result.maxDisplacementMm, 0.001 * (1.0 - 1e-12));
  EXPECT_EQ(result.curve.data().poles.col(1), Vector3(1, 0.001, 0));
  ASSERT_EQ(result.warnings.size(), 2U);
  EXPECT_EQ(result.warnings[0],
            "gap: closed at 1 join (0.002 mm, between curves[0] and curves[1])");
  EXPECT_NEAR(result.inputJoins[0].report.deviation.gapMm, 0.002, 1e-12);
  EXPECT_EQ(result.inputJoins[0].report.order, -1);
  EXPECT_EQ(result.joins[0].report.order, 0);
}

TEST(JoinTolerance, FindsTheMultiplicitiesUnderNoise) {
  Random random(230);
  for (const bool rational : {false, true}) {
    for (const int degree : {2, 3, 5}) {
      SCOPED_TRACE(testing::Message() << degree << rational);
      const BSplineCurve whole = randomSpline(random, degree, degree - 1, rational);
      const auto clean = pieces(whole, {0.3, 0.8, 1.1, 2.5, 3.1});
      const auto parts = disguised(random, shaken(random, clean, 1e-6), {});
      const Construction result = joinCurves(parts, 1e-4);
      EXPECT_EQ(result.curve.data().knots.multiplicities, whole.data().knots.multiplicities);
      expectWithin(result, parts, 1e-4);
    }
  }
}

TEST(JoinTolerance, IsNeverExceeded) {
  Random random(231);
  for (const bool rational : {false, true}) {
    const BSplineCurve whole = randomSpline(random, 4, 3, rational);
    const auto clean = pieces(whole, {0.3, 0.8, 1.1, 2.5, 3.1});
    const auto parts = disguised(random, shaken(random, clean, 1e-3), {.elevate = 1});
    int before = 1000;
    for (const double tolerance : {0.0021, 0.01, 0.1, 1.0}) {
      SCOPED_TRACE(tolerance);
      const Construction result = joinCurves(parts, tolerance);
      expectWithin(result, parts, tolerance);
      EXPECT_LE(poleCount(result), before);
      before = poleCount(result);
    }
    EXPECT_LT(before, 20);
  }
}

TEST(JoinTolerance, SmoothsEveryJoinBeforeOneMore) {
  Random random(232);
  const BSplineCurve whole(randomBezier(random, 5, false));
  const auto parts = shaken(random, pieces(whole, {0.25, 0.5, 0.75}), 1e-4);
  const Construction result = joinCurves(parts, 5e-4);
  int lowest = 5;
  int highest = 0;
  for (const BSplineCurve::InnerKnot& knot : result.curve.innerKnots()) {
    lowest = std::min(lowest, knot.multiplicity);
    highest = std::max(highest, knot.multiplicity);
  }
  EXPECT_LT(highest, 5);
  for (const CurveJoin& join : result.joins)
    EXPECT_GE(join.report.parametricOrder, 1);
}

TEST(JoinTolerance, LeavesInnerKnotsOfTheInputsAlone) {
  Random random(233);
  const BSplineCurve whole = randomSpline(random, 3, 2, false);
  const auto parts = pieces(whole, {1.1});
  const Construction result = joinCurves(parts, 10.0);
  EXPECT_EQ(result.curve.data().knots.multiplicities, whole.data().knots.multiplicities);
  EXPECT_LE(*result.maxDisplacementMm, 1e-13 * size(whole));
}

TEST(JoinTolerance, ClosesAChain) {
  Random random(234);
  const KnotVector knots{{0, 0.8, 2, 2.5, 4, 5}, {1, 1, 2, 1, 1, 1}};
  for (const bool rational : {false, true}) {
    const BSplineCurve loop(randomSplineData(random, 3, knots, rational, true));
    const auto parts = shaken(random, pieces(loop, {0, 1.3, 2.5, 4.4}), 1e-6);
    const Construction result = joinCurves(parts, 1e-4);
    EXPECT_TRUE(result.curve.isPeriodic());
    EXPECT_EQ(result.curve.data().knots.multiplicities, knots.multiplicities);
    expectWithin(result, parts, 1e-4);
  }
}

TEST(JoinTolerance, OfShortLoopsIsNotExceededEither) {
  Random random(235);
  const KnotVector knots{{0, 1, 2, 3}, {1, 1, 1, 1}};
  const BSplineCurve loop(randomSplineData(random, 3, knots, false, true));
  const auto parts = shaken(random, pieces(loop, {0, 1, 2}), 1e-3);
  for (const double tolerance : {0.01, 0.1, 1.0, 10.0})
    expectWithin(joinCurves(parts, tolerance), parts, tolerance);
}

TEST(JoinTolerance, DoesNotCloseAChainHardlyLongerThanItsOpening) {
  const std::vector<BSplineCurve> parts{segment({0, 0, 0}, {1, 0, 0}),
                                        segment({1, 0, 0}, {1, 1, 0})};
  EXPECT_FALSE(joinCurves(parts, 0.1).curve.isClosed(0.5));
  const Construction wide = joinCurves(parts, 2.0);
  EXPECT_FALSE(wide.curve.isClosed(0.5));
  EXPECT_EQ(wide.joins.size(), 1U);
}

TEST(JoinTolerance, OfAThousandCurvesTakesNoLongTime) {
  Random random(236);
  KnotVector knots{{0}, {6}};
  std::vector<double> cuts;
  for (int i = 1; i < 1000; ++i) {
    knots.knots.push_back(i);
    knots.multiplicities.push_back(2);
    cuts.push_back(i);
  }
  knots.knots.push_back(1000);
  knots.multiplicities.push_back(6);
  const BSplineCurve whole(randomSplineData(random, 5, knots, false));
  const auto parts = disguised(random, shaken(random, pieces(whole, cuts), 1e-6), {});
  const Construction result = joinCurves(parts, 1e-4);
  EXPECT_EQ(result.curve.data().knots.multiplicities, knots.multiplicities);
  expectWithin(result, parts, 1e-4);
}

}  // namespace
}  // namespace osculate
