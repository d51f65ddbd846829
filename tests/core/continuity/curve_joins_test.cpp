#include "osculate/continuity/curve_joins.h"

#include <limits>

#include "support/errors.h"
#include "support/joins.h"
#include "support/spline_samples.h"

namespace osculate::test {
namespace {

using enum CurveEnd;

BSplineCurve lineOf(const Vector3& from, const Vector3& to) {
  return BSplineCurve(bezier({from, to}));
}

TEST(NearestEnds, AreEachOfTheFourPairs) {
  const BSplineCurve curve = lineOf({0, 0, 0}, {10, 0, 0});
  const auto ends = [&](const Vector3& from, const Vector3& to) {
    return nearestEnds(curve, lineOf(from, to), 1e-3).ends;
  };
  EXPECT_EQ(ends({10, 1, 0}, {20, 0, 0}), (JoinEnds{kEnd, kStart}));
  EXPECT_EQ(ends({20, 0, 0}, {10, 1, 0}), (JoinEnds{kEnd, kEnd}));
  EXPECT_EQ(ends({0, 1, 0}, {-20, 0, 0}), (JoinEnds{kStart, kStart}));
  EXPECT_EQ(ends({-20, 0, 0}, {0, 1, 0}), (JoinEnds{kStart, kEnd}));
}

TEST(NearestEnds, OnATieAreEndAndStart) {
  const BSplineCurve curve = lineOf({0, 0, 0}, {10, 0, 0});
  const NearestEnds back = nearestEnds(curve, lineOf({10, 0, 0}, {0, 5e-4, 0}), 1e-3);
  EXPECT_EQ(back.ends, (JoinEnds{kEnd, kStart}));
  EXPECT_TRUE(back.touchesAtBothEnds);
  const NearestEnds apart = nearestEnds(curve, lineOf({10, 3, 0}, {0, 3, 0}), 1e-3);
  EXPECT_EQ(apart.ends, (JoinEnds{kEnd, kStart}));
  EXPECT_FALSE(apart.touchesAtBothEnds) << "equally near is not touching";
}

TEST(NearestEnds, SeeCurvesThatRunTheSameWayTouchAtBothEnds) {
  const BSplineCurve straight = lineOf({0, 0, 0}, {10, 0, 0});
  const BSplineCurve bow(bezier({{0, 0, 0}, {5, 5, 0}, {10, 0, 0}}));
  const NearestEnds nearest = nearestEnds(straight, bow, 1e-3);
  EXPECT_TRUE(nearest.touchesAtBothEnds);
  EXPECT_EQ(nearest.ends, (JoinEnds{kEnd, kEnd}));
}

TEST(AnalyzeCurves, TakesGivenEndsEvenIfOthersAreNearer) {
  const BSplineCurve first = lineOf({0, 0, 0}, {10, 0, 0});
  const BSplineCurve second = lineOf({10, 0, 0}, {20, 0, 0});
  EXPECT_EQ(analyzeCurves(first, second).report.order, 4);
  const JoinReport given = analyzeCurves(first, second, {}, JoinEnds{kStart, kEnd}).report;
  EXPECT_EQ(given.order, -1);
  EXPECT_EQ(given.residuals[0], 20.0);
  EXPECT_FALSE(given.warnings.has(Warning::kTouchesAtBothEnds));
}

TEST(AnalyzeCurves, ReturnsTheSegmentsThatMeetAndTheirParameters) {
  Random random(280);
  const BSplineCurve spline(randomSplineData(random, 3, {{0, 1, 2, 5}, {4, 1, 1, 4}}, true));
  const BSplineCurve line = lineOf(spline.endPoint(kEnd), spline.endPoint(kEnd) + Vector3(1, 0, 0));
  const CurveJoin found = analyzeCurves(spline, line);
  EXPECT_EQ(found.firstSegment.first, 2.0);
  EXPECT_EQ(found.firstSegment.last, 5.0);
  EXPECT_TRUE(identical(found.firstSegment.curve, spline.segment(2).curve));
  EXPECT_FALSE(found.parameter);
}

TEST(AnalyzeCurves, ScaleIsTheReachOfTheWholeCurvesNotOfTheirSpans) {
  Random random(281);
  const BSplineCurve spline(randomSplineData(random, 3, {{0, 1e-6, 2, 5}, {4, 1, 1, 4}}, false));
  const BSplineCurve line =
      lineOf(spline.endPoint(kStart) - Vector3(100, 0, 0), spline.endPoint(kStart));
  const Vector3& start = spline.endPoint(kStart);
  const double reach =
      std::max((spline.endPoint(kEnd) - start).norm(), (spline.middlePoint() - start).norm());
  EXPECT_DOUBLE_EQ(analyzeCurves(line, spline).report.scaleMm, reach);
}

TEST(AnalyzeCurves, HalvesOfASplineJoinSmoothlyWhereverItIsCut) {
  for (const SplineSample& sample : splineSamples(282)) {
    if (sample.data.degree > 5 || sample.data.periodic) continue;
    SCOPED_TRACE(sample.name);
    const BSplineCurve curve(sample.data);
    const auto [left, right] = curve.split(0.3 * curve.first() + 0.7 * curve.last());
    const JoinReport report = analyzeCurves(left, right, {}, JoinEnds{}).report;
    EXPECT_EQ(report.order, 4);
    EXPECT_EQ(report.parametricOrder, 4) << "the parameter runs on";
  }
}

TEST(AnalyzeCurves, TheErrorOfPolesEntersTheUncertaintyAndIsToldOf) {
  const BSplineCurve first = lineOf({0, 0, 0}, {10, 0, 0});
  const BSplineCurve second = lineOf({10, 0, 0}, {20, 0, 0}).withPoleError(2e-3);
  const JoinReport report = analyzeCurves(first, second).report;
  EXPECT_TRUE(report.warnings.has(Warning::kApproximated));
  EXPECT_GE(report.uncertainties[0], 2e-3);
  EXPECT_EQ(report.verdicts[0], Verdict::kUndecided);
  EXPECT_EQ(report.order, -1);
  EXPECT_FALSE(
      analyzeCurves(first, second.withPoleError(0.0)).report.warnings.has(Warning::kApproximated));
}

TEST(ReportCurves, IsTheReportOfAnalyzeCurves) {
  Random random(283);
  const auto [first, second] = randomJoin(random, 2, 5);
  const BSplineCurve a(first);
  const BSplineCurve b(second);
  const JoinReport expected = analyzeCurves(a, b, {}, JoinEnds{}).report;
  const JoinReport found = reportCurves(a, b, {}, JoinEnds{});
  EXPECT_EQ(found.residuals, expected.residuals);
  EXPECT_EQ(found.order, expected.order);
}

TEST(AnalyzeInnerJoins, FindTheSmoothnessThatTheMultiplicityOfEachKnotLeaves) {
  Random random(284);
  const BSplineCurve curve(
      randomSplineData(random, 5, {{0, 1, 2, 3, 4, 5, 6, 7}, {6, 1, 2, 3, 4, 5, 6, 6}}, false));
  const std::vector<CurveJoin> joins = analyzeInnerJoins(curve, withPreset("osculate"));
  ASSERT_EQ(joins.size(), 6U);
  const int expected[] = {4, 3, 2, 1, 0, -1};
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(joins[i].parameter, static_cast<double>(i + 1));
    EXPECT_EQ(joins[i].report.order, expected[i]) << "degree 5, multiplicity " << i + 1;
    EXPECT_EQ(joins[i].report.parametricOrder, expected[i]);
    EXPECT_EQ(joins[i].secondSegment.first, joins[i].parameter);
  }
}

TEST(AnalyzeInnerJoins, EndWithTheClosingOfAClosedCurve) {
  Random random(285);
  const BSplineCurve periodic(
      randomSplineData(random, 5, {{0, 1, 2, 3}, {2, 1, 1, 2}}, false, true));
  const std::vector<CurveJoin> joins = analyzeInnerJoins(periodic);
  ASSERT_EQ(joins.size(), 3U);
  EXPECT_FALSE(joins.back().parameter);
  EXPECT_EQ(joins.back().report.order, 3) << "degree 5, seam of multiplicity 2";
  EXPECT_EQ(joins.back().report.sides[0].end, kEnd);
  EXPECT_EQ(analyzeClosing(periodic).report.order, 3);
}

TEST(AnalyzeInnerJoins, OfOneOpenSegmentAreNone) {
  EXPECT_TRUE(analyzeInnerJoins(lineOf({0, 0, 0}, {1, 0, 0})).empty());
}

TEST(AnalyzeInnerJoins, ReportProgressAndStopWhereItSaysSo) {
  Random random(286);
  const BSplineCurve curve(
      randomSplineData(random, 2, {{0, 1, 2, 3, 4, 5}, {3, 1, 1, 1, 1, 3}}, false));
  std::vector<double> shares;
  const auto all = analyzeInnerJoins(curve, {}, [&](double share) {
    shares.push_back(share);
    return true;
  });
  EXPECT_EQ(all.size(), 4U);
  EXPECT_EQ(shares, (std::vector<double>{0.0, 0.25, 0.5, 0.75, 1.0}));
  const auto some = analyzeInnerJoins(curve, {}, [](double share) { return share < 0.5; });
  EXPECT_EQ(some.size(), 2U) << "what was done is returned";
}

TEST(AnalyzeAt, AKnotIsTheJoinOfItsSegments) {
  Random random(91);
  const KnotVector knots{{0, 1, 2.5, 4, 5}, {6, 2, 3, 5, 6}};
  const BSplineCurve curve(randomSplineData(random, 5, knots, true));
  const std::vector<CurveJoin> joins = analyzeInnerJoins(curve);
  for (std::size_t i = 0; i < joins.size(); ++i) {
    const CurveJoin join = analyzeAt(curve, knots.knots[i + 1]);
    EXPECT_EQ(join.report.order, joins[i].report.order);
    EXPECT_EQ(join.report.residuals, joins[i].report.residuals);
    EXPECT_EQ(join.report.scaleMm, joins[i].report.scaleMm);
    EXPECT_EQ(join.parameter, joins[i].parameter);
  }
}

TEST(AnalyzeAt, AParameterBetweenKnotsCutsASegment) {
  Random random(92);
  const BSplineCurve curve(randomSplineData(random, 4, {{0, 1, 2.5, 4}, {5, 2, 1, 5}}, false));
  const CurveJoin join = analyzeAt(curve, 1.5);
  EXPECT_EQ(join.report.order, 4);
  EXPECT_EQ(join.report.parametricOrder, 4);
  EXPECT_EQ(join.parameter, 1.5);
  EXPECT_EQ(join.firstSegment.first, 1.0);
  EXPECT_EQ(join.firstSegment.last, 1.5);
  EXPECT_EQ(join.secondSegment.last, 2.5);
  EXPECT_LE((join.secondSegment.curve.pole(0) - curve.evaluate(1.5)).norm(), 1e-13);
}

TEST(AnalyzeAt, NamesAParameterThatIsNotInside) {
  const BSplineCurve curve = lineOf({0, 0, 0}, {10, 0, 0});
  for (const double bad : {-0.5, 0.0, 1.0, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_ERROR(analyzeAt(curve, bad), "parameter: must be inside (0.0");
}

TEST(CheckOptions, NamesWhatIsOutOfRange) {
  AnalysisOptions options;
  EXPECT_NO_THROW(checkOptions(options));
  options.order = 9;
  EXPECT_ERROR(checkOptions(options), "order: must be from 0 to 8, got 9");
  options.order = -1;
  EXPECT_ERROR(checkOptions(options), "order: must be from 0 to 8, got -1");
  options = {};
  options.scaleMm = -1.0;
  EXPECT_ERROR(checkOptions(options), "scale_mm: must be finite and > 0");
  options.scaleMm = std::numeric_limits<double>::quiet_NaN();
  EXPECT_ERROR(checkOptions(options), "scale_mm: must be finite and > 0");
  options = {};
  options.tolerances.third = 0.0;
  EXPECT_ERROR(checkOptions(options), "third: a tolerance must be finite and > 0");
  const BSplineCurve line = lineOf({0, 0, 0}, {1, 0, 0});
  EXPECT_ERROR(analyzeCurves(line, line, options), "third:");
  EXPECT_ERROR(analyzeClosing(line, options), "third:");
  EXPECT_ERROR(analyzeInnerJoins(line, options), "third:");
}

}  // namespace
}  // namespace osculate::test
