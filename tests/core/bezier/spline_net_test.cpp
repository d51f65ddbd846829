#include "osculate/bezier/spline_net.h"

#include <gtest/gtest.h>

#include "osculate/bezier/index.h"
#include "support/knot_insertion.h"
#include "support/spline_samples.h"

namespace osculate::test {
namespace {

void expectSamePoints(const BSplineCurve& actual, const BSplineCurve& expected) {
  for (int i = 0; i <= 40; ++i) {
    const double t = std::lerp(expected.first(), expected.last(), i / 40.0);
    EXPECT_LE((actual.evaluate(t) - expected.evaluate(t)).norm(), tolerance(expected)) << t;
  }
}

TEST(SplineNet, IsTheClampedCurve) {
  for (const SplineSample& sample : splineSamples(90)) {
    SCOPED_TRACE(sample.name);
    const BSplineCurve curve(sample.data);
    const SplineNet net = clampedNet(curve);
    EXPECT_EQ(net.flat.size(), net.poles.size() + static_cast<std::size_t>(net.degree) + 1);
    EXPECT_EQ(net.find(curve.first()).multiplicity, curve.degree() + 1);
    expectSamePoints(curveOf(net), curve);
  }
}

TEST(SplineNet, OfAClosedCurveIsPeriodicWithAClosingOfFullMultiplicity) {
  for (const SplineSample& sample : splineSamples(91)) {
    if (!sample.data.periodic) continue;
    SCOPED_TRACE(sample.name);
    const BSplineCurve curve(sample.data);
    const SplineNet net = periodicNet(clampedNet(curve));
    EXPECT_EQ(net.find(curve.first()).multiplicity, curve.degree());
    EXPECT_EQ(openedNet(net).flat.size(), net.flat.size() + index(net.degree) + 2U);
    expectSamePoints(curveOf(openedNet(net)), curve);
    const BSplineCurve again = curveOf(net, 0.5);
    EXPECT_TRUE(again.isPeriodic());
    EXPECT_EQ(again.poleError(), 0.5);
    EXPECT_EQ(again.first(), curve.first());
    EXPECT_EQ(again.last(), curve.last());
    expectSamePoints(again, curve);
  }
}

TEST(SplineNet, OfOnePeriodGoesOnBeyondItsEnds) {
  SplineNet net;
  net.flat = {0.0, 1.0, 2.5};
  net.poles = {Eigen::Vector4d::Constant(1), Eigen::Vector4d::Constant(2),
               Eigen::Vector4d::Constant(3)};
  net.period = 4.0;
  EXPECT_EQ(net.knot(-1), -1.5);
  EXPECT_EQ(net.knot(-3), -4.0);
  EXPECT_EQ(net.knot(3), 4.0);
  EXPECT_EQ(net.knot(7), 9.0);
  EXPECT_EQ(net.pole(-1)[0], 3.0);
  EXPECT_EQ(net.pole(-4)[0], 3.0);
  EXPECT_EQ(net.pole(4)[0], 2.0);
}

TEST(SplineNet, HasTheBezierNetsOfTheCurve) {
  for (const SplineSample& sample : splineSamples(92)) {
    SCOPED_TRACE(sample.name);
    const BSplineCurve curve(sample.data);
    const SplineNet clamped = clampedNet(curve);
    const SplineNet net = sample.data.periodic ? periodicNet(clamped) : clamped;
    for (int span = 0; span < curve.spanCount(); ++span) {
      const BezierSegment segment = curve.segment(span);
      const double last = segment.first + 0.5 * segment.length();
      const Net half = bezierNet(net, segment.first, last);
      EXPECT_EQ(half.rows(), sample.data.weights.empty() ? 3 : 4);
      const double share = (last - segment.first) / segment.length();
      const Net expected = toNet(segment.curve.segment(0.0, share).view());
      // the knots of a periodic curve that begins beyond 0 round by a shift by the period
      EXPECT_LE((half - expected).cwiseAbs().maxCoeff(), 2000.0 * tolerance(curve)) << span;
    }
  }
}

TEST(SplineNet, TestsInsertKnotsWithoutChangingTheCurve) {
  for (const SplineSample& sample : splineSamples(93)) {
    SCOPED_TRACE(sample.name);
    const BSplineCurve curve(sample.data);
    if (curve.degree() == kMaxDegree) continue;
    const SplineNet clamped = clampedNet(curve);
    const SplineNet net = sample.data.periodic ? periodicNet(clamped) : clamped;
    const double u = std::lerp(curve.first(), curve.last(), 0.43);
    const SplineNet finer = inserted(net, u, curve.degree());
    EXPECT_EQ(finer.find(u).multiplicity, curve.degree());
    expectSamePoints(curveOf(finer), curve);
  }
}

}  // namespace
}  // namespace osculate::test
