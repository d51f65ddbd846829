// The tolerance of each order of continuity, and the presets of other systems with their sources.
#pragma once

#include <span>
#include <string_view>

namespace osculate {

/// The highest order of contact that is analysed.
inline constexpr int kMaxOrder = 8;

/// How other systems measure a G2 deviation (the verdict itself is always the vector one).
enum class CurvatureMetric : unsigned char {
  kVector,        ///< |k1 N1 - k2 N2| / max(k1, k2, 1/L)
  kMaximum,       ///< 1 - r, r = kmin/kmax: CATIA V5, KOMPAS
  kOpenNurbs,     ///< 1 - r, with the angle of the curvature vectors at most 2 degrees
  kSum,           ///< (1 - r)/(1 + r): Alias
  kMean,          ///< 2 (1 - r)/(1 + r)
  kGeometricMean  ///< (1 - r)/sqrt(r), with the angle of the normals: OCCT LocalAnalysis
};

/// Largest residual of each order that still passes.
struct Tolerances {
  double gapMm = 1e-3;        ///< order 0: distance of the ends, mm
  double angleDegrees = 0.1;  ///< order 1: angle between the tangents, degrees
  double curvature = 0.01;    ///< order 2, dimensionless
  double third = 0.02;        ///< order 3, dimensionless
  double fourth = 0.05;       ///< order 4 and above, dimensionless
  CurvatureMetric metric = CurvatureMetric::kVector;  ///< how this preset's system measures G2
  std::string_view name = "osculate";                 ///< of the preset, or "custom"; static text

  /// The tolerance of one order, 0 .. kMaxOrder, in the unit of its residual.
  double ofOrder(int order) const {
    switch (order) {
      case 0:
        return gapMm;
      case 1:
        return angleDegrees;
      case 2:
        return curvature;
      case 3:
        return third;
      default:
        return fourth;
    }
  }
  /// Throws std::invalid_argument that lists the presets.
  static Tolerances preset(std::string_view name);
  /// Throws std::invalid_argument unless every tolerance is finite and > 0.
  void check() const;
};

/// A preset with what is known of it.
struct TolerancePreset {
  std::string_view name;
  std::string_view source;    ///< where its numbers are from
  std::string_view borrowed;  ///< which of its values are those of `osculate`, or empty
};
std::span<const TolerancePreset> tolerancePresets();

}  // namespace osculate
