// The extraction of Bézier segments (bspline_extraction.cpp).
#include "support/exact_spline.h"
#include "support/random_curves.h"
#include "support/spline_samples.h"

namespace osculate::test {
namespace {

TEST(SegmentExtraction, CoversTheRangeSpanBySpan) {
  for (const SplineSample& sample : splineSamples(50)) {
    SCOPED_TRACE(sample.name);
    const BSplineCurve curve(sample.data);
    double reached = curve.first();
    for (int i = 0; i < curve.spanCount(); ++i) {
      const BezierSegment segment = curve.segment(i);
      EXPECT_EQ(segment.first, reached);
      EXPECT_GT(segment.last, segment.first);
      EXPECT_EQ(segment.curve.degree(), curve.degree());
      EXPECT_EQ(segment.curve.isRational(), curve.isRational());
      reached = segment.last;
    }
    EXPECT_EQ(reached, curve.last());
  }
}

/// Every pole of every span must lie within its stated error of the exact one.
void expectStatedErrorsHold(const BSplineData& data) {
  const BSplineCurve curve(data);
  const auto reference = exactSpline<Rational>(data);
  for (int i = 0; i < curve.spanCount(); ++i) {
    const BezierSegment segment = curve.segment(i);
    const auto net = spanNet(reference, Rational(segment.first), Rational(segment.last));
    for (int j = 0; j <= curve.degree(); ++j) {
      const auto& point = net[static_cast<std::size_t>(j)];
      const Point<Rational> pole = point.head<3>() / point[3];
      EXPECT_LE(distance(pole, segment.curve.pole(j)), segment.poleError)
          << "span " << i << " pole " << j;
    }
  }
}

TEST(SegmentExtraction, StatedErrorBoundsTheDistanceOfEveryPoleFromTheExactOne) {
  for (std::uint64_t seed = 51; seed < 54; ++seed) {
    for (const SplineSample& sample : splineSamples(seed)) {
      SCOPED_TRACE(sample.name);
      expectStatedErrorsHold(sample.data);
    }
  }
}

TEST(SegmentExtraction, StatedErrorHoldsForWeightsOfVeryDifferentSize) {
  Random random(55);
  for (int round = 0; round < 4; ++round) {
    for (SplineSample& sample : splineSamples(static_cast<std::uint64_t>(round))) {
      if (sample.data.weights.empty() || sample.data.degree > 10) continue;
      SCOPED_TRACE(sample.name);
      for (double& weight : sample.data.weights)
        weight = std::exp(random.uniform(-9.0, 9.0));
      expectStatedErrorsHold(sample.data);
    }
  }
}

TEST(SegmentExtraction, StatedErrorIsOfTheSizeOfRoundingAndIncludesThatOfTheCurve) {
  for (const SplineSample& sample : splineSamples(56)) {
    SCOPED_TRACE(sample.name);
    const BSplineCurve curve(sample.data);
    const double largest = sample.data.poles.colwise().norm().maxCoeff();
    const double rounding = curve.segment(0).poleError;
    EXPECT_LE(rounding, 64.0 * (curve.degree() + 2) * kUnitRoundoff * largest);
    EXPECT_EQ(curve.withPoleError(0.25).segment(0).poleError, 0.25 + rounding);
  }
}

TEST(SegmentExtraction, OfAClampedBezierSpanCopiesThePoles) {
  Random random(57);
  const BSplineCurve curve(randomSplineData(random, 4, {{0, 1, 2}, {5, 4, 5}}, false));
  const BezierSegment second = curve.segment(1);
  EXPECT_EQ(second.poleError, 0.0);
  for (int j = 0; j <= 4; ++j)
    EXPECT_EQ(Vector3(second.curve.pole(j)), Vector3(curve.data().poles.col(4 + j)));
}

/// The span's own degree+1 poles and 2 degree knots stay, everything else becomes huge.
BSplineData poisoned(const BSplineData& data, std::size_t knotBefore) {
  BSplineData changed = data;
  const int p = data.degree;
  int flatIndex = -1;  // of the last repetition of the knot at which the span begins
  for (std::size_t i = 0; i <= knotBefore; ++i)
    flatIndex += data.knots.multiplicities[i];
  for (Eigen::Index i = 0; i < data.poles.cols(); ++i) {
    if (i < flatIndex - p || i > flatIndex) changed.poles.col(i).setConstant(1e200);
  }
  int index = 0;
  for (std::size_t i = 0; i < data.knots.knots.size(); ++i) {
    const int end = index + data.knots.multiplicities[i];
    if (end <= flatIndex - p + 1) changed.knots.knots[i] = (data.knots.knots[i] - 100.0) * 1e100;
    if (index > flatIndex + p) changed.knots.knots[i] *= 1e100;
    index = end;
  }
  return changed;
}

TEST(SegmentExtraction, ReadsOnlyThePolesAndKnotsOfItsSpan) {
  Random random(58);
  KnotVector knots;
  for (int i = 0; i < 24; ++i) {
    knots.knots.push_back(i);
    knots.multiplicities.push_back(i == 0 || i == 23 ? 4 : 1 + i % 2);
  }
  for (const bool rational : {false, true}) {
    const BSplineData data = randomSplineData(random, 3, knots, rational);
    const BSplineCurve curve(data);
    for (const int span : {0, 7, 11, 22}) {
      const BSplineCurve other(poisoned(data, static_cast<std::size_t>(span)));
      const BezierSegment expected = curve.segment(span);
      const BezierSegment found = other.segment(span);
      EXPECT_TRUE(identical(found.curve, expected.curve)) << "span " << span;
      EXPECT_EQ(found.poleError, expected.poleError);
    }
  }
}

}  // namespace
}  // namespace osculate::test
