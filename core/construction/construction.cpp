#include "osculate/construction/construction.h"

namespace osculate {

namespace {

/// The part of the curve that stays: that up to the departure, in the direction of leaving.
struct Kept {
  BSplineCurve curve;
  CurveEnd end;
};

Kept keptPart(const BSplineCurve& curve, const Departure& departure) {
  if (!departure.inside) return {curve, departure.end};
  const double t = departure.parameter;
  if (departure.forward)
    return {t < curve.last() ? curve.trimmed(curve.first(), t) : curve, CurveEnd::kEnd};
  return {t > curve.first() ? curve.trimmed(t, curve.last()) : curve, CurveEnd::kStart};
}

CurveJoin exactJoin(const BSplineCurve& first, const BSplineCurve& second, JoinEnds ends,
                    int order) {
  return analyzeCurves(first, second, {.order = order, .tolerances = Tolerances::preset("exact")},
                       ends);
}

void warnWhereMissed(const CurveJoin& join, const char* end, Construction& result) {
  if (join.report.order >= join.report.requestedOrder) return;
  result.warnings.push_back("rounding: at the " + std::string(end) +
                            " end double coordinates carry G" + std::to_string(join.report.order) +
                            " to the preset `exact`, asked for G" +
                            std::to_string(join.report.requestedOrder));
}

}  // namespace

std::array<Departure, 2> nearestDepartures(const BSplineCurve& first, const BSplineCurve& second) {
  const JoinEnds ends = nearestEnds(first, second, 0.0).ends;
  return {Departure{.end = ends.first}, Departure{.end = ends.second}};
}

Construction blendCurves(const BSplineCurve& first, const BSplineCurve& second,
                         const std::array<Departure, 2>& departures, const BlendOptions& options) {
  const Blend solved = blend(contactJet(first, departures[0], options.order[0]),
                             contactJet(second, departures[1], options.order[1]), options);
  const Kept before = keptPart(first, departures[0]);
  const Kept after = keptPart(second, departures[1]);
  Construction result{BSplineCurve(solved.curve), {}, {}, solved.objective, solved.warnings};
  result.joins.push_back(
      exactJoin(before.curve, result.curve, {before.end, CurveEnd::kStart}, options.order[0]));
  result.joins.push_back(
      exactJoin(result.curve, after.curve, {CurveEnd::kEnd, after.end}, options.order[1]));
  warnWhereMissed(result.joins[0], "first", result);
  warnWhereMissed(result.joins[1], "second", result);
  for (std::size_t end = 0; end < 2; ++end) {
    result.beta[end].assign(solved.beta[end].begin(),
                            solved.beta[end].begin() + options.order[end]);
  }
  return result;
}

}  // namespace osculate
