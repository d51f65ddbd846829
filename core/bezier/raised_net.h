// The net of a B-spline of a higher degree.
#pragma once

#include "osculate/bezier/spline_net.h"

namespace osculate {

/// The clamped net of the same curve with the degree raised by `times` and every inner multiplicity
/// with it: its Bézier segments are raised and their knots removed again as far as they were not
/// there (Piegl and Tiller 1994, Software-engineering approach to degree elevation of B-spline
/// curves). The cost grows with the degree squared, for each span; BSplineCurve::elevated takes
/// blossoms at every step and is slow at high degrees. The curve must not be torn (inner
/// multiplicities at most its degree); throws std::invalid_argument above kMaxDegree.
SplineNet raisedNet(const BSplineCurve& curve, int times);

}  // namespace osculate
