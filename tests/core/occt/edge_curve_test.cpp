// Edges as wholes: placement, direction, what is refused, and the way back.
#include "osculate/occt/edge_curve.h"

#include <limits>
#include <numbers>

#include <gtest/gtest.h>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Line.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include "occt/edge_samples.h"
#include "osculate/occt/occt_error.h"
#include "support/errors.h"
#include "support/exact.h"

namespace osculate::test {
namespace {

gp_Trsf randomPlacement(Random& random, double size) {
  const Vector3 axis = random.direction();
  const Vector3 move = random.vector(size);
  gp_Trsf rotation;
  rotation.SetRotation(gp_Ax1(gp::Origin(), gp_Dir(axis.x(), axis.y(), axis.z())),
                       random.uniform(0.0, 6.0));
  gp_Trsf translation;
  translation.SetTranslation(gp_Vec(move.x(), move.y(), move.z()));
  return translation * rotation;
}

/// Edges of several kinds, each with a range that is not its curve's.
std::vector<TopoDS_Edge> edgesOfManyKinds(Random& random) {
  return {edgeOf(randomSpline(random, 3, kClamped, true), 0.5, 3.5),
          edgeOf(randomSpline(random, 3, kPeriodic, true, true), 0.8, 1.3),
          edgeOf(new Geom_Circle(gp_Ax2(gp_Pnt(1, 2, 3), gp_Dir(1, 1, 0)), 2.0), 1.0, 4.0),
          edgeOf(new Geom_Line(gp_Pnt(1, 2, 3), gp_Dir(1, 1, 0)), -1.0, 4.0)};
}

TEST(EdgeCurve, PlacementIsApplied) {
  Random random(1);
  for (const TopoDS_Edge& edge : edgesOfManyKinds(random)) {
    const TopoDS_Shape moved = edge.Located(TopLoc_Location(randomPlacement(random, 10.0)));
    const EdgeCurve converted = curveFromEdge(moved);
    EXPECT_LE(largestDistance(converted, TopoDS::Edge(moved)), 1e-13);
    EXPECT_LE(converted.errorMm, 1e-14);
    EXPECT_EQ(converted.kind, curveFromEdge(edge).kind);
  }
}

TEST(EdgeCurve, MirroredAndScaledPlacementIsApplied) {
  Random random(2);
  gp_Trsf mirror;
  mirror.SetMirror(gp_Ax2(gp_Pnt(1, 0, 0), gp_Dir(1, 2, 3)));
  gp_Trsf scale;
  scale.SetScale(gp_Pnt(1, 2, 3), 2.5);
  for (const TopoDS_Edge& edge : edgesOfManyKinds(random)) {
    for (const gp_Trsf& placement : {mirror, scale}) {
      const TopoDS_Shape moved = edge.Located(TopLoc_Location(placement), Standard_False);
      const BSplineCurve curve = curveFromEdge(moved).curve;
      const BSplineCurve local = curveFromEdge(edge).curve;
      for (const double share : {0.0, 0.25, 1.0}) {
        const double t = (1.0 - share) * local.first() + share * local.last();
        const Vector3 p = local.evaluate(t);
        const gp_Pnt expected = gp_Pnt(p.x(), p.y(), p.z()).Transformed(placement);
        EXPECT_LE((curve.evaluate(t) - toVector(expected.XYZ())).norm(), 1e-13);
      }
    }
  }
}

/// A placement that brings poles back from far away leaves the rounding of far away.
TEST(EdgeCurve, PoleErrorBoundsTheRoundingOfAPlacement) {
  Random random(3);
  double worst = 0.0;
  for (int i = 0; i < 100; ++i) {
    const gp_Trsf placement = randomPlacement(random, 1e6);
    const auto spline = randomSpline(random, 3, kClamped, false);
    spline->Transform(placement.Inverted());
    const TopoDS_Shape edge = edgeOf(spline).Located(TopLoc_Location(placement));
    const BSplineCurve curve = curveFromEdge(edge).curve;
    const Poles poles = dataOf(*spline).poles;
    for (Eigen::Index k = 0; k < poles.cols(); ++k) {
      Point<Real> exactPole;
      for (int row = 0; row < 3; ++row) {
        exactPole[row] = Real(placement.Value(row + 1, 4));
        for (int c = 0; c < 3; ++c)
          exactPole[row] += Real(placement.Value(row + 1, c + 1)) * Real(poles(c, k));
      }
      worst = std::max(worst, distance(exactPole, curve.data().poles.col(k)) / curve.poleError());
    }
    EXPECT_LE(curve.poleError(), 1e-8);
  }
  EXPECT_LE(worst, 1.0);
  EXPECT_GE(worst, 0.05) << "the bound says nothing";
}

TEST(EdgeCurve, ReversedEdgeIsTravelledBackwards) {
  Random random(4);
  for (const TopoDS_Edge& edge : edgesOfManyKinds(random)) {
    const TopoDS_Shape placed = edge.Located(TopLoc_Location(randomPlacement(random, 10.0)));
    const TopoDS_Edge reversed = TopoDS::Edge(placed.Reversed());
    const EdgeCurve converted = curveFromEdge(reversed);
    EXPECT_LE(largestDistance(converted, reversed), 1e-13);
    EXPECT_EQ(converted.curve.endPoint(CurveEnd::kStart),
              curveFromEdge(placed).curve.endPoint(CurveEnd::kEnd));
  }
}

TEST(EdgeCurve, ReversedWholeSplineKeepsTheBitsOfItsPoles) {
  Random random(5);
  const auto spline = randomSpline(random, 3, kClamped, true);
  const BSplineCurve curve = curveFromEdge(edgeOf(spline).Reversed()).curve;
  EXPECT_EQ(curve.data().poles, dataOf(*spline).poles.rowwise().reverse());
}

TEST(EdgeCurve, InternalEdgeIsTravelledForwards) {
  Random random(6);
  const TopoDS_Edge edge = edgeOf(randomSpline(random, 3, kClamped, true));
  const TopoDS_Shape internal = edge.Oriented(TopAbs_INTERNAL);
  EXPECT_EQ(curveFromEdge(internal).curve.data().poles, curveFromEdge(edge).curve.data().poles);
}

TEST(EdgeCurve, RefusesWhatIsNoEdge) {
  const TopoDS_Shape face = BRepBuilderAPI_MakeFace(gp_Pln(), 0.0, 1.0, 0.0, 1.0);
  EXPECT_ERROR(curveFromEdge(TopoDS_Shape()), "edge: the shape is null");
  EXPECT_ERROR(curveFromEdge(TopoDS_Edge()), "edge: the shape is null");
  const TopoDS_Shape vertex = BRepBuilderAPI_MakeVertex(gp_Pnt(1, 2, 3));
  EXPECT_ERROR(curveFromEdge(face), "edge: an edge is needed, got a face");
  EXPECT_ERROR(curveFromEdge(TopExp_Explorer(face, TopAbs_WIRE).Current()), "got a wire");
  EXPECT_ERROR(curveFromEdge(vertex), "edge: an edge is needed, got a vertex");
}

TEST(EdgeCurve, RefusesDegeneratedEdgesOnly) {
  const double half = 0.5 * std::numbers::pi;
  const TopoDS_Shape sphere =
      BRepBuilderAPI_MakeFace(gp_Sphere(gp_Ax3(), 2.0), 0.0, 4.0 * half, -half, half);
  int degenerated = 0;
  for (TopExp_Explorer it(sphere, TopAbs_EDGE); it.More(); it.Next()) {
    if (BRep_Tool::Degenerated(TopoDS::Edge(it.Current()))) {
      ++degenerated;
      EXPECT_ERROR(curveFromEdge(it.Current()), "edge: is degenerated");
    } else {
      EXPECT_EQ(curveFromEdge(it.Current()).kind, EdgeCurveKind::kCircle);
    }
  }
  EXPECT_EQ(degenerated, 2);
}

TEST(EdgeCurve, RefusesEdgesWithoutFiniteGeometry) {
  TopoDS_Edge empty;
  BRep_Builder().MakeEdge(empty);
  EXPECT_ERROR(curveFromEdge(empty), "edge: has no geometry");
  const Handle(Geom_Line) line = new Geom_Line(gp::OX());
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_ERROR(curveFromEdge(edgeOf(line)), "edge: is infinite");
  EXPECT_ERROR(curveFromEdge(edgeOf(line, 0.0, 2e100)), "edge: is infinite");
  EXPECT_ERROR(curveFromEdge(edgeOf(line, -infinity, 0.0)), "edge: is infinite");
  EXPECT_ERROR(curveFromEdge(edgeOf(line, 1.0, 1.0)), "edge: its parameter range is empty");
}

TEST(EdgeCurve, RefusesEdgesOfZeroLength) {
  Random random(7);
  BSplineData data = randomSplineData(random, 3, kClamped, false);
  data.poles.colwise() = Vector3(1.0, 2.0, 3.0);
  EXPECT_ERROR(curveFromEdge(edgeOf(geomFrom(data))), "zero length");
  const Handle(Geom_Line) far = new Geom_Line(gp_Pnt(1e5, 0, 0), gp::DX());
  EXPECT_ERROR(curveFromEdge(edgeOf(far, 0.0, 1e-14)), "zero length");
}

class WayBack : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(PolynomialAndRational, WayBack, testing::Bool());

TEST_P(WayBack, KeepsEveryBit) {
  Random random(8);
  for (const bool periodic : {false, true}) {
    BSplineData data =
        randomSplineData(random, 3, periodic ? kPeriodic : kClamped, GetParam(), periodic);
    data.poles(0, 1) = 5e-324;
    data.poles(1, 1) = -0.0;
    const BSplineCurve curve(data);
    const BSplineData back = curveFromEdge(edgeFromCurve(curve)).curve.data();
    EXPECT_EQ(back.poles, data.poles);
    EXPECT_TRUE(std::signbit(back.poles(1, 1)));
    EXPECT_EQ(back.weights, data.weights);
    EXPECT_EQ(back.knots.knots, data.knots.knots);
    EXPECT_EQ(back.knots.multiplicities, data.knots.multiplicities);
    EXPECT_EQ(back.periodic, periodic);
  }
}

TEST(EdgeCurve, EqualWeightsStayInTheEdge) {
  Random random(9);
  BSplineData data = randomSplineData(random, 3, kClamped, false);
  data.weights.assign(static_cast<std::size_t>(data.poles.cols()), 2.0);
  EXPECT_EQ(curveFromEdge(edgeFromCurve(BSplineCurve(data))).curve.data().weights, data.weights);
}

TEST(EdgeCurve, CurveThatNoEdgeCanHoldIsRefused) {
  Random random(10);
  const KnotVector torn{{0.0, 1.0, 2.0}, {4, 4, 4}};
  EXPECT_ERROR(edgeFromCurve(BSplineCurve(randomSplineData(random, 3, torn, false))),
               "curve: is torn at the inner knot 2");
  const KnotVector close{{0.0, 1.0, std::nextafter(1.0, 2.0), 2.0}, {4, 1, 1, 4}};
  EXPECT_THROW(edgeFromCurve(BSplineCurve(randomSplineData(random, 3, close, false))), OcctError);
}

TEST(EdgeCurve, KindsHaveNames) {
  EXPECT_EQ(name(EdgeCurveKind::kBSpline), "bspline");
  EXPECT_EQ(name(EdgeCurveKind::kHyperbola), "hyperbola");
  EXPECT_EQ(name(EdgeCurveKind::kFitted), "fitted");
}

}  // namespace
}  // namespace osculate::test
