// Arc lengths between the points of a comb; private to this floor.
#pragma once

#include "osculate/differential/comb_point.h"

namespace osculate {

/// The length of a segment between two of its points, from what they know of the speed: to a
/// relative error of about 1e-9, or an absolute one of 1e-11 of the control polygon.
double lengthBetween(const SegmentSampler& sampler, const CombPoint& a, const CombPoint& b);

}  // namespace osculate
