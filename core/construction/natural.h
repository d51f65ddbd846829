// A curve's own continuation beyond its end.
#pragma once

#include "osculate/bezier/bspline_curve.h"

namespace osculate {

/// The curve of the end segment, from that end on, of the given length in mm: a circle goes on as
/// the same circle. Over [0, 1], beginning at the end. A polynomial segment gives one segment of
/// its degree; a rational one (in its lowest degree) as few as keep the weights of each within a
/// factor of two, of even length where they can, so that weights that turn to zero or less beyond
/// the end do not matter.
///
/// Throws std::invalid_argument for a length that is not finite and > 0; ContactError at a singular
/// end (repeated poles), and where the curve would take more than 100 segments (it runs to
/// infinity, or winds that often).
BSplineCurve naturalContinuation(const BSplineCurve& curve, CurveEnd end, double lengthMm);

}  // namespace osculate
