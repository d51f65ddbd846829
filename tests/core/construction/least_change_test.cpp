#include "osculate/construction/least_change.h"

#include <gtest/gtest.h>

#include "construction/match_samples.h"
#include "osculate/construction/curve_head.h"
#include "osculate/continuity/curve_joins.h"
#include "osculate/differential/arc_length.h"

namespace osculate::test {
namespace {

BSplineCurve withDisplacement(const BSplineCurve& curve, const Poles& displacement) {
  BSplineData data = curve.data();
  data.poles.leftCols(displacement.cols()) += displacement;
  return BSplineCurve(std::move(data));
}

struct ChangeSample {
  KnotVector knots;
  ChangeWindow window;  ///< of a curve of degree 4, two derivatives kept at the far end
};

const std::vector<ChangeSample>& samples() {
  static const std::vector<ChangeSample> kSamples{
      {{{0, 1}, {5, 5}}, {1, 2, true}},
      {{{0, 1, 2.5, 3}, {5, 1, 1, 5}}, {3, 4, true}},
      {{{0, 1, 2, 3, 4, 5, 6}, {5, 1, 1, 1, 1, 1, 5}}, {4, 4, false}},
      {{{0, 1, 2, 3, 4}, {5, 3, 2, 4, 5}}, {2, 5, false}},
  };
  return kSamples;
}

TEST(LeastChange, CostIsTheIntegralAndNothingBeyondTheWindowMoves) {
  Random random(360);
  for (const bool rational : {false, true}) {
    for (const ChangeSample& sample : samples()) {
      const BSplineCurve curve(randomSplineData(random, 4, sample.knots, rational));
      const LeastChange change =
          leastChange(curveHead(curve, CurveEnd::kStart, sample.window.spans), knotContacts(curve),
                      sample.window, 2);
      Poles first(3, 2);
      first << random.vector(1.0), random.vector(1.0);
      const Poles displacement = first * change.response.transpose();
      EXPECT_EQ(displacement.cols(), sample.window.poles);
      EXPECT_EQ(displacement.leftCols(2), first);
      const BSplineCurve moved = withDisplacement(curve, displacement);
      double stated = 0.0;
      for (int axis = 0; axis < 3; ++axis)
        stated += (first.row(axis) * change.cost * first.row(axis).transpose())(0, 0);
      EXPECT_NEAR(integralOfSquares(curve, moved), stated, 1e-5 * stated);
      const BezierSegment last = curve.segment(sample.window.spans - 1);
      EXPECT_NEAR(change.lengthMm, length(curve, curve.first(), last.last), 1e-6);
      for (int span = sample.window.spans; span < curve.spanCount(); ++span)
        EXPECT_TRUE(identical(curve.segment(span).curve, moved.segment(span).curve));
    }
  }
}

TEST(LeastChange, IsTheLeastUnderItsConstraints) {
  // any other displacement that keeps the contacts costs more: x + e (y - x) for random y of the
  // same kind, made as the answer for another curve's arc length
  Random random(361);
  for (const ChangeSample& sample : samples()) {
    const BSplineData data = randomSplineData(random, 4, sample.knots, false);
    const BSplineCurve curve(data);
    BSplineData other = data;
    for (auto pole : other.poles.colwise())
      pole += random.vector(3.0);
    const auto solve = [&](const BSplineCurve& measure) {
      return leastChange(curveHead(measure, CurveEnd::kStart, sample.window.spans),
                         knotContacts(curve), sample.window, 2);
    };
    const LeastChange least = solve(curve);
    const LeastChange beside = solve(BSplineCurve(other));
    Poles first(3, 2);
    first << random.vector(1.0), random.vector(1.0);
    const auto cost = [&](double share) {
      const Eigen::MatrixXd response = (1.0 - share) * least.response + share * beside.response;
      return integralOfSquares(curve, withDisplacement(curve, first * response.transpose()));
    };
    if ((least.response - beside.response).norm() < 1e-9) continue;  // nothing is free
    for (const double share : {-0.5, -0.05, 0.05, 0.5})
      EXPECT_GT(cost(share), cost(0.0));
  }
}

TEST(LeastChange, KeepsTheContactOfMultipleKnots) {
  // quintic pieces of one curve with knots that do not fit them: G4 but only C0
  Random random(362);
  const auto [left, right] = randomBezier(random, 5, true).split(0.3);
  BSplineData data{.poles = Poles(3, 11),
                   .weights = {},
                   .knots = {{0, 1, 2}, {6, 5, 6}},
                   .degree = 5,
                   .periodic = false,
                   .poleError = 0.0};
  const double factor = left.weight(5) / right.weight(0);
  for (int i = 0; i <= 10; ++i) {
    data.poles.col(i) = i <= 5 ? left.pole(i) : right.pole(i - 5);
    data.weights.push_back(i <= 5 ? left.weight(i) : factor * right.weight(i - 5));
  }
  const BSplineCurve curve(data);
  const auto contacts = knotContacts(curve);
  ASSERT_EQ(contacts[0].order, 4);
  const LeastChange change = leastChange(curve, contacts, {2, 8, true}, 3);
  Poles first(3, 3);
  first << random.vector(1.0), random.vector(1.0), random.vector(1.0);
  const BSplineCurve moved = withDisplacement(curve, first * change.response.transpose());
  const AnalysisOptions exact{.order = 4, .tolerances = Tolerances::preset("exact")};
  EXPECT_EQ(analyzeInnerJoins(moved, exact)[0].report.order, 4);
}

}  // namespace
}  // namespace osculate::test
