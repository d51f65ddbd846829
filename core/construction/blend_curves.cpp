#include "osculate/construction/blend_curves.h"

namespace osculate {

std::array<Departure, 2> nearestDepartures(const BSplineCurve& first, const BSplineCurve& second) {
  const JoinEnds ends = nearestEnds(first, second, 0.0).ends;
  return {Departure{.end = ends.first}, Departure{.end = ends.second}};
}

Construction blendCurves(const BSplineCurve& first, const BSplineCurve& second,
                         const std::array<Departure, 2>& departures, const BlendOptions& options) {
  const Blend solved = blend(contactJet(first, departures[0], options.order[0]),
                             contactJet(second, departures[1], options.order[1]), options);
  const KeptPart before = keptPart(first, departures[0]);
  const KeptPart after = keptPart(second, departures[1]);
  Construction result{.curve = BSplineCurve(solved.curve),
                      .objective = solved.objective,
                      .warnings = solved.warnings};
  addVerifiedJoin(before.curve, result.curve, {before.end, CurveEnd::kStart}, options.order[0],
                  "first end", result);
  addVerifiedJoin(result.curve, after.curve, {CurveEnd::kEnd, after.end}, options.order[1],
                  "second end", result);
  for (std::size_t end = 0; end < 2; ++end) {
    result.beta[end].assign(solved.beta[end].begin(),
                            solved.beta[end].begin() + options.order[end]);
  }
  return result;
}

}  // namespace osculate
