#include "osculate/differential/flatness.h"

#include <algorithm>
#include <cmath>

#include "osculate/differential/arc_invariants.h"

namespace osculate {

namespace {

/// Whether the ends and the middle are one point, as those of a figure of eight can be.
bool areOnePoint(const BSplineCurve& curve) {
  constexpr double kNothing = 1e-6;
  const Vector3& start = curve.endPoint(CurveEnd::kStart);
  const Poles& poles = curve.data().poles;
  const double legs = std::max((poles.col(1) - poles.col(0)).squaredNorm(),
                               (poles.col(poles.cols() / 2) - poles.col(0)).squaredNorm());
  return std::max((curve.endPoint(CurveEnd::kEnd) - start).squaredNorm(),
                  (curve.middlePoint() - start).squaredNorm()) <= kNothing * kNothing * legs;
}

}  // namespace

Flatness::Flatness(const BSplineCurve& curve)
    : landmarks_{curve.endPoint(CurveEnd::kStart), curve.endPoint(CurveEnd::kEnd),
                 curve.middlePoint(), Vector3::Zero()},
      count_(3) {
  constexpr double kGoldenSection = 0.38196601125010515;
  if (!areOnePoint(curve)) return;
  landmarks_[count_++] = curve.evaluate(std::lerp(curve.first(), curve.last(), kGoldenSection));
}

double Flatness::below(const Vector3& point, double curvatureError) const {
  double squared = 0.0;
  for (std::size_t i = 0; i < count_; ++i)
    squared = std::max(squared, (landmarks_[i] - point).squaredNorm());
  return std::max(curvatureError, kFlatness / std::sqrt(squared));
}

}  // namespace osculate
