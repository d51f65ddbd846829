// What the report of a join warns of: short codes, each with a sentence.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace osculate {

enum class Warning : unsigned char {
  kUndecided,             ///< an order is undecided
  kCusp,                  ///< the tangents are opposite
  kDegenerateTangent,     ///< a first derivative is zero at the join
  kFractionalSmoothness,  ///< a singular end whose arc-length derivatives end at some order
  kNearFlat,              ///< curvature too small for normal, torsion and rates
  kFarFromOrigin,         ///< coordinates so large that digits are lost
  kTouchesAtBothEnds,     ///< the curves meet at both ends; the end-start join is reported
  kApproximated,          ///< a side was converted with a stated error
  kCount
};

/// A set of warnings without allocation.
class WarningSet {
 public:
  void add(Warning warning) { bits_ |= 1U << static_cast<unsigned>(warning); }
  bool has(Warning warning) const { return (bits_ >> static_cast<unsigned>(warning) & 1U) != 0; }
  bool empty() const { return bits_ == 0; }
  std::vector<Warning> list() const;

 private:
  std::uint32_t bits_ = 0;
};

/// The code a program tests, e.g. "cusp".
std::string_view code(Warning warning);
/// One sentence for a person.
std::string_view sentence(Warning warning);

}  // namespace osculate
