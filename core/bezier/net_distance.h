// How far two Bézier curves are apart at equal parameters.
#pragma once

#include "osculate/bezier/bernstein.h"

namespace osculate {

/// The largest distance of two curves from above, and a parameter that attains it to a thousandth.
struct FarthestPoints {
  double distanceMm = 0.0;
  double t = 0.0;
};

/// max |A(t) - B(t)| over [0, 1] from above, in mm: a bound by the hull of the poles of the
/// difference, refined by subdivision until it is within a thousandth of the maximum. The nets have
/// the same size; weights > 0.
FarthestPoints farthestPoints(const Net& a, const Net& b);
/// The distance alone.
double largestDistance(const Net& a, const Net& b);

}  // namespace osculate
