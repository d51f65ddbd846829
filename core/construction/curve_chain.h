// Curves put one behind the other: which follows which, and which of them are travelled backwards.
#pragma once

#include <span>
#include <vector>

#include "osculate/bezier/bspline_curve.h"

namespace osculate {

/// One curve of a chain.
struct ChainLink {
  std::size_t index;  ///< in the list of curves
  bool reversed;      ///< travelled against its own direction
};

struct CurveChain {
  std::vector<ChainLink> links;  ///< in the order of travel
  /// The last end meets the first start; not where the curves are less than four times as long as
  /// the gap there, unless that is rounding.
  bool closed = false;
  bool sorted = false;  ///< the order is not that of the list
};

/// A share of the coordinates below which differences are rounding: 1.1e-13.
inline constexpr double kJoinRounding = 0x1p-43;

/// What ends of these curves may be apart by rounding, in mm: kJoinRounding of the largest distance
/// of a pole from the origin, and what is known of the errors of the poles.
double roundingMm(const BSplineCurve& first, const BSplineCurve& second);

/// Length of the control polygon, in mm.
double polygonLength(const BSplineCurve& curve);

/// The curves in the order of the list, each in the direction for which the sum of the gaps is
/// least, the first one in its own where that decides nothing. If a gap between ends is then wider
/// than rounding and than twice the tolerance (so that each end would move by more than the
/// tolerance), the curves are sorted by their ends instead; the first of the list then keeps its
/// direction, and a closed chain begins with it. Throws ContactError where the curves make no
/// chain: a gap (with the pair and the gap), ends of three curves at one point that only the order
/// of the list could tell apart; std::invalid_argument for no curve, for a curve that is twice in
/// the list (also reversed) and for a tolerance that is negative or not finite.
CurveChain orderChain(std::span<const BSplineCurve> curves, double toleranceMm);

}  // namespace osculate
