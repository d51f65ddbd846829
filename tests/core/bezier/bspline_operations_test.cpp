// New B-splines from old ones (bspline_operations.cpp).
#include "support/errors.h"
#include "support/exact_spline.h"
#include "support/random_curves.h"
#include "support/spline_samples.h"

namespace osculate::test {
namespace {

/// Parameters inside every span of the curve.
std::vector<double> parametersOf(const BSplineCurve& curve, Random& random) {
  std::vector<double> parameters;
  for (int i = 0; i < curve.spanCount(); ++i) {
    const BezierSegment segment = curve.segment(i);
    parameters.push_back(segment.first + segment.length() * random.uniform(0.05, 0.95));
  }
  return parameters;
}

TEST(BSplineCurve, ReversedRunsBackwardsThroughTheSamePoints) {
  Random random(70);
  for (const SplineSample& sample : splineSamples(70)) {
    SCOPED_TRACE(sample.name);
    const BSplineCurve curve(sample.data);
    const BSplineCurve turned = curve.reversed();
    const auto reference = exactSpline<Rational>(turned.data());
    const Rational sum = Rational(curve.first()) + Rational(curve.last());
    EXPECT_EQ(turned.first(), curve.first());
    EXPECT_EQ(turned.last(), curve.last());
    // the reversed knots are sums of doubles and round: by so much the parameter may differ
    const double slack = 4.0 * kUnitRoundoff * (std::abs(curve.first()) + std::abs(curve.last()));
    for (const double t : parametersOf(curve, random)) {
      const std::vector<Vector3> expected = curve.derivatives(t, 1);
      EXPECT_LE(distance(evaluate(reference, Rational(sum - Rational(t))), expected[0]),
                tolerance(curve) + slack * 4.0 * curve.degree() * expected[1].norm())
          << "at " << t;
    }
  }
}

TEST(BSplineCurve, ReversedTwiceHasTheSamePoles) {
  for (const SplineSample& sample : splineSamples(71)) {
    SCOPED_TRACE(sample.name);
    const BSplineCurve curve(sample.data);
    EXPECT_EQ(curve.reversed().reversed().data().poles, sample.data.poles);
    EXPECT_EQ(curve.reversed().reversed().data().weights, sample.data.weights);
  }
}

TEST(BSplineCurve, ElevatedIsTheSameCurveWithEveryMultiplicityRaised) {
  Random random(72);
  for (const SplineSample& sample : splineSamples(72)) {
    for (const int times : {1, 2}) {
      if (sample.data.degree + times > kMaxDegree) continue;
      SCOPED_TRACE(sample.name + " raised by " + std::to_string(times));
      const BSplineCurve curve(sample.data);
      const BSplineCurve raised = curve.elevated(times);
      EXPECT_EQ(raised.degree(), curve.degree() + times);
      EXPECT_EQ(raised.isPeriodic(), curve.isPeriodic());
      EXPECT_EQ(raised.first(), curve.first());
      EXPECT_EQ(raised.last(), curve.last());
      const auto reference = exactSpline<Rational>(raised.data());
      for (const double t : parametersOf(curve, random)) {
        EXPECT_LE(distance(evaluate(reference, Rational(t)), curve.evaluate(t)),
                  4.0 * tolerance(raised))
            << "at " << t;
      }
      const auto knots = curve.innerKnots();
      const auto raisedKnots = raised.innerKnots();
      ASSERT_EQ(raisedKnots.size(), knots.size());
      for (std::size_t i = 0; i < knots.size(); ++i) {
        EXPECT_EQ(raisedKnots[i].parameter, knots[i].parameter);
        EXPECT_EQ(raisedKnots[i].multiplicity, knots[i].multiplicity + times);
      }
    }
  }
}

TEST(BSplineCurve, TrimmedIsTheSameCurveOverItsPartAndClamped) {
  Random random(73);
  for (const SplineSample& sample : splineSamples(73)) {
    SCOPED_TRACE(sample.name);
    const BSplineCurve curve(sample.data);
    const double range = curve.last() - curve.first();
    for (int round = 0; round < 3; ++round) {
      const double a = curve.first() + range * random.uniform(0.0, 0.6);
      const double b = a + range * random.uniform(0.1, 0.35);
      const BSplineCurve part = curve.trimmed(a, b);
      EXPECT_EQ(part.first(), a);
      EXPECT_EQ(part.last(), b);
      EXPECT_EQ(part.data().knots.multiplicities.front(), curve.degree() + 1);
      EXPECT_EQ(part.data().knots.multiplicities.back(), curve.degree() + 1);
      const auto reference = exactSpline<Rational>(part.data());
      for (const double t : parametersOf(part, random)) {
        EXPECT_LE(distance(evaluate(reference, Rational(t)), curve.evaluate(t)),
                  4.0 * tolerance(curve))
            << "at " << t;
      }
    }
  }
}

TEST(BSplineCurve, TrimmedBeyondTheSeamMeetsAKnotThatRoundingMisses) {
  BSplineData data{.poles = Poles::Random(3, 6),
                   .weights = {},
                   .knots = {{0.0, 0.3, 0.5, 0.7, 1.0}, {2, 1, 1, 2, 2}},
                   .degree = 3,
                   .periodic = true,
                   .poleError = 0.0};
  const BSplineCurve curve(data);
  const BSplineCurve part = curve.trimmed(1.0, 1.3);  // 1.3 - 1 is not 0.3 in doubles
  EXPECT_EQ(part.spanCount(), 1);
  EXPECT_EQ(part.last(), 1.3);
  EXPECT_LE((part.evaluate(1.15) - curve.evaluate(0.15)).norm(), 1e-14);
}

TEST(BSplineCurve, TrimmedMayCrossTheSeamOfAPeriodicCurve) {
  Random random(74);
  for (const SplineSample& sample : splineSamples(74)) {
    if (!sample.data.periodic) continue;
    SCOPED_TRACE(sample.name);
    const BSplineCurve curve(sample.data);
    const double period = curve.last() - curve.first();
    for (const double turns : {0.0, 1.0, -2.0}) {
      const double a = curve.first() + (turns + random.uniform(0.6, 0.9)) * period;
      const double b = a + random.uniform(0.5, 1.0) * period;
      const BSplineCurve part = curve.trimmed(a, b);
      EXPECT_EQ(part.first(), a);
      EXPECT_EQ(part.last(), b);
      EXPECT_FALSE(part.isPeriodic());
      for (int i = 0; i <= 20; ++i) {
        const double t = a + (b - a) * i / 20.0;
        double own = t - period * std::floor((t - curve.first()) / period);
        own = std::min(own, curve.last());
        const auto expected = curve.derivatives(own, 1);
        // the parameter is shifted by periods, which rounds
        const double slack =
            8.0 * kUnitRoundoff * (std::abs(a) + period) * expected[1].norm() * curve.degree();
        EXPECT_LE((part.evaluate(t) - expected[0]).norm(), 4.0 * tolerance(curve) + slack)
            << "at " << t;
      }
    }
  }
}

TEST(BSplineCurve, TrimmedToAWholePeriodBeginsAndEndsAtTheSamePoint) {
  Random random(75);
  const BSplineCurve curve(
      randomSplineData(random, 3, {{0, 1, 2, 3, 4}, {1, 1, 1, 1, 1}}, true, true));
  for (const double a : {0.0, 0.25, 1.0, 3.5}) {
    const BSplineCurve turn = curve.trimmed(a, a + 4.0);
    EXPECT_TRUE(turn.isClosed(tolerance(curve))) << "from " << a;
    EXPECT_LT((turn.endPoint(CurveEnd::kStart) - curve.evaluate(a)).norm(), tolerance(curve));
  }
}

TEST(BSplineCurve, TrimmedToItsRangeIsTheSameClampedCurve) {
  Random random(76);
  const BSplineCurve clamped(randomSplineData(random, 3, {{0, 1, 2}, {4, 1, 4}}, false));
  EXPECT_EQ(&clamped.trimmed(0.0, 2.0).data(), &clamped.data());
  const BSplineCurve open(randomSplineData(random, 3, unclampedKnots(3), false));
  EXPECT_EQ(open.trimmed(open.first(), open.last()).data().knots.multiplicities.front(), 4);
}

TEST(BSplineCurve, TrimmedKeepsPolesOverItsOwnKnotsBitForBit) {
  Random random(79);
  for (const bool rational : {false, true}) {
    const BSplineCurve curve(randomSplineData(
        random, 3, {{0, 1, 2, 3, 4, 5, 6, 7}, {4, 1, 2, 1, 3, 1, 1, 4}}, rational));
    const BSplineCurve part = curve.trimmed(0.5, 5.5);
    // the part's knots 1, 2, 2, 3, 4, 4, 4, 5: six poles stand over three of these
    EXPECT_EQ(part.data().poles.middleCols(3, 6), curve.data().poles.middleCols(3, 6));
    if (rational) {
      EXPECT_TRUE(std::equal(part.data().weights.begin() + 3, part.data().weights.begin() + 9,
                             curve.data().weights.begin() + 3));
    }
    const BSplineCurve open(randomSplineData(random, 3, unclampedKnots(3), rational));
    const BSplineCurve clamped = open.trimmed(open.first(), open.last());
    EXPECT_NE(clamped.data().poles.col(0), open.data().poles.col(0));
    EXPECT_EQ(clamped.data().poles.middleCols(3, open.data().poles.cols() - 6),
              open.data().poles.middleCols(3, open.data().poles.cols() - 6));
  }
}

TEST(BSplineCurve, ExtractionGivesTheBezierPoles) {
  Random random(80);
  for (const SplineSample& sample : splineSamples(80)) {
    const BSplineCurve curve(sample.data);
    const auto count = sample.data.poles.cols();
    for (int span = 0; span < curve.spanCount(); ++span) {
      const SpanExtraction extraction = curve.extraction(span);
      const BezierCurve segment = curve.segment(span).curve;
      for (int j = 0; j <= curve.degree(); ++j) {
        Vector3 numerator = Vector3::Zero();
        double weight = 0.0;
        for (int i = 0; i <= curve.degree(); ++i) {
          const Eigen::Index pole = (extraction.firstPole + i) % count;
          const double own =
              curve.isRational() ? sample.data.weights[static_cast<std::size_t>(pole)] : 1.0;
          const double factor = extraction.factors(i, j) * own;
          numerator += factor * sample.data.poles.col(pole);
          weight += factor;
        }
        EXPECT_LE((numerator / weight - segment.pole(j)).norm(), 4.0 * tolerance(curve))
            << sample.name;
      }
    }
    EXPECT_ERROR(curve.extraction(-1), "span: must be from 0");
    EXPECT_ERROR(curve.extraction(curve.spanCount()), "span: must be from 0");
  }
}

TEST(BSplineCurve, SplitGivesTwoPartsThatMeet) {
  Random random(77);
  for (const SplineSample& sample : splineSamples(77)) {
    SCOPED_TRACE(sample.name);
    const BSplineCurve curve(sample.data);
    const double t = curve.first() + 0.37 * (curve.last() - curve.first());
    const auto [left, right] = curve.split(t);
    EXPECT_EQ(left.first(), curve.first());
    EXPECT_EQ(left.last(), t);
    EXPECT_EQ(right.first(), t);
    EXPECT_EQ(right.last(), curve.last());
    EXPECT_LE((left.endPoint(CurveEnd::kEnd) - right.endPoint(CurveEnd::kStart)).norm(),
              tolerance(curve));
  }
}

TEST(BSplineCurve, ReparametrisedMapsTheRangeAffinelyAndKeepsPoles) {
  Random random(78);
  for (const SplineSample& sample : splineSamples(78)) {
    SCOPED_TRACE(sample.name);
    const BSplineCurve curve(sample.data);
    const BSplineCurve mapped = curve.reparametrised(-3.0, 5.0);
    EXPECT_NEAR(mapped.first(), -3.0, 1e-14);
    EXPECT_NEAR(mapped.last(), 5.0, 1e-14);
    EXPECT_EQ(mapped.data().poles, curve.data().poles);
    EXPECT_LT((mapped.middlePoint() - curve.middlePoint()).norm(),
              1e-9 * (1.0 + curve.middlePoint().norm()));
  }
}

TEST(BSplineCurve, TransformedIsTheMapOfTheCurve) {
  Random random(79);
  const Eigen::Affine3d map =
      Eigen::Translation3d(1, 2, 3) * Eigen::AngleAxisd(0.3, random.direction());
  for (const SplineSample& sample : splineSamples(79)) {
    SCOPED_TRACE(sample.name);
    const BSplineCurve curve(sample.data);
    EXPECT_LT((curve.transformed(map).middlePoint() - map * curve.middlePoint()).norm(),
              4.0 * tolerance(curve));
  }
}

TEST(BSplineCurve, NamesTrimsAndSplitsOutOfRange) {
  Random random(80);
  const BSplineCurve curve(randomSplineData(random, 3, {{0, 1, 2}, {4, 1, 4}}, false));
  EXPECT_ERROR(curve.trimmed(-0.5, 1.0), "trim: needs a < b inside [");
  EXPECT_ERROR(curve.trimmed(0.5, 2.5), "trim: needs a < b inside [");
  EXPECT_ERROR(curve.trimmed(1.0, 1.0), "trim: needs a < b");
  EXPECT_ERROR(curve.trimmed(1.5, 0.5), "trim: needs a < b");
  EXPECT_ERROR(curve.split(0.0), "split: t must be inside (");
  EXPECT_ERROR(curve.split(2.0), "split: t must be inside (");
  const BSplineCurve periodic(
      randomSplineData(random, 3, {{0, 1, 2, 3}, {1, 1, 1, 1}}, false, true));
  EXPECT_ERROR(periodic.trimmed(0.5, 4.0), "trim: needs a < b and at most one period");
}

TEST(BSplineCurve, NamesElevationsAndRangesThatAreNone) {
  Random random(81);
  const BSplineCurve curve(randomSplineData(random, 24, {{0, 1}, {25, 25}}, false));
  EXPECT_ERROR(curve.elevated(2), "times: the degree 24 can be raised by 0 to 1, got 2");
  EXPECT_ERROR(curve.elevated(-1), "times: the degree 24 can be raised by 0 to 1, got -1");
  EXPECT_ERROR(curve.reparametrised(1.0, 1.0), "range: first must be below last");
  EXPECT_ERROR(curve.withPoleError(-1.0), "pole error: must be finite and >= 0");
}

}  // namespace
}  // namespace osculate::test
