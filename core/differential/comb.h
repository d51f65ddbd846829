// Combs: curvature, torsion and their rates along a curve, one-sided wherever the curve has a knot.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include "osculate/bezier/bspline_curve.h"

namespace osculate {

/// What a comb can show; rates are by arc length.
enum class CombQuantity : unsigned char {
  kCurvature,       ///< kappa >= 0, 1/mm
  kTorsion,         ///< tau, signed, 1/mm
  kCurvatureRate,   ///< d kappa / ds, 1/mm^2
  kCurvatureRate2,  ///< d^2 kappa / ds^2, 1/mm^3
  kTorsionRate      ///< d tau / ds, 1/mm^2
};
inline constexpr std::size_t kCombQuantities = 5;
/// "curvature", "torsion", "curvature_rate", "curvature_rate2", "torsion_rate".
std::string_view name(CombQuantity quantity);

/// One point of a comb. What does not exist is NaN: normal, torsion and rates where the curvature
/// is zero, all but the tangent at a cusp.
struct CombSample {
  double parameter;  ///< of the curve
  double arcLength;  ///< from the curve's start, mm
  Vector3 point;     ///< mm
  Vector3 tangent, normal, binormal;
  std::array<double, kCombQuantities> value;
  bool isTooth;  ///< one of the evenly spaced samples, not one that was added between them

  double operator[](CombQuantity quantity) const {
    return value[static_cast<std::size_t>(quantity)];
  }
};

/// Samples between which all quantities are smooth: from one knot, inflection or cusp to the next.
/// The first and the last have the limits from within the run.
struct CombRun {
  std::size_t first, last;  ///< indices into the samples
};

enum class CombMarkKind : unsigned char {
  kInflection,  ///< the curvature is zero and the curve bends to the other side
  kVertex,      ///< the curvature is stationary: d kappa / ds = 0 changes sign
  kCusp,        ///< the tangent turns back
  kPeak         ///< a local maximum of the magnitude of a quantity
};
/// "inflection", "vertex", "cusp", "peak".
std::string_view name(CombMarkKind kind);

/// A point of interest; it is one of the samples.
struct CombMark {
  CombMarkKind kind;
  CombQuantity quantity;  ///< of a peak; of the others kCurvature
  std::size_t sample;
  double uncertainty;  ///< how far along the curve it can be from the true place, mm
};

struct Comb {
  std::vector<CombSample> samples;  ///< in the direction of the parameter
  std::vector<CombRun> runs;
  std::vector<CombMark> marks;  ///< in the order of their samples
  double length = 0.0;          ///< of the curve, mm
};

struct CombOptions {
  /// Intervals of equal parameter of each Bézier segment, from 2 to 10000; a segment of degree n
  /// has 2n at least.
  int density = 24;
  /// Between them samples are added where the quantities that are shown bend away from their chord
  /// by more than this share of themselves, and where the curve turns by more than 15 degrees; 0
  /// adds none.
  double tolerance = 0.005;
  /// For which quantities samples are added and peaks are looked for. All are computed.
  std::array<bool, kCombQuantities> shown{true, true, true, true, true};
};

/// The comb of a curve. Values are one-sided at every knot: the two segments that meet there have a
/// sample each. Inflections, vertices and peaks are roots of kappa, d kappa/ds and of the
/// quantity's rate, found between samples of opposite sign to 1e-12 of the segment's parameter
/// interval or to where rounding hides the sign. Arc lengths have a relative error of about 1e-9.
/// Throws std::invalid_argument for options out of range.
Comb comb(const BSplineCurve& curve, const CombOptions& options = {});

}  // namespace osculate
