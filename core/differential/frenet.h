// The Frenet frame, curvature, torsion and their rates from arc-length derivatives.
#pragma once

#include <algorithm>
#include <optional>

#include "osculate/bezier/bezier_curve.h"

namespace osculate {

/// How the frame at a point came about (bachelor thesis, ch. 5: the special cases of its
/// algorithm).
enum class FrameKind : unsigned char {
  kFrenet,            ///< from the curvature
  kFictitiousNormal,  ///< curvature zero: the first leg of the control polygon off the tangent
  kLine,              ///< a straight line: the normal is chosen, in the xy plane where possible
  kFictitiousTangent  ///< first derivative zero: the first leg that is not
};
std::string_view name(FrameKind kind);

struct FrenetFrame {
  Vector3 tangent = Vector3::Zero();
  std::optional<Vector3> normal;
  std::optional<Vector3> binormal;
};

/// Units 1/mm, 1/mm, 1/mm^2, 1/mm^3, 1/mm^2; empty where the quantity does not exist.
struct Invariants {
  std::optional<double> curvature;  ///< empty only where r_2 does not exist (singular end)
  std::optional<double> torsion;
  std::optional<double> curvatureRate;   ///< d kappa / ds
  std::optional<double> curvatureRate2;  ///< d^2 kappa / ds^2
  std::optional<double> torsionRate;     ///< d tau / ds
};

/// A complete orthonormal frame at one end of a segment, by the thesis's special cases.
struct EndFrame {
  FrenetFrame frame;
  FrameKind kind = FrameKind::kFrenet;
};

/// How far rounding, or an error of the poles, can move poles of this size off a line they are on.
inline double lineTolerance(double size, double poleError) {
  return 2.0 * std::max(poleError, 8.0 * kUnitRoundoff * size);
}

/// Legs of the control polygon, counted from the end, that lie on the tangent line there to a
/// tolerance in mm. All legs of a straight segment do.
int legsOnTangent(BezierView segment, CurveEnd end, double tolerance);

/// The frame where curvature gives none: outward tangent known, normal from the first leg off it.
/// The tangent points in the direction of travel, the frame is right-handed.
EndFrame fictitiousFrame(BezierView segment, CurveEnd end, const Vector3& tangent, bool singular,
                         double poleError = 0.0);

}  // namespace osculate
