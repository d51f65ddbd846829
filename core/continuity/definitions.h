// What "G2" and "G3" mean in other systems, evaluated side by side at one join.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "osculate/continuity/tolerances.h"

namespace osculate {

enum class Verdict : unsigned char { kPass, kFail, kUndecided };
std::string_view name(Verdict verdict);

/// The meanings of G2 and G3 in use (design notes: docs/theory.md).
enum class Definition : unsigned char {
  kG2Vector,
  kG2Maximum,
  kG2OpenNurbs,
  kG2Sum,
  kG2Mean,
  kG2GeometricMean,
  kG3Vector,
  kG3FrenetFrame,
  kG3ScalarRate,
  kG3GraphAngle,
  kG3Torsion,
  kC3,
  kCount
};
inline constexpr int kDefinitionCount = static_cast<int>(Definition::kCount);

struct DefinitionInfo {
  std::string_view name;     ///< key in reports, e.g. "g3-scalar-rate"
  std::string_view who;      ///< which systems mean this
  std::string_view meaning;  ///< the condition in words
  std::string_view unit;     ///< of value and tolerance, empty if dimensionless
};
const DefinitionInfo& info(Definition definition);

/// One definition at one join. No verdict where the definition does not apply (curvature zero).
struct DefinitionResult {
  std::optional<Verdict> verdict;
  double value = 0.0;  ///< what is compared; meaningful only with a verdict
  double tolerance = 0.0;
};
using DefinitionResults = std::array<DefinitionResult, static_cast<std::size_t>(kDefinitionCount)>;

}  // namespace osculate
