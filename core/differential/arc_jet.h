// Derivatives by arc length at a regular end of a curve, with bounds of their errors.
#pragma once

#include <array>
#include <cmath>
#include <limits>

#include "osculate/differential/jet.h"
#include "osculate/differential/series.h"

namespace osculate {

/// Outward from the end, s >= 0. r[k] in mm^(1-k).
template <int N>
struct ArcJet {
  std::array<Vector3, N + 1> r;        ///< d^k P / ds^k, k >= 1; r[0] is zero
  std::array<double, N + 1> norm;      ///< |r[k]|
  std::array<double, N + 1> error;     ///< bounds of the errors |delta r[k]|
  std::array<double, N + 1> parameter; ///< Taylor coefficients of t(s); of a regular end only
  std::array<double, N + 1> arcLength; ///< Taylor coefficients of s(t); of a regular end only
  int multiplicity = 1;                ///< first non-vanishing derivative by the parameter
  int smoothness = N;                  ///< r[1] .. r[smoothness] exist
};

namespace detail {

/// t(s) and its powers: power[j][k] is the coefficient of s^k in t(s)^j, j <= k.
template <class Scalar, int N>
using PowerTable = std::array<std::array<Scalar, N + 1>, N + 1>;

/// t(s) from dt/ds = f(t), f = |P'|^(-1/2 of the square): (k+1) t_{k+1} = sum_j f_j [s^k] t^j.
template <class Scalar, int N>
[[gnu::always_inline]] inline void invertArcLength(const std::array<Scalar, N>& f, PowerTable<Scalar, N>& power) {
  auto& t = power[1];
  t[1] = f[0];
  for (std::size_t k = 1; k < N; ++k) {
    Scalar sum(0);
    for (std::size_t j = 1; j <= k; ++j) {
      if (j > 1) {
        power[j][k] = series::nextPower(t.data(), power[j - 1].data(), static_cast<int>(j), static_cast<int>(k));
      }
      sum += f[j] * power[j][k];
    }
    t[k + 1] = sum / Scalar(k + 1);
  }
  for (std::size_t j = 2; j <= N; ++j) {
    power[j][N] = series::nextPower(t.data(), power[j - 1].data(), static_cast<int>(j), N);
  }
}

/// Bounds of the errors of the Taylor coefficients rho_k by arc length, to first order. A change
/// D(s) of the points changes the curve by arc length by D - R'(s) int_0^s R' . D' (first variation
/// of arc length), whose coefficients are bounded by products of norms. `epsilon` bounds the errors
/// of the coefficients of P by a parameter of unit speed, `length` is |rho_k|.
template <int N>
[[gnu::always_inline]] inline void propagateErrors(const std::array<double, N + 1>& epsilon,
                                                   const PowerTable<double, N>& power,
                                                   const std::array<double, N + 1>& length,
                                                   std::array<double, N + 1>& error) {
  PowerTable<double, N> majorant;
  for (std::size_t k = 1; k <= N; ++k) majorant[1][k] = std::abs(power[1][k]);
  std::array<double, N + 1> d{};
  std::array<double, N + 1> arc{};
  for (std::size_t k = 1; k <= N; ++k) {
    d[k] = epsilon[1] * majorant[1][k];
    for (std::size_t j = 2; j <= k; ++j) {
      majorant[j][k] =
          series::nextPower(majorant[1].data(), majorant[j - 1].data(), static_cast<int>(j), static_cast<int>(k));
      d[k] += epsilon[j] * majorant[j][k];
    }
    for (std::size_t a = 0; a < k; ++a) {
      arc[k] += static_cast<double>((a + 1) * (k - a)) * length[a + 1] * d[k - a];
    }
    arc[k] /= static_cast<double>(k);
    error[k] = d[k];
    for (std::size_t i = 0; i < k; ++i) error[k] += static_cast<double>(i + 1) * length[i + 1] * arc[k - i];
  }
}

/// 1 where first-order bounds are good, growing to infinity where the error is as large as the thing.
inline double nonlinearity(double relativeError) {
  return relativeError < 0.1 ? 1.0 / (1.0 - 8.0 * relativeError) : std::numeric_limits<double>::infinity();
}

constexpr std::array<double, 9> kFactorials{1, 1, 2, 6, 24, 120, 720, 5040, 40320};

}  // namespace detail

/// True where the first derivative is not to be told from zero.
template <int N>
inline bool isSingular(const Jet<N>& jet) {
  return jet.c[1].squaredNorm() <= jet.error[1] * jet.error[1];
}

/// Arc-length derivatives of a regular end: t(s) is found from dt/ds = 1/|P'| as a series and put
/// into P (mathematics: Boehm, Curvature continuous curves and surfaces, 1985; series by recurrence).
template <int N>
[[gnu::always_inline]] inline ArcJet<N> arcJet(const Jet<N>& jet) {
  ArcJet<N> arc;
  const double speed = jet.c[1].norm();
  const double inverse = 1.0 / speed;

  // the parameter is scaled to unit speed at the end: p_k = c_k / speed^k, so that p_1 is the tangent
  std::array<Vector3, N + 1> p;
  std::array<double, N + 1> epsilon;
  double scale = 1.0;
  for (std::size_t k = 1; k <= N; ++k) {
    scale *= inverse;
    p[k] = scale * jet.c[k];
    epsilon[k] = scale * jet.error[k] + 16.0 * kUnitRoundoff * p[k].norm();
  }

  std::array<double, N> g;  // |P'|^2
  for (std::size_t k = 0; k < N; ++k) {
    g[k] = 0.0;
    for (std::size_t i = 0; i <= k; ++i) {
      g[k] += static_cast<double>((i + 1) * (k - i + 1)) * p[i + 1].dot(p[k - i + 1]);
    }
  }
  g[0] = 1.0;
  std::array<double, N> f;
  f[0] = 1.0;
  series::power(g.data(), -0.5, f.data(), N - 1);
  detail::PowerTable<double, N> power;
  detail::invertArcLength<double, N>(f, power);

  std::array<double, N + 1> length;
  std::array<double, N + 1> error;
  std::array<Vector3, N + 1> rho;
  for (std::size_t k = 1; k <= N; ++k) {
    rho[k] = power[1][k] * p[1];
    for (std::size_t j = 2; j <= k; ++j) rho[k] += power[j][k] * p[j];
    length[k] = rho[k].norm();
  }
  detail::propagateErrors<N>(epsilon, power, length, error);

  std::array<double, N> h;  // |P'|
  series::multiply(g.data(), f.data(), h.data(), N - 1);
  const double growth = detail::nonlinearity(epsilon[1]);
  arc.r[0].setZero();
  arc.norm[0] = arc.error[0] = arc.parameter[0] = arc.arcLength[0] = 0.0;
  double speedPower = 1.0;
  for (std::size_t k = 1; k <= N; ++k) {
    arc.r[k] = detail::kFactorials[k] * rho[k];
    arc.norm[k] = detail::kFactorials[k] * length[k];
    arc.error[k] = growth * detail::kFactorials[k] * error[k];
    arc.parameter[k] = inverse * power[1][k];
    speedPower *= speed;
    arc.arcLength[k] = speedPower * h[k - 1] / static_cast<double>(k);
  }
  return arc;
}

}  // namespace osculate
