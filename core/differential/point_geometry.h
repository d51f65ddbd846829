// Everything that differential geometry says of a curve at one parameter.
#pragma once

#include "osculate/bezier/bspline_curve.h"
#include "osculate/differential/frenet.h"

namespace osculate {

struct PointGeometry {
  Vector3 point = Vector3::Zero();  ///< mm
  FrenetFrame frame;                ///< normal and binormal empty where curvature is zero
  FrameKind kind = FrameKind::kFrenet;
  Invariants invariants;
  int smoothness = 0;  ///< arc-length derivatives that exist, at most 4
};

/// The geometry at t on the given side of a knot; tangent in the direction of the parameter.
PointGeometry geometryAt(const BSplineCurve& curve, double t, Side side = Side::kRight);

}  // namespace osculate
