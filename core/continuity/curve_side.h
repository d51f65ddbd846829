// What a curve brings to a join besides the segment there; private to this floor.
#pragma once

#include "osculate/bezier/bspline_curve.h"
#include "osculate/continuity/join_analysis.h"

namespace osculate {

/// From an end to the other end or the middle point, whichever is farther.
double farthestFrom(const BSplineCurve& curve, CurveEnd end);
/// The reach from a join inside, where both sides belong to the curve: its ends and its middle
/// count.
double reachInside(const BSplineCurve& curve, const Vector3& join);

/// The side of a curve that has the segment at the join.
JoinSide sideOf(const BSplineCurve& curve, const BezierSegment& segment, CurveEnd end,
                double reach);

/// Whether the curve was converted with an error beyond the rounding of an exact conversion.
bool isApproximated(const BSplineCurve& curve);

}  // namespace osculate
