#include "osculate/occt/space_curve.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <GeomAdaptor_Curve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_Hyperbola.hxx>
#include <Geom_Line.hxx>
#include <Geom_OffsetCurve.hxx>
#include <Geom_Parabola.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TColStd_Array1OfReal.hxx>

#include "osculate/occt/conic_arc.h"
#include "osculate/occt/fitted_curve.h"
#include "osculate/occt/spline_arrays.h"

namespace osculate {

namespace {

Vector3 vectorOf(const gp_XYZ& xyz) { return {xyz.X(), xyz.Y(), xyz.Z()}; }

ConicAxes axesOf(const gp_Ax2& position, double x, double y) {
  return {vectorOf(position.Location().XYZ()), x * vectorOf(position.XDirection().XYZ()),
          y * vectorOf(position.YDirection().XYZ())};
}

/// The basis of trimmed curves: the edge's range says more than theirs.
Handle(Geom_Curve) untrimmed(Handle(Geom_Curve) curve) {
  while (const auto trimmed = Handle(Geom_TrimmedCurve)::DownCast(curve)) {
    curve = trimmed->BasisCurve();
  }
  return curve;
}

/// How far a trim may be from a knot to be moved to it, relative to the curve's parameter range:
/// nearer, the sliver of a span that the trim leaves holds no digits.
constexpr double kSnap = 1e-12;

/// A parameter as turns + own: own within the curve's range, turns a multiple of its period (0
/// unless the curve is periodic).
struct Trim {
  double own;
  double turns;
};

/// The trim at t, moved to the knot that it misses by rounding. Adds to `moved` how far, in mm.
Trim trimAt(const BSplineCurve& curve, double t, double& moved) {
  const std::vector<double>& knots = curve.data().knots.knots;
  const double range = curve.last() - curve.first();
  const double turns = curve.isPeriodic() ? range * std::floor((t - curve.first()) / range) : 0.0;
  const double own = t - turns;
  const auto above = std::lower_bound(knots.begin() + 1, knots.end() - 1, own);
  const double knot = *above - own < own - above[-1] ? *above : above[-1];
  if (knot == own || std::abs(knot - own) > kSnap * range) return {own, turns};
  moved += (curve.evaluate(knot) - curve.evaluate(own)).norm();
  return {knot, turns};
}

void checkInside(const BSplineCurve& curve, double first, double last) {
  if (curve.first() <= first && last <= curve.last()) return;
  throw std::invalid_argument("edge: its range [" + std::to_string(first) + ", " +
                              std::to_string(last) + "] leaves the range of its curve, [" +
                              std::to_string(curve.first()) + ", " + std::to_string(curve.last()) +
                              "]");
}

/// The part of a periodic curve, within its first two turns; `end` in the turn of `begin` or the
/// one after.
BSplineCurve periodicPart(const BSplineCurve& whole, Trim begin, Trim end) {
  const double period = whole.last() - whole.first();
  if (begin.own == whole.last()) begin = {whole.first(), begin.turns + period};
  const double last = std::min(end.own + (end.turns - begin.turns), begin.own + period);
  const bool isWhole = begin.own == whole.first() && last == whole.last();
  return isWhole ? whole : whole.trimmed(begin.own, last);
}

BSplineCurve openPart(const BSplineCurve& whole, double begin, double end) {
  checkInside(whole, begin, end);
  return begin == whole.first() && end == whole.last() ? whole : whole.trimmed(begin, end);
}

/// The part [first, last] of a B-spline; the whole curve keeps its bits.
EdgeCurve partOf(const BSplineCurve& whole, EdgeCurveKind kind, double first, double last) {
  if (first == whole.first() && last == whole.last()) return {whole, kind};
  double moved = 0.0;
  const Trim begin = trimAt(whole, first, moved);
  const Trim end = trimAt(whole, last, moved);
  BSplineCurve part =
      whole.isPeriodic() ? periodicPart(whole, begin, end) : openPart(whole, begin.own, end.own);
  if (begin.turns != 0.0) part = part.reparametrised(first, last);
  return {moved > 0.0 ? part.withPoleError(part.poleError() + moved) : part, kind, moved};
}

EdgeCurve converted(const Geom_BSplineCurve& spline, double first, double last) {
  return partOf(BSplineCurve(dataOf(spline)), EdgeCurveKind::kBSpline, first, last);
}

EdgeCurve converted(const Geom_BezierCurve& bezier, double first, double last) {
  return partOf(BSplineCurve(dataOf(bezier)), EdgeCurveKind::kBezier, first, last);
}

EdgeCurve converted(const Geom_Line& line, double first, double last) {
  const gp_Ax1& position = line.Position();
  return {lineSegment(vectorOf(position.Location().XYZ()), vectorOf(position.Direction().XYZ()),
                      first, last),
          EdgeCurveKind::kLine};
}

EdgeCurve converted(const Geom_Circle& circle, double first, double last) {
  return {ellipticArc(axesOf(circle.Position(), circle.Radius(), circle.Radius()), first, last),
          EdgeCurveKind::kCircle};
}

EdgeCurve converted(const Geom_Ellipse& ellipse, double first, double last) {
  return {ellipticArc(axesOf(ellipse.Position(), ellipse.MajorRadius(), ellipse.MinorRadius()),
                      first, last),
          EdgeCurveKind::kEllipse};
}

EdgeCurve converted(const Geom_Hyperbola& hyperbola, double first, double last) {
  return {
      hyperbolicArc(axesOf(hyperbola.Position(), hyperbola.MajorRadius(), hyperbola.MinorRadius()),
                    first, last),
      EdgeCurveKind::kHyperbola};
}

EdgeCurve converted(const Geom_Parabola& parabola, double first, double last) {
  return {parabolicArc(axesOf(parabola.Position(), 0.25 / parabola.Focal(), 1.0), first, last),
          EdgeCurveKind::kParabola};
}

/// Its points are P(u) + d (T x V) / |T x V|: P the basis, T its tangent, V the curve's direction.
EdgeCurve converted(const Geom_OffsetCurve& offset, double first, double last) {
  const Handle(Geom_Curve) basis = untrimmed(offset.BasisCurve());
  const gp_XYZ& direction = offset.Direction().XYZ();
  const double distance = offset.Offset();
  if (const auto line = Handle(Geom_Line)::DownCast(basis)) {
    const gp_XYZ across = line->Position().Direction().XYZ().Crossed(direction).Normalized();
    const Geom_Line moved(line->Position().Translated(gp_Vec(distance * across)));
    return converted(moved, first, last);
  }
  if (const auto circle = Handle(Geom_Circle)::DownCast(basis)) {
    // T x V points outward where V is the axis, inward where it is opposite
    const double cosine = circle->Position().Direction().XYZ().Dot(direction);
    const double radius = circle->Radius() + std::copysign(1.0, cosine) * distance;
    if (std::abs(cosine) >= 1.0 - kUnitRoundoff) {
      return {ellipticArc(axesOf(circle->Position(), radius, radius), first, last),
              EdgeCurveKind::kCircle};
    }
  }
  return fitAdaptor(GeomAdaptor_Curve(&offset, first, last), first, last);
}

/// Converts as the first of the given classes that the curve is; fits a curve that is none of them.
template <typename... Curves>
EdgeCurve convertAs(const opencascade::handle<Geom_Curve>& curve, double first, double last) {
  std::optional<EdgeCurve> result;
  const auto attempt = [&](const auto* exact) {
    if (exact != nullptr) result = converted(*exact, first, last);
    return exact != nullptr;
  };
  if ((attempt(dynamic_cast<const Curves*>(curve.get())) || ...)) return *result;
  return fitAdaptor(GeomAdaptor_Curve(curve, first, last), first, last);
}

}  // namespace

EdgeCurve convertCurve(const opencascade::handle<Geom_Curve>& curve, double first, double last) {
  return convertAs<Geom_BSplineCurve, Geom_Line, Geom_Circle, Geom_BezierCurve, Geom_Ellipse,
                   Geom_Hyperbola, Geom_Parabola, Geom_OffsetCurve>(untrimmed(curve), first, last);
}

EdgeCurve fitAdaptor(const Adaptor3d_Curve& adaptor, double first, double last) {
  const int intervals = adaptor.NbIntervals(GeomAbs_CN);
  TColStd_Array1OfReal breaks(1, intervals + 1);
  adaptor.Intervals(breaks, GeomAbs_CN);
  std::vector<double> range{first};
  std::copy_if(breaks.begin(), breaks.end(), std::back_inserter(range),
               [&](double t) { return range.back() < t && t < last; });
  range.push_back(last);
  const FittedCurve fitted =
      fitCurve([&](double t) { return vectorOf(adaptor.Value(t).XYZ()); }, range);
  return {fitted.curve, EdgeCurveKind::kFitted, fitted.errorMm};
}

}  // namespace osculate
