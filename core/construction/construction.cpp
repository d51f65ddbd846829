#include "osculate/construction/construction.h"

namespace osculate {

namespace {

std::string roundingWarning(const JoinReport& report, const std::string& place) {
  return "rounding: at the " + place + " double coordinates carry G" +
         std::to_string(report.order) + " to the preset `exact`, asked for G" +
         std::to_string(report.requestedOrder);
}

}  // namespace

void addVerifiedJoin(const BSplineCurve& first, const BSplineCurve& second, JoinEnds ends,
                     int order, const std::string& place, Construction& construction) {
  const AnalysisOptions options{.order = order, .tolerances = Tolerances::preset("exact")};
  construction.joins.push_back(analyzeCurves(first, second, options, ends));
  const JoinReport& report = construction.joins.back().report;
  if (report.order < report.requestedOrder)
    construction.warnings.push_back(roundingWarning(report, place));
}

KeptPart keptPart(const BSplineCurve& curve, const Departure& departure) {
  if (!departure.inside) return {curve, departure.end};
  const double t = departure.parameter;
  if (departure.forward)
    return {t < curve.last() ? curve.trimmed(curve.first(), t) : curve, CurveEnd::kEnd};
  return {t > curve.first() ? curve.trimmed(t, curve.last()) : curve, CurveEnd::kStart};
}

}  // namespace osculate
