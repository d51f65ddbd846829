// The continuation of a whole curve, with the proof of what it meets.
#pragma once

#include "osculate/construction/construction.h"
#include "osculate/construction/extend.h"

namespace osculate {

/// A curve that begins at the end of the given one. Over [0, 1], for `parametric` over [0, h] where
/// h is the length of the end segment's interval. Where rounding keeps the join from the order
/// asked for, a warning says so. Throws as extend does.
Construction extendCurve(const BSplineCurve& curve, const ExtendOptions& options = {});

/// The same for the curve's own continuation (see natural.h); without a length, that of its reach.
/// The join is analysed up to `order`.
Construction extendNaturally(const BSplineCurve& curve, CurveEnd end, int order,
                             std::optional<double> lengthMm = {});

}  // namespace osculate
