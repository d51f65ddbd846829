#include "osculate/occt/spline_arrays.h"

#include <stdexcept>

#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>

namespace osculate {

namespace {

/// Poles and weights of a curve class of OpenCASCADE that has both.
template <typename Curve>
void readPoles(const Curve& curve, BSplineData& data) {
  const TColgp_Array1OfPnt& poles = curve.Poles();
  data.poles.resize(3, poles.Length());
  for (int i = 0; i < poles.Length(); ++i) {
    const gp_Pnt& pole = poles.Value(poles.Lower() + i);
    data.poles.col(i) << pole.X(), pole.Y(), pole.Z();
  }
  if (const TColStd_Array1OfReal* weights = curve.Weights()) {
    data.weights.assign(weights->begin(), weights->end());
  }
}

void checkOcctMultiplicities(const BSplineData& data) {
  const auto& multiplicities = data.knots.multiplicities;
  for (std::size_t i = 1; i + 1 < multiplicities.size(); ++i) {
    if (multiplicities[i] > data.degree) {
      throw std::invalid_argument("curve: is torn at the inner knot " + std::to_string(i + 1) +
                                  " (multiplicity degree + 1), which no edge can be");
    }
  }
}

}  // namespace

BSplineData dataOf(const Geom_BSplineCurve& spline) {
  const TColStd_Array1OfReal& knots = spline.Knots();
  const TColStd_Array1OfInteger& multiplicities = spline.Multiplicities();
  BSplineData data{
      .poles = {},
      .weights = {},
      .knots = {{knots.begin(), knots.end()}, {multiplicities.begin(), multiplicities.end()}},
      .degree = spline.Degree(),
      .periodic = spline.IsPeriodic(),
      .poleError = 0.0};
  readPoles(spline, data);
  return data;
}

BSplineData dataOf(const Geom_BezierCurve& bezier) {
  const int degree = bezier.Degree();
  BSplineData data{.poles = {},
                   .weights = {},
                   .knots = {{0.0, 1.0}, {degree + 1, degree + 1}},
                   .degree = degree,
                   .periodic = false,
                   .poleError = 0.0};
  readPoles(bezier, data);
  return data;
}

Handle(Geom_BSplineCurve) geomFrom(const BSplineData& data) {
  checkOcctMultiplicities(data);
  const int poleCount = static_cast<int>(data.poles.cols());
  const int knotCount = static_cast<int>(data.knots.knots.size());
  TColgp_Array1OfPnt poles(1, poleCount);
  for (int i = 0; i < poleCount; ++i) {
    const auto pole = data.poles.col(i);
    poles.SetValue(i + 1, gp_Pnt(pole.x(), pole.y(), pole.z()));
  }
  const TColStd_Array1OfReal knots(data.knots.knots.front(), 1, knotCount);
  const TColStd_Array1OfInteger multiplicities(data.knots.multiplicities.front(), 1, knotCount);
  if (data.weights.empty()) {
    return new Geom_BSplineCurve(poles, knots, multiplicities, data.degree, data.periodic);
  }
  const TColStd_Array1OfReal weights(data.weights.front(), 1, poleCount);
  // without the check that would drop equal weights
  return new Geom_BSplineCurve(poles, weights, knots, multiplicities, data.degree, data.periodic,
                               Standard_False);
}

}  // namespace osculate
