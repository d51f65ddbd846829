// Truncated power series: c[k] is the coefficient of t^k. Lengths are given; nothing is allocated.
// The scalar is a template so that the formulas can be checked in higher precision.
#pragma once

namespace osculate::series {

/// b = a^p up to t^n for a[0] > 0, given b[0] = a[0]^p:
/// b_k = 1/(k a_0) sum_{j=1..k} (p j - (k-j)) a_j b_{k-j} (J. C. P. Miller; Knuth, TAOCP 2, sec. 4.7).
template <class Scalar>
inline void power(const Scalar* a, Scalar p, Scalar* b, int n) {
  const Scalar inverse = Scalar(1) / a[0];
  for (int k = 1; k <= n; ++k) {
    Scalar sum(0);
    for (int j = 1; j <= k; ++j) sum += (p * Scalar(j) - Scalar(k - j)) * a[j] * b[k - j];
    b[k] = sum * inverse / Scalar(k);
  }
}

/// c = a b up to t^n.
template <class Scalar>
inline void multiply(const Scalar* a, const Scalar* b, Scalar* c, int n) {
  for (int k = 0; k <= n; ++k) {
    Scalar sum(0);
    for (int j = 0; j <= k; ++j) sum += a[j] * b[k - j];
    c[k] = sum;
  }
}

/// The coefficient of t^k in x(t)^j, from those of x^(j-1); x[0] = 0, 1 <= j <= k.
template <class Scalar>
inline Scalar nextPower(const Scalar* x, const Scalar* lowerPower, int j, int k) {
  Scalar sum(0);
  for (int i = 1; i <= k - j + 1; ++i) sum += x[i] * lowerPower[k - i];
  return sum;
}

}  // namespace osculate::series
