#include "osculate/construction/knot_contact.h"

#include <algorithm>

#include "osculate/continuity/curve_joins.h"

namespace osculate {

std::vector<KnotContact> knotContacts(const BSplineCurve& curve) {
  const int degree = curve.degree();
  std::vector<KnotContact> contacts;
  bool simple = true;
  for (const auto& knot : curve.innerKnots()) {
    contacts.push_back({.multiplicity = knot.multiplicity, .order = degree - knot.multiplicity});
    simple = simple && knot.multiplicity == 1;
  }
  if (simple) return contacts;
  // the closing join, where there is one, comes last
  const auto joins =
      analyzeInnerJoins(curve, {.order = std::min(degree - 1, kMaxOrder), .tolerances = {}});
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    if (contacts[i].multiplicity == 1) continue;
    const JoinReport& report = joins[i].report;
    if (report.verdicts[0] == Verdict::kFail) continue;
    contacts[i].order = std::max(contacts[i].order, report.betaCount);
    contacts[i].beta = report.beta;
  }
  return contacts;
}

}  // namespace osculate
