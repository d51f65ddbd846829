#include "osculate/differential/comb_length.h"

#include <algorithm>
#include <cmath>

namespace osculate {

namespace {

constexpr double kRelative = 1e-9;
constexpr double kAbsolute = 1e-11;
constexpr int kMostBisections = 50;

/// Integral of the speed over an interval h from its derivatives at both ends, as many as there are
/// weights: sum w_k h^(k+1) (f_0^(k) + (-1)^k f_1^(k)) with
/// w_k = m! (2m-k-1)! / ((k+1)! (2m)! (m-k-1)!), m the number of weights: the integral of the
/// Hermite interpolant at both ends (Lanczos, Applied Analysis, ch. VI).
template <std::size_t Count>
double twoPointIntegral(const CombPoint& a, const CombPoint& b, double h,
                        const std::array<double, Count>& weights) {
  double sum = 0.0;
  double power = h;
  for (std::size_t k = 0; k < Count; ++k) {
    sum += weights[k] * power * (k % 2 == 0 ? a.speed[k] + b.speed[k] : a.speed[k] - b.speed[k]);
    power *= h;
  }
  return sum;
}

/// The same with halved intervals as far as `tolerance` (mm) needs, as it does beside a cusp.
double adaptiveLength(const SegmentSampler& sampler, const CombPoint& a, const CombPoint& b,
                      double tolerance, int depth) {
  constexpr std::array<double, 4> kFour{1.0 / 2, 3.0 / 28, 1.0 / 84, 1.0 / 1680};
  constexpr std::array<double, 5> kFive{1.0 / 2, 1.0 / 9, 1.0 / 72, 1.0 / 1008, 1.0 / 30240};
  const double h = b.t - a.t;
  const double best = twoPointIntegral(a, b, h, kFive);
  const double lower = twoPointIntegral(a, b, h, kFour);
  if (std::abs(best - lower) <= std::max(kRelative * best, tolerance)) return best;
  const double chord = (b.point - a.point).norm();
  if (chord <= tolerance || depth == 0) return chord;
  const CombPoint middle = sampler.at(0.5 * (a.t + b.t));
  return adaptiveLength(sampler, a, middle, tolerance, depth - 1) +
         adaptiveLength(sampler, middle, b, tolerance, depth - 1);
}

double polygonLength(const BezierCurve& curve) {
  double sum = 0.0;
  for (int i = 0; i < curve.degree(); ++i)
    sum += (curve.pole(i + 1) - curve.pole(i)).norm();
  return sum;
}

}  // namespace

double lengthBetween(const SegmentSampler& sampler, const CombPoint& a, const CombPoint& b) {
  return adaptiveLength(sampler, a, b, kAbsolute * polygonLength(sampler.segment().curve),
                        kMostBisections);
}

}  // namespace osculate
