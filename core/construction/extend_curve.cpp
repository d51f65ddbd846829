#include "osculate/construction/extend_curve.h"

#include "osculate/construction/natural.h"
#include "osculate/differential/arc_jet.h"

namespace osculate {

namespace {

/// beta of a curve over [0, 1] at its start; none where its ends coincide.
std::vector<double> betaAtStart(const BSplineCurve& curve, int order) {
  const BezierSegment first = curve.segment(0);
  const auto arc = arcJet(endJet<kMaxOrder>(first.curve.view(), CurveEnd::kStart, first.poleError));
  const double chord = (curve.endPoint(CurveEnd::kEnd) - curve.endPoint(CurveEnd::kStart)).norm();
  std::vector<double> beta;
  if (!(chord > 1e-9 * reachFrom(curve, CurveEnd::kStart))) return beta;
  double factor = 1.0 / chord;
  for (int k = 1; k <= order; ++k) {
    factor *= k / first.length();
    beta.push_back(factor * arc.arcLength[static_cast<std::size_t>(k)]);
  }
  return beta;
}

void warnWhereNotParametric(int order, Construction& result) {
  const JoinReport& report = result.joins.front().report;
  if (report.parametricOrder >= order || report.order < order) return;
  result.warnings.push_back("rounding: at the join double coordinates carry C" +
                            std::to_string(report.parametricOrder) +
                            " to the preset `exact`, asked for C" + std::to_string(order));
}

}  // namespace

Construction extendCurve(const BSplineCurve& curve, const ExtendOptions& options) {
  const Extension solved = extend(curve, options);
  Construction result{.curve = BSplineCurve(solved.curve, 0.0, solved.parameterLength),
                      .beta = {solved.beta, {}},
                      .objective = solved.objective,
                      .freeNumbers = solved.freeNumbers,
                      .warnings = solved.warnings};
  addVerifiedJoin(curve, result.curve, {options.end, CurveEnd::kStart}, options.order, "join",
                  result);
  if (options.parametric) warnWhereNotParametric(options.order, result);
  return result;
}

Construction extendNaturally(const BSplineCurve& curve, CurveEnd end, int order,
                             std::optional<double> lengthMm) {
  if (order < 0 || order > kMaxOrder) {
    throw std::invalid_argument("order: must be from 0 to " + std::to_string(kMaxOrder) + ", got " +
                                std::to_string(order));
  }
  Construction result{
      .curve = naturalContinuation(curve, end, lengthMm ? *lengthMm : reachFrom(curve, end)),
      .freeNumbers = 0};
  result.beta[0] = betaAtStart(result.curve, order);
  addVerifiedJoin(curve, result.curve, {end, CurveEnd::kStart}, order, "join", result);
  return result;
}

}  // namespace osculate
