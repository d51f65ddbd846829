#include "osculate/bezier/net_distance.h"

#include <gtest/gtest.h>

#include "support/random_curves.h"

namespace osculate::test {
namespace {

double sampledDistance(const BezierCurve& a, const BezierCurve& b) {
  double largest = 0.0;
  for (int i = 0; i <= 5000; ++i)
    largest = std::max(largest, (a.evaluate(i / 5000.0) - b.evaluate(i / 5000.0)).norm());
  return largest;
}

double distanceOf(const BezierCurve& a, const BezierCurve& b) {
  return largestDistance(toNet(a.view()), toNet(b.view()));
}

BezierCurve moved(Random& random, const BezierCurve& curve, double amount) {
  std::vector<Vector3> poles = polesOf(curve);
  std::vector<double> weights = weightsOf(curve);
  for (Vector3& pole : poles)
    pole += random.vector(amount);
  for (double& weight : weights)
    weight *= 1.0 + random.uniform(0.0, 0.01 * amount);
  return BezierCurve(poles, weights);
}

TEST(NetDistance, IsTheMaximumFromAboveWithinAThousandth) {
  Random random(120);
  for (const bool rational : {false, true}) {
    for (const int degree : {1, 3, 8, 25}) {
      for (const double amount : {1.0, 1e-3, 1e-9}) {
        const BezierCurve a = randomBezier(random, degree, rational);
        const BezierCurve b = moved(random, a, amount);
        const double sampled = sampledDistance(a, b);
        EXPECT_GE(distanceOf(a, b), sampled * (1.0 - 1e-6)) << degree << ' ' << amount;
        EXPECT_LE(distanceOf(a, b), sampled * 1.0015) << degree << ' ' << amount;
      }
    }
  }
}

TEST(NetDistance, OfEqualCurvesIsZero) {
  Random random(121);
  for (const bool rational : {false, true}) {
    const BezierCurve curve = randomBezier(random, 5, rational);
    EXPECT_LE(distanceOf(curve, curve), rational ? 1e-15 : 0.0);
  }
}

TEST(NetDistance, TellsWhere) {
  Random random(123);
  for (const bool rational : {false, true}) {
    for (const int degree : {2, 5, 9}) {
      const BezierCurve a = randomBezier(random, degree, rational);
      const BezierCurve b = moved(random, a, 1.0);
      // the same weights, too
      std::vector<Vector3> poles = polesOf(a);
      for (Vector3& pole : poles)
        pole += random.vector(1.0);
      const BezierCurve c(poles, weightsOf(a));
      for (const BezierCurve& other : {b, c}) {
        const FarthestPoints found = farthestPoints(toNet(a.view()), toNet(other.view()));
        const double there = (a.evaluate(found.t) - other.evaluate(found.t)).norm();
        EXPECT_GE(there, 0.998 * found.distanceMm);
        EXPECT_GE(found.distanceMm, sampledDistance(a, other) * (1.0 - 1e-6));
        EXPECT_LE(found.distanceMm, sampledDistance(a, other) * 1.0015);
      }
    }
  }
}

TEST(NetDistance, DoesNotDependOnAFactorOfTheWeights) {
  Random random(122);
  const BezierCurve curve = randomBezier(random, 4, true);
  Net scaled = toNet(curve.view());
  scaled *= 1000.0;
  EXPECT_LE(largestDistance(toNet(curve.view()), scaled), 1e-12);
}

}  // namespace
}  // namespace osculate::test
