// Arc length of a curve and its inverse.
#pragma once

#include "osculate/bezier/bspline_curve.h"

namespace osculate {

/// Length in mm, to a relative error of about 1e-12 (adaptive Gauss-Kronrod per Bézier segment); of
/// about 1e-11 where the curve turns back on itself, as its speed has a kink there.
double length(const BSplineCurve& curve);
/// Length of the part [a, b], a <= b inside the range.
double length(const BSplineCurve& curve, double a, double b);
/// The parameter where the length from the start is s; throws std::invalid_argument for s outside
/// [0, length].
double parameterAtLength(const BSplineCurve& curve, double s);

}  // namespace osculate
