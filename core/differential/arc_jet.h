// Derivatives by arc length at a regular end of a curve, with bounds of their errors.
#pragma once

#include <array>
#include <cmath>
#include <limits>

#include "osculate/differential/jet.h"
#include "osculate/differential/lanes.h"
#include "osculate/differential/series.h"

namespace osculate {

/// Outward from the end, s >= 0. The scalar is double for one end, Lanes for both ends of a join.
template <int N, class Scalar = double>
struct ArcJet {
  using Vector = Eigen::Matrix<Scalar, 3, 1>;
  std::array<Vector, N + 1> r;          ///< d^k P / ds^k in mm^(1-k), k >= 1; r[0] is zero
  std::array<Scalar, N + 1> norm;       ///< |r[k]|
  std::array<Scalar, N + 1> error;      ///< bounds of the errors |delta r[k]|
  std::array<Scalar, N + 1> parameter;  ///< Taylor coefficients of t(s), s in mm
  std::array<Scalar, N + 1> arcLength;  ///< Taylor coefficients of s(t)
};

namespace detail {

/// t(s) and its powers: power[j][k] is the coefficient of s^k in t(s)^j, j <= k.
template <class Scalar, int N>
using PowerTable = std::array<std::array<Scalar, N + 1>, N + 1>;

/// t(s) from dt/ds = f(t), f = 1/|P'|: (k+1) t_{k+1} = sum_j f_j [s^k] t^j.
template <class Scalar, int N>
[[gnu::always_inline]] inline void invertArcLength(const std::array<Scalar, N>& f,
                                                   PowerTable<Scalar, N>& power) {
  auto& t = power[1];
  t[1] = f[0];
#pragma GCC unroll 8
  for (std::size_t k = 1; k < N; ++k) {
    Scalar sum(0.0);
#pragma GCC unroll 8
    for (std::size_t j = 1; j <= k; ++j) {
      if (j > 1) {
        power[j][k] = series::nextPower(t.data(), power[j - 1].data(), static_cast<int>(j),
                                        static_cast<int>(k));
      }
      sum += f[j] * power[j][k];
    }
    t[k + 1] = Scalar(1.0 / static_cast<double>(k + 1)) * sum;
  }
#pragma GCC unroll 8
  for (std::size_t j = 2; j <= N; ++j) {
    power[j][N] = series::nextPower(t.data(), power[j - 1].data(), static_cast<int>(j), N);
  }
}

/// Bounds of the errors of the Taylor coefficients rho_k by arc length, to first order. A change
/// D(s) of the points changes the curve by arc length by D - R'(s) int_0^s R' . D' (first variation
/// of arc length), whose coefficients are bounded by products of norms. `epsilon` bounds the errors
/// of the coefficients of P by a parameter of unit speed, D = sum_j delta p_j t(s)^j; `length` is
/// |rho_k|.
template <int N, class Scalar>
[[gnu::always_inline]] inline void propagateErrors(const std::array<Scalar, N + 1>& epsilon,
                                                   const PowerTable<Scalar, N>& power,
                                                   const std::array<Scalar, N + 1>& length,
                                                   std::array<Scalar, N + 1>& error) {
  using std::abs;
  std::array<Scalar, N + 1> d;
  std::array<Scalar, N + 1> arc;
#pragma GCC unroll 8
  for (std::size_t k = 1; k <= N; ++k) {
    d[k] = epsilon[k];  // [s^k] t(s)^k = 1
#pragma GCC unroll 8
    for (std::size_t j = 1; j < k; ++j)
      d[k] += epsilon[j] * abs(power[j][k]);
    arc[k] = Scalar(0.0);
#pragma GCC unroll 8
    for (std::size_t a = 0; a < k; ++a) {
      const double factor = static_cast<double>((a + 1) * (k - a)) / static_cast<double>(k);
      arc[k] += Scalar(factor) * length[a + 1] * d[k - a];
    }
    error[k] = d[k];
#pragma GCC unroll 8
    for (std::size_t i = 0; i < k; ++i) {
      error[k] += Scalar(static_cast<double>(i + 1)) * length[i + 1] * arc[k - i];
    }
  }
}

/// 1 where first-order bounds are good, growing to infinity where the error is as large as the
/// thing.
inline double nonlinearity(double relativeError) {
  return relativeError < 0.1 ? 1.0 / (1.0 - 8.0 * relativeError)
                             : std::numeric_limits<double>::infinity();
}
inline Lanes nonlinearity(Lanes relativeError) {
  return {nonlinearity(relativeError[0]), nonlinearity(relativeError[1])};
}

constexpr std::array<double, 9> kFactorials{1, 1, 2, 6, 24, 120, 720, 5040, 40320};

}  // namespace detail

/// True where the first derivative is not to be told from zero.
template <int N>
inline bool isSingular(const Jet<N>& jet) {
  return jet.c[1].squaredNorm() <= jet.error[1] * jet.error[1];
}

namespace detail {

/// The parameter scaled to unit speed at the end, p_k = c_k / speed^k, so that p_1 is the tangent;
/// and bounds of the errors of p_k.
template <int N, class Scalar>
[[gnu::always_inline]] inline void scaleToUnitSpeed(
    const std::array<Eigen::Matrix<Scalar, 3, 1>, N + 1>& c, const std::array<Scalar, N + 1>& error,
    const Scalar& inverse, std::array<Eigen::Matrix<Scalar, 3, 1>, N + 1>& p,
    std::array<Scalar, N + 1>& epsilon) {
  Scalar scale(1.0);
#pragma GCC unroll 8
  for (std::size_t k = 1; k <= N; ++k) {
    scale *= inverse;
    p[k] = c[k] * scale;
    epsilon[k] = scale * error[k] + Scalar(16.0 * kUnitRoundoff) * normBound(p[k]);
  }
}

/// The series g of |P'|^2.
template <int N, class Scalar>
[[gnu::always_inline]] inline void setSpeedSquared(
    const std::array<Eigen::Matrix<Scalar, 3, 1>, N + 1>& p, std::array<Scalar, N>& g) {
  g[0] = Scalar(1.0);
#pragma GCC unroll 8
  for (std::size_t k = 1; k < N; ++k) {
    g[k] = Scalar(0.0);
#pragma GCC unroll 8
    for (std::size_t i = 0; 2 * i <= k; ++i) {
      const double twice = 2 * i == k ? 1.0 : 2.0;
      g[k] +=
          Scalar(twice * static_cast<double>((i + 1) * (k - i + 1))) * p[i + 1].dot(p[k - i + 1]);
    }
  }
}

}  // namespace detail

/// Arc-length derivatives from Taylor coefficients c_1 .. c_N of a regular end and bounds of their
/// errors: t(s) is found from dt/ds = 1/|P'| as a series and put into P.
template <int N, class Scalar>
[[gnu::always_inline]] inline void setArcJet(
    const std::array<Eigen::Matrix<Scalar, 3, 1>, N + 1>& c, const std::array<Scalar, N + 1>& error,
    ArcJet<N, Scalar>& arc) {
  using std::sqrt;
  using Vector = Eigen::Matrix<Scalar, 3, 1>;
  const Scalar speed = sqrt(c[1].squaredNorm());
  const Scalar inverse = Scalar(1.0) / speed;

  std::array<Vector, N + 1> p;
  std::array<Scalar, N + 1> epsilon;
  detail::scaleToUnitSpeed<N, Scalar>(c, error, inverse, p, epsilon);
  std::array<Scalar, N> g;  // |P'|^2
  detail::setSpeedSquared<N, Scalar>(p, g);
  std::array<Scalar, N> f;  // 1/|P'|
  f[0] = Scalar(1.0);
  series::power(g.data(), -0.5, f.data(), N - 1);
  detail::PowerTable<Scalar, N> power;
  detail::invertArcLength<Scalar, N>(f, power);

  arc.r[1] = p[1];
  arc.norm[1] = Scalar(1.0);
  std::array<Scalar, N + 1> length;
  length[1] = Scalar(1.0);
#pragma GCC unroll 8
  for (std::size_t k = 2; k <= N; ++k) {
    Vector rho = p[1] * power[1][k];
#pragma GCC unroll 8
    for (std::size_t j = 2; j < k; ++j)
      rho += p[j] * power[j][k];
    rho += p[k];  // [s^k] t^k = 1
    length[k] = sqrt(rho.squaredNorm());
    const Scalar factorial(detail::kFactorials[k]);
    arc.r[k] = rho * factorial;
    arc.norm[k] = length[k] * factorial;
  }
  detail::propagateErrors<N, Scalar>(epsilon, power, length, arc.error);

  std::array<Scalar, N> h;  // |P'|
  series::multiply(g.data(), f.data(), h.data(), N - 1);
  const Scalar growth = detail::nonlinearity(epsilon[1]);
  arc.r[0].setZero();
  arc.norm[0] = arc.error[0] = arc.parameter[0] = arc.arcLength[0] = Scalar(0.0);
  Scalar speedPower(1.0);
#pragma GCC unroll 8
  for (std::size_t k = 1; k <= N; ++k) {
    arc.error[k] *= growth * Scalar(detail::kFactorials[k]);
    arc.parameter[k] = inverse * power[1][k];
    speedPower *= speed;
    arc.arcLength[k] = speedPower * h[k - 1] * Scalar(1.0 / static_cast<double>(k));
  }
}

template <int N>
[[gnu::always_inline]] inline ArcJet<N> arcJet(const Jet<N>& jet) {
  ArcJet<N> arc;
  setArcJet<N, double>(jet.c, jet.error, arc);
  return arc;
}

}  // namespace osculate
