// Differential geometry to 100 digits from Taylor coefficients, by formulas that the core does not
// use: the operator d/ds = (1/|P'|) d/dt on series, and curvature and torsion from cross products.
#pragma once

#include <array>

#include "support/exact.h"

namespace osculate::test {

using RealSeries = Series<Real>;
using PointSeries = std::vector<Point<Real>>;

inline RealSeries operator*(const RealSeries& a, const RealSeries& b) {
  RealSeries product(std::min(a.size(), b.size()), Real(0));
  for (std::size_t k = 0; k < product.size(); ++k) {
    for (std::size_t j = 0; j <= k; ++j)
      product[k] += a[j] * b[k - j];
  }
  return product;
}

inline PointSeries operator*(const RealSeries& a, const PointSeries& b) {
  PointSeries product(std::min(a.size(), b.size()), Point<Real>::Constant(Real(0)));
  for (std::size_t k = 0; k < product.size(); ++k) {
    for (std::size_t j = 0; j <= k; ++j)
      product[k] += a[j] * b[k - j];
  }
  return product;
}

inline RealSeries dot(const PointSeries& a, const PointSeries& b) {
  RealSeries product(std::min(a.size(), b.size()), Real(0));
  for (std::size_t k = 0; k < product.size(); ++k) {
    for (std::size_t j = 0; j <= k; ++j)
      product[k] += a[j].dot(b[k - j]);
  }
  return product;
}

inline PointSeries cross(const PointSeries& a, const PointSeries& b) {
  PointSeries product(std::min(a.size(), b.size()), Point<Real>::Constant(Real(0)));
  for (std::size_t k = 0; k < product.size(); ++k) {
    for (std::size_t j = 0; j <= k; ++j)
      product[k] += a[j].cross(b[k - j]);
  }
  return product;
}

/// The derivative, one coefficient shorter.
template <class Coefficient>
std::vector<Coefficient> derivative(const std::vector<Coefficient>& a) {
  std::vector<Coefficient> result;
  for (std::size_t k = 1; k < a.size(); ++k)
    result.push_back(Coefficient(Real(k) * a[k]));
  return result;
}

/// 1/a by long division.
inline RealSeries inverse(const RealSeries& a) {
  RealSeries result{Real(1) / a[0]};
  for (std::size_t k = 1; k < a.size(); ++k) {
    Real sum(0);
    for (std::size_t j = 1; j <= k; ++j)
      sum += a[j] * result[k - j];
    result.push_back(-sum / a[0]);
  }
  return result;
}

/// sqrt(a) by comparing coefficients of b b = a.
inline RealSeries squareRoot(const RealSeries& a) {
  RealSeries b{sqrt(a[0])};
  for (std::size_t k = 1; k < a.size(); ++k) {
    Real sum = a[k];
    for (std::size_t j = 1; j < k; ++j)
      sum -= b[j] * b[k - j];
    b.push_back(sum / (2 * b[0]));
  }
  return b;
}

/// r_0 = P(0) and the derivatives by arc length that the coefficients P_0 .. P_n give, |P_1| > 0:
/// R_0 = P, R_{k+1} = (1/|P'|) dR_k/dt, r_k = R_k(0).
inline PointSeries arcDerivatives(const PointSeries& p) {
  const PointSeries velocity = derivative(p);
  const RealSeries perSpeed = inverse(squareRoot(dot(velocity, velocity)));
  PointSeries result{p[0]};
  PointSeries r = p;
  for (std::size_t k = 1; k < p.size(); ++k) {
    r = perSpeed * derivative(r);
    result.push_back(r[0]);
  }
  return result;
}

struct ExactInvariants {
  Real curvature, torsion, curvatureRate, curvatureRate2, torsionRate;
};

/// kappa = |P' x P''| / |P'|^3, tau = (P' x P'') . P''' / |P' x P''|^2 as functions of t, and d/ds
/// of them; needs P_0 .. P_4 at least.
inline ExactInvariants invariants(const PointSeries& p) {
  const PointSeries first = derivative(p);
  const PointSeries second = derivative(first);
  const PointSeries binormal = cross(first, second);
  const RealSeries speed = squareRoot(dot(first, first));
  const RealSeries perSpeed = inverse(speed);
  const RealSeries area = dot(binormal, binormal);
  const RealSeries curvature = squareRoot(area) * perSpeed * perSpeed * perSpeed;
  const RealSeries torsion = dot(binormal, derivative(second)) * inverse(area);
  const auto rate = [&](const RealSeries& a) { return perSpeed * derivative(a); };
  return {curvature[0], torsion[0], rate(curvature)[0], rate(rate(curvature))[0], rate(torsion)[0]};
}

/// Outward Taylor coefficients 0..count of a curve from one of its ends.
inline PointSeries outwardTaylor(const ExactBezier<Real>& curve, CurveEnd end, int count) {
  return taylor(end == CurveEnd::kStart ? curve : reversed(curve), Real(0), count);
}

/// Derivatives by arc length in the direction of travel from the outward ones.
inline PointSeries backwards(PointSeries r) {
  for (std::size_t k = 1; k < r.size(); k += 2)
    r[k] = -r[k];
  return r;
}

}  // namespace osculate::test
