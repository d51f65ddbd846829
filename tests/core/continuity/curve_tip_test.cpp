#include "osculate/continuity/curve_tip.h"

#include <gtest/gtest.h>

#include <utility>

#include "osculate/continuity/curve_joins.h"
#include "support/spline_samples.h"

namespace osculate::test {
namespace {

TEST(CurveTip, GivesTheReportsOfTheCurves) {
  const std::vector<SplineSample> samples = splineSamples(5);
  for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
    SCOPED_TRACE(samples[i].name);
    const BSplineCurve first(samples[i].data);
    const BSplineCurve second(samples[i + 1].data);
    for (const CurveEnd a : {CurveEnd::kStart, CurveEnd::kEnd}) {
      for (const CurveEnd b : {CurveEnd::kStart, CurveEnd::kEnd}) {
        const JoinReport report = analyzeTips(CurveTip(first, a), CurveTip(second, b));
        const JoinReport expected = analyzeCurves(first, second, {}, JoinEnds{a, b}).report;
        EXPECT_EQ(report.residuals, expected.residuals);
        EXPECT_EQ(report.uncertainties, expected.uncertainties);
        EXPECT_EQ(report.parametricResiduals, expected.parametricResiduals);
        EXPECT_EQ(report.scaleMm, expected.scaleMm);
        EXPECT_EQ(report.warnings.list(), expected.warnings.list());
      }
    }
  }
}

TEST(CurveTip, LivesWithoutItsCurveAndMoves) {
  Random random(2);
  const BezierCurve whole = randomBezier(random, 5, true);
  const auto [left, right] = whole.split(0.4);
  std::vector<CurveTip> tips;
  for (const BezierCurve& part : {left, right}) {
    tips.emplace_back(BSplineCurve(part), tips.empty() ? CurveEnd::kEnd : CurveEnd::kStart);
    CurveTip moved(std::move(tips.back()));
    tips.back() = std::move(moved);
  }
  EXPECT_EQ(analyzeTips(tips[0], tips[1]).order, 4);
}

TEST(CurveTip, MarksCurvesConvertedWithAnError) {
  Random random(3);
  const BSplineCurve exact(randomBezier(random, 3, false));
  const BSplineCurve fitted = exact.withPoleError(1e-6);
  const auto marked = [](const BSplineCurve& a, const BSplineCurve& b) {
    return analyzeTips(CurveTip(a, CurveEnd::kEnd), CurveTip(b, CurveEnd::kStart))
        .warnings.has(Warning::kApproximated);
  };
  EXPECT_FALSE(marked(exact, exact));
  EXPECT_TRUE(marked(fitted, exact));
  EXPECT_TRUE(marked(exact, fitted));
}

}  // namespace
}  // namespace osculate::test
