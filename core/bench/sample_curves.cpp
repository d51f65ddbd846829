#include "sample_curves.h"

#include <random>

#include <BRep_Tool.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>

#include "osculate/occt/edge_curve.h"

namespace osculate::bench {

namespace {

constexpr int kDegree = 5;

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
