// Derivatives by arc length at an end whose first derivative is zero (a repeated end pole).
#pragma once

#include "osculate/differential/arc_jet.h"

namespace osculate {

/// The highest order of arc-length derivatives that singularEnd can be asked for.
inline constexpr int kMaxArcOrder = 8;

/// What is known of a singular end, outward from it.
struct SingularEnd {
  int multiplicity = 1;  ///< m, the first derivative by the parameter that does not vanish
  int smoothness = 0;    ///< r_1 .. r_smoothness exist
  std::array<Vector3, kMaxArcOrder + 1> r;     ///< d^k P / ds^k, zero where it does not exist
  std::array<double, kMaxArcOrder + 1> error;  ///< bounds of the errors |delta r[k]|
};

/// With m the first derivative that does not vanish, the curve by arc length is a series in
/// s^(1/m); the terms of whole powers give r_k, the first other term that does not vanish ends the
/// smoothness (Puiseux expansion; e.g. (t^2, t^3) has an s^(3/2) term and only r_1). Terms within
/// the error bounds count as vanishing. Where all poles are one point, multiplicity is degree+1,
/// smoothness 0.
SingularEnd singularEnd(BezierView segment, CurveEnd end, double poleError, int order);

}  // namespace osculate
