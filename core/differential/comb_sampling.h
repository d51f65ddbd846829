// Where a segment is sampled for a comb; private to this floor.
#pragma once

#include <vector>

#include "osculate/differential/comb.h"
#include "osculate/differential/comb_point.h"

namespace osculate {

/// Fills `points` with samples of the segment from t = 0 to t = 1: evenly spaced ones, and those
/// that the tolerance asks for between them. The ends have the limits from within.
void sampleSegment(const SegmentSampler& sampler, const CombOptions& options,
                   std::vector<CombPoint>& points);

}  // namespace osculate
