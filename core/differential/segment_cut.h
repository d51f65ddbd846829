// A Bézier segment cut at a parameter, so that a point inside it is an end.
#pragma once

#include <array>

#include "osculate/bezier/bspline_curve.h"

namespace osculate {

/// The longer of the two parts of a segment that is cut, seen outward from the cut.
struct CutSegment {
  BezierCurve curve;  ///< over [0, 1]
  CurveEnd end;       ///< the end of `curve` at the cut
  double length;      ///< share of the segment's parameter interval that it has
  double poleError;   ///< bound of the error of its poles in mm

  /// -1 where outward runs against the parameter.
  double sign() const { return end == CurveEnd::kEnd ? -1.0 : 1.0; }
};

/// Cuts one segment at many parameters; nothing is allocated.
class SegmentCutter {
 public:
  explicit SegmentCutter(const BezierSegment& segment);

  /// t in [0, 1]; the whole segment at 0 and 1, bit for bit.
  CutSegment at(double t) const;

  const BezierSegment& segment() const { return segment_; }

 private:
  template <int Dimension>
  CutSegment cut(double t) const;

  BezierSegment segment_;
  std::array<double, 4 * (kMaxDegree + 1)> net_;  ///< x y z, or w x, w y, w z, w
  double rounding_;  ///< bound of what a cut adds to the error of the poles
};

}  // namespace osculate
