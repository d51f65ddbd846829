// The points of interest of a comb within one segment; private to this floor.
#pragma once

#include <vector>

#include "osculate/differential/comb.h"
#include "osculate/differential/comb_point.h"

namespace osculate {

/// Bits of CombPoint::marks.
inline constexpr std::uint8_t bitOf(CombMarkKind kind) {
  return static_cast<std::uint8_t>(1U << static_cast<unsigned>(kind));
}
inline constexpr std::uint8_t bitOfPeak(std::size_t quantity) {
  return static_cast<std::uint8_t>(1U << (static_cast<unsigned>(CombMarkKind::kPeak) + quantity));
}

/// -1, 1, or 0 where rounding hides the sign or the number does not exist.
inline int signOf(double value, double error) {
  if (value > error) return 1;
  return value < -error ? -1 : 0;
}

/// Puts inflections, vertices, cusps and the peaks of the shown quantities among the points of a
/// segment. At inflections and cusps two points, with the limits from both sides, end a run and
/// begin another.
void markSegment(const SegmentSampler& sampler, const CombOptions& options,
                 std::vector<CombPoint>& points);

}  // namespace osculate
