// Taylor coefficients of a Bézier curve at one of its ends, outward from that end, with error
// bounds.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "osculate/bezier/bernstein.h"
#include "osculate/bezier/bezier_curve.h"

namespace osculate {

/// P(t) = point + sum_k c[k] t^k, t running from the end into the segment (t in [0, 1]).
template <int N>
struct Jet {
  Vector3 point;
  double pointError;                ///< bound of the error of the point, mm
  std::array<Vector3, N + 1> c;     ///< c[0] is zero
  std::array<double, N + 1> error;  ///< bounds of the errors |delta c[k]|
  double size;                      ///< largest distance from the origin of the poles used
};

namespace detail {

/// The sum of the components' magnitudes: a bound of the norm without a square root.
template <class Vector>
[[gnu::always_inline]] inline auto normBound(const Vector& v) {
  using std::abs;
  return abs(v.x()) + abs(v.y()) + abs(v.z());
}

/// The poles counted from the end.
struct PolesFromEnd {
  BezierView view;
  bool fromStart;
  Eigen::Map<const Vector3> pole(int i) const { return view.pole(index(i)); }
  double weight(int i) const { return view.weights[index(i)]; }
  int index(int i) const { return fromStart ? i : view.degree - i; }
};

/// Forward differences in place: d[k] becomes Delta^k d[0].
template <class Element>
[[gnu::always_inline]] inline void differences(Element* d, int count) {
  for (int k = 1; k <= count; ++k) {
    for (int i = count; i >= k; --i)
      d[i] = d[i] - d[i - 1];
  }
}

/// How much a difference of order k multiplies an error of its terms: 2^k, and half as much again
/// for each subtraction's own rounding.
constexpr double amplification(int degree, int k) {
  return binomial(degree, k) * static_cast<double>(1 << k) * (1.0 + 0.5 * k);
}

/// c_k = C(n,k) Delta^k b_0 for k = 1..used (Farin, CAGD, sec. 5.3). Reads used+1 poles.
template <int N>
[[gnu::always_inline]] inline void polynomialTaylor(const PolesFromEnd& from, int used,
                                                    double poleError, Jet<N>& jet) {
  std::array<Vector3, N + 1> d;
  double largest = 0.0;
  for (int i = 0; i <= used; ++i) {
    const auto k = static_cast<std::size_t>(i);
    d[k] = from.pole(i);
    largest = std::max(largest, d[k].squaredNorm());
  }
  jet.size = std::sqrt(largest);
  jet.pointError = std::max(poleError, kUnitRoundoff * jet.size);
  jet.point = d[0];
  differences(d.data(), used);
  for (int i = 1; i <= used; ++i) {
    const auto k = static_cast<std::size_t>(i);
    jet.c[k] = binomial(from.view.degree, i) * d[k];
    jet.error[k] = amplification(from.view.degree, i) * jet.pointError;
  }
  for (auto k = static_cast<std::size_t>(used) + 1; k <= N; ++k) {
    jet.c[k].setZero();
    jet.error[k] = 0.0;
  }
}

/// The homogeneous Taylor coefficients (w (b - b_0), w), then c_k = (a_k - sum w_j c_{k-j}) / w_0.
template <int N>
[[gnu::always_inline]] inline void rationalTaylor(const PolesFromEnd& from, int used,
                                                  double poleError, Jet<N>& jet) {
  std::array<Eigen::Vector4d, N + 1> h;
  double largest = 0.0;
  double heaviest = 0.0;
  jet.point = from.pole(0);
  for (int i = 0; i <= used; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const Vector3 difference = from.pole(i) - jet.point;
    const double weight = from.weight(i);
    h[k] << weight * difference, weight;
    largest = std::max(largest, from.pole(i).squaredNorm());
    heaviest = std::max(heaviest, weight);
  }
  jet.size = std::sqrt(largest);
  jet.pointError = std::max(poleError, kUnitRoundoff * jet.size);
  // two poles and three roundings of their difference, which is at most twice the size
  const double termError = heaviest * (2.0 * jet.pointError + 6.0 * kUnitRoundoff * jet.size);
  differences(h.data(), used);

  const double inverse = 1.0 / h[0][3];
  std::array<double, N + 1> norm;         // bounds of |c_k|
  std::array<double, N + 1> weightError;  // of the weight's coefficients and the products with them
  norm[0] = 0.0;
  for (int i = 1; i <= N; ++i) {
    const auto k = static_cast<std::size_t>(i);
    Vector3 sum = Vector3::Zero();
    double error = 0.0;
    if (i <= used) {
      h[k] *= binomial(from.view.degree, i);
      sum = h[k].template head<3>();
      const double growth = amplification(from.view.degree, i);
      error = growth * termError;
      weightError[k] = kUnitRoundoff * (2.0 * growth * heaviest + 4.0 * std::abs(h[k][3]));
    }
    for (int m = 1; m <= std::min(i, used); ++m) {
      const auto j = static_cast<std::size_t>(m);
      sum -= h[j][3] * jet.c[k - j];
      error += std::abs(h[j][3]) * jet.error[k - j] + weightError[j] * norm[k - j];
    }
    jet.c[k] = inverse * sum;
    norm[k] = normBound(jet.c[k]);
    jet.error[k] = inverse * error + 4.0 * kUnitRoundoff * norm[k];
  }
}

}  // namespace detail

/// The jet at one end of a segment, from the poles that matter only: those next to the end.
/// The errors suppose poles known to half a unit in the last place, or to `poleError` mm if that
/// is more, and weights to half a unit; they are bounds to first order.
template <int N>
[[gnu::always_inline]] inline Jet<N> endJet(BezierView view, CurveEnd end, double poleError) {
  Jet<N> jet;
  const detail::PolesFromEnd from{view, end == CurveEnd::kStart};
  jet.c[0].setZero();
  jet.error[0] = 0.0;
  const auto expand = [&](int used) __attribute__((always_inline)) {
    if (view.weights == nullptr) {
      detail::polynomialTaylor<N>(from, used, poleError, jet);
    } else {
      detail::rationalTaylor<N>(from, used, poleError, jet);
    }
  };
  if constexpr (N <= kMaxDegree) {
    if (view.degree >= N) {
      expand(N);  // a constant bound lets the compiler unroll the loops
      return jet;
    }
  }
  expand(std::min(view.degree, N));
  return jet;
}

}  // namespace osculate
