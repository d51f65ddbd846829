// Truncated power series: c[k] is the coefficient of t^k. Lengths are given; nothing is allocated.
// The scalar is double, or Lanes for both sides of a join at once.
#pragma once

namespace osculate::series {

/// b = a^p up to t^n for a[0] = b[0] = 1:
/// b_k = 1/k sum_{j=1..k} (p j - (k-j)) a_j b_{k-j} (J. C. P. Miller; Knuth, TAOCP 2, sec. 4.7).
template <class Scalar>
inline void power(const Scalar* a, double p, Scalar* b, int n) {
#pragma GCC unroll 8
  for (int k = 1; k <= n; ++k) {
    Scalar sum(0.0);
#pragma GCC unroll 8
    for (int j = 1; j <= k; ++j)
      sum += Scalar(p * j - (k - j)) * a[j] * b[k - j];
    b[k] = sum * Scalar(1.0 / k);
  }
}

/// c = a b up to t^n.
template <class Scalar>
inline void multiply(const Scalar* a, const Scalar* b, Scalar* c, int n) {
#pragma GCC unroll 8
  for (int k = 0; k <= n; ++k) {
    Scalar sum(0.0);
#pragma GCC unroll 8
    for (int j = 0; j <= k; ++j)
      sum += a[j] * b[k - j];
    c[k] = sum;
  }
}

/// The coefficient of t^k in x(t)^j, from those of x^(j-1); x[0] = 0, 1 <= j <= k.
template <class Scalar>
inline Scalar nextPower(const Scalar* x, const Scalar* lowerPower, int j, int k) {
  Scalar sum(0.0);
#pragma GCC unroll 8
  for (int i = 1; i <= k - j + 1; ++i)
    sum += x[i] * lowerPower[k - i];
  return sum;
}

}  // namespace osculate::series
