// Interpolation of points by a cubic curve that is G2, with a tension at each point.
#pragma once

#include <array>
#include <vector>

#include "osculate/bezier/bspline_curve.h"

namespace osculate {

/// How parameters are chosen: their steps are powers of the distances of the points.
enum class Spacing : unsigned char {
  kUniform,      ///< |step|^0
  kCentripetal,  ///< |step|^(1/2) (Lee 1989): no loops where distances differ much
  kChordal       ///< |step|
};

/// What an open curve does at one of its ends.
struct NuSplineEnd {
  enum class Kind : unsigned char {
    kNatural,  ///< least energy: P'' = nu P' at the start, P'' = -nu P' at the end, so that the
               ///< curvature is 0 there
    kBessel,   ///< the derivative of the parabola through the first three points
    kTangent   ///< the derivative `tangent` times the speed |step| / h of the end span
  };
  Kind kind = Kind::kNatural;
  Vector3 tangent = Vector3::Zero();  ///< in the direction of travel; a unit vector is neutral
};

struct NuSplineOptions {
  /// >= 0, without dimension: one for each point, or one for all. 0 is the C2 cubic spline.
  std::vector<double> tension{0.0};
  /// Increasing, one for each point, and of a closed curve the end of its period; empty: chosen by
  /// `spacing`, from 0 to the length of the polygon.
  std::vector<double> parameters{};
  Spacing spacing = Spacing::kCentripetal;
  std::array<NuSplineEnd, 2> ends{};  ///< of an open curve
  bool closed = false;                ///< goes on from the last point to the first
};

/// The nu-spline (Nielson 1974) through the points, 3 x n: the C1 cubic curve that minimises
///     int |P''|^2 dt + sum nu_i |P'(t_i)|^2,
/// so that P''(t_i+) - P''(t_i-) = nu_i P'(t_i): the curvature vector is continuous.
///
/// nu_i = tension_i (1/h_{i-1} + 1/h_i) / 2 with the parameter steps h beside the point (at an open
/// end with the one there is): the shape does not change when points or parameters are scaled, and
/// for steps of 1 the tension is nu. Inner knots are double, or simple where nu_i = 0, and a closed
/// curve is periodic. The cost is linear in n.
///
/// Throws std::invalid_argument that names the argument and the rule: at least 2 points (closed:
/// 3), finite coordinates, no two neighbours equal unless parameters are given, increasing
/// parameters, tensions >= 0, tangents that are not zero.
BSplineCurve nuSpline(const Poles& points, const NuSplineOptions& options = {});

}  // namespace osculate
