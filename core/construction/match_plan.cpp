#include "osculate/construction/match_plan.h"

#include <algorithm>

#include "osculate/bezier/index.h"
#include "osculate/construction/contact_error.h"

namespace osculate {

namespace {

/// Counts what is free where a curve is changed over its first spans.
class Freedom {
 public:
  Freedom(const BSplineCurve& curve, const std::vector<KnotContact>& contacts,
          const MatchOptions& options)
      : own_(curve.degree()), spans_(curve.spanCount()), contacts_(contacts), options_(options) {}

  int spans() const { return spans_; }

  /// The dimension of the changes: degree+1 of the first span, for each further one as many as its
  /// knot's contact leaves, less the contact at the end.
  int dimension(int degree, int spans) const {
    int count = degree + 1;
    for (int j = 1; j < spans; ++j)
      count += degree - contacts_[index(j - 1)].order;
    return count - (spans == spans_ ? kept(degree) : contacts_[index(spans - 1)].order) - 1;
  }

  ChangeWindow window(int degree, int spans) const {
    const bool whole = spans == spans_;
    int poles = whole ? degree + 1 - (kept(degree) + 1) : 0;
    for (int j = 1; j <= spans - (whole ? 1 : 0); ++j)
      poles += contacts_[index(j - 1)].multiplicity + degree - own_;
    return {spans, poles, whole};
  }

  /// The fewest of `most` spans with this dimension, or those with the largest.
  int fewest(int degree, int most, int wanted) const {
    int best = 1;
    for (int spans = 1; spans <= most; ++spans) {
      if (dimension(degree, spans) >= wanted) return spans;
      if (dimension(degree, spans) > dimension(degree, best)) best = spans;
    }
    return best;
  }

 private:
  /// All derivatives are kept with the whole segment.
  int kept(int degree) const { return std::min(options_.keep, degree); }

  int own_;
  int spans_;
  const std::vector<KnotContact>& contacts_;
  const MatchOptions& options_;
};

void checkDegree(const BSplineCurve& curve, const MatchOptions& options) {
  if (options.degree == 0) return;
  const int least = std::max(curve.degree(), options.order);
  if (options.degree < least || options.degree > kMaxDegree) {
    throw ContactError("degree: b has degree " + std::to_string(curve.degree()) + ", and order " +
                       std::to_string(options.order) + " needs one from " + std::to_string(least) +
                       " to " + std::to_string(kMaxDegree) + ", got " +
                       std::to_string(options.degree));
  }
}

[[noreturn]] void failSpans(const MatchOptions& options, int least) {
  throw ContactError("spans: order " + std::to_string(options.order) + " needs at least " +
                     std::to_string(least) + " to change, with what b keeps at its knots; got " +
                     std::to_string(options.spans));
}

[[noreturn]] void failDegree(const MatchOptions& options, int least) {
  const std::string both = "order " + std::to_string(options.order) +
                           " at the join and the derivatives up to " +
                           std::to_string(options.keep) + " at the far end ";
  if (least > kMaxDegree) {
    throw ContactError("degree: " + both + "need more than " + std::to_string(kMaxDegree) +
                       "; keep less, or a lower order");
  }
  throw ContactError("degree: " + both + "need at least " + std::to_string(least) + ", got " +
                     std::to_string(options.degree));
}

}  // namespace

int mostUsefulSpans(int degree, const MatchOptions& options) {
  return options.order + 1 + 2 * (std::max({degree, options.order, options.degree}) + 1);
}

MatchPlan planMatch(const BSplineCurve& curve, const std::vector<KnotContact>& contacts,
                    const MatchOptions& options) {
  checkDegree(curve, options);
  const Freedom freedom(curve, contacts, options);
  const int useful = mostUsefulSpans(curve.degree(), options);
  const int reachable = std::min(freedom.spans(), useful);
  const int most = options.spans == 0 ? reachable : std::min(options.spans, reachable);
  const int needed = options.order + 1;
  int degree = std::max({curve.degree(), options.order, options.degree});
  for (; degree <= kMaxDegree; ++degree) {
    const int spans = freedom.fewest(degree, most, needed + 2 * (degree + 1));
    if (freedom.dimension(degree, spans) >= needed) return {degree, freedom.window(degree, spans)};
    const int least = freedom.fewest(degree, reachable, needed);
    if (freedom.dimension(degree, least) >= needed) failSpans(options, least);
    if (options.degree == degree) {
      int higher = degree;
      while (higher <= kMaxDegree && freedom.dimension(higher, most) < needed)
        ++higher;
      failDegree(options, higher);
    }
  }
  failDegree(options, degree);
}

}  // namespace osculate
