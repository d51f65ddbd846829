// Splines, trims and offsets: the part of the curve that the edge has.
#include "osculate/occt/space_curve.h"

#include <numbers>

#include <gtest/gtest.h>
#include <Geom_Circle.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_Line.hxx>
#include <Geom_OffsetCurve.hxx>
#include <Geom_TrimmedCurve.hxx>

#include "occt/edge_samples.h"
#include "support/errors.h"

namespace osculate::test {
namespace {

const KnotVector kUnclamped{{-2.0, -1.0, 0.0, 1.0, 2.5, 4.0, 5.0, 7.0}, {1, 1, 2, 1, 2, 1, 1, 2}};

void expectSameBits(const BSplineCurve& curve, const Geom_BSplineCurve& spline) {
  const BSplineData expected = dataOf(spline);
  const BSplineData& data = curve.data();
  EXPECT_EQ(data.poles, expected.poles);
  EXPECT_EQ(data.weights, expected.weights);
  EXPECT_EQ(data.knots.knots, expected.knots.knots);
  EXPECT_EQ(data.knots.multiplicities, expected.knots.multiplicities);
  EXPECT_EQ(data.degree, spline.Degree());
  EXPECT_EQ(data.periodic, bool(spline.IsPeriodic()));
  EXPECT_EQ(data.poleError, 0.0);
}

/// Derivatives 0 to 4 between the knots, where both sides agree; u = t + shift is OpenCASCADE's.
void expectSameDerivatives(const BSplineCurve& curve, const Geom_Curve& expected,
                           double shift = 0.0) {
  for (int span = 0; span < curve.spanCount(); ++span) {
    const BezierSegment segment = curve.segment(span);
    for (const double share : {0.1, 0.5, 0.9}) {
      const double t = segment.first + share * segment.length();
      const auto ours = curve.derivatives(t, 4);
      const auto theirs = occtDerivatives(expected, t + shift);
      for (std::size_t k = 0; k <= 4; ++k) {
        const double size = largestPole(curve) / std::pow(segment.length(), static_cast<double>(k));
        EXPECT_LE((ours[k] - theirs[k]).norm(), 1e-11 * size) << "derivative " << k << " at " << t;
      }
    }
  }
}

class Spline : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(PolynomialAndRational, Spline, testing::Bool());

TEST_P(Spline, WholeCurveKeepsItsBits) {
  Random random(1);
  for (const auto& [knots, periodic] :
       {std::pair(kClamped, false), std::pair(kUnclamped, false), std::pair(kPeriodic, true)}) {
    const auto spline = randomSpline(random, 3, knots, GetParam(), periodic);
    const EdgeCurve converted = curveFromEdge(edgeOf(spline));
    EXPECT_EQ(converted.kind, EdgeCurveKind::kBSpline);
    EXPECT_EQ(converted.errorMm, 0.0);
    expectSameBits(converted.curve, *spline);
    expectSameDerivatives(converted.curve, *spline);
  }
}

TEST_P(Spline, TrimIsThePartOfTheCurve) {
  Random random(2);
  for (int i = 0; i < 50; ++i) {
    const auto& knots = i % 2 == 0 ? kClamped : kUnclamped;
    const auto spline = randomSpline(random, 3, knots, GetParam());
    const double first = random.uniform(0.0, 3.0);
    const double last = random.uniform(first + 0.1, 4.0);
    const EdgeCurve converted = curveFromEdge(edgeOf(spline, first, last));
    EXPECT_EQ(converted.curve.first(), first);
    EXPECT_EQ(converted.curve.last(), last);
    EXPECT_EQ(converted.errorMm, 0.0);
    expectSameDerivatives(converted.curve, *spline);
  }
}

TEST_P(Spline, PeriodicCurveMayBeCrossedAtItsSeamInAnyTurn) {
  Random random(3);
  const auto spline = randomSpline(random, 3, kPeriodic, GetParam(), true);
  for (const auto& [first, last] :
       {std::pair(0.8, 1.3), std::pair(1.8, 2.3), std::pair(-0.2, 0.3), std::pair(0.3, 1.3),
        std::pair(0.9, 1.9), std::pair(0.1, 0.4)}) {
    SCOPED_TRACE(std::to_string(first) + " to " + std::to_string(last));
    const EdgeCurve converted = curveFromEdge(edgeOf(spline, first, last));
    EXPECT_EQ(converted.curve.first(), first);
    EXPECT_EQ(converted.curve.last(), last);
    EXPECT_FALSE(converted.curve.isPeriodic());
    expectSameDerivatives(converted.curve, *spline);
  }
}

TEST_P(Spline, BezierKeepsItsBitsAndItsTrim) {
  Random random(4);
  const auto poles = randomPoles(random, 26);
  TColgp_Array1OfPnt array(1, 26);
  TColStd_Array1OfReal weights(1, 26);
  for (int i = 0; i < 26; ++i) {
    const Vector3& pole = poles[static_cast<std::size_t>(i)];
    array.SetValue(i + 1, gp_Pnt(pole.x(), pole.y(), pole.z()));
    weights.SetValue(i + 1, random.uniform(1.0, 2.0));
  }
  const Handle(Geom_BezierCurve) bezier =
      GetParam() ? new Geom_BezierCurve(array, weights) : new Geom_BezierCurve(array);
  const EdgeCurve whole = curveFromEdge(edgeOf(bezier));
  EXPECT_EQ(whole.kind, EdgeCurveKind::kBezier);
  EXPECT_EQ(whole.curve.data().poles, columns(poles));
  EXPECT_EQ(whole.curve.data().weights, dataOf(*bezier).weights);
  const TopoDS_Edge part = edgeOf(bezier, 0.25, 0.75);
  EXPECT_LE(largestDistance(curveFromEdge(part), part), 1e-13);
}

TEST(SpaceCurve, TrimThatMissesAKnotByRoundingLeavesNoSliver) {
  Random random(5);
  const auto spline = randomSpline(random, 3, kClamped, false);
  const EdgeCurve inner = curveFromEdge(edgeOf(spline, 1.0 - 4e-16, 2.5 + 4e-16));
  EXPECT_EQ(inner.curve.spanCount(), 1);
  EXPECT_EQ(inner.curve.first(), 1.0);
  EXPECT_EQ(inner.curve.last(), 2.5);
  EXPECT_GT(inner.errorMm, 0.0);
  EXPECT_LE(inner.errorMm, 1e-13);
  EXPECT_GE(inner.curve.poleError(), inner.errorMm);
  const EdgeCurve whole = curveFromEdge(edgeOf(spline, -1e-15, 4.0 + 1e-15));
  EXPECT_EQ(whole.curve.data().poles, dataOf(*spline).poles);
  EXPECT_EQ(curveFromEdge(edgeOf(spline, 1.0 - 1e-9, 2.5)).curve.spanCount(), 2);
}

TEST(SpaceCurve, TrimNearTheSeamSnapsToIt) {
  Random random(6);
  const auto spline = randomSpline(random, 3, kPeriodic, false, true);
  EXPECT_EQ(curveFromEdge(edgeOf(spline, 1.0 - 1e-16, 1.3)).curve.spanCount(), 1);
  EXPECT_EQ(curveFromEdge(edgeOf(spline, 0.5, 1.0 + 4e-16)).curve.spanCount(), 1);
}

TEST(SpaceCurve, RangeOutsideTheCurveIsRefused) {
  Random random(7);
  const auto spline = randomSpline(random, 3, kClamped, false);
  EXPECT_ERROR(curveFromEdge(edgeOf(spline, -0.5, 2.0)), "edge: its range");
  EXPECT_ERROR(curveFromEdge(edgeOf(spline, 1.0, 4.1)), "edge: its range");
}

TEST(SpaceCurve, TrimmedCurvesGiveWayToTheEdgesRange) {
  Random random(8);
  const auto spline = randomSpline(random, 3, kClamped, true);
  const Handle(Geom_TrimmedCurve) once = new Geom_TrimmedCurve(spline, 0.5, 3.5);
  const Handle(Geom_TrimmedCurve) twice = new Geom_TrimmedCurve(once, 1.0, 3.0);
  const TopoDS_Edge edge = edgeOf(twice, 1.2, 2.8);
  EXPECT_EQ(curveFromEdge(edge).curve.first(), 1.2);
  EXPECT_LE(largestDistance(curveFromEdge(edge), edge), 1e-13);
  const Handle(Geom_TrimmedCurve) back = new Geom_TrimmedCurve(spline, 0.5, 3.5, false);
  const TopoDS_Edge backward = edgeOf(back);
  EXPECT_LE(largestDistance(curveFromEdge(backward), backward), 1e-13);
}

TEST(SpaceCurve, OffsetOfALineIsALine) {
  const Handle(Geom_Line) line = new Geom_Line(gp_Pnt(1, 2, 3), gp_Dir(1, 1, 0));
  const TopoDS_Edge edge = edgeOf(new Geom_OffsetCurve(line, -2.5, gp_Dir(0, 1, 1)), -1.0, 3.0);
  const EdgeCurve converted = curveFromEdge(edge);
  EXPECT_EQ(converted.kind, EdgeCurveKind::kLine);
  EXPECT_LE(largestDistance(converted, edge), 1e-15 * 8);
}

TEST(SpaceCurve, OffsetOfACircleInItsPlaneIsACircle) {
  const gp_Dir axis(1, 2, 2);
  const Handle(Geom_Circle) circle = new Geom_Circle(gp_Ax2(gp_Pnt(1, 2, 3), axis), 2.0);
  for (const gp_Dir& direction : {axis, axis.Reversed()}) {
    for (const double distance : {1.5, -1.5, -5.0, 5.0}) {  // 5 beyond the centre
      const TopoDS_Edge edge = edgeOf(new Geom_OffsetCurve(circle, distance, direction), 0.5, 4.0);
      const EdgeCurve converted = curveFromEdge(edge);
      EXPECT_EQ(converted.kind, EdgeCurveKind::kCircle);
      EXPECT_LE(largestDistance(converted, edge), 1e-14) << distance;
    }
  }
  EXPECT_ERROR(curveFromEdge(edgeOf(new Geom_OffsetCurve(circle, -2.0, axis), 0.0, 1.0)),
               "zero length");
}

TEST(SpaceCurve, OffsetOfACircleOutOfItsPlaneIsFitted) {
  const Handle(Geom_Circle) circle = new Geom_Circle(gp::XOY(), 2.0);
  const TopoDS_Edge edge = edgeOf(new Geom_OffsetCurve(circle, 1.0, gp_Dir(0, 1, 1)), 0.5, 4.0);
  const EdgeCurve converted = curveFromEdge(edge);
  EXPECT_EQ(converted.kind, EdgeCurveKind::kFitted);
  EXPECT_LE(largestDistance(converted, edge, 400), converted.errorMm);
}

/// Curvature of an offset: kappa / (1 + d kappa) with the offset d to the outer side, and its rate
/// kappa' / (1 + d kappa)^3 by the offset's own arc length.
TEST(SpaceCurve, OffsetOfAnEllipseHasTheCurvatureThatOffsetsHave) {
  constexpr double kDistance = 1.25;
  const Handle(Geom_Ellipse) ellipse = new Geom_Ellipse(gp::XOY(), 3.0, 2.0);
  const TopoDS_Edge edge =
      edgeOf(new Geom_OffsetCurve(ellipse, kDistance, gp::DZ()), 0.0, 2.0 * kPi);
  const EdgeCurve converted = curveFromEdge(edge);
  EXPECT_EQ(converted.kind, EdgeCurveKind::kFitted);
  EXPECT_LE(converted.errorMm, 1e-12);
  EXPECT_LE(largestDistance(converted, edge, 400), converted.errorMm);
  for (const double t : {0.0, 0.7, 2.0, 4.5, 2.0 * kPi}) {
    const auto basis = arcLengthDerivatives(occtDerivatives(*ellipse, t));
    const auto offset = arcLengthDerivatives(converted.curve.derivatives(t, 4));
    const double curvature = basis[2].norm();
    const double stretch = 1.0 + kDistance * curvature;
    EXPECT_NEAR(offset[2].norm(), curvature / stretch, 1e-10) << t;
    const double rate = basis[3].dot(basis[2].normalized());
    EXPECT_NEAR(offset[3].dot(offset[2].normalized()), rate / std::pow(stretch, 3), 1e-8) << t;
  }
}

TEST(SpaceCurve, OffsetOfASplineIsFittedBetweenItsKnots) {
  Random random(9);
  const auto spline = randomSpline(random, 3, kClamped, true);
  const TopoDS_Edge edge =
      edgeOf(new Geom_OffsetCurve(spline, 0.1, gp_Dir(0.3, 0.2, 1.0)), 0.5, 3.75);
  const EdgeCurve converted = curveFromEdge(edge);
  EXPECT_EQ(converted.kind, EdgeCurveKind::kFitted);
  EXPECT_EQ(converted.curve.first(), 0.5);
  EXPECT_EQ(converted.curve.last(), 3.75);
  EXPECT_LE(converted.errorMm, 1e-11);
  EXPECT_LE(largestDistance(converted, edge, 1000), converted.errorMm);
}

}  // namespace
}  // namespace osculate::test
