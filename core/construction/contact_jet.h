// What a new curve has to agree with where it leaves another one.
#pragma once

#include <array>

#include "osculate/bezier/bspline_curve.h"
#include "osculate/continuity/tolerances.h"

namespace osculate {

/// Derivatives by arc length at a point of a curve, in the direction in which a new curve leaves.
struct ContactJet {
  std::array<Vector3, kMaxOrder + 1> r;  ///< r[0] the point in mm, r[k] = d^k P / ds^k in mm^(1-k)
  int order = 0;                         ///< r[0] .. r[order] are set
};

/// Where a new curve leaves an old one.
struct Departure {
  CurveEnd end = CurveEnd::kEnd;  ///< the end it leaves from, continuing the curve beyond it; or
  bool inside = false;            ///< it leaves from `parameter` instead,
  double parameter = 0.0;
  bool forward = true;  ///< in the direction of the parameter, or against it
};

/// Throws ContactError where the curve itself has no derivatives of that order (a singular end),
/// with the order it has; std::invalid_argument for an order outside
/// 0..kMaxOrder and for a parameter outside the curve or at the end that leaves nothing to
/// continue.
ContactJet contactJet(const BSplineCurve& curve, const Departure& departure, int order);

}  // namespace osculate
