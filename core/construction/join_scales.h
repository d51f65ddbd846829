// By what the knot intervals of joined curves are scaled; private to this floor.
#pragma once

#include <span>
#include <vector>

#include "osculate/bezier/bspline_curve.h"

namespace osculate {

struct JoinScales {
  std::vector<double> scales;   ///< of the parameter of each curve; the first is 1
  std::vector<double> weights;  ///< of the weights of each curve; the first is 1
};

/// Curves in the direction of travel, each clamped. Where two of them meet smoothly (the first
/// derivatives that are not zero are of one order m and within 0.1 degrees, the tolerance of G1 of
/// the preset `osculate`, or as near as the tolerance lets them be made equal), their scales make
/// the m-th derivatives equally long; for m = 1, the speeds. Scales that the poles cannot
/// tell from equal ones are equal. What this links is travelled at the
/// mean speed (length by parameter) of what is linked with the first curve. A link is cut where the
/// curve behind it would be a million times faster or slower than the first one of its run, as then
/// doubles could not tell its knots apart. Factors of the weights make them agree at every join.
/// `closed`: the last curve meets the first.
JoinScales joinScales(std::span<const BSplineCurve> curves, bool closed, double toleranceMm);

}  // namespace osculate
