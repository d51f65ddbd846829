#include "osculate/differential/frenet.h"

#include <algorithm>
#include <cmath>

namespace osculate {

namespace {

int fromEnd(BezierView segment, CurveEnd end, int i) {
  return end == CurveEnd::kStart ? i : segment.degree - i;
}

/// The part of the leg to pole i that is off the line through the end along the tangent.
Vector3 offTangent(BezierView segment, CurveEnd end, int i, const Vector3& tangent) {
  const Vector3 leg =
      segment.pole(fromEnd(segment, end, i)) - segment.pole(fromEnd(segment, end, 0));
  return leg - leg.dot(tangent) * tangent;
}

/// Largest distance of a pole from the origin.
double sizeOf(BezierView segment) {
  double largest = 0.0;
  for (int i = 0; i <= segment.degree; ++i)
    largest = std::max(largest, segment.pole(i).squaredNorm());
  return std::sqrt(largest);
}

/// Direction of the first leg that is not zero, outward from the end; zero if there is none.
Vector3 firstLeg(BezierView segment, CurveEnd end, double tolerance) {
  for (int i = 1; i <= segment.degree; ++i) {
    const Vector3 leg =
        segment.pole(fromEnd(segment, end, i)) - segment.pole(fromEnd(segment, end, 0));
    if (leg.norm() > tolerance) return leg.normalized();
  }
  return Vector3::Zero();
}

/// A normal of a straight line: in the xy plane (bachelor thesis, ch. 5), or x for a line along z.
Vector3 lineNormal(const Vector3& tangent) {
  const Vector3 level(-tangent.y(), tangent.x(), 0.0);
  return level.norm() > 1e-9 ? Vector3(level.normalized()) : Vector3(Vector3::UnitX());
}

}  // namespace

std::string_view name(FrameKind kind) {
  switch (kind) {
    case FrameKind::kFrenet:
      return "frenet";
    case FrameKind::kFictitiousNormal:
      return "fictitious-normal";
    case FrameKind::kLine:
      return "line";
    case FrameKind::kFictitiousTangent:
      return "fictitious-tangent";
  }
  return "";
}

int legsOnTangent(BezierView segment, CurveEnd end, double tolerance) {
  const double squaredTolerance = tolerance * tolerance;
  const Vector3 join = segment.pole(fromEnd(segment, end, 0));
  Vector3 first = Vector3::Zero();  // the first leg that is not zero gives the tangent
  double firstSquared = 0.0;
  for (int i = 1; i <= segment.degree; ++i) {
    const Vector3 leg = segment.pole(fromEnd(segment, end, i)) - join;
    const double squared = leg.squaredNorm();
    if (firstSquared == 0.0) {
      if (squared <= squaredTolerance) continue;
      first = leg;
      firstSquared = squared;
      continue;
    }
    // distance from the line against the tolerance, which grows with the distance along the line as
    // the direction is only known to tolerance over the first leg: (1 + x)^2 <= 2 (1 + x^2)
    if (leg.cross(first).squaredNorm() > 2.0 * squaredTolerance * (firstSquared + squared))
      return i - 1;
  }
  return segment.degree;
}

EndFrame fictitiousFrame(BezierView segment, CurveEnd end, const Vector3& tangent, bool singular,
                         double poleError) {
  const double tolerance = lineTolerance(sizeOf(segment), poleError);
  Vector3 direction = tangent;
  if (direction.isZero(0.0)) {
    direction = firstLeg(segment, end, tolerance);
    if (end == CurveEnd::kEnd) direction = -direction;
    if (direction.isZero(0.0)) direction = Vector3::UnitX();
  }
  EndFrame result;
  result.frame.tangent = direction;
  const int legs = legsOnTangent(segment, end, tolerance);
  const bool straight = legs == segment.degree;
  const Vector3 normal = straight
                             ? lineNormal(direction)
                             : Vector3(offTangent(segment, end, legs + 1, direction).normalized());
  result.frame.normal = normal;
  result.frame.binormal = direction.cross(normal);
  result.kind = singular   ? FrameKind::kFictitiousTangent
                : straight ? FrameKind::kLine
                           : FrameKind::kFictitiousNormal;
  return result;
}

}  // namespace osculate
