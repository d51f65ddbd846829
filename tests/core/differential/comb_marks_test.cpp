#include <algorithm>

#include "osculate/differential/comb.h"
#include "osculate/differential/point_geometry.h"
#include "support/comb_curves.h"

namespace osculate::test {
namespace {

using enum CombMarkKind;

std::vector<const CombSample*> marked(const Comb& comb, CombMarkKind kind,
                                      CombQuantity quantity = CombQuantity::kCurvature) {
  std::vector<const CombSample*> samples;
  for (const CombMark& mark : comb.marks) {
    if (mark.kind == kind && mark.quantity == quantity)
      samples.push_back(&comb.samples[mark.sample]);
  }
  return samples;
}

/// Planar graph (u, f(u)) over [first, last] from the coefficients of f.
BSplineCurve graph(const std::vector<double>& f, double first, double last) {
  PointSeries taylor(std::max<std::size_t>(f.size(), 2), Point<Real>::Constant(Real(0)));
  const Real h = Real(last) - Real(first);
  // f(first + h t) by Horner's scheme in the shifted variable
  RealSeries shifted{Real(0)};
  for (std::size_t k = f.size(); k-- > 0;) {
    RealSeries next(shifted.size() + 1, Real(0));
    for (std::size_t i = 0; i < shifted.size(); ++i) {
      next[i] += Real(first) * shifted[i];
      next[i + 1] += h * shifted[i];
    }
    next[0] += Real(f[k]);
    shifted = next;
  }
  for (std::size_t k = 0; k < taylor.size() && k < shifted.size(); ++k)
    taylor[k].y() = shifted[k];
  taylor[0].x() = Real(first);
  taylor[1].x() = h;
  return BSplineCurve(roundedCurve(bezierNet(taylor)), first, last);
}

TEST(CombMarks, VerticesOfAnEllipseAreItsAxes) {
  const Ellipse ellipse{30.0, 10.0};
  for (const double from : {0.0, 0.3}) {  // at knots, and between them
    SCOPED_TRACE(from);
    const Comb found = comb(ellipse.curve(from));
    const auto vertices = marked(found, kVertex);
    const auto peaks = marked(found, kPeak);
    ASSERT_EQ(vertices.size(), 4U);
    ASSERT_EQ(peaks.size(), 2U);
    EXPECT_TRUE(marked(found, kInflection).empty());
    for (const CombSample* vertex : vertices)
      EXPECT_LE(std::min(std::abs(vertex->point.x()), std::abs(vertex->point.y())), 1e-9);
    for (const CombSample* peak : peaks) {
      EXPECT_NEAR(std::abs(peak->point.x()), 30.0, 1e-12);
      EXPECT_NEAR((*peak)[CombQuantity::kCurvature], 0.3, 1e-13) << "a / b^2";
    }
  }
}

TEST(CombMarks, InflectionsAreWhereTheClothoidSaysToItsUncertainty) {
  // kappa = s - 0.5 over [0, 1.5]: the inflection at s = 0.5
  const Comb found = comb(curveOf(-0.5, 1.0, 0.0, 1.5));
  const auto inflections = marked(found, kInflection);
  ASSERT_EQ(inflections.size(), 1U);
  EXPECT_NEAR(inflections[0]->arcLength, 0.5, 1e-12);
  EXPECT_NEAR(inflections[0]->parameter, 1.0 / 3.0, 1e-12);
  EXPECT_EQ(found.runs.size(), 2U);
  for (const CombMark& mark : found.marks)
    EXPECT_LE(mark.uncertainty, 1e-9);
}

TEST(CombMarks, LimitsAtAnInflectionAreThoseOfBothSides) {
  // kappa = 2 s - 1 and torsion 0.3 of a frame that is continuous: the Frenet frame turns over
  const Comb found = comb(curveOf(-1.0, 2.0, 0.3, 1.0));
  ASSERT_EQ(found.runs.size(), 2U);
  const CombSample& before = found.samples[found.runs[0].last];
  const CombSample& after = found.samples[found.runs[1].first];
  EXPECT_LE((before.normal + after.normal).norm(), 1e-9);
  EXPECT_LE((before.binormal + after.binormal).norm(), 1e-9);
  EXPECT_NEAR(before[CombQuantity::kCurvatureRate], -2.0, 1e-9);
  EXPECT_NEAR(after[CombQuantity::kCurvatureRate], 2.0, 1e-9);
  for (const CombSample* side : {&before, &after}) {
    EXPECT_EQ((*side)[CombQuantity::kCurvature], 0.0);
    EXPECT_NEAR((*side)[CombQuantity::kTorsion], 0.3, 1e-7);
    EXPECT_NEAR((*side)[CombQuantity::kCurvatureRate2], 0.0, 1e-7);
    EXPECT_LE((side->tangent.cross(side->normal) - side->binormal).norm(), 1e-12);
  }
  // the limits continue what the samples beside them say
  const CombSample& earlier = found.samples[found.runs[0].last - 1];
  EXPECT_GT(earlier.normal.dot(before.normal), 0.99);
  EXPECT_NEAR(earlier[CombQuantity::kTorsion], 0.3, 1e-7);
}

TEST(CombMarks, AnInflectionOnASampleIsFoundOnce) {
  const Comb found = comb(graph({0, 0, 0, 1}, -1.0, 1.0), {.density = 24});
  ASSERT_EQ(marked(found, kInflection).size(), 1U);
  const CombSample& at = *marked(found, kInflection)[0];
  EXPECT_NEAR(at.parameter, 0.0, 1e-12);
  EXPECT_NEAR(at[CombQuantity::kCurvatureRate], 6.0, 1e-9) << "kappa = 6 |x| + O(x^5)";
  EXPECT_EQ(std::count_if(found.samples.begin(), found.samples.end(),
                          [](const CombSample& s) { return std::abs(s.parameter) < 1e-6; }),
            2);
}

TEST(CombMarks, AFlatPointThatDoesNotTurnIsAVertex) {
  const Comb found = comb(graph({0, 0, 0, 0, 1}, -1.0, 0.9));  // (x, x^4)
  EXPECT_TRUE(marked(found, kInflection).empty());
  const auto vertices = marked(found, kVertex);
  const auto flat = std::find_if(vertices.begin(), vertices.end(),
                                 [](const CombSample* s) { return std::abs(s->parameter) < 1e-3; });
  ASSERT_NE(flat, vertices.end());
  EXPECT_NEAR((*flat)->parameter, 0.0, 1e-4);
  EXPECT_NEAR((**flat)[CombQuantity::kCurvatureRate2], 24.0, 1e-4) << "kappa = 12 x^2 + ...";
  EXPECT_LE(((*flat)->normal - Vector3::UnitY()).norm(), 1e-6);
}

TEST(CombMarks, AnInflectionAtAKnotIsMarked) {
  // x^3 on both sides of its inflection, as one B-spline with a knot of full multiplicity there
  const BSplineData data{
      .poles = columns(
          {{-3, -27, 0}, {-2, 0, 0}, {-1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 27, 0}}),
      .weights = {},
      .knots = {{0, 1, 2}, {4, 3, 4}},
      .degree = 3,
      .periodic = false,
      .poleError = 0.0};
  const Comb found = comb(BSplineCurve(data));
  ASSERT_EQ(marked(found, kInflection).size(), 1U);
  EXPECT_EQ(marked(found, kInflection)[0]->parameter, 1.0);
}

TEST(CombMarks, OppositeArcsInflectWhereTheyMeetThoughTheirCurvatureJumps) {
  const double w = std::numbers::sqrt2 / 2.0;
  const BSplineData data{
      .poles = columns({{1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {-1, 1, 0}, {-1, 2, 0}}),
      .weights = {1, w, 1, w, 1},
      .knots = {{0, 1, 2}, {3, 2, 3}},
      .degree = 2,
      .periodic = false,
      .poleError = 0.0};
  const Comb found = comb(BSplineCurve(data));
  ASSERT_EQ(found.marks.size(), 1U);
  EXPECT_EQ(found.marks[0].kind, kInflection);
  EXPECT_EQ(found.samples[found.marks[0].sample].parameter, 1.0);
}

TEST(CombMarks, ACuspIsMarkedAndIsNoVertex) {
  const BSplineCurve curve(
      BezierCurve(std::vector<Vector3>{{1, -1, 0}, {-1, 2, 0}, {0, -4, 0}, {4, 8, 0}}));
  for (const int density : {24, 25}) {
    const Comb found = comb(curve, {.density = density});
    ASSERT_EQ(marked(found, kCusp).size(), 1U);
    EXPECT_NEAR(marked(found, kCusp)[0]->parameter, 1.0 / 3.0, 1e-9);
    EXPECT_TRUE(marked(found, kVertex).empty());
  }
}

TEST(CombMarks, ANarrowTurnIsAVertexAndNoCusp) {
  // (t^2, t^3 + t / 500) turns within a radius of 1/500^2 / 2
  const BSplineCurve curve = [] {
    PointSeries taylor{Point<Real>(Real(0.49), Real(-0.343 - 0.0014), 0),
                       Point<Real>(Real(-1.4), Real(1.47 + 0.002), 0),
                       Point<Real>(Real(1), Real(-2.1), 0), Point<Real>(0, Real(1), 0)};
    return BSplineCurve(roundedCurve(bezierNet(taylor)));
  }();
  const Comb found = comb(curve);
  EXPECT_TRUE(marked(found, kCusp).empty());
  const auto vertices = marked(found, kVertex);
  ASSERT_FALSE(vertices.empty());
  const auto sharpest = std::max_element(
      vertices.begin(), vertices.end(),
      [](const CombSample* a, const CombSample* b) { return a->value[0] < b->value[0]; });
  EXPECT_NEAR((*sharpest)->parameter, 0.7, 1e-3);
  EXPECT_NEAR((**sharpest)[CombQuantity::kCurvature], 2.0 * 500.0 * 500.0, 5e3);
}

/// Local maxima of the magnitude by brute force; where both sides of a knot agree they count once.
int maximaByCounting(const BSplineCurve& curve, std::size_t q) {
  constexpr int kSteps = 40000;
  std::vector<double> values;
  const auto add = [&](double t, Side side) {
    const Invariants at = geometryAt(curve, t, side).invariants;
    const std::array<std::optional<double>, 5> all{at.curvature, at.torsion, at.curvatureRate,
                                                   at.curvatureRate2, at.torsionRate};
    const double value = std::abs(all[q].value_or(0.0));
    const bool isSame = !values.empty() && std::abs(value - values.back()) <= 1e-9 * value;
    if (!isSame || side == Side::kLeft) values.push_back(value);
  };
  for (int span = 0; span < curve.spanCount(); ++span) {
    const BezierSegment segment = curve.segment(span);
    for (int i = 0; i < kSteps; ++i)
      add(std::lerp(segment.first, segment.last, i / double(kSteps)), Side::kRight);
    add(segment.last, Side::kLeft);
  }
  int count = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const bool overLeft = i == 0 || values[i] > values[i - 1];
    const bool overRight = i + 1 == values.size() || values[i] > values[i + 1];
    if (overLeft && overRight) ++count;
  }
  return count;
}

TEST(CombMarks, PeaksAreAllLocalMaximaAndNothingElse) {
  Random random(190);
  for (int round = 0; round < 4; ++round) {
    const BSplineCurve curve(randomSplineData(
        random, 3 + round, {{0, 1, 2}, {4 + round, 1 + round, 4 + round}}, round % 2 == 1));
    const Comb found = comb(curve);
    for (std::size_t q = 0; q < kCombQuantities; ++q) {
      SCOPED_TRACE(std::string(name(static_cast<CombQuantity>(q))) + " of curve " +
                   std::to_string(round));
      EXPECT_EQ(static_cast<int>(marked(found, kPeak, static_cast<CombQuantity>(q)).size()),
                maximaByCounting(curve, q));
    }
  }
}

TEST(CombMarks, PeaksAreStationaryToRounding) {
  Random random(191);
  const BSplineCurve curve(randomSplineData(random, 5, {{0, 1}, {6, 6}}, true));
  const Comb found = comb(curve);
  int inside = 0;
  for (const CombMark& mark : found.marks) {
    const CombSample& at = found.samples[mark.sample];
    if (mark.kind != kPeak || at.parameter == 0.0 || at.parameter == 1.0) continue;
    if (mark.quantity == CombQuantity::kCurvature) {
      EXPECT_NEAR(at[CombQuantity::kCurvatureRate], 0.0, 1e-9);
      ++inside;
    } else if (mark.quantity == CombQuantity::kTorsion) {
      EXPECT_NEAR(at[CombQuantity::kTorsionRate], 0.0, 1e-7);
      ++inside;
    } else if (mark.quantity == CombQuantity::kCurvatureRate) {
      EXPECT_NEAR(at[CombQuantity::kCurvatureRate2], 0.0, 1e-7);
      ++inside;
    }
  }
  EXPECT_GE(inside, 3);
}

TEST(CombMarks, OnlyShownQuantitiesHavePeaks) {
  Random random(192);
  const BSplineCurve curve(randomSplineData(random, 5, {{0, 1}, {6, 6}}, false));
  const Comb found = comb(curve, {.shown = {false, true, false, false, false}});
  for (const CombMark& mark : found.marks)
    EXPECT_TRUE(mark.kind != kPeak || mark.quantity == CombQuantity::kTorsion);
  EXPECT_FALSE(marked(found, kVertex).empty());
}

TEST(CombMarks, StayWhereTheyAreUnderMotionScalingAndElevation) {
  Random random(193);
  const BSplineCurve curve(randomSplineData(random, 4, {{0, 1, 2}, {5, 1, 5}}, false));
  const Comb plain = comb(curve);
  Eigen::Affine3d motion = Eigen::Translation3d(100, -50, 20) *
                           Eigen::AngleAxisd(0.7, Vector3(1, 2, 3).normalized()) *
                           Eigen::Scaling(0.01);
  for (const BSplineCurve& same : {curve.transformed(motion), curve.elevated(2)}) {
    const Comb other = comb(same);
    ASSERT_EQ(other.marks.size(), plain.marks.size());
    for (std::size_t i = 0; i < plain.marks.size(); ++i) {
      EXPECT_EQ(other.marks[i].kind, plain.marks[i].kind);
      EXPECT_NEAR(other.samples[other.marks[i].sample].parameter,
                  plain.samples[plain.marks[i].sample].parameter, 1e-5);
    }
  }
}

}  // namespace
}  // namespace osculate::test
