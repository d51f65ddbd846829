#include "osculate/bezier/raised_net.h"

#include <gtest/gtest.h>

#include "support/errors.h"
#include "support/spline_samples.h"

namespace osculate::test {
namespace {

TEST(RaisedNet, IsTheElevatedCurve) {
  for (const SplineSample& sample : splineSamples(130)) {
    if (sample.isTorn()) continue;
    for (const int times : {0, 1, 2, 5}) {
      if (sample.data.degree + times > kMaxDegree || sample.data.periodic) continue;
      SCOPED_TRACE(sample.name + " raised by " + std::to_string(times));
      const BSplineCurve whole(sample.data);
      const BSplineCurve curve = whole.trimmed(whole.first(), whole.last());
      const BSplineCurve raised = curveOf(raisedNet(curve, times));
      const BSplineCurve expected = curve.elevated(times);
      EXPECT_EQ(raised.data().knots.knots, expected.data().knots.knots);
      ASSERT_EQ(raised.data().knots.multiplicities, expected.data().knots.multiplicities);
      const double size = curve.data().poles.colwise().norm().maxCoeff();
      EXPECT_LE((raised.data().poles - expected.data().poles).colwise().norm().maxCoeff(),
                1e-10 * size);
      for (int i = 0; i <= 60; ++i) {
        const double t = std::lerp(curve.first(), curve.last(), i / 60.0);
        EXPECT_LE((raised.evaluate(t) - curve.evaluate(t)).norm(), 1e-13 * size) << t;
      }
    }
  }
}

TEST(RaisedNet, ReachesTheHighestDegreeAtOnce) {
  Random random(131);
  KnotVector knots{{0}, {4}};
  for (int i = 1; i < 200; ++i) {
    knots.knots.push_back(i + random.uniform(-0.4, 0.4));
    knots.multiplicities.push_back(random.integer(1, 3));
  }
  knots.knots.push_back(200);
  knots.multiplicities.push_back(4);
  for (const bool rational : {false, true}) {
    const BSplineCurve curve(randomSplineData(random, 3, knots, rational));
    const BSplineCurve raised = curveOf(raisedNet(curve, 22));
    EXPECT_EQ(raised.degree(), 25);
    for (std::size_t i = 1; i < 200; ++i)
      EXPECT_EQ(raised.data().knots.multiplicities[i], knots.multiplicities[i] + 22);
    const double size = curve.data().poles.colwise().norm().maxCoeff();
    for (int i = 0; i <= 2000; ++i)
      EXPECT_LE((raised.evaluate(i / 10.0) - curve.evaluate(i / 10.0)).norm(), 1e-13 * size) << i;
  }
}

TEST(RaisedNet, NamesDegreesThatAreTooHigh) {
  Random random(132);
  EXPECT_ERROR(raisedNet(BSplineCurve(randomBezier(random, 20, false)), 6), "times: ");
}

}  // namespace
}  // namespace osculate::test
