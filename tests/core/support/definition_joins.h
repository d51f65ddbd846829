// Joins that tell the definitions of G2 and G3 apart.
#pragma once

#include "support/joins.h"

namespace osculate::test {

/// A parametrisation of degree 6 that is not by arc length; the curve is about 4 mm long.
inline RealSeries unevenSigma() {
  return {Real(0), Real(4), Real(1), Real(-2), Real(1), Real(0), Real(0)};
}

/// A curve of constant or linearly changing curvature and torsion against another one, in mm.
struct Bends {
  double curvature;
  double rate = 0.0;
  double torsion = 0.0;
};

inline PointSeries arcOf(const Bends& bends) {
  return frenetCurve({Real(bends.curvature), Real(bends.rate)}, {Real(bends.torsion)}, 6);
}

inline JoinReport joinOf(const Bends& first, const Bends& second, double scale = 1.0,
                         const AnalysisOptions& options = {}) {
  const Eigen::Affine3d map(Eigen::Scaling(scale));
  return join(endingWith(arcOf(first), unevenSigma()).transformed(map),
              startingWith(arcOf(second), unevenSigma()).transformed(map), options);
}

inline BezierCurve quarterCircle(const std::vector<Vector3>& poles) {
  return BezierCurve(poles, std::vector<double>{1.0, std::sqrt(0.5), 1.0});
}

/// Quarter circles of two radii, tangent to x at the origin, both bending to +y.
inline JoinReport circlesOf(double firstRadius, double secondRadius,
                            const AnalysisOptions& options = {}) {
  const double r = firstRadius;
  const double s = secondRadius;
  return join(quarterCircle({{-r, r, 0}, {-r, 0, 0}, {0, 0, 0}}),
              quarterCircle({{0, 0, 0}, {s, 0, 0}, {s, s, 0}}), options);
}

/// Equal circles of radius 10 mm of which the first is only known to `poleError` mm; gaps below
/// 0.05 mm and angles below 5 degrees pass.
inline JoinReport undecidedCircles(double poleError) {
  const BezierCurve first = quarterCircle({{-10, 10, 0}, {-10, 0, 0}, {0, 0, 0}});
  const BezierCurve second = quarterCircle({{0, 0, 0}, {10, 0, 0}, {10, 10, 0}});
  JoinSide before = arriving(first);
  before.poleError = poleError;
  AnalysisOptions options;
  options.tolerances.gapMm = 0.05;
  options.tolerances.angleDegrees = 5.0;
  return analyzeJoin(before, leaving(second), options);
}

/// The second circle of the same radius turned about the tangent.
inline JoinReport turnedCircles(double degrees) {
  const double angle = degrees * std::numbers::pi / 180.0;
  const Vector3 side(0, 10 * std::cos(angle), 10 * std::sin(angle));
  return join(quarterCircle({{-10, 10, 0}, {-10, 0, 0}, {0, 0, 0}}),
              quarterCircle({{0, 0, 0}, {10, 0, 0}, Vector3(10, 0, 0) + side}));
}

/// One curve cut in the middle, the second half by another parameter.
inline JoinReport reparametrisedHalves() {
  const BezierCurve curve =
      bezier({{0, 0, 0}, {2, 3, 0}, {5, 3, 2}, {7, 0, 4}, {8, -3, 3}, {9, -3, 0}});
  const auto [left, right] = curve.split(0.5);
  return join(left, moebius(right, 2.0));
}

}  // namespace osculate::test
