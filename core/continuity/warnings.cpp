#include "osculate/continuity/warnings.h"

#include <array>

namespace osculate {

namespace {

struct Text {
  std::string_view code;
  std::string_view sentence;
};

constexpr std::array<Text, static_cast<std::size_t>(Warning::kCount)> kTexts{{
    {"undecided",
     "An order cannot be decided: its tolerance lies within what double coordinates can carry "
     "here."},
    {"cusp", "The tangents are opposite: the path turns back on itself at the join."},
    {"degenerate-tangent",
     "A first derivative is zero at the join (repeated poles); the tangent comes from higher "
     "ones."},
    {"fractional-smoothness",
     "A side's derivatives by arc length end at some order because its end is singular (repeated "
     "poles)."},
    {"near-flat",
     "Curvature is zero or nearly so at the join: normal, torsion and rates mean nothing on that "
     "side."},
    {"far-from-origin",
     "The coordinates are over a million times the curves' size: many digits are lost."},
    {"touches-at-both-ends",
     "The curves meet at both ends; the join of the first's end with the second's start is shown."},
    {"approximated",
     "A side is no B-spline or conic and was converted with a stated error, which enters the "
     "uncertainty."},
}};

const Text& text(Warning warning) { return kTexts[static_cast<std::size_t>(warning)]; }

}  // namespace

std::vector<Warning> WarningSet::list() const {
  std::vector<Warning> result;
  for (unsigned i = 0; i < static_cast<unsigned>(Warning::kCount); ++i) {
    if (has(static_cast<Warning>(i))) result.push_back(static_cast<Warning>(i));
  }
  return result;
}

std::string_view code(Warning warning) { return text(warning).code; }
std::string_view sentence(Warning warning) { return text(warning).sentence; }

}  // namespace osculate
