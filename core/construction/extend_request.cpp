#include "osculate/construction/extend_request.h"

#include <algorithm>
#include <cmath>

#include "osculate/bezier/bernstein.h"
#include "osculate/bezier/index.h"
#include "osculate/construction/contact_error.h"
#include "osculate/continuity/curve_joins.h"
#include "osculate/differential/arc_jet.h"

namespace osculate {

namespace {

// Fairness sees what lies between the ends: with contact of order 3 and more it would rather change
// the curvature at once, in a boundary layer where the poles crowd and double coordinates do not
// carry the order. A first leg of this share of an even one keeps G4 within the preset `exact`.
constexpr double kLeastStep = 0.35;

void check(bool good, const char* message) {
  if (!good) throw std::invalid_argument(message);
}

void checkPossible(bool good, const char* message) {
  if (!good) throw ContactError(message);
}

int givenCount(const GivenNumbers& numbers) {
  return static_cast<int>(
      std::count_if(numbers.begin(), numbers.end(), [](const auto& number) { return !!number; }));
}

void checkGiven(const GivenNumbers& numbers, int order, const std::string& name,
                const std::string& first) {
  for (int k = 1; k <= kMaxOrder; ++k) {
    const auto& number = numbers[index(k - 1)];
    if (!number) continue;
    if (k > order) {
      throw std::invalid_argument(name + ": contact of order " + std::to_string(order) + " has " +
                                  std::to_string(order) + " numbers, got one for order " +
                                  std::to_string(k));
    }
    if (!std::isfinite(*number))
      throw std::invalid_argument(name + ": every number must be finite");
    if (k == 1 && *number <= 0.0)
      throw std::invalid_argument(std::string(name).append(": ").append(first) + " must be > 0");
  }
}

void checkRanges(const ExtendOptions& options) {
  if (options.order < 0 || options.order > kMaxOrder) {
    throw std::invalid_argument("order: must be from 0 to " + std::to_string(kMaxOrder) + ", got " +
                                std::to_string(options.order));
  }
  if (options.degree < 0 || options.degree > kMaxDegree) {
    throw std::invalid_argument("degree: must be from 1 to " + std::to_string(kMaxDegree) +
                                ", or 0 for the lowest that can, got " +
                                std::to_string(options.degree));
  }
  checkGiven(options.beta, options.order, "beta", "beta_1");
  checkGiven(options.tangential, options.order, "tangential", "that of C_1");
  const auto& [point, direction, vector, curvature, length] = options.targets;
  check(!length || (std::isfinite(*length) && *length > 0.0), "length: must be finite and > 0");
  check(!point || point->allFinite(), "to_point: must be finite");
  check(!direction || (direction->allFinite() && direction->norm() > 0.0),
        "to_direction: must be finite and not zero");
  check(!vector || vector->allFinite(), "to_curvature: must be finite");
  check(!curvature || (std::isfinite(*curvature) && *curvature >= 0.0),
        "to_curvature: a number must be finite and >= 0; give a vector for the side it bends to");
  check(!options.parameter || (std::isfinite(*options.parameter) && *options.parameter > 0.0),
        "parameter: must be finite and > 0");
}

void checkAgreement(const ExtendOptions& options) {
  const bool isParametric = options.parametric || options.parameter;
  const bool hasBeta = givenCount(options.beta) > 0;
  const bool hasTangential = givenCount(options.tangential) > 0;
  checkPossible(!(hasBeta && hasTangential),
                "over-determined: beta and tangential are the same free numbers; give one of them");
  checkPossible(!(isParametric && (hasBeta || hasTangential)),
                "over-determined: with parametric or parameter, the curve's own parameter fixes "
                "the numbers that beta and tangential give");
  checkPossible(!(options.parametric && options.parameter),
                "over-determined: parameter shortens the curve of parametric, so that it is not "
                "C^m any more; give one of them");
  const auto& [point, direction, vector, curvature, length] = options.targets;
  check(!(vector && curvature), "to_curvature: give a vector or a number");
  if (vector && direction) {
    const double along = std::abs(vector->dot(direction->normalized()));
    checkPossible(along <= 1e-9 * vector->norm(),
                  "to_curvature: a curvature vector is at right angles to the tangent, and this "
                  "one is not to to_direction");
  }
}

}  // namespace

ExtendRequest::ExtendRequest(const BSplineCurve& curve, const ExtendOptions& options)
    : options_(options), reach_(0.0) {
  checkRanges(options);
  checkAgreement(options);
  // the tangent is the direction of a curve without contact too
  contact_ = contactJet(curve, {.end = options.end}, std::max(options.order, 1));
  jet_ = graphJet(contact_);
  contact_.order = jet_.overTangent.order = options.order;
  reach_ = reachFrom(curve, options.end);
  checkTargets();
  setOwnSeries(curve);
}

void ExtendRequest::checkTargets() const {
  const auto& [point, direction, vector, curvature, length] = options_.targets;
  if (!point) return;
  const double distance = (*point - contact_.r[0]).norm();
  checkPossible(distance > 1e-12 * std::max(point->norm(), contact_.r[0].norm()),
                "to_point: it is the end itself; an extension has a length");
  checkPossible(!length || *length > distance,
                "length: not more than the distance of to_point; a curve is longer than its chord");
}

/// The Taylor coefficients of the curve go on where it arrives: outward at its end, t becomes -t.
void ExtendRequest::setOwnSeries(const BSplineCurve& curve) {
  const BezierSegment segment = curve.endSegment(options_.end);
  const auto jet = endJet<kMaxOrder>(segment.curve.view(), options_.end, segment.poleError);
  if (isSingular(jet)) {
    checkPossible(!isParametric() || order() == 0,
                  "parametric: the curve stops at its end (repeated poles), so that no curve "
                  "continues its parameter; take geometric contact");
    return;
  }
  const auto arc = arcJet(jet);
  const double share = options_.parameter.value_or(1.0);
  ArcLengthSeries sigma{};
  double sign = 1.0;
  double scale = share;
  for (int k = 1; k <= order(); ++k) {
    sigma[index(k - 1)] = sign * scale * arc.arcLength[index(k)];
    sign = -sign;
    scale *= share;
  }
  ownSeries_ = tangentialOf(contact_, sigma);
  constexpr double kVanishes = 8.0;  // bounds of its error
  while (ownDegree_ > 1 &&
         jet.c[index(ownDegree_)].norm() <= kVanishes * jet.error[index(ownDegree_)])
    --ownDegree_;
}

bool ExtendRequest::canBeParametric(int degree) const {
  return !isParametric() || degree >= std::min(order(), ownDegree_);
}

bool ExtendRequest::isFixedByBeta(int degree) const {
  return order() > 0 && degree <= order() && givenCount(options_.beta) == order();
}

ExtendTask ExtendRequest::task(int degree) const {
  ExtendTask task{.jet = jet_,
                  .tangent = contact_.r[1],
                  .degree = degree,
                  .beta = options_.beta,
                  .tangential = options_.tangential,
                  .targets = options_.targets,
                  .unit = 1.0};
  const int attached = std::min(degree, order());
  if (isParametric()) {
    for (int k = 1; k <= attached; ++k) {
      double along = 0.0;
      for (int l = 1; l <= k; ++l)
        along += binomial(k, l) / binomial(degree, l) * ownSeries_[index(l - 1)];
      task.tangential[index(k - 1)] = along;
    }
  }
  auto& [point, direction, vector, curvature, length] = task.targets;
  const bool hasFree = degree > attached || givenCount(task.tangential) < attached;
  if (!length && !point && hasFree && !isFixedByBeta(degree)) length = defaultLength(task);
  task.unit = length ? *length : point ? (*point - contact_.r[0]).norm() : defaultLength(task);
  if (degree >= order() && !options_.beta[0]) task.leastStep = kLeastStep;
  return task;
}

/// The reach, or, where coordinates of poles are given, n/k times the last of them: the length of
/// the curve that goes on so.
double ExtendRequest::defaultLength(const ExtendTask& task) const {
  for (int k = std::min(order(), task.degree); k >= 1; --k) {
    const auto& along = task.tangential[index(k - 1)];
    if (along && *along > 0.0) return *along * task.degree / k;
  }
  return reach_;
}

int ExtendRequest::numbers(int degree) const {
  const int attached = std::min(degree, order());
  const int given = isParametric() ? attached : givenCount(options_.tangential);
  return attached - std::min(given, attached) + 3 * (degree - attached);
}

std::vector<ExtendRequest::Condition> ExtendRequest::conditions(int degree) const {
  const auto& [point, direction, vector, curvature, length] = options_.targets;
  std::vector<Condition> list;
  const auto add = [&](const char* name, int count) {
    if (count > 0) list.push_back({name, count});
  };
  add("contact above the degree", 2 * std::max(order() - degree, 0));
  add("beta", givenCount(options_.beta));
  add("to_point", point ? 3 : 0);
  add("to_direction", direction ? 2 : 0);
  const bool isVector = vector || (curvature && *curvature == 0.0);
  add("to_curvature", isVector ? (direction || curvature ? 2 : 3) : (curvature ? 1 : 0));
  add("length", length ? 1 : 0);
  return list;
}

bool ExtendRequest::isOverdetermined(int degree) const {
  int sum = 0;
  for (const Condition& condition : conditions(degree))
    sum += condition.count;
  return sum > numbers(degree);
}

std::string ExtendRequest::count(int degree) const {
  int sum = 0;
  std::string names;
  for (const Condition& condition : conditions(degree)) {
    sum += condition.count;
    names += (names.empty() ? ": " : ", ") + condition.name + " (" +
             std::to_string(condition.count) + ")";
  }
  return "degree " + std::to_string(degree) + " has " + std::to_string(numbers(degree)) +
         " free numbers for " + std::to_string(sum) + " conditions" + names;
}

}  // namespace osculate
