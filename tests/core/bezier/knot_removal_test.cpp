#include "osculate/bezier/knot_removal.h"

#include <gtest/gtest.h>

#include "support/knot_insertion.h"
#include "support/spline_samples.h"

namespace osculate::test {
namespace {

double size(const SplineNet& net) {
  double largest = 0.0;
  for (const Eigen::Vector4d& pole : net.poles)
    largest = std::max(largest, project(pole).norm());
  return largest;
}

void expectSameNet(const SplineNet& actual, const SplineNet& expected, double tolerance) {
  ASSERT_EQ(actual.flat, expected.flat);
  ASSERT_EQ(actual.poles.size(), expected.poles.size());
  for (std::size_t i = 0; i < expected.poles.size(); ++i)
    EXPECT_LE((actual.poles[i] - expected.poles[i]).norm(), tolerance) << i;
}

/// A clamped or periodic net with spans of different lengths, and at 2 a knot of this multiplicity.
SplineNet randomNet(Random& random, int degree, bool rational, bool periodic, int multiplicity) {
  const int end = periodic ? std::min(degree, 2) : degree + 1;
  KnotVector knots{{0, 0.7, 2, 2.4, 3.5, 4, 5}, {end, 1, multiplicity, 1, 1, 1, end}};
  if (multiplicity == 0) knots = {{0, 0.7, 2.4, 3.5, 4, 5}, {end, 1, 1, 1, 1, end}};
  const BSplineCurve curve(randomSplineData(random, degree, knots, rational, periodic));
  const SplineNet net = clampedNet(curve);
  return periodic ? periodicNet(net) : net;
}

/// Largest distance of two curves over the same range, on 400 points.
double sampledDistance(const SplineNet& a, const SplineNet& b) {
  const BSplineCurve first = curveOf(a);
  const BSplineCurve second = curveOf(b);
  double largest = 0.0;
  for (int i = 0; i <= 400; ++i) {
    const double t = std::lerp(first.first(), first.last(), i / 400.0);
    largest = std::max(largest, (first.evaluate(t) - second.evaluate(t)).norm());
  }
  return largest;
}

void expectUndone(const SplineNet& coarse, int times) {
  SplineNet net = inserted(coarse, 2.0, times);
  const KnotRemoval removal = proposeRemoval(net, net.find(2.0), times);
  EXPECT_LE(removal.deviationMm, 300.0 * net.degree * kUnitRoundoff * size(net));
  apply(removal, net);
  expectSameNet(net, coarse, 1e4 * net.degree * kUnitRoundoff * size(net));
}

TEST(KnotRemoval, UndoesAnInsertion) {
  Random random(100);
  for (const bool periodic : {false, true}) {
    for (const bool rational : {false, true}) {
      for (const int degree : {1, 2, 3, 5, 7}) {
        for (int multiplicity = 0; multiplicity < degree; ++multiplicity) {
          SCOPED_TRACE(testing::Message()
                       << "degree " << degree << ", multiplicity " << multiplicity
                       << (periodic ? ", periodic" : "") << (rational ? ", rational" : ""));
          const SplineNet coarse = randomNet(random, degree, rational, periodic, multiplicity);
          for (int times = 1; times <= degree - multiplicity; ++times)
            expectUndone(coarse, times);
        }
      }
    }
  }
}

TEST(KnotRemoval, IsExactToRoundingAtDegree25) {
  Random random(101);
  for (const bool rational : {false, true}) {
    const BSplineCurve curve(randomBezier(random, 25, rational));
    const SplineNet whole = clampedNet(curve);
    for (const double u : {0.5, 0.1, 0.93}) {
      SplineNet net = inserted(whole, u, 25);
      const KnotRemoval removal = proposeRemoval(net, net.find(u), 25);
      EXPECT_LE(removal.deviationMm, 1e-14 * size(net)) << u;
      apply(removal, net);
      EXPECT_EQ(net.flat, whole.flat);
      EXPECT_LE(sampledDistance(net, whole), 1e-13 * size(net)) << u;
    }
  }
}

TEST(KnotRemoval, KeepsThePolesThatItNeedNotChange) {
  Random random(102);
  SplineNet net = randomNet(random, 3, false, false, 2);
  const SplineNet old = net;
  const KnotRemoval removal = proposeRemoval(net, net.find(2.0), 1);
  EXPECT_EQ(removal.oldPoles, 2);
  ASSERT_EQ(removal.poles.size(), 1U);
  apply(removal, net);
  for (int i = 0; i < net.poleCount(); ++i) {
    if (i == removal.firstPole) continue;
    EXPECT_EQ(net.pole(i), old.pole(i < removal.firstPole ? i : i + 1));
  }
}

TEST(KnotRemoval, BoundsTheDeviation) {
  Random random(103);
  double tightest = 0.0;
  for (const bool periodic : {false, true}) {
    for (const bool rational : {false, true}) {
      for (const int degree : {2, 3, 5}) {
        for (int multiplicity = 1; multiplicity <= degree; ++multiplicity) {
          SplineNet net = randomNet(random, degree, rational, periodic, multiplicity);
          for (int times = 1; times <= removableTimes(net, net.find(2.0)); ++times) {
            SCOPED_TRACE(testing::Message() << degree << ' ' << multiplicity << ' ' << times);
            SplineNet shorter = net;
            const KnotRemoval removal = proposeRemoval(net, net.find(2.0), times);
            if (!std::isfinite(removal.deviationMm)) continue;
            apply(removal, shorter);
            const double distance = sampledDistance(net, shorter);
            EXPECT_LE(distance, removal.deviationMm * (1.0 + 1e-12));
            EXPECT_GT(distance, 0.0);
            tightest = std::max(tightest, distance / removal.deviationMm);
          }
        }
      }
    }
  }
  EXPECT_GT(tightest, 0.99);  // at multiplicity `degree` the only basis function reaches 1
}

TEST(KnotRemoval, LeavesTheLeastSquaresOfTheOldPoles) {
  Random random(104);
  const SplineNet net = randomNet(random, 5, false, false, 4);
  const KnotRemoval best = proposeRemoval(net, net.find(2.0), 3);
  const auto squares = [&](const KnotRemoval& removal) {
    SplineNet shorter = net;
    apply(removal, shorter);
    const SplineNet again = inserted(shorter, 2.0, 3);
    double sum = 0.0;
    for (int i = 0; i < net.poleCount(); ++i)
      sum += (again.pole(i) - net.pole(i)).squaredNorm();
    return sum;
  };
  const double least = squares(best);
  EXPECT_GT(least, 1e-3);
  for (std::size_t i = 0; i < best.poles.size(); ++i) {
    for (const double step : {-1e-3, 1e-3}) {
      KnotRemoval other = best;
      other.poles[i].head<3>() += step * random.direction();
      EXPECT_GT(squares(other), least);
    }
  }
}

TEST(KnotRemoval, OfAJoinIsTheDistanceFromTheLineOfItsNeighbours) {
  SplineNet net{
      .degree = 2, .rational = false, .flat = {0, 0, 0, 2, 2, 3, 3, 3}, .poles = {}, .period = 0.0};
  for (const Vector3& pole : {Vector3(0, 0, 0), Vector3(2, 0, 0), Vector3(4, 0.3, 0),
                              Vector3(5, 0, 0), Vector3(6, 2, 0)}) {
    net.poles.push_back(pole.homogeneous());
  }
  const KnotRemoval removal = proposeRemoval(net, net.find(2.0), 1);
  EXPECT_NEAR(removal.deviationMm, 0.3, 1e-15);  // (4, 0, 0) parts (2, 0, 0) to (5, 0, 0) as 2 : 1
  EXPECT_EQ(removal.poles.size(), 0U);
}

TEST(KnotRemoval, IsInfinitelyFarWhereAWeightWouldNotBePositive) {
  // weights 1, 0.1, 1, 0.1, 1: C2 at the join would need a weight of 2 * 0.1 - 1
  SplineNet net{
      .degree = 2, .rational = true, .flat = {0, 0, 0, 1, 1, 2, 2, 2}, .poles = {}, .period = 0.0};
  const double weights[] = {1.0, 0.1, 1.0, 0.1, 1.0};
  for (int i = 0; i < 5; ++i)
    net.poles.emplace_back(weights[i] * i, 0.0, 0.0, weights[i]);
  EXPECT_EQ(proposeRemoval(net, net.find(1.0), 2).deviationMm,
            std::numeric_limits<double>::infinity());
}

TEST(KnotRemoval, OfAPeriodicNetLeavesAPoleOutside) {
  Random random(105);
  const BSplineCurve loop(
      randomSplineData(random, 3, {{0, 1, 2}, {3, 3, 3}}, false, true));  // two closed cubics
  SplineNet net = periodicNet(clampedNet(loop));
  EXPECT_EQ(net.poleCount(), 6);
  EXPECT_EQ(removableTimes(net, net.find(1.0)), 3);
  EXPECT_EQ(removableTimes(net, net.find(1.0), 1), 2);
  apply(proposeRemoval(net, net.find(1.0), 3), net);
  EXPECT_EQ(net.poleCount(), 3);
  EXPECT_EQ(removableTimes(net, net.find(0.0), 1), 1);
  apply(proposeRemoval(net, net.find(0.0), 1), net);
  EXPECT_EQ(net.flat, (std::vector<double>{0, 0}));
  EXPECT_EQ(curveOf(net).first(), 0.0);
  EXPECT_EQ(curveOf(net).last(), 2.0);
}

TEST(KnotRemoval, OfAPeriodicNetKeepsTheBitsOfTheOtherKnots) {
  Random random(107);
  const KnotVector knots{{0.1, 0.8, 1.3, 2.1, 2.6, 3.7}, {1, 1, 1, 1, 1, 1}};
  SplineNet net =
      periodicNet(clampedNet(BSplineCurve(randomSplineData(random, 3, knots, false, true))));
  for (const double u : {0.1, 2.6, 1.3}) {
    const auto found = std::find_if(net.flat.begin(), net.flat.end(),
                                    [&](double knot) { return std::abs(knot - u) < 1e-9; });
    const SplineNet::Occurrence knot = net.find(*found);
    const int times = removableTimes(net, knot, u < 1.0 ? 1 : 0);
    apply(proposeRemoval(net, knot, times), net);
  }
  EXPECT_EQ(net.flat, (std::vector<double>{0.1, 0.8, 2.1}));
}

TEST(KnotRemoval, AtTheClosingKeepsTheBeginning) {
  Random random(106);
  for (const bool rational : {false, true}) {
    const KnotVector knots{{0, 0.7, 2, 2.4, 3.5}, {1, 1, 2, 1, 1}};
    const BSplineCurve curve(randomSplineData(random, 3, knots, rational, true));
    SplineNet net = periodicNet(clampedNet(curve));
    const KnotRemoval removal = proposeRemoval(net, net.find(0.0), 2);
    EXPECT_LE(removal.deviationMm, 1e-13);
    apply(removal, net);
    const BSplineCurve again = curveOf(net);
    EXPECT_EQ(again.data().knots.multiplicities, knots.multiplicities);
    EXPECT_EQ(again.data().knots.knots, knots.knots);
    EXPECT_LE((again.data().poles - curve.data().poles).colwise().norm().maxCoeff(), 1e-12);
  }
}

}  // namespace
}  // namespace osculate::test
