// Points that lie near each other; private to this floor.
#pragma once

#include <utility>
#include <vector>

#include "osculate/bezier/vector3.h"

namespace osculate {

/// For each point the first one that stands for its place: itself, or an earlier one that stands
/// for itself and is not farther away than the tolerance. Points that are not finite stand for
/// themselves. Linear in the points as long as few are in one place.
std::vector<int> mergePoints(const std::vector<Vector3>& points, double tolerance);

/// Pairs of points not farther apart than the tolerance, each point in one pair at most, the
/// nearest pairs first.
std::vector<std::pair<int, int>> matchPoints(const std::vector<Vector3>& points, double tolerance);

}  // namespace osculate
