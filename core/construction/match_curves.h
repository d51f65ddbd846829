// A match of two whole curves, with the proof of what it meets.
#pragma once

#include "osculate/construction/construction.h"
#include "osculate/construction/match.h"

namespace osculate {

/// The second curve changed at `end` so that it continues the first one from `departure`. Where
/// they meet already to the preset `exact`, and no number or higher degree is asked for, the second
/// curve as it is. Where rounding keeps the join from the order asked for, a warning says so.
/// Throws as contactJet and match do.
Construction matchCurves(const BSplineCurve& first, const Departure& departure,
                         const BSplineCurve& second, CurveEnd end,
                         const MatchOptions& options = {});

/// A curve changed at one of its ends so that this meets its other end: the closing join. At least
/// the derivatives up to the order are kept at the other end.
Construction matchClosing(const BSplineCurve& curve, CurveEnd changed,
                          const MatchOptions& options = {});

}  // namespace osculate
