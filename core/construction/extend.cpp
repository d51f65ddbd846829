#include "osculate/construction/extend.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "osculate/construction/contact_error.h"
#include "osculate/construction/extend_search.h"
#include "osculate/differential/arc_jet.h"

namespace osculate {

namespace {

struct Least {
  int degree;
  FoundExtension found;
};

/// The highest degree that is tried: more poles than all conditions together need.
int highestDegree(const ExtendRequest& request) {
  constexpr int kMostMore = 8;
  return std::min(request.lowestDegree() + kMostMore, kMaxDegree);
}

/// The lowest degree that can, from one on.
std::optional<Least> lowestFrom(const ExtendRequest& request, int first) {
  for (int degree = first; degree <= highestDegree(request); ++degree) {
    if (auto found = findExtension(request, degree)) return Least{degree, *found};
  }
  return {};
}

/// `higher` is a degree that can, if there is one.
[[noreturn]] void fail(const ExtendRequest& request, int degree,
                       const std::optional<Least>& higher) {
  std::string text = request.isOverdetermined(degree) ? "over-determined: " : "degree: ";
  text += request.count(degree);
  text += request.isFixedByBeta(degree)
              ? ": they fix the chord, and there is none that agrees with them"
              : ", and no curve of that degree was found";
  text += higher ? "; degree " + std::to_string(higher->degree) + " can"
                 : ", nor of any up to " + std::to_string(highestDegree(request));
  throw ContactError(text);
}

FoundExtension find(const ExtendRequest& request) {
  const int wanted = request.options().degree;
  const int lowest = request.lowestDegree();
  if (wanted != 0 && wanted <= lowest) {
    if (const auto found = findExtension(request, wanted)) return *found;
    fail(request, wanted, lowestFrom(request, wanted + 1));
  }
  const std::optional<Least> least = lowestFrom(request, lowest);
  if (!least || (wanted != 0 && least->degree > wanted))
    fail(request, wanted == 0 ? lowest : wanted, least);
  if (wanted == 0 || least->degree == wanted) return least->found;
  // more poles are never worse: at least the same curve
  const auto found = findExtension(request, wanted, &least->found);
  return found ? *found
               : FoundExtension{least->found.curve.elevated(wanted - least->degree),
                                least->found.objective, least->found.freeNumbers};
}

std::vector<double> betaOf(const BezierCurve& curve, int order) {
  const auto arc = arcJet(endJet<kMaxOrder>(curve.view(), CurveEnd::kStart, 0.0));
  const double chord = (curve.pole(curve.degree()) - curve.pole(0)).norm();
  std::vector<double> beta;
  for (int k = 1; k <= order; ++k) {
    const auto i = static_cast<std::size_t>(k);
    beta.push_back(detail::kFactorials[i] * arc.arcLength[i] / chord);
  }
  return beta;
}

/// More energy than a full circle has: (2 pi)^4 of "mvc", (2 pi)^2 of "bending".
bool isSharp(double objective, Fairness fairness) {
  const double power = fairness == Fairness::kBending ? 2.0 : 4.0;
  return objective > power * std::log(2.0 * std::numbers::pi);
}

void addWarnings(const ExtendOptions& options, Extension& result) {
  constexpr double kCramped = 0.1;
  if (options.order >= 1 && result.beta[0] < kCramped) {
    result.warnings.emplace_back(
        "cramped: beta_1 is below a tenth of a chord; the poles crowd at the join");
  }
  const auto& [point, direction, vector, curvature, length] = options.targets;
  const bool isAimed = point || direction || vector || curvature;
  if (isAimed && result.objective && isSharp(*result.objective, *options.fairness)) {
    result.warnings.push_back("sharp: the curve bends more than a full circle; degree " +
                              std::to_string(result.curve.degree() + 1) +
                              " leaves more numbers to fairness");
  }
}

}  // namespace

Extension extend(const BSplineCurve& curve, const ExtendOptions& options) {
  const ExtendRequest request(curve, options);
  const FoundExtension found = find(request);
  Extension result{.curve = found.curve,
                   .beta = betaOf(found.curve, options.order),
                   .objective = found.objective,
                   .freeNumbers = found.freeNumbers};
  if (options.parametric) result.parameterLength = curve.endSegment(options.end).length();
  addWarnings(options, result);
  return result;
}

}  // namespace osculate
