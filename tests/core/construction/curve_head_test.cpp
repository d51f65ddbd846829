#include "osculate/construction/curve_head.h"

#include "support/random_curves.h"
#include "support/spline_samples.h"

#include <gtest/gtest.h>

namespace osculate::test {
namespace {

TEST(CurveHead, IsTheCurveFromEitherEnd) {
  Random random(330);
  for (const SplineSample& sample : splineSamples(330)) {
    const BSplineCurve curve = openClamped(BSplineCurve(sample.data));
    const double size = curve.data().poles.colwise().norm().maxCoeff();
    for (const CurveEnd end : {CurveEnd::kStart, CurveEnd::kEnd}) {
      for (int spans = 1; spans <= curve.spanCount(); ++spans) {
        const BSplineCurve head = curveHead(curve, end, spans);
        EXPECT_EQ(head.spanCount(), spans) << sample.name;
        EXPECT_EQ(head.first(), 0.0);
        const double t = random.uniform(0.0, head.last());
        const double own = end == CurveEnd::kStart ? curve.first() + t : curve.last() - t;
        // the parameter is a difference that rounds
        EXPECT_LE((head.evaluate(t) - curve.evaluate(own)).norm(), 1e-11 * size) << sample.name;
      }
    }
  }
}

TEST(CurveHead, HasThePolesAndWeightsBitForBit) {
  Random random(331);
  const BSplineCurve curve(randomSplineData(random, 3, {{0, 1, 2, 3, 4}, {4, 1, 2, 1, 4}}, true));
  const BSplineCurve start = curveHead(curve, CurveEnd::kStart, 2);
  EXPECT_EQ(start.data().poles, curve.data().poles.leftCols(5));
  const BSplineCurve end = curveHead(curve, CurveEnd::kEnd, 1);
  for (int i = 0; i < 4; ++i) {
    const Eigen::Index from = curve.data().poles.cols() - 1 - i;
    EXPECT_EQ(end.data().poles.col(i), curve.data().poles.col(from));
    EXPECT_EQ(end.data().weights[static_cast<std::size_t>(i)],
              curve.data().weights[static_cast<std::size_t>(from)]);
  }
  EXPECT_EQ(curveHead(curve, CurveEnd::kStart, 4).data().poles, curve.data().poles);
}

TEST(CurveHead, OpensPeriodicAndClampsUnclampedCurves) {
  for (const SplineSample& sample : splineSamples(332)) {
    const BSplineCurve open = openClamped(BSplineCurve(sample.data));
    EXPECT_FALSE(open.isPeriodic()) << sample.name;
    EXPECT_EQ(open.data().knots.multiplicities.front(), open.degree() + 1) << sample.name;
    EXPECT_EQ(open.data().knots.multiplicities.back(), open.degree() + 1) << sample.name;
  }
}

}  // namespace
}  // namespace osculate::test
