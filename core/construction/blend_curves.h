// A blend between two whole curves, with the proof of what it meets.
#pragma once

#include "osculate/construction/blend.h"
#include "osculate/construction/construction.h"

namespace osculate {

/// Where a blend between two curves leaves each: their nearest ends.
std::array<Departure, 2> nearestDepartures(const BSplineCurve& first, const BSplineCurve& second);

/// A blend from the first curve to the second, over t in [0, 1]. Where rounding keeps a join from
/// the order asked for, a warning says so. Throws as contactJet and blend do.
Construction blendCurves(const BSplineCurve& first, const BSplineCurve& second,
                         const std::array<Departure, 2>& departures,
                         const BlendOptions& options = {});

}  // namespace osculate
