// The first spans of a curve, seen from one of its ends; private to this floor.
#pragma once

#include "osculate/bezier/bspline_curve.h"

namespace osculate {

/// The same curve, clamped at both ends and not periodic: a periodic one is opened at its seam.
BSplineCurve openClamped(const BSplineCurve& curve);

/// The first `spans` spans of a clamped curve from an end, as a curve that runs away from that end:
/// its pole i is the i-th from the end, bit for bit, and its knots are measured from the end. Not
/// clamped on the far side, unless these are all the spans.
BSplineCurve curveHead(const BSplineCurve& curve, CurveEnd end, int spans);

}  // namespace osculate
