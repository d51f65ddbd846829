#include "osculate/bezier/bspline_curve.h"

#include <limits>
#include <thread>

#include "support/errors.h"
#include "support/exact_spline.h"
#include "support/random_curves.h"
#include "support/spline_samples.h"

namespace osculate::test {
namespace {

double largestPole(const BSplineData& data) { return data.poles.colwise().norm().maxCoeff(); }

TEST(BSplineCurve, EvaluatesAsTheBasisFunctionsOfCoxAndDeBoor) {
  for (const SplineSample& sample : splineSamples(30)) {
    SCOPED_TRACE(sample.name);
    const BSplineCurve curve(sample.data);
    const auto reference = exactSpline<Rational>(sample.data);
    Random random(31);
    for (int i = 0; i < curve.spanCount(); ++i) {
      const BezierSegment segment = curve.segment(i);
      const double t = random.uniform(segment.first, segment.last);
      EXPECT_LE(distance(evaluate(reference, Rational(t)), curve.evaluate(t)),
                64.0 * sample.data.degree * kUnitRoundoff * largestPole(sample.data))
          << "at " << t;
    }
  }
}

TEST(BSplineCurve, DerivativesAreOneSidedAtKnots) {
  for (const SplineSample& sample : splineSamples(32)) {
    SCOPED_TRACE(sample.name);
    const BSplineCurve curve(sample.data);
    const auto reference = exactSpline<Rational>(sample.data);
    for (const auto& knot : curve.innerKnots()) {
      for (const Side side : {Side::kLeft, Side::kRight}) {
        const auto expected = taylor(reference, Rational(knot.parameter), 3, side);
        const std::vector<Vector3> found = curve.derivatives(knot.parameter, 3, side);
        const double span = curve.segment(curve.spanAt(knot.parameter, side)).length();
        double bound = 128.0 * curve.degree() * kUnitRoundoff * largestPole(sample.data);
        for (int k = 0; k <= 3; ++k) {
          const auto i = static_cast<std::size_t>(k);
          EXPECT_LE(distance(Point<Rational>(factorial<Rational>(k) * expected[i]), found[i]),
                    bound)
              << "derivative " << k << " at " << knot.parameter;
          bound *= 4.0 * curve.degree() / span;
        }
      }
    }
  }
}

TEST(BSplineCurve, EndsAndMiddleArePointsOfTheCurve) {
  for (const SplineSample& sample : splineSamples(33)) {
    SCOPED_TRACE(sample.name);
    const BSplineCurve curve(sample.data);
    const auto reference = exactSpline<Rational>(sample.data);
    const double bound = 64.0 * curve.degree() * kUnitRoundoff * largestPole(sample.data);
    const Rational first(curve.first());
    const Rational last(curve.last());
    EXPECT_LE(distance(evaluate(reference, first), curve.endPoint(CurveEnd::kStart)), bound);
    EXPECT_LE(distance(evaluate(reference, last, Side::kLeft), curve.endPoint(CurveEnd::kEnd)),
              bound);
    EXPECT_LE(distance(evaluate(reference, Rational((first + last) / 2)), curve.middlePoint()),
              bound);
  }
}

TEST(BSplineCurve, AgreesWithOpenCascadeOnPeriodicKnotsOfEveryFirstMultiplicity) {
  for (const PeriodicReference& reference : periodicReferences()) {
    SCOPED_TRACE(reference.name);
    const BSplineCurve curve(reference.data);
    EXPECT_TRUE(curve.isPeriodic());
    for (const auto& [t, point] : reference.points) {
      EXPECT_LT((curve.evaluate(t) - point).norm(), 1e-13 * largestPole(reference.data))
          << "at " << t;
    }
  }
}

TEST(BSplineCurve, APeriodicCurveIsClosedWithTheSmoothnessOfItsSeamKnot) {
  for (const SplineSample& sample : splineSamples(34)) {
    if (!sample.data.periodic) continue;
    SCOPED_TRACE(sample.name);
    const BSplineCurve curve(sample.data);
    EXPECT_TRUE(curve.isClosed(0.0));
    const int smoothness = curve.degree() - sample.data.knots.multiplicities.front();
    const auto start = curve.derivatives(curve.first(), smoothness);
    const auto end = curve.derivatives(curve.last(), smoothness, Side::kLeft);
    for (std::size_t k = 0; k < start.size(); ++k) {
      EXPECT_LT((start[k] - end[k]).norm(), 1e-11 * (largestPole(sample.data) + start[k].norm()))
          << "order " << k;
    }
  }
}

TEST(BSplineCurve, FindsTheSpanOnTheSideAskedFor) {
  Random random(35);
  const BSplineCurve curve(randomSplineData(random, 3, {{0, 1, 2, 4}, {4, 2, 4, 4}}, false));
  ASSERT_EQ(curve.spanCount(), 3);
  EXPECT_EQ(curve.spanAt(0.5), 0);
  EXPECT_EQ(curve.spanAt(1.0), 1);
  EXPECT_EQ(curve.spanAt(1.0, Side::kLeft), 0);
  EXPECT_EQ(curve.spanAt(2.0), 2);
  EXPECT_EQ(curve.spanAt(2.0, Side::kLeft), 1);
  EXPECT_EQ(curve.spanAt(-7.0), 0) << "before the range";
  EXPECT_EQ(curve.spanAt(0.0, Side::kLeft), 0) << "nothing lies left of the start";
  EXPECT_EQ(curve.spanAt(4.0), 2) << "nothing lies right of the end";
  EXPECT_EQ(curve.spanAt(9.0), 2) << "after the range";
}

TEST(BSplineCurve, ListsInnerKnotsWithMultiplicityAndSpan) {
  Random random(36);
  const BSplineCurve curve(randomSplineData(random, 3, {{0, 1, 2, 4}, {4, 2, 4, 4}}, false));
  const auto knots = curve.innerKnots();
  ASSERT_EQ(knots.size(), 2U);
  EXPECT_EQ(knots[0].parameter, 1.0);
  EXPECT_EQ(knots[0].multiplicity, 2);
  EXPECT_EQ(knots[0].spanAfter, 1);
  EXPECT_EQ(knots[1].multiplicity, 4);
  EXPECT_EQ(knots[1].spanAfter, 2);
}

TEST(BSplineCurve, RangeOfAnUnclampedCurveLeavesOutTheOuterKnots) {
  Random random(37);
  const BSplineCurve curve(
      randomSplineData(random, 2, {{0, 1, 3, 4, 7, 8}, {1, 1, 1, 1, 1, 1}}, false));
  EXPECT_EQ(curve.first(), 3.0);
  EXPECT_EQ(curve.last(), 4.0);
  EXPECT_EQ(curve.spanCount(), 1);
}

TEST(BSplineCurve, AMultiplicityAboveTheDegreeBreaksTheCurve) {
  BSplineData data{.poles = columns({{0, 0, 0}, {1, 0, 0}, {5, 5, 0}, {6, 5, 0}}),
                   .weights = {},
                   .knots = {{0, 1, 2}, {2, 2, 2}},
                   .degree = 1,
                   .periodic = false,
                   .poleError = 0.0};
  const BSplineCurve curve(data);
  EXPECT_EQ(curve.derivatives(1.0, 0, Side::kLeft)[0], Vector3(1, 0, 0));
  EXPECT_EQ(curve.derivatives(1.0, 0, Side::kRight)[0], Vector3(5, 5, 0));
}

TEST(BSplineCurve, EndSegmentSkipsSpansThatAreOnePoint) {
  const Vector3 corner(1, 2, 3);
  BSplineData data{.poles = columns({corner, corner, corner, {4, 2, 3}, {5, 5, 5}}),
                   .weights = {},
                   .knots = {{0, 1, 2}, {3, 2, 3}},
                   .degree = 2,
                   .periodic = false,
                   .poleError = 0.0};
  const BezierSegment start = BSplineCurve(data).endSegment(CurveEnd::kStart);
  EXPECT_EQ(start.first, 1.0);
  EXPECT_EQ(start.curve.pole(0), corner);
  const BezierSegment end = BSplineCurve(data).reversed().endSegment(CurveEnd::kEnd);
  EXPECT_EQ(end.last, 1.0);
  EXPECT_EQ(end.curve.pole(2), corner);
}

TEST(BSplineCurve, IsClosedWithinTheToleranceOnly) {
  BSplineData data{.poles = columns({{0, 0, 0}, {1, 0, 0}, {0, 0.5, 0}}),
                   .weights = {},
                   .knots = {{0, 1, 2}, {2, 1, 2}},
                   .degree = 1,
                   .periodic = false,
                   .poleError = 0.0};
  EXPECT_TRUE(BSplineCurve(data).isClosed(0.5));
  EXPECT_FALSE(BSplineCurve(data).isClosed(0.499));
}

TEST(BSplineCurve, OfOneBezierSegmentIsThatSegmentOverItsRange) {
  Random random(38);
  const BezierCurve segment = randomBezier(random, 5, true);
  const BSplineCurve curve(segment, 2.0, 6.0, 1e-5);
  EXPECT_EQ(curve.first(), 2.0);
  EXPECT_EQ(curve.last(), 6.0);
  EXPECT_EQ(curve.poleError(), 1e-5);
  EXPECT_LT((curve.evaluate(3.0) - segment.evaluate(0.25)).norm(), 1e-14 * size(segment));
}

TEST(BSplineCurve, CopiesShareDataThatNeverChange) {
  Random random(39);
  const BSplineCurve curve(randomSplineData(random, 3, {{0, 1, 2}, {4, 1, 4}}, true));
  const Poles poles = curve.data().poles;
  const BSplineCurve copy = curve;
  EXPECT_EQ(&copy.data(), &curve.data());
  static_cast<void>(std::tuple(copy.reversed(), copy.elevated(2), copy.split(0.5),
                               copy.trimmed(0.1, 1.5), copy.reparametrised(5, 6),
                               copy.withPoleError(1.0), copy.segment(1)));
  EXPECT_EQ(curve.data().poles, poles);
  EXPECT_EQ(curve.poleError(), 0.0);
}

TEST(BSplineCurve, MayBeReadByManyThreadsAtOnce) {
  Random random(40);
  const BSplineCurve curve(randomSplineData(random, 4, {{0, 1, 2, 3}, {5, 1, 2, 5}}, true));
  const Vector3 point = curve.evaluate(1.25);
  const BezierCurve segment = curve.segment(2).curve;
  std::vector<int> equal(4, 0);
  {
    std::vector<std::jthread> threads;
    for (std::size_t i = 0; i < equal.size(); ++i) {
      threads.emplace_back([&, i, copy = curve] {
        for (int round = 0; round < 200; ++round) {
          equal[i] +=
              copy.evaluate(1.25) == point && identical(copy.segment(2).curve, segment) ? 1 : 0;
        }
      });
    }
  }
  EXPECT_EQ(equal, std::vector<int>(4, 200));
}

/// A right B-spline that each test makes wrong in one way.
BSplineData good() {
  return {.poles = columns({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}),
          .weights = {},
          .knots = {{0, 1, 2}, {2, 1, 2}},
          .degree = 1,
          .periodic = false,
          .poleError = 0.0};
}

TEST(BSplineCurve, NamesPolesThatAreNotFiniteOrAllOnePoint) {
  BSplineData data = good();
  data.poles(2, 1) = kNaN;
  EXPECT_ERROR(BSplineCurve(data), "poles: every coordinate must be finite");
  data.poles.setOnes();
  EXPECT_ERROR(BSplineCurve(data), "poles: all are one point");
}

TEST(BSplineCurve, NamesBadWeightsKnotsAndPoleError) {
  BSplineData data = good();
  data.weights = {1.0, 2.0};
  EXPECT_ERROR(BSplineCurve(data), "weights: one for each pole is needed, got 2 for 3 poles");
  data.weights = {1.0, 2.0, -1.0};
  EXPECT_ERROR(BSplineCurve(data), "weights: every weight must be finite and > 0");
  data = good();
  data.knots.multiplicities = {2, 2, 2};
  EXPECT_ERROR(BSplineCurve(data), "multiplicities: their sum must be 5");
  data = good();
  data.poleError = -1.0;
  EXPECT_ERROR(BSplineCurve(data), "pole error: must be finite and >= 0");
}

TEST(BSplineCurve, NamesKnotsWithoutASpanInsideTheRange) {
  BSplineData data = good();
  data.degree = 2;
  data.knots = {{0, 1, 2}, {2, 3, 1}};  // u_2 = u_3 = 1: the range is one point
  EXPECT_ERROR(BSplineCurve(data), "knots: no span of positive length");
}

TEST(BSplineCurve, NamesSpansThatItDoesNotHave) {
  EXPECT_ERROR(BSplineCurve(good()).segment(2), "span: must be from 0 to 1, got 2");
  EXPECT_ERROR(BSplineCurve(good()).segment(-1), "span: must be from 0 to 1, got -1");
}

}  // namespace
}  // namespace osculate::test
