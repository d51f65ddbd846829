// Edges that have nothing but a curve on a surface.
#include "osculate/occt/surface_curve.h"

#include <numbers>

#include <gtest/gtest.h>
#include <BRepTools.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_Circle.hxx>
#include <Geom2d_Ellipse.hxx>
#include <Geom2d_Line.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <TColgp_Array2OfPnt.hxx>

#include "occt/edge_samples.h"

namespace osculate::test {
namespace {

TopoDS_Edge edgeOn(const Handle(Geom_Surface) & surface, const Handle(Geom2d_Curve) & pcurve,
                   double first, double last) {
  TopoDS_Edge edge;
  BRep_Builder builder;
  builder.MakeEdge(edge);
  builder.UpdateEdge(edge, pcurve, surface, TopLoc_Location(), 1e-7);
  builder.Range(edge, first, last);
  return edge;
}

gp_Ax3 position(bool rightHanded) {
  gp_Ax3 axes(gp_Pnt(1, 2, 3), gp_Dir(1, 2, 2));
  if (!rightHanded) axes.YReverse();
  return axes;
}

Handle(Geom_BezierSurface) bezierSurface(Random& random) {
  TColgp_Array2OfPnt poles(1, 4, 1, 3);
  for (int i = 1; i <= 4; ++i) {
    for (int j = 1; j <= 3; ++j)
      poles.SetValue(i, j, gp_Pnt(i, j, random.uniform(0.0, 1.0)));
  }
  return new Geom_BezierSurface(poles);
}

TEST(SurfaceCurve, CurveOnAPlaneIsExact) {
  TColgp_Array1OfPnt2d poles(1, 3);
  poles.SetValue(1, gp_Pnt2d(0, 0));
  poles.SetValue(2, gp_Pnt2d(1, 2));
  poles.SetValue(3, gp_Pnt2d(3, 1));
  TColStd_Array1OfReal knots(1, 2);
  knots.SetValue(1, 0.0);
  knots.SetValue(2, 2.0);
  const TColStd_Array1OfInteger multiplicities = [] {
    TColStd_Array1OfInteger three(1, 2);
    three.Init(3);
    return three;
  }();
  const Handle(Geom2d_BSplineCurve) spline =
      new Geom2d_BSplineCurve(poles, knots, multiplicities, 2);
  const gp_Ax22d leftHanded(gp_Pnt2d(1, 1), gp_Dir2d(3, 4), gp_Dir2d(4, -3));
  const std::pair<Handle(Geom2d_Curve), EdgeCurveKind> cases[] = {
      {spline, EdgeCurveKind::kBSpline},
      {new Geom2d_TrimmedCurve(spline, 0.1, 1.9), EdgeCurveKind::kBSpline},
      {new Geom2d_Line(gp_Pnt2d(1, 1), gp_Dir2d(3, 4)), EdgeCurveKind::kLine},
      {new Geom2d_Circle(leftHanded, 2.0), EdgeCurveKind::kCircle},
      {new Geom2d_Ellipse(leftHanded, 2.0, 1.0), EdgeCurveKind::kEllipse}};
  for (const bool rightHanded : {true, false}) {
    for (const auto& [pcurve, kind] : cases) {
      const TopoDS_Edge edge = edgeOn(new Geom_Plane(position(rightHanded)), pcurve, 0.25, 1.75);
      const EdgeCurve converted = curveFromEdge(edge);
      EXPECT_EQ(converted.kind, kind);
      EXPECT_EQ(converted.curve.first(), 0.25);
      EXPECT_EQ(converted.curve.last(), 1.75);
      EXPECT_LE(largestDistance(converted, edge), 1e-14) << name(kind);
    }
  }
}

TEST(SurfaceCurve, IsoparametricLineIsExactInBothDirections) {
  Random random(1);
  const Handle(Geom_Ellipse) ellipse =
      new Geom_Ellipse(gp_Ax2(gp_Pnt(9, 0, 0), gp::DY()), 3.0, 2.0);
  const std::pair<Handle(Geom_Surface), std::array<EdgeCurveKind, 2>> cases[] = {
      {new Geom_CylindricalSurface(position(true), 2.0),
       {EdgeCurveKind::kCircle, EdgeCurveKind::kLine}},
      {new Geom_CylindricalSurface(position(false), 2.0),
       {EdgeCurveKind::kCircle, EdgeCurveKind::kLine}},
      {new Geom_ConicalSurface(position(true), 0.3, 2.0),
       {EdgeCurveKind::kCircle, EdgeCurveKind::kLine}},
      {new Geom_SphericalSurface(position(true), 2.0),
       {EdgeCurveKind::kCircle, EdgeCurveKind::kCircle}},
      {new Geom_ToroidalSurface(position(false), 5.0, 2.0),
       {EdgeCurveKind::kCircle, EdgeCurveKind::kCircle}},
      {new Geom_SurfaceOfLinearExtrusion(ellipse, gp_Dir(1, 1, 1)),
       {EdgeCurveKind::kEllipse, EdgeCurveKind::kLine}},
      {new Geom_SurfaceOfRevolution(ellipse, gp::OZ()),
       {EdgeCurveKind::kCircle, EdgeCurveKind::kEllipse}},
      {bezierSurface(random), {EdgeCurveKind::kBezier, EdgeCurveKind::kBezier}},
      {new Geom_RectangularTrimmedSurface(bezierSurface(random), 0.1, 0.9, 0.1, 0.9),
       {EdgeCurveKind::kBezier, EdgeCurveKind::kBezier}}};
  const gp_Dir2d along[] = {gp_Dir2d(1, 0), gp_Dir2d(0, 1)};
  for (const auto& [surface, kinds] : cases) {
    for (const std::size_t direction : {0U, 1U}) {
      const gp_Dir2d& forward = along[direction];
      const double start = 0.125;
      const TopoDS_Edge there =
          edgeOn(surface, new Geom2d_Line(gp_Pnt2d(start, start), forward), 0.05, 0.5);
      const TopoDS_Edge back =
          edgeOn(surface, new Geom2d_Line(gp_Pnt2d(0.75, 0.75), forward.Reversed()), 0.05, 0.5);
      for (const TopoDS_Edge& edge : {there, back}) {
        const EdgeCurve converted = curveFromEdge(edge);
        EXPECT_EQ(converted.kind, kinds[direction]) << surface->DynamicType()->Name();
        EXPECT_EQ(converted.curve.first(), 0.05);
        EXPECT_EQ(converted.curve.last(), 0.5);
        EXPECT_LE(largestDistance(converted, edge), 1e-14) << surface->DynamicType()->Name();
      }
    }
  }
}

TEST(SurfaceCurve, HelixHasTheCurvatureAndTorsionOfAHelix) {
  constexpr double kRadius = 2.0;
  const Handle(Geom2d_Line) oblique = new Geom2d_Line(gp_Pnt2d(0, 0), gp_Dir2d(4, 3));
  const TopoDS_Edge edge =
      edgeOn(new Geom_CylindricalSurface(position(true), kRadius), oblique, 0.0, 10.0);
  const EdgeCurve converted = curveFromEdge(edge);
  EXPECT_EQ(converted.kind, EdgeCurveKind::kFitted);
  EXPECT_LE(converted.errorMm, 1e-12);
  EXPECT_LE(largestDistance(converted, edge, 400), converted.errorMm);
  // angle 0.8 t, height 0.6 t: kappa = r / (r^2 + c^2), tau = c / (r^2 + c^2), c the rise per
  // radian
  const double rise = 0.6 / 0.8;
  const double square = kRadius * kRadius + rise * rise;
  for (const double t : {0.0, 3.3, 10.0}) {
    const auto r = arcLengthDerivatives(converted.curve.derivatives(t, 4));
    EXPECT_NEAR(r[2].norm(), kRadius / square, 1e-10);
    EXPECT_NEAR(r[1].cross(r[2]).dot(r[3]) / r[2].squaredNorm(), rise / square, 1e-8);
    EXPECT_NEAR(r[3].dot(r[2].normalized()), 0.0, 1e-8);
  }
}

TEST(SurfaceCurve, CurveAcrossASplineSurfaceIsFittedBetweenItsKnots) {
  TColgp_Array2OfPnt poles(1, 5, 1, 4);
  Random random(2);
  for (int i = 1; i <= 5; ++i) {
    for (int j = 1; j <= 4; ++j)
      poles.SetValue(i, j, gp_Pnt(i, j, random.uniform(0.0, 1.0)));
  }
  TColStd_Array1OfReal u(1, 3);
  TColStd_Array1OfReal v(1, 2);
  TColStd_Array1OfInteger uMultiplicities(1, 3);
  TColStd_Array1OfInteger vMultiplicities(1, 2);
  for (int i = 1; i <= 3; ++i)
    u.SetValue(i, 0.5 * (i - 1));
  for (int i = 1; i <= 2; ++i)
    v.SetValue(i, i - 1.0);
  uMultiplicities.Init(4);
  uMultiplicities.SetValue(2, 1);
  vMultiplicities.Init(4);
  const Handle(Geom_BSplineSurface) surface =
      new Geom_BSplineSurface(poles, u, v, uMultiplicities, vMultiplicities, 3, 3);
  const TopoDS_Edge edge = edgeOn(
      surface, new Geom2d_Circle(gp_Ax2d(gp_Pnt2d(0.5, 0.5), gp_Dir2d(1, 0)), 0.4), 0.0, 6.0);
  const EdgeCurve converted = curveFromEdge(edge);
  EXPECT_EQ(converted.kind, EdgeCurveKind::kFitted);
  EXPECT_LE(converted.errorMm, 1e-12);
  EXPECT_LE(largestDistance(converted, edge, 1000), converted.errorMm);
}

TEST(SurfaceCurve, IsoparametricLineOfAnOffsetSurfaceIsFitted) {
  Random random(3);
  const Handle(Geom_OffsetSurface) surface = new Geom_OffsetSurface(bezierSurface(random), 0.25);
  const TopoDS_Edge edge =
      edgeOn(surface, new Geom2d_Line(gp_Pnt2d(0.0, 0.25), gp_Dir2d(1, 0)), 0.0, 1.0);
  const EdgeCurve converted = curveFromEdge(edge);
  EXPECT_EQ(converted.kind, EdgeCurveKind::kFitted);
  EXPECT_LE(converted.errorMm, 1e-11);
  EXPECT_LE(largestDistance(converted, edge, 400), converted.errorMm);
}

}  // namespace
}  // namespace osculate::test
