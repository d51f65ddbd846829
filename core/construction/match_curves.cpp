#include "osculate/construction/match_curves.h"

#include <algorithm>
#include <functional>

#include "osculate/differential/arc_jet.h"

namespace osculate {

namespace {

/// The second curve meets the first already, and nothing else is asked of it.
bool isMet(const CurveJoin& join, const BSplineCurve& second, const MatchOptions& options) {
  const bool asked = std::any_of(options.beta.begin(), options.beta.end(),
                                 [](const auto& number) { return number.has_value(); });
  if (asked || options.degree > second.degree()) return false;
  const JoinReport& report = join.report;
  // within the tolerances, though perhaps not for certain: another solution would be no better
  const auto end = report.residuals.begin() + report.requestedOrder + 1;
  return std::equal(report.residuals.begin(), end, report.tolerances.begin(), std::less_equal{});
}

Construction constructionOf(Match match) {
  Construction result{.curve = std::move(match.curve), .warnings = std::move(match.warnings)};
  result.beta[0] = std::move(match.beta);
  result.maxDisplacementMm = match.change.largestMm;
  result.change = match.change;
  return result;
}

/// `met`: the join with the second curve as it is.
Construction solve(const CurveJoin& met, const ContactJet& target, const BSplineCurve& second,
                   CurveEnd end, const MatchOptions& options) {
  return constructionOf(isMet(met, second, options) ? unchanged(second, end, options.order)
                                                    : match(target, second, end, options));
}

}  // namespace

Construction matchCurves(const BSplineCurve& first, const Departure& departure,
                         const BSplineCurve& second, CurveEnd end, const MatchOptions& options) {
  const ContactJet target = contactJet(first, departure, options.order);
  const KeptPart before = keptPart(first, departure);
  const JoinEnds ends{before.end, end};
  const AnalysisOptions exact{.order = options.order, .tolerances = Tolerances::preset("exact")};
  Construction result =
      solve(analyzeCurves(before.curve, second, exact, ends), target, second, end, options);
  addVerifiedJoin(before.curve, result.curve, ends, options.order, "join", result);
  return result;
}

Construction matchClosing(const BSplineCurve& curve, CurveEnd changed,
                          const MatchOptions& options) {
  const Departure departure{.end = opposite(changed)};
  const ContactJet target = contactJet(curve, departure, options.order);
  const JoinEnds ends{departure.end, changed};
  const AnalysisOptions exact{.order = options.order, .tolerances = Tolerances::preset("exact")};
  MatchOptions kept = options;
  kept.keep = std::max(options.keep, options.order);
  Construction result =
      solve(analyzeCurves(curve, curve, exact, ends), target, curve, changed, kept);
  addVerifiedJoin(result.curve, result.curve, ends, options.order, "join", result);
  return result;
}

}  // namespace osculate
