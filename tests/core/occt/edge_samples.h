// What the tests of this floor share: edges of curves, and converted curves beside their edges.
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <BRepAdaptor_Curve.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_Curve.hxx>
#include <TopoDS_Edge.hxx>

#include "osculate/occt/edge_curve.h"
#include "osculate/occt/spline_arrays.h"
#include "support/random_curves.h"

namespace osculate::test {

inline constexpr double kPi = std::numbers::pi;

/// Knots of cubic curves: clamped, and of a turn.
inline const KnotVector kClamped{{0.0, 1.0, 2.5, 4.0}, {4, 1, 2, 4}};
inline const KnotVector kPeriodic{{0.0, 0.3, 0.5, 1.0}, {2, 1, 1, 2}};

inline Vector3 toVector(const gp_XYZ& xyz) { return {xyz.X(), xyz.Y(), xyz.Z()}; }

/// An edge with exactly this range: BRepBuilderAPI_MakeEdge would move the range of a periodic
/// curve into its first turn and refuse others.
inline TopoDS_Edge edgeOf(const Handle(Geom_Curve) & curve, double first, double last) {
  TopoDS_Edge edge;
  BRep_Builder builder;
  builder.MakeEdge(edge, curve, 1e-7);
  builder.Range(edge, first, last);
  return edge;
}

inline TopoDS_Edge edgeOf(const Handle(Geom_Curve) & curve) {
  return edgeOf(curve, curve->FirstParameter(), curve->LastParameter());
}

/// A curve of OpenCASCADE with random poles.
inline Handle(Geom_BSplineCurve) randomSpline(Random& random, int degree, const KnotVector& knots,
                                              bool rational, bool periodic = false) {
  return geomFrom(randomSplineData(random, degree, knots, rational, periodic));
}

/// The edge's own parameter for the parameter t of the converted curve. In a conic's piece [m - d,
/// m + d] it is m + 2 atan((t - m)/d tan(d/2)), with hyperbolic functions for the hyperbola.
inline double edgeParameter(const EdgeCurve& converted, bool reversed, double t) {
  const BSplineCurve& curve = converted.curve;
  if (reversed) {
    const EdgeCurve forward{curve.reversed(), converted.kind, 0.0};
    return edgeParameter(forward, false, curve.first() + curve.last() - t);
  }
  const BezierSegment piece = curve.segment(curve.spanAt(t));
  const double half = 0.5 * piece.length();
  const double middle = 0.5 * (piece.first + piece.last);
  switch (converted.kind) {
    case EdgeCurveKind::kCircle:
    case EdgeCurveKind::kEllipse:
      return middle + 2.0 * std::atan((t - middle) / half * std::tan(0.5 * half));
    case EdgeCurveKind::kHyperbola:
      return middle + 2.0 * std::atanh((t - middle) / half * std::tanh(0.5 * half));
    default:
      return t;
  }
}

/// The point of an edge at its own parameter, by OpenCASCADE. Not by BRepAdaptor_Curve where there
/// is a curve in space: it evaluates in the power basis, which at degree 25 costs ten digits.
inline Vector3 edgePoint(const TopoDS_Edge& edge, double u) {
  double first = 0.0;
  double last = 0.0;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
  return toVector(curve.IsNull() ? BRepAdaptor_Curve(edge).Value(u).XYZ() : curve->Value(u).XYZ());
}

/// Largest distance between the converted curve and the edge at `count` + 1 parameters.
inline double largestDistance(const EdgeCurve& converted, const TopoDS_Edge& edge, int count = 40) {
  const BSplineCurve& curve = converted.curve;
  const bool reversed = edge.Orientation() == TopAbs_REVERSED;
  double largest = 0.0;
  for (int i = 0; i <= count; ++i) {
    const double t = curve.first() + i * (curve.last() - curve.first()) / count;
    const Vector3 expected = edgePoint(edge, edgeParameter(converted, reversed, t));
    largest = std::max(largest, (curve.evaluate(t) - expected).norm());
  }
  return largest;
}

/// The size that rounding errors of a curve are relative to.
inline double largestPole(const BSplineCurve& curve) {
  return curve.data().poles.colwise().norm().maxCoeff();
}

/// Derivatives 1 to 4 by arc length, [0] not set, from derivatives 1 to 4 by any parameter, by
/// series: R_{k+1} = (dR_k/dt) / |P'|.
inline std::array<Vector3, 5> arcLengthDerivatives(const std::vector<Vector3>& derivatives) {
  std::array<Vector3, 4> series;  // of P'
  double factorial = 1.0;
  for (std::size_t k = 0; k < 4; ++k) {
    series[k] = derivatives[k + 1] / factorial;
    factorial *= static_cast<double>(k) + 1.0;
  }
  std::array<double, 4> square{};
  for (std::size_t k = 0; k < 4; ++k) {
    for (std::size_t j = 0; j <= k; ++j)
      square[k] += series[j].dot(series[k - j]);
  }
  std::array<double, 4> inverse{1.0 / std::sqrt(square[0])};  // square^(-1/2)
  for (std::size_t k = 1; k < 4; ++k) {
    for (std::size_t j = 1; j <= k; ++j) {
      inverse[k] +=
          (0.5 * static_cast<double>(j) - static_cast<double>(k)) * square[j] * inverse[k - j];
    }
    inverse[k] /= static_cast<double>(k) * square[0];
  }
  std::array<Vector3, 5> result{};
  std::array<Vector3, 4> rate = series;  // of R_order by t
  for (std::size_t order = 1; order <= 4; ++order) {
    std::array<Vector3, 4> next;
    for (std::size_t k = 0; k <= 4 - order; ++k) {
      next[k] = Vector3::Zero();
      for (std::size_t j = 0; j <= k; ++j)
        next[k] += inverse[j] * rate[k - j];
    }
    result[order] = next[0];
    for (std::size_t k = 0; k + order < 4; ++k)
      rate[k] = (static_cast<double>(k) + 1.0) * next[k + 1];
  }
  return result;
}

/// Derivatives 0 to 4 of a curve of OpenCASCADE.
inline std::vector<Vector3> occtDerivatives(const Geom_Curve& curve, double u) {
  std::vector<Vector3> result{toVector(curve.Value(u).XYZ())};
  for (int k = 1; k <= 4; ++k)
    result.push_back(toVector(curve.DN(u, k).XYZ()));
  return result;
}

}  // namespace osculate::test
