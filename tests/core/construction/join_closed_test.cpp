// Closed chains joined (join.cpp, joined_net.cpp).
#include <gtest/gtest.h>

#include "construction/join_checks.h"
#include "osculate/construction/join.h"
#include "osculate/differential/arc_length.h"

namespace osculate {
namespace {

using namespace test;

BSplineCurve randomLoop(Random& random, int degree, int multiplicity, bool rational) {
  KnotVector knots{{0, 0.4, 0.8, 1.6, 2, 2.5, 3, 4, 4.7, 5}, std::vector<int>(10, 1)};
  knots.multiplicities.front() = knots.multiplicities.back() = multiplicity;
  return BSplineCurve(randomSplineData(random, degree, knots, rational, true));
}

TEST(JoinClosed, ReturnsThePeriodicSplineThatWasCut) {
  Random random(220);
  for (const bool rational : {false, true}) {
    for (const int degree : {2, 3, 4, 6}) {
      for (int multiplicity = 1; multiplicity < degree; ++multiplicity) {
        SCOPED_TRACE(testing::Message() << degree << ' ' << multiplicity << rational);
        const BSplineCurve loop = randomLoop(random, degree, multiplicity, rational);
        const auto parts = disguised(random, pieces(loop, {0, 0.8, 1.3, 2.5, 4.4}), {});
        const Construction result = joinCurves(parts);
        expectSameCurve(result.curve, loop, 1e-9 * size(loop));
        expectTraces(result, parts, 1e-13);
        ASSERT_EQ(result.joins.size(), 5U);
        EXPECT_EQ(result.joins.back().report.parametricOrder, std::min(4, degree - multiplicity));
        EXPECT_TRUE(result.warnings.empty());
      }
    }
  }
}

TEST(JoinClosed, KeepsOneCopyOfAKnotWhereTheListBegins) {
  Random random(221);
  const BSplineCurve loop = randomLoop(random, 3, 2, false);
  const auto parts = disguised(random, pieces(loop, {1.3, 3.0}), {});
  const Construction result = joinCurves(parts);
  EXPECT_EQ(result.curve.data().knots.multiplicities,
            (std::vector<int>{1, 1, 1, 1, 1, 1, 1, 2, 1, 1, 1}));
  EXPECT_NEAR(result.curve.first(), 1.3, 0.0);
  EXPECT_EQ(result.joins.back().report.parametricOrder, 4);
}

TEST(JoinClosed, OfOneCurveCloses) {
  Random random(222);
  const BSplineCurve loop = randomLoop(random, 3, 1, true);
  expectSameCurve(joinCurves(std::vector{loop}).curve, loop, 1e-11);
  const BSplineCurve clamped = loop.trimmed(loop.first(), loop.last());
  const Construction result = joinCurves(std::vector{clamped});
  expectSameCurve(result.curve, loop, 1e-11);
  EXPECT_EQ(result.joins.size(), 1U);
  EXPECT_EQ(result.inputJoins.size(), 1U);
}

TEST(JoinClosed, LinksSpeedsAcrossTheClosing) {
  // a D: its arc is cut, and the list begins at the cut
  Random random(223);
  const auto [lower, upper] = BSplineCurve(randomBezier(random, 3, false)).split(0.4);
  const Vector3 begin = lower.endPoint(CurveEnd::kStart);
  const Vector3 end = upper.endPoint(CurveEnd::kEnd);
  const std::vector<BSplineCurve> parts{upper.reparametrised(0, 1), segment(end, begin),
                                        lower.reparametrised(2, 9).reversed()};
  const Construction result = joinCurves(parts);
  expectTraces(result, parts, 1e-13);
  EXPECT_TRUE(result.curve.isPeriodic());
  EXPECT_EQ(result.curve.data().knots.multiplicities, (std::vector<int>{1, 3, 3, 1}));
  EXPECT_EQ(result.joins.back().report.parametricOrder, 4);
  ASSERT_EQ(result.warnings.size(), 1U);
  EXPECT_TRUE(result.warnings[0].starts_with("corner: G0 only at 2 joins"));
  // the segment is travelled at the mean speed of the arc
  const double share = (*result.joins[1].parameter - *result.joins[0].parameter) /
                       (result.curve.last() - result.curve.first());
  const double arcLength = length(lower) + length(upper);
  EXPECT_NEAR(share, (end - begin).norm() / ((end - begin).norm() + arcLength), 1e-10);
}

TEST(JoinClosed, IsClampedWhereItClosesWithACorner) {
  const std::vector<BSplineCurve> parts{
      segment({0, 0, 0}, {4, 0, 0}), segment({4, 0, 0}, {4, 3, 0}), segment({0, 0, 0}, {4, 3, 0})};
  const Construction result = joinCurves(parts);
  EXPECT_FALSE(result.curve.isPeriodic());
  EXPECT_TRUE(result.curve.isClosed(0.0));
  EXPECT_EQ(result.curve.data().knots.multiplicities, (std::vector<int>{2, 1, 1, 2}));
  EXPECT_EQ(result.joins.size(), 3U);
  EXPECT_TRUE(result.warnings[0].starts_with("corner: G0 only at 3 joins (the sharpest, 143 deg"));
}

TEST(JoinClosed, OfTheArcsOfACircleIsClamped) {
  const std::vector<BSplineCurve> parts{arc(0, 100), arc(100, 230), arc(230, 360)};
  const Construction result = joinCurves(parts);
  EXPECT_FALSE(result.curve.isPeriodic());
  EXPECT_EQ(result.curve.data().knots.multiplicities, (std::vector<int>{3, 2, 2, 3}));
  EXPECT_EQ(result.joins.back().report.order, 4);
  EXPECT_TRUE(result.warnings.empty());
}

TEST(JoinClosed, OfTwoCurvesBeginsWithTheFirst) {
  const std::vector<BSplineCurve> arcs{arc(10, 170), arc(170, 220), arc(220, 370)};
  const auto lower = joinCurves(std::vector{arcs[1], arcs[2]}).curve;
  for (const BSplineCurve& second : {lower, lower.reversed()}) {
    const Construction result = joinCurves(std::vector{arcs[0], second});
    EXPECT_TRUE(result.curve.isClosed(1e-12));
    EXPECT_LE((result.curve.evaluate(0.5) - arcs[0].evaluate(0.5)).norm(), 1e-14);
  }
}

TEST(JoinClosed, SaysWhereTheSpeedsDoNotCloseUp) {
  // speeds double from the start to the end of the loop
  const std::vector<Vector3> poles{{0, 0, 0},  {1, 0, 0},  {6, 5, 0},
                                   {-6, 5, 0}, {-2, 0, 0}, {0, 0, 0}};
  const Construction result = joinCurves(std::vector{BSplineCurve(BezierCurve(poles))});
  EXPECT_FALSE(result.curve.isPeriodic());
  ASSERT_EQ(result.warnings.size(), 1U);
  EXPECT_EQ(result.warnings[0],
            "speed: smooth but at two speeds, so that the knot keeps its full multiplicity, at 1 "
            "join (2 times, between curves[0] and curves[0])");
}

TEST(JoinClosed, OfTwoCubicsMayBeOnePeriodicSpan) {
  // few poles: what a removal changes reaches almost around
  Random random(224);
  const KnotVector knots{{0, 1, 2, 3}, {1, 1, 1, 1}};
  const BSplineCurve loop(randomSplineData(random, 3, knots, false, true));
  const auto parts = disguised(random, pieces(loop, {0, 1, 2}), {});
  expectSameCurve(joinCurves(parts).curve, loop, 1e-11);
}

}  // namespace
}  // namespace osculate
