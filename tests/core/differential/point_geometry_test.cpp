#include "osculate/differential/point_geometry.h"

#include "support/designed_curves.h"
#include "support/exact_spline.h"
#include "support/spline_samples.h"

namespace osculate::test {
namespace {

void expectInvariants(const Invariants& found, const ExactInvariants& expected) {
  ASSERT_TRUE(found.curvature && found.torsion && found.curvatureRate && found.curvatureRate2 &&
              found.torsionRate);
  const double curvature = toDouble(expected.curvature);
  const double unit = std::max(1.0, curvature) / std::min(1.0, curvature);  // of the conditioning
  EXPECT_NEAR(*found.curvature, curvature, 1e-10 * unit);
  EXPECT_NEAR(*found.torsion, toDouble(expected.torsion), 1e-10 * unit * unit);
  EXPECT_NEAR(*found.curvatureRate, toDouble(expected.curvatureRate), 1e-9 * unit * unit);
  EXPECT_NEAR(*found.curvatureRate2, toDouble(expected.curvatureRate2), 1e-8 * unit * unit * unit);
  EXPECT_NEAR(*found.torsionRate, toDouble(expected.torsionRate), 1e-8 * unit * unit * unit);
}

TEST(GeometryAt, GivesTheInvariantsOfTheSideAskedFor) {
  Random random(160);
  for (const bool rational : {false, true}) {
    // a knot of multiplicity 2: the quintic is C^3 there, so that its fourth derivatives differ
    const BSplineData data = randomSplineData(random, 5, {{0, 1, 2.5, 4}, {6, 2, 1, 6}}, rational);
    const BSplineCurve curve(data);
    const auto reference = exactSpline<Real>(data);
    for (const double t : {0.0, 0.3, 0.9, 1.0, 2.5, 3.75, 4.0}) {
      for (const Side side : {Side::kLeft, Side::kRight}) {
        SCOPED_TRACE("t = " + std::to_string(t) +
                     (side == Side::kLeft ? " from the left" : " from the right"));
        const PointSeries p = taylor(reference, Real(t), 5,
                                     t == 4.0   ? Side::kLeft
                                     : t == 0.0 ? Side::kRight
                                                : side);
        const PointGeometry found = geometryAt(curve, t, side);
        EXPECT_LE(distance(p[0], found.point), 1e-13);
        EXPECT_LE(distance(Point<Real>(p[1].normalized()), found.frame.tangent), 1e-12);
        EXPECT_EQ(found.smoothness, 4);
        EXPECT_EQ(found.kind, FrameKind::kFrenet);
        expectInvariants(found.invariants, invariants(p));
      }
    }
  }
}

TEST(GeometryAt, BothSidesOfASmoothPointAgreeAndReversalTurnsTheSigns) {
  Random random(161);
  const BSplineCurve curve(randomSplineData(random, 5, {{0, 1, 2}, {6, 1, 6}}, false));
  const BSplineCurve turned = curve.reversed();
  for (const double t : {0.25, 0.7, 1.4}) {
    const PointGeometry left = geometryAt(curve, t, Side::kLeft);
    const PointGeometry right = geometryAt(curve, t, Side::kRight);
    EXPECT_EQ(left.invariants.curvature, right.invariants.curvature);
    const PointGeometry back = geometryAt(turned, 2.0 - t);
    EXPECT_LE((back.frame.tangent + right.frame.tangent).norm(), 1e-12);
    EXPECT_LE((*back.frame.normal - *right.frame.normal).norm(), 1e-10);
    EXPECT_NEAR(*back.invariants.torsion, *right.invariants.torsion, 1e-10);
    EXPECT_NEAR(*back.invariants.curvatureRate, -*right.invariants.curvatureRate, 1e-10);
    EXPECT_NEAR(*back.invariants.torsionRate, -*right.invariants.torsionRate, 1e-9);
  }
}

TEST(GeometryAt, ARationalCircleHasItsRadiusEverywhere) {
  const double root = std::sqrt(0.5);
  const BSplineData circle{.poles = columns({{5, 0, 0},
                                             {5, 5, 0},
                                             {0, 5, 0},
                                             {-5, 5, 0},
                                             {-5, 0, 0},
                                             {-5, -5, 0},
                                             {0, -5, 0},
                                             {5, -5, 0},
                                             {5, 0, 0}}),
                           .weights = {1, root, 1, root, 1, root, 1, root, 1},
                           .knots = {{0, 1, 2, 3, 4}, {3, 2, 2, 2, 3}},
                           .degree = 2,
                           .periodic = false,
                           .poleError = 0.0};
  const BSplineCurve curve(circle);
  for (int i = 0; i <= 16; ++i) {
    const PointGeometry found = geometryAt(curve, 0.25 * i);
    EXPECT_NEAR(*found.invariants.curvature, 0.2, 1e-14);
    EXPECT_NEAR(*found.invariants.torsion, 0.0, 1e-13);
    EXPECT_NEAR(*found.invariants.curvatureRate, 0.0, 1e-13);
    EXPECT_LE((*found.frame.normal + found.point / 5.0).norm(), 1e-13) << "towards the centre";
  }
}

TEST(GeometryAt, AnInflectionHasNoNormalButAFrameKind) {
  // (x, x^3) has its inflection at x = 0, the middle of the range
  const BSplineCurve curve(
      BezierCurve(std::vector<Vector3>{{-3, -27, 0}, {-1, 27, 0}, {1, -27, 0}, {3, 27, 0}}));
  const PointGeometry found = geometryAt(curve, 0.5);
  ASSERT_TRUE(found.invariants.curvature);
  EXPECT_NEAR(*found.invariants.curvature, 0.0, 1e-12);
  EXPECT_FALSE(found.frame.normal || found.invariants.torsion || found.invariants.curvatureRate);
  EXPECT_EQ(found.kind, FrameKind::kFictitiousNormal);
  EXPECT_LE((found.frame.tangent - Vector3::UnitX()).norm(), 1e-14);
}

TEST(GeometryAt, ALineHasATangentAndZeroCurvatureOnly) {
  const BSplineCurve line(BezierCurve(std::vector<Vector3>{{0, 0, 0}, {3, 4, 0}}));
  const PointGeometry found = geometryAt(line, 0.25);
  EXPECT_EQ(found.kind, FrameKind::kLine);
  EXPECT_LE((found.frame.tangent - Vector3(0.6, 0.8, 0)).norm(), 1e-15);
  EXPECT_EQ(found.invariants.curvature, 0.0);
  EXPECT_FALSE(found.invariants.torsion);
}

TEST(GeometryAt, ACuspHasATangentOnEachSideAndNoCurvature) {
  // (t^2, t^3) for t in [-1, 1], the cusp in the middle of the range
  const BSplineCurve curve(BezierCurve(
      std::vector<Vector3>{{1, -1, 0}, {-1.0 / 3, 1, 0}, {-1.0 / 3, -1, 0}, {1, 1, 0}}));
  const PointGeometry found = geometryAt(curve, 0.5);
  EXPECT_EQ(found.kind, FrameKind::kFictitiousTangent);
  EXPECT_EQ(found.smoothness, 1);
  EXPECT_FALSE(found.invariants.curvature);
}

TEST(GeometryAt, ADoubleEndPoleOfARegularTraceHasItsCurvature) {
  // the parabola (u, u^2) with u = t^2
  const BSplineCurve curve(BezierCurve(
      std::vector<Vector3>{{0, 0, 0}, {0, 0, 0}, {1.0 / 6, 0, 0}, {0.5, 0, 0}, {1, 1, 0}}));
  const PointGeometry found = geometryAt(curve, 0.0);
  EXPECT_EQ(found.kind, FrameKind::kFictitiousTangent);
  EXPECT_EQ(found.smoothness, 4);
  ASSERT_TRUE(found.invariants.curvature && found.invariants.curvatureRate2);
  EXPECT_NEAR(*found.invariants.curvature, 2.0, 1e-12);
  // kappa = 2 (1 + 4 u^2)^(-3/2), ds = du (1 + 2 u^2 + ...): kappa'' = -24 at the vertex
  EXPECT_NEAR(*found.invariants.curvatureRate2, -24.0, 1e-9);
  EXPECT_LE((*found.frame.normal - Vector3::UnitY()).norm(), 1e-14);
}

}  // namespace
}  // namespace osculate::test
