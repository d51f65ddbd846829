// Edges of OpenCASCADE as B-spline curves, and back.
#pragma once

#include <string_view>

#include <TopoDS_Edge.hxx>

#include "osculate/bezier/bspline_curve.h"

namespace osculate {

/// What an edge's curve was, and so how it became a B-spline.
enum class EdgeCurveKind : unsigned char {
  kBSpline,    ///< poles, weights and knots as stored
  kBezier,     ///< poles and weights as stored
  kLine,       ///< degree 1
  kCircle,     ///< rational of degree 2
  kEllipse,    ///< rational of degree 2
  kHyperbola,  ///< rational of degree 2
  kParabola,   ///< degree 2
  kFitted      ///< has no exact form as a B-spline: fitted, with a stated error
};
std::string_view name(EdgeCurveKind kind);

struct EdgeCurve {
  BSplineCurve curve;
  EdgeCurveKind kind = EdgeCurveKind::kBSpline;
  /// Bound of the distance to the edge's own curve; 0: exact but for rounding.
  double errorMm = 0.0;
};

/// The edge's own part of its curve, placed as the edge and in its direction of travel.
///
/// - A B-spline or Bézier curve keeps its arrays bit for bit unless the edge is trimmed, placed or
///   reversed. A trim that misses a knot by rounding is moved to the knot; errorMm says how far.
/// - Circle, ellipse, hyperbola and parabola become rational Bézier pieces (Piegl-Tiller, The NURBS
///   Book, ch. 7) joined in one B-spline: circle and ellipse in the least number of equal pieces of
///   at most 90 degrees (a full circle: 4, cut where the edge begins; its end pole is its start
///   pole), the hyperbola in pieces of at most 1 in its parameter, the parabola in one. An offset
///   of a line, or of a circle in its plane, is a line or a circle.
/// - An edge with nothing but a curve on a surface is exact where that surface is a plane, and
/// where
///   the curve is an isoparametric line of an elementary, swept, Bézier or B-spline surface.
/// - Everything else (offset of a spline, curve across a surface) is fitted in polynomial pieces of
///   degree 9 until the deviation reaches rounding; errorMm states what was found.
///
/// Knots are the edge's own parameter values (of a reversed edge mirrored on the same range).
/// Within the pieces of a circle, ellipse or hyperbola the parameter is NOT that of OpenCASCADE
/// (the angle): shape, tangent, curvature, torsion and their rates by arc length are exact,
/// derivatives by the parameter are those of the rational form, and so are orders of parametric
/// continuity (C^m).
///
/// curve.poleError() covers errorMm and the rounding of the conversion (placement, poles of
/// conics).
///
/// Throws std::invalid_argument with the reason for a null shape, anything but an edge, a
/// degenerated edge, an edge without geometry, of infinite or zero length, or with a range outside
/// its curve; OcctError for what OpenCASCADE throws.
EdgeCurve curveFromEdge(const TopoDS_Shape& edge);

/// An edge over the whole curve with the same poles, weights and knots, bit for bit. Throws
/// std::invalid_argument for a curve torn at an inner knot, OcctError where OpenCASCADE refuses.
TopoDS_Edge edgeFromCurve(const BSplineCurve& curve);

}  // namespace osculate
