#include "sample_curves.h"

#include <random>

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>

#include "osculate/occt/edge_curve.h"

namespace osculate::bench {

namespace {

constexpr int kDegree = 5;
constexpr double kTolerance = 1e-7;

/// Points along x, 10 mm apart, off it by up to 10 mm.
Poles wavyPoles(int count) {
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> off(-10.0, 10.0);
  Poles poles(3, count);
  for (int i = 0; i < count; ++i)
    poles.col(i) << 10.0 * i + off(generator) / 3.0, off(generator), off(generator);
  return poles;
}

std::vector<double> weights(int count, bool rational) {
  std::vector<double> result;
  for (int i = 0; rational && i < count; ++i)
    result.push_back(1.0 + 0.1 * (i % 3));
  return result;
}

/// A cubic of two spans, 10 mm along x, that rises to a side and comes back.
Handle(Geom_BSplineCurve) wave(double x, double side) {
  TColgp_Array1OfPnt poles(1, 5);
  poles(1) = gp_Pnt(x, 0, 0);
  poles(2) = gp_Pnt(x + 2, side, 0);
  poles(3) = gp_Pnt(x + 5, 3 * side, 1);
  poles(4) = gp_Pnt(x + 8, side, 0);
  poles(5) = gp_Pnt(x + 10, 0, 0);
  TColStd_Array1OfReal knots(1, 3);
  TColStd_Array1OfInteger multiplicities(1, 3);
  for (int i = 1; i <= 3; ++i) {
    knots(i) = i * i;
    multiplicities(i) = i == 2 ? 1 : 4;
  }
  return new Geom_BSplineCurve(poles, knots, multiplicities, 3);
}

}  // namespace

std::pair<BezierCurve, BezierCurve> quinticPair(bool rational) {
  const Poles poles = wavyPoles(kDegree + 1);
  std::vector<Vector3> points;
  for (const auto& pole : poles.colwise())
    points.emplace_back(pole);
  return BezierCurve(points, weights(kDegree + 1, rational)).split(0.4);
}

BSplineCurve spline(int spans, bool rational) {
  BSplineData data;
  data.degree = kDegree;
  data.poles = wavyPoles(spans + kDegree);
  data.weights = weights(spans + kDegree, rational);
  for (int i = 0; i <= spans; ++i) {
    data.knots.knots.push_back(i);
    data.knots.multiplicities.push_back(i == 0 || i == spans ? kDegree + 1 : 1);
  }
  return BSplineCurve(std::move(data));
}

std::pair<BSplineCurve, BSplineCurve> splinePair(int spans, bool rational) {
  return spline(2 * spans, rational).split(spans);
}

TopoDS_Wire chain(int edges) {
  const BRep_Builder builder;
  const auto vertexAt = [&](double x) {
    TopoDS_Vertex vertex;
    builder.MakeVertex(vertex, gp_Pnt(x, 0, 0), kTolerance);
    return vertex;
  };
  TopoDS_Wire wire;
  builder.MakeWire(wire);
  TopoDS_Vertex start = vertexAt(0.0);
  for (int i = 0; i < edges; ++i) {
    const TopoDS_Vertex end = vertexAt(10.0 * (i + 1));
    TopoDS_Edge edge;
    builder.MakeEdge(edge, wave(10.0 * i, i % 2 == 0 ? 1.0 : -1.0), kTolerance);
    builder.Add(edge, start.Oriented(TopAbs_FORWARD));
    builder.Add(edge, end.Oriented(TopAbs_REVERSED));
    builder.Add(wire, edge);
    start = end;
  }
  return wire;
}

Handle(Geom_BezierCurve) geom(const BezierCurve& curve) {
  TColgp_Array1OfPnt poles(1, curve.degree() + 1);
  TColStd_Array1OfReal weights(1, curve.degree() + 1);
  for (int i = 0; i <= curve.degree(); ++i) {
    poles(i + 1) = gp_Pnt(curve.pole(i).x(), curve.pole(i).y(), curve.pole(i).z());
    weights(i + 1) = curve.weight(i);
  }
  return curve.isRational() ? new Geom_BezierCurve(poles, weights) : new Geom_BezierCurve(poles);
}

Handle(Geom_BSplineCurve) geom(const BSplineCurve& curve) {
  double first = 0.0;
  double last = 0.0;
  return Handle(Geom_BSplineCurve)::DownCast(BRep_Tool::Curve(edgeFromCurve(curve), first, last));
}

}  // namespace osculate::bench
