// Where the curvature of a curve is too small to give a normal.
#pragma once

#include <array>

#include "osculate/bezier/bspline_curve.h"

namespace osculate {

/// Judges points of one curve on the scale of the whole curve.
class Flatness {
 public:
  explicit Flatness(const BSplineCurve& curve);

  /// The curvature in 1/mm up to which the curve is flat at a point of it: kFlatness / L, L the
  /// largest distance of the curve's ends and middle from the point, or what rounding can make of
  /// zero, whichever is larger.
  double below(const Vector3& point, double curvatureError) const;

 private:
  std::array<Vector3, 4> landmarks_;
  std::size_t count_;
};

}  // namespace osculate
