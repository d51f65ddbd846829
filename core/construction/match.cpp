#include "osculate/construction/match.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "osculate/bezier/index.h"
#include "osculate/bezier/net_distance.h"
#include "osculate/construction/contact_fit.h"
#include "osculate/construction/curve_head.h"
#include "osculate/construction/match_plan.h"
#include "osculate/construction/span_basis.h"
#include "osculate/continuity/join_analysis.h"
#include "osculate/differential/arc_jet.h"

namespace osculate {

namespace {

void checkRange(int value, int least, int most, const char* name) {
  if (value >= least && value <= most) return;
  throw std::invalid_argument(std::string(name) + ": must be from " + std::to_string(least) +
                              " to " + std::to_string(most) + ", got " + std::to_string(value));
}

void checkOptions(const ContactJet& target, const MatchOptions& options) {
  checkRange(options.order, 0, kMaxOrder, "order");
  checkRange(options.keep, 0, kMaxOrder, "keep");
  if (options.spans < 0) throw std::invalid_argument("spans: must be at least 1");
  if (target.order != options.order) {
    throw std::invalid_argument("order: the derivatives given belong to another order");
  }
  for (std::size_t k = 0; k < kMaxOrder; ++k) {
    const auto& number = options.beta[k];
    if (number && (!std::isfinite(*number) || (k == 0 && *number <= 0.0))) {
      throw std::invalid_argument(k == 0
                                      ? "beta: beta_1 must be finite and > 0 (at 0 the curve stops)"
                                      : "beta: every number must be finite");
    }
  }
}

/// Elementary symmetric polynomials e_0 .. e_count of some numbers.
std::vector<double> symmetricPolynomials(std::span<const double> numbers, int count) {
  std::vector<double> e(index(count) + 1, 0.0);
  e[0] = 1.0;
  for (const double x : numbers) {
    for (std::size_t k = e.size() - 1; k > 0; --k)
      e[k] += x * e[k - 1];
  }
  return e;
}

/// Factors of the Taylor coefficients c_1 .. c_m at a clamped start, by the parameter of the first
/// span over [0, 1], in C_i - C_0, i <= m <= degree. A pole is the blossom at the knots it stands
/// over, and the blossom of t^k is e_k / C(n,k) (Ramshaw 1989); of a rational curve that holds for
/// the numerator a_j = sum_k W_{j-k} c_k, W the Taylor coefficients of its denominator.
Eigen::MatrixXd polesByTaylor(const BSplineCurve& head, const SpanBasis& start, int m) {
  const int degree = head.degree();
  std::vector<double> flat = flatten(head.data().knots);
  const double span = flat[index(degree) + 1] - flat[index(degree)];
  for (double& knot : flat)
    knot /= span;
  Eigen::MatrixXd factors = Eigen::MatrixXd::Zero(m + 1, m + 1);
  for (int i = 0; i <= m; ++i) {
    const auto e = symmetricPolynomials(std::span(flat).subspan(index(i) + 1, index(degree)), m);
    for (int k = 0; k <= m; ++k)
      factors(i, k) = e[index(k)] / binomial(degree, k);
  }
  if (!head.isRational()) return factors;
  const Eigen::VectorXd weight = start.weightTaylor(m);
  Eigen::MatrixXd products = Eigen::MatrixXd::Zero(m + 1, m + 1);
  for (int k = 0; k <= m; ++k)
    products.col(k).tail(m + 1 - k) = weight.head(m + 1 - k);
  factors = factors * products;
  for (int i = 0; i <= m; ++i)
    factors.row(i) /= head.data().weights[index(i)];
  return factors;
}

/// The series s(t) of the curve itself at its start.
ArcLengthSeries ownSeries(const BezierCurve& segment, double unit) {
  const auto jet = endJet<kMaxOrder>(segment.view(), CurveEnd::kStart, 0.0);
  ArcLengthSeries series{unit};
  if (isSingular(jet)) return series;
  const auto arc = arcJet(jet);
  std::copy_n(arc.arcLength.begin() + 1, kMaxOrder, series.begin());
  return series;
}

FitOptions fitOptions(const MatchOptions& options, const BezierCurve& segment, double unit) {
  constexpr double kLeastSpeed = 0.5;
  FitOptions fit{.start = ownSeries(segment, unit)};
  fit.lowestSpeed = kLeastSpeed * std::min(unit, fit.start[0]);
  for (std::size_t k = 0; k < kMaxOrder; ++k) {
    if (options.beta[k]) fit.given[k] = *options.beta[k] * unit / detail::kFactorials[k + 1];
  }
  return fit;
}

/// The curve with other poles in place of the first ones from an end.
BSplineCurve withPoles(const BSplineCurve& curve, CurveEnd end, const Poles& first) {
  BSplineData data = curve.data();
  data.poleError = 0.0;  // these poles are the curve
  if (end == CurveEnd::kStart) {
    data.poles.leftCols(first.cols()) = first;
  } else {
    data.poles.rightCols(first.cols()) = first.rowwise().reverse();
  }
  return BSplineCurve(std::move(data));
}

/// The parameter range of the first spans from an end.
std::pair<double, double> rangeOf(const BSplineCurve& curve, CurveEnd end, int spans) {
  if (end == CurveEnd::kStart) return {curve.first(), curve.segment(spans - 1).last};
  return {curve.segment(curve.spanCount() - spans).first, curve.last()};
}

/// The largest distance of the changed spans from what they were, and where it is.
void setLargest(const BSplineCurve& curve, const BSplineCurve& head, const BSplineCurve& changed,
                CurveChange& change) {
  FarthestPoints farthest;
  int where = 0;
  for (int span = 0; span < change.spans; ++span) {
    const FarthestPoints here = farthestPoints(toNet(head.segment(span).curve.view()),
                                               toNet(changed.segment(span).curve.view()));
    if (here.distanceMm <= farthest.distanceMm) continue;
    farthest = here;
    where = span;
  }
  const BezierSegment segment = head.segment(where);
  const double fromEnd = segment.first + farthest.t * segment.length();
  const double parameter =
      change.end == CurveEnd::kStart ? curve.first() + fromEnd : curve.last() - fromEnd;
  change.largestMm = farthest.distanceMm + curve.poleError();
  change.parameter = std::clamp(parameter, change.first, change.last);
  change.point = segment.curve.evaluate(farthest.t);
  change.moved = changed.segment(where).curve.evaluate(farthest.t);
}

void addWarnings(const BSplineCurve& curve, bool isHeld, Match& result) {
  if (curve.isClosed(Tolerances{}.gapMm)) {
    result.warnings.emplace_back(
        "opened: b was closed; its end at the join moves and the other one stays");
  }
  if (result.change.raised > 0) {
    result.warnings.push_back("raised: b has degree " + std::to_string(result.curve.degree()) +
                              " now, from " + std::to_string(curve.degree()) +
                              ", to have enough poles for the order and the far end");
  }
  if (isHeld) {
    result.warnings.emplace_back(
        "held: the least change would begin at less than half the speed that b had, where poles "
        "crowd; it is held there");
  }
}

double unitOf(const BezierCurve& segment, double lengthMm) {
  const double reach = reachOf(segment.view(), CurveEnd::kStart);
  return reach > 0.0 ? reach : lengthMm;
}

void setBeta(const ArcLengthSeries& sigma, int order, double unit, Match& result) {
  for (std::size_t k = 0; k < index(order); ++k)
    result.beta.push_back(sigma[k] * detail::kFactorials[k + 1] / unit);
}

}  // namespace

Match unchanged(const BSplineCurve& curve, CurveEnd end, int order) {
  const BezierCurve segment = curveHead(openClamped(curve), end, 1).segment(0).curve;
  const double unit = unitOf(segment, 0.0);
  Match result{.curve = curve};
  result.change.end = end;
  result.change.parameter = end == CurveEnd::kStart ? curve.first() : curve.last();
  result.change.first = result.change.last = result.change.parameter;
  result.change.point = result.change.moved = curve.endPoint(end);
  if (unit > 0.0) setBeta(ownSeries(segment, unit), order, unit, result);
  return result;
}

Match match(const ContactJet& target, const BSplineCurve& curve, CurveEnd end,
            const MatchOptions& options) {
  checkOptions(target, options);
  const BSplineCurve own = openClamped(curve);
  const int seen = std::min(own.spanCount(), mostUsefulSpans(own.degree(), options) + 1);
  std::vector<KnotContact> contacts = knotContacts(curveHead(own, end, seen));
  const MatchPlan plan = planMatch(own, contacts, options);
  const int raised = plan.degree - own.degree();
  for (KnotContact& contact : contacts)
    contact.multiplicity += raised;

  const BSplineCurve full = own.elevated(raised);
  const BSplineCurve head = curveHead(full, end, plan.window.spans);
  const int count = options.order + 1;
  const LeastChange change = leastChange(head, contacts, plan.window, count);
  const BezierCurve segment = head.segment(0).curve;
  const double unit = unitOf(segment, change.lengthMm);
  const FirstPoles first{head.data().poles.leftCols(count),
                         polesByTaylor(head, SpanBasis(head, 0), options.order), change.cost};
  const FitOptions numbers = fitOptions(options, segment, unit);
  const ContactFit fit = fitContact(target, first, numbers);

  const Poles displacement = (fit.poles - first.old) * change.response.transpose();
  Poles poles = head.data().poles.leftCols(plan.window.poles) + displacement;
  poles.leftCols(count) = fit.poles;
  Match result{.curve = withPoles(full, end, poles)};
  result.change = {.end = end,
                   .raised = raised,
                   .spans = plan.window.spans,
                   .poles = plan.window.poles,
                   .rootMeanSquareMm = std::sqrt(fit.cost / change.lengthMm)};
  std::tie(result.change.first, result.change.last) = rangeOf(full, end, plan.window.spans);
  setLargest(full, head, curveHead(result.curve, end, plan.window.spans), result.change);
  const auto still = static_cast<int>(full.data().poles.cols()) - plan.window.poles;
  if (still <= plan.degree) result.change.kept = still - 1;
  setBeta(fit.sigma, options.order, unit, result);
  const bool isHeld = options.order >= 1 && !options.beta[0] && fit.sigma[0] == numbers.lowestSpeed;
  addWarnings(curve, isHeld, result);
  return result;
}

}  // namespace osculate
