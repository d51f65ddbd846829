// The degree and the window of a match, against counts by hand.
#include "osculate/construction/match_plan.h"

#include <gtest/gtest.h>

#include "construction/match_samples.h"
#include "osculate/construction/contact_error.h"
#include "support/errors.h"

namespace osculate::test {
namespace {

MatchPlan planOf(int degree, int spans, const MatchOptions& options) {
  Random random(400);
  const BSplineCurve curve = wave(random, degree, spans);
  const std::vector<KnotContact> contacts(static_cast<std::size_t>(spans - 1),
                                          KnotContact{.multiplicity = 1, .order = degree - 1});
  return planMatch(curve, contacts, options);
}

TEST(MatchPlan, ASingleSpanNeedsPolesForBothEnds) {
  // n + 1 = (m+1) + (keep+1)
  for (int order = 0; order <= kMaxOrder; ++order) {
    for (int keep = 0; keep <= kMaxOrder; ++keep) {
      const MatchPlan plan = planOf(1, 1, {.order = order, .keep = keep});
      EXPECT_EQ(plan.degree, order + std::min(keep, plan.degree) + 1);
      EXPECT_EQ(plan.window.spans, 1);
      EXPECT_EQ(plan.window.poles, order + 1);
      EXPECT_TRUE(plan.window.wholeCurve);
    }
  }
}

TEST(MatchPlan, EachSpanOfASimpleKnotAddsOneFreedom) {
  for (int degree = 2; degree <= 7; ++degree) {
    for (int order = 0; order <= degree; ++order) {
      const MatchPlan plan = planOf(degree, 100, {.order = order});
      EXPECT_EQ(plan.degree, degree);
      // n + 1 of the first span, 1 of each further one, less the n conditions at the end
      EXPECT_EQ(plan.window.spans, order + 1 + 2 * (degree + 1));
      EXPECT_EQ(plan.window.poles, plan.window.spans);
      EXPECT_FALSE(plan.window.wholeCurve);
      EXPECT_EQ(plan.window.spans, mostUsefulSpans(degree, {.order = order}));
    }
  }
}

TEST(MatchPlan, AskedForSpansAreTheMost) {
  for (int spans = 3; spans <= 20; ++spans)
    EXPECT_EQ(planOf(3, 100, {.order = 2, .spans = spans}).window.spans, std::min(spans, 11));
  EXPECT_ERROR(planOf(3, 100, {.order = 2, .spans = 2}), "order 2 needs at least 3");
}

TEST(MatchPlan, TheOrderRaisesTheDegree) {
  EXPECT_EQ(planOf(3, 100, {.order = 5}).degree, 5);
  EXPECT_EQ(planOf(3, 100, {.order = 5, .degree = 7}).degree, 7);
  EXPECT_ERROR(planOf(3, 100, {.order = 5, .degree = 4}), "needs one from 5 to 25, got 4");
}

}  // namespace
}  // namespace osculate::test
