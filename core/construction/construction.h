// A constructed curve with the proof of what it meets.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "osculate/construction/blend.h"
#include "osculate/continuity/curve_joins.h"

namespace osculate {

struct Construction {
  BSplineCurve curve;
  std::vector<CurveJoin> joins;             ///< of the finished poles, under the preset `exact`
  std::array<std::vector<double>, 2> beta;  ///< the free numbers at each end
  std::optional<double> objective;          ///< what was minimised
  std::vector<std::string> warnings;        ///< sentences
};

/// Where a blend between two curves leaves each: their nearest ends.
std::array<Departure, 2> nearestDepartures(const BSplineCurve& first, const BSplineCurve& second);

/// A blend from the first curve to the second, over t in [0, 1]. Where rounding keeps a join from
/// the order asked for, a warning says so. Throws as contactJet and blend do.
Construction blendCurves(const BSplineCurve& first, const BSplineCurve& second,
                         const std::array<Departure, 2>& departures,
                         const BlendOptions& options = {});

}  // namespace osculate
