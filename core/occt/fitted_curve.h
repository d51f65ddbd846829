// Polynomial fits of curves that have no exact form as a B-spline; private to this floor.
#pragma once

#include <functional>
#include <span>

#include "osculate/bezier/bspline_curve.h"

namespace osculate {

struct FittedCurve {
  /// Pieces of degree 9 with the ends of the given curve; its pole error bounds derivatives too.
  BSplineCurve curve;
  double errorMm = 0.0;  ///< four times the largest deviation found between the nodes
};

/// Interpolates `pointAt` at Chebyshev points, in pieces that begin and end at the breaks (at least
/// two, increasing; where the curve may be less than smooth) and are halved, at most to 1/256 of
/// the distance of two breaks, until the deviation is rounding.
FittedCurve fitCurve(const std::function<Vector3(double)>& pointAt, std::span<const double> breaks);

}  // namespace osculate
