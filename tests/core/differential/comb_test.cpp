#include "osculate/differential/comb.h"

#include <set>

#include "osculate/differential/arc_length.h"
#include "osculate/differential/point_geometry.h"
#include "support/comb_curves.h"
#include "support/errors.h"
#include "support/spline_samples.h"

namespace osculate::test {
namespace {

using enum CombQuantity;

/// Quantities in the order of CombQuantity.
void expectValues(const CombSample& sample, const std::array<double, kCombQuantities>& expected,
                  double error) {
  for (std::size_t q = 0; q < kCombQuantities; ++q) {
    EXPECT_NEAR(sample.value[q], expected[q], error)
        << name(static_cast<CombQuantity>(q)) << " at s = " << sample.arcLength;
  }
}

TEST(Comb, OfACircleIsItsCurvatureAndNothingElse) {
  const Comb found = comb(circle(5.0));
  EXPECT_EQ(found.runs.size(), 4U);
  EXPECT_TRUE(found.marks.empty());
  EXPECT_NEAR(found.length, 10.0 * std::numbers::pi, 1e-12);
  for (const CombSample& sample : found.samples) {
    expectValues(sample, {0.2, 0.0, 0.0, 0.0, 0.0}, 1e-12);
    EXPECT_LE((sample.normal + sample.point / 5.0).norm(), 1e-13) << "towards the centre";
    const double angle = std::atan2(sample.point.y(), sample.point.x());
    const double turns = std::round((sample.arcLength / 5.0 - angle) / (2.0 * std::numbers::pi));
    EXPECT_NEAR(sample.arcLength, 5.0 * (angle + 2.0 * std::numbers::pi * turns), 1e-12);
  }
}

TEST(Comb, OfAHelixIsConstant) {
  // radius 2, pitch 2 pi 1.5: kappa = r/(r^2 + c^2), tau = c/(r^2 + c^2)
  const double squares = 2.0 * 2.0 + 1.5 * 1.5;
  for (const double hand : {1.0, -1.0}) {
    const Comb found = comb(curveOf(2.0 / squares, 0.0, hand * 1.5 / squares, 6.0));
    EXPECT_NEAR(found.length, 6.0, 1e-12);
    for (const CombSample& sample : found.samples) {
      EXPECT_NEAR(sample[kCurvature], 0.32, 1e-12);
      EXPECT_NEAR(sample[kTorsion], hand * 0.24, 1e-11);
      EXPECT_NEAR(sample[kCurvatureRate], 0.0, 1e-10);
      EXPECT_NEAR(sample[kCurvatureRate2], 0.0, 1e-8);
      EXPECT_NEAR(sample[kTorsionRate], 0.0, 1e-9);
      EXPECT_NEAR(sample.arcLength, 6.0 * sample.parameter, 1e-11);
    }
  }
}

TEST(Comb, OfAClothoidIsALine) {
  const Comb found = comb(curveOf(0.1, 0.3, 0.0, 1.2));
  ASSERT_EQ(found.runs.size(), 1U);
  for (const CombSample& sample : found.samples) {
    const double s = 1.2 * sample.parameter;
    EXPECT_NEAR(sample.arcLength, s, 1e-11);
    EXPECT_NEAR(sample[kCurvature], 0.1 + 0.3 * s, 1e-12);
    EXPECT_NEAR(sample[kTorsion], 0.0, 1e-10);
    EXPECT_NEAR(sample[kCurvatureRate], 0.3, 1e-10);
    EXPECT_NEAR(sample[kCurvatureRate2], 0.0, 1e-8);
  }
}

TEST(Comb, OfAnEllipseIsItsClosedForm) {
  const Ellipse ellipse{30.0, 10.0};
  for (const double from : {0.0, 0.3}) {
    const Comb found = comb(ellipse.curve(from));
    for (const CombSample& sample : found.samples) {
      const double u = ellipse.angle(sample.point);
      expectValues(
          sample,
          {ellipse.curvature(u), 0.0, ellipse.curvatureRate(u), ellipse.curvatureRate2(u), 0.0},
          1e-11);
    }
  }
}

/// A sample beside what geometryAt says of its place, seen from within its run.
void expectSameGeometry(const CombSample& sample, const PointGeometry& expected, double unit) {
  EXPECT_LE((sample.point - expected.point).norm(), 1e-12);
  EXPECT_LE((sample.tangent - expected.frame.tangent).norm(), 1e-11);
  EXPECT_NEAR(sample[kCurvature], *expected.invariants.curvature, 1e-10 * unit);
  if (!expected.frame.normal) return;
  EXPECT_LE((sample.normal - *expected.frame.normal).norm(), 1e-9 * unit);
  EXPECT_LE((sample.binormal - *expected.frame.binormal).norm(), 1e-9 * unit);
  EXPECT_NEAR(sample[kTorsion], *expected.invariants.torsion, 1e-9 * unit);
  EXPECT_NEAR(sample[kCurvatureRate], *expected.invariants.curvatureRate, 1e-9 * unit);
  EXPECT_NEAR(sample[kCurvatureRate2], *expected.invariants.curvatureRate2, 1e-7 * unit);
  EXPECT_NEAR(sample[kTorsionRate], *expected.invariants.torsionRate, 1e-7 * unit);
}

TEST(Comb, OfAnySplineIsTheGeometryOfTheSideOfEachRun) {
  Random random(180);
  for (const int degree : {2, 3, 5, 8}) {
    for (const bool rational : {false, true}) {
      SCOPED_TRACE(std::to_string(degree) + (rational ? " rational" : ""));
      const BSplineCurve curve(randomSplineData(
          random, degree, {{0, 1, 2.5, 4}, {degree + 1, 1, 2, degree + 1}}, rational));
      const Comb found = comb(curve);
      ASSERT_GE(found.runs.size(), 3U);
      for (const CombRun& run : found.runs) {
        for (std::size_t i = run.first; i <= run.last; ++i) {
          const CombSample& sample = found.samples[i];
          const double k = sample[kCurvature];
          if (!(k > 1e-3)) continue;  // beside an inflection digits are lost
          const double unit = std::pow(std::max(k, 1.0) / std::min(k, 1.0), 4.0);
          expectSameGeometry(
              sample,
              geometryAt(curve, sample.parameter, i == run.last ? Side::kLeft : Side::kRight),
              unit);
        }
      }
    }
  }
}

TEST(Comb, HasTwoSamplesAtEveryKnotAndEveryRunIsWithinOneSegment) {
  for (const SplineSample& sample : splineSamples(181)) {
    SCOPED_TRACE(sample.name);
    const BSplineCurve curve(sample.data);
    const Comb found = comb(curve, {.density = 5, .tolerance = 0.0});
    EXPECT_EQ(found.samples.front().parameter, curve.first());
    EXPECT_EQ(found.samples.back().parameter, curve.last());
    for (const auto& knot : curve.innerKnots()) {
      const auto at = [&](const CombRun& run, bool last) {
        return found.samples[last ? run.last : run.first].parameter == knot.parameter;
      };
      EXPECT_EQ(std::count_if(found.runs.begin(), found.runs.end(),
                              [&](const CombRun& run) { return at(run, true); }),
                1);
      EXPECT_EQ(std::count_if(found.runs.begin(), found.runs.end(),
                              [&](const CombRun& run) { return at(run, false); }),
                1);
    }
    std::size_t next = 0;
    for (const CombRun& run : found.runs) {
      EXPECT_EQ(run.first, next);
      EXPECT_LT(run.first, run.last);
      next = run.last + 1;
      EXPECT_EQ(curve.spanAt(found.samples[run.first].parameter, Side::kRight),
                curve.spanAt(found.samples[run.last].parameter, Side::kLeft));
    }
    EXPECT_EQ(next, found.samples.size());
  }
}

TEST(Comb, KeepsAJumpOfTheCurvatureAJump) {
  // quarters of circles of radius 1 and 2 on a common tangent, as one quadratic with a double knot
  const double w = std::numbers::sqrt2 / 2.0;
  const BSplineData data{
      .poles = columns({{1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {-2, 1, 0}, {-2, -1, 0}}),
      .weights = {1, w, 1, w, 1},
      .knots = {{0, 1, 2}, {3, 2, 3}},
      .degree = 2,
      .periodic = false,
      .poleError = 0.0};
  const Comb found = comb(BSplineCurve(data));
  ASSERT_EQ(found.runs.size(), 2U);
  const CombSample& before = found.samples[found.runs[0].last];
  const CombSample& after = found.samples[found.runs[1].first];
  EXPECT_EQ(before.parameter, after.parameter);
  EXPECT_EQ(before.arcLength, after.arcLength);
  for (std::size_t i = 0; i < found.samples.size(); ++i) {
    EXPECT_NEAR(found.samples[i][kCurvature], i <= found.runs[0].last ? 1.0 : 0.5, 1e-13);
  }
}

TEST(Comb, OfALineHasNoCurvatureAndNothingThatNeedsANormal) {
  const Comb found = comb(BSplineCurve(BezierCurve(std::vector<Vector3>{{0, 0, 0}, {3, 4, 0}})));
  EXPECT_TRUE(found.marks.empty());
  EXPECT_NEAR(found.length, 5.0, 1e-14);
  for (const CombSample& sample : found.samples) {
    EXPECT_EQ(sample[kCurvature], 0.0);
    EXPECT_LE((sample.tangent - Vector3(0.6, 0.8, 0.0)).norm(), 1e-15);
    EXPECT_TRUE(sample.normal.array().isNaN().all());
    for (std::size_t q = 1; q < kCombQuantities; ++q)
      EXPECT_TRUE(std::isnan(sample.value[q]));
  }
}

TEST(Comb, AtACuspHasTheTangentsOfBothSidesAndNothingElse) {
  // (t^2, t^3) for t in [-1, 2], the cusp at a third of the range: on a sample, and between two
  const BSplineCurve curve(
      BezierCurve(std::vector<Vector3>{{1, -1, 0}, {-1, 2, 0}, {0, -4, 0}, {4, 8, 0}}));
  for (const int density : {24, 25}) {
    SCOPED_TRACE(density);
    const Comb found = comb(curve, {.density = density});
    ASSERT_EQ(found.runs.size(), 2U);
    const CombSample& before = found.samples[found.runs[0].last];
    const CombSample& after = found.samples[found.runs[1].first];
    EXPECT_NEAR(before.parameter, 1.0 / 3.0, 1e-9);
    EXPECT_LE((before.tangent + Vector3::UnitX()).norm(), 1e-6);
    EXPECT_LE((after.tangent - Vector3::UnitX()).norm(), 1e-6);
    EXPECT_TRUE(std::isnan(before[kCurvature]) && std::isnan(after[kCurvature]));
    // s = ((4 + 9 t^2)^(3/2) - 8) / 27 from the cusp
    EXPECT_NEAR(before.arcLength, (std::pow(13.0, 1.5) - 8.0) / 27.0, 1e-9);
    EXPECT_NEAR(found.length, (std::pow(13.0, 1.5) + std::pow(40.0, 1.5) - 16.0) / 27.0, 1e-9);
  }
}

TEST(Comb, ArcLengthsAreThoseOfTheAdaptiveIntegral) {
  for (const SplineSample& sample : splineSamples(182)) {
    SCOPED_TRACE(sample.name);
    const BSplineCurve curve(sample.data);
    const Comb found = comb(curve, {.density = 7});
    EXPECT_NEAR(found.length, length(curve), 2e-9 * found.length);
    for (std::size_t i = 0; i < found.samples.size(); i += 40) {
      EXPECT_NEAR(found.samples[i].arcLength,
                  length(curve, curve.first(), found.samples[i].parameter), 2e-9 * found.length);
    }
  }
}

TEST(Comb, FollowsItsQuantitiesBetweenSamplesAsCloselyAsAsked) {
  Random random(183);
  const BSplineCurve curve(randomSplineData(random, 5, {{0, 1, 2, 3}, {6, 1, 1, 6}}, true));
  for (const CombQuantity shown : {kCurvature, kTorsion, kCurvatureRate}) {
    CombOptions options{.density = 4, .tolerance = 0.01, .shown = {}};
    const auto q = static_cast<std::size_t>(shown);
    options.shown[q] = true;
    const Comb found = comb(curve, options);
    const auto valueAt = [&](double t) {
      const Invariants at = geometryAt(curve, t).invariants;
      const std::array<double, 3> values{*at.curvature, at.torsion.value_or(NAN),
                                         at.curvatureRate.value_or(NAN)};
      return values[q];
    };
    int beyond = 0;
    for (const CombRun& run : found.runs) {
      for (std::size_t i = run.first; i < run.last; ++i) {
        const CombSample& a = found.samples[i];
        const CombSample& b = found.samples[i + 1];
        const double middle = valueAt(0.5 * (a.parameter + b.parameter));
        const double share = 0.5;  // of a short interval
        const double off = std::abs(middle - std::lerp(a.value[q], b.value[q], share));
        if (off > 0.03 * std::max(std::abs(a.value[q]), std::abs(b.value[q]))) ++beyond;
      }
    }
    EXPECT_LE(beyond, 2) << name(shown);  // where a quantity goes through zero
    EXPECT_LT(found.samples.size(), 1000U);
  }
}

TEST(Comb, ToleranceZeroAddsNothingButMarks) {
  Random random(184);
  const BSplineCurve curve(randomSplineData(random, 3, {{0, 1, 2}, {4, 1, 4}}, false));
  const Comb found = comb(curve, {.density = 10, .tolerance = 0.0});
  std::set<double> teeth;
  for (const CombSample& sample : found.samples) {
    if (sample.isTooth) teeth.insert(sample.parameter);
  }
  EXPECT_EQ(teeth.size(), 21U);
  std::set<std::size_t> marked;
  for (const CombMark& mark : found.marks)
    marked.insert(mark.sample);
  EXPECT_LE(found.samples.size(), 22U + 2U * marked.size());
}

TEST(Comb, TurnsWithItsCurve) {
  Random random(185);
  const BSplineCurve curve(randomSplineData(random, 4, {{0, 1, 3}, {5, 2, 5}}, true));
  const Comb there = comb(curve);
  const Comb back = comb(curve.reversed());
  ASSERT_EQ(there.samples.size(), back.samples.size());
  ASSERT_EQ(there.marks.size(), back.marks.size());
  const double range = curve.first() + curve.last();
  for (std::size_t i = 0; i < there.samples.size(); ++i) {
    const CombSample& a = there.samples[i];
    const CombSample& b = back.samples[back.samples.size() - 1 - i];
    EXPECT_NEAR(a.parameter, range - b.parameter, 1e-9);
    if (!(a[kCurvature] > 1e-4)) continue;
    const double unit = std::pow(std::max(1.0, a[kCurvature]) / std::min(1.0, a[kCurvature]), 3.0);
    EXPECT_LE((a.tangent + b.tangent).norm(), 1e-8);
    EXPECT_LE((a.normal - b.normal).norm(), 1e-8 * unit);
    EXPECT_NEAR(a[kTorsion], b[kTorsion], 1e-7 * unit);
    EXPECT_NEAR(a[kCurvatureRate], -b[kCurvatureRate], 1e-7 * unit);
    EXPECT_NEAR(a[kCurvatureRate2], b[kCurvatureRate2], 1e-5 * unit);
  }
}

TEST(Comb, NamesOptionsOutOfRange) {
  const BSplineCurve curve = circle(1.0);
  EXPECT_ERROR(comb(curve, {.density = 1}), "density: must be from 2 to 10000, got 1");
  EXPECT_ERROR(comb(curve, {.density = 10001}), "density: must be from 2 to 10000");
  EXPECT_ERROR(comb(curve, {.tolerance = -0.1}), "tolerance: must be from 0 to below 1");
  EXPECT_ERROR(comb(curve, {.tolerance = NAN}), "tolerance: must be from 0 to below 1");
}

}  // namespace
}  // namespace osculate::test
