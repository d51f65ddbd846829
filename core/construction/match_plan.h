// Which degree a match needs and how much of the curve it changes; private to this floor.
#pragma once

#include "osculate/construction/least_change.h"
#include "osculate/construction/match.h"

namespace osculate {

struct MatchPlan {
  int degree = 0;
  ChangeWindow window;
};

/// More spans than this are never changed: where one more of them is free, each displacement
/// falls by a factor from span to span (that of the inverse of a Gram matrix of B-splines: Demko
/// 1977), and over 2 (degree+1) of them to below a hundredth for every degree.
int mostUsefulSpans(int degree, const MatchOptions& options);

/// `contacts` are those of the first inner knots, from the end that is matched; all, or as many as
/// spans are useful. Throws as match does.
MatchPlan planMatch(const BSplineCurve& curve, const std::vector<KnotContact>& contacts,
                    const MatchOptions& options);

}  // namespace osculate
