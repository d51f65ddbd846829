// A Bézier curve, polynomial or rational, as an immutable value of fixed size (no allocation).
#pragma once

#include <array>
#include <span>
#include <utility>
#include <vector>

#include "osculate/bezier/vector3.h"

namespace osculate {

/// Which end of a curve: its start (t = first parameter) or its end (t = last parameter).
enum class CurveEnd : unsigned char { kStart, kEnd };

inline CurveEnd opposite(CurveEnd end) {
  return end == CurveEnd::kStart ? CurveEnd::kEnd : CurveEnd::kStart;
}

/// Poles and weights that live elsewhere: what the hot paths read. Nothing is checked.
struct BezierView {
  const double* poles = nullptr;    ///< degree+1 points, x y z each, in mm
  const double* weights = nullptr;  ///< degree+1 positive weights, or null for a polynomial curve
  int degree = 0;                   ///< 1 .. kMaxDegree

  Eigen::Map<const Vector3> pole(int i) const { return Eigen::Map<const Vector3>(poles + 3 * i); }
  double weight(int i) const { return weights == nullptr ? 1.0 : weights[i]; }
};

/// A Bézier curve of degree 1 to kMaxDegree over t in [0, 1].
class BezierCurve {
 public:
  /// Throws std::invalid_argument that names the argument and the rule: 2 to 26 poles, finite
  /// coordinates, as many weights as poles (or none), weights finite and > 0.
  explicit BezierCurve(std::span<const Vector3> poles, std::span<const double> weights = {});
  explicit BezierCurve(BezierView view);

  int degree() const { return degree_; }
  bool isRational() const { return rational_; }
  Eigen::Map<const Vector3> pole(int i) const { return view().pole(i); }
  double weight(int i) const { return rational_ ? weights_[static_cast<std::size_t>(i)] : 1.0; }
  BezierView view() const {
    return {poles_.data(), rational_ ? weights_.data() : nullptr, degree_};
  }

  /// The point at t (de Casteljau in homogeneous form; any real t).
  Vector3 evaluate(double t) const;
  /// Derivatives 0..count by t, count >= 0 (beyond the degree too).
  std::vector<Vector3> derivatives(double t, int count) const;

  BezierCurve reversed() const;
  /// The same curve with the degree raised; throws std::invalid_argument above kMaxDegree.
  BezierCurve elevated(int times = 1) const;
  /// The parts [0, t] and [t, 1], each over [0, 1]. Throws std::invalid_argument for t that is not
  /// finite, and where a rational curve is left so far that a weight of a part is not > 0.
  std::pair<BezierCurve, BezierCurve> split(double t) const;
  /// The part [a, b] over [0, 1]; a > b reverses, a = b throws std::invalid_argument, as split
  /// does.
  BezierCurve segment(double a, double b) const;
  BezierCurve transformed(const Eigen::Affine3d& map) const;

 private:
  friend class BezierBuilder;
  BezierCurve() = default;
  /// Also keeps end poles from the rounding of a multiplication and division by their weight.
  void setPole(int i, const Vector3& pole);

  std::array<double, 3 * (kMaxDegree + 1)> poles_;
  std::array<double, kMaxDegree + 1> weights_;
  int degree_ = 0;
  bool rational_ = false;
};

}  // namespace osculate
