// A constructed curve with the proof of what it meets.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "osculate/construction/contact_jet.h"
#include "osculate/construction/curve_change.h"
#include "osculate/continuity/curve_joins.h"

namespace osculate {

struct Construction {
  BSplineCurve curve;
  std::vector<CurveJoin> joins{};             ///< of the finished poles, under the preset `exact`
  std::vector<CurveJoin> inputJoins{};        ///< where a join changes them: as they were, likewise
  std::array<std::vector<double>, 2> beta{};  ///< the free numbers at each end that has some
  std::optional<double> objective{};          ///< what was minimised, where anything was free
  std::optional<int> freeNumbers{};           ///< that the request left free and fairness chose
  std::optional<double> maxDisplacementMm{};  ///< where a curve was changed: how far at most
  std::optional<CurveChange> change{};        ///< likewise: what of it
  std::vector<std::string> warnings{};        ///< sentences
};

/// Adds the join of two curves, analysed under the preset `exact`, to a construction, and where it
/// misses the order asked for a warning that names the place, e.g. "first end".
void addVerifiedJoin(const BSplineCurve& first, const BSplineCurve& second, JoinEnds ends,
                     int order, const std::string& place, Construction& construction);

/// The part of a curve that stays where another one leaves it, and the end of it that they share.
struct KeptPart {
  BSplineCurve curve;
  CurveEnd end;
};
KeptPart keptPart(const BSplineCurve& curve, const Departure& departure);

}  // namespace osculate
