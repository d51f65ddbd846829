// What contact a curve has with itself at its inner knots; private to this floor.
#pragma once

#include <array>
#include <vector>

#include "osculate/bezier/bspline_curve.h"
#include "osculate/continuity/tolerances.h"

namespace osculate {

/// The contact of the two segments at an inner knot.
struct KnotContact {
  int multiplicity = 1;
  /// Of geometric contact, at most degree - 1, which a simple knot has; at least what the
  /// multiplicity ensures, degree - multiplicity.
  int order = 0;
  /// beta[k-1] of the re-parametrisation that carries the segment before into the one after, both
  /// over [0, 1], for k up to the order; not set at simple knots.
  std::array<double, kMaxOrder> beta{};
};

/// One for each inner knot, judged under the default tolerances: a joint that looks smooth to order
/// m has order m.
std::vector<KnotContact> knotContacts(const BSplineCurve& curve);

}  // namespace osculate
