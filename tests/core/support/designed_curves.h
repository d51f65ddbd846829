// Bézier curves made to have given derivatives by arc length at an end, and those of known curves.
#pragma once

#include <vector>

#include "support/exact_geometry.h"

namespace osculate::test {

/// Nearest doubles to a polynomial or rational Bézier net.
inline BezierCurve roundedCurve(const std::vector<Point<Real>>& poles) {
  std::vector<Vector3> rounded;
  for (const Point<Real>& pole : poles)
    rounded.push_back(toDouble(pole));
  return BezierCurve(rounded);
}

/// P(s(t)) for the Taylor series P = sum r_k s^k / k! and s = sum sigma_k t^k / k! (sigma[0] is not
/// used), up to t^count: Faà di Bruno by series.
inline PointSeries composed(const PointSeries& arc, const RealSeries& sigma, std::size_t count) {
  RealSeries s(count + 1, Real(0));
  for (std::size_t k = 1; k < sigma.size() && k <= count; ++k)
    s[k] = sigma[k] / factorial<Real>(static_cast<int>(k));
  RealSeries power(count + 1, Real(0));
  power[0] = Real(1);
  PointSeries result(count + 1, Point<Real>::Constant(Real(0)));
  for (std::size_t j = 0; j < arc.size() && j <= count; ++j) {
    const Real scale = Real(1) / factorial<Real>(static_cast<int>(j));
    for (std::size_t k = 0; k <= count; ++k)
      result[k] += Real(power[k] * scale) * arc[j];
    power = power * s;
  }
  return result;
}

/// The Bézier curve of degree `sigma.size() - 1` that starts with the derivatives r_0, r_1, ... by
/// arc length, with s(t) as above; sigma decides the parametrisation.
inline BezierCurve startingWith(const PointSeries& arc, const RealSeries& sigma) {
  return roundedCurve(bezierNet(composed(arc, sigma, sigma.size() - 1)));
}

/// The same, ending with them in the direction of travel.
inline BezierCurve endingWith(const PointSeries& arc, const RealSeries& sigma) {
  return startingWith(backwards(arc), sigma).reversed();
}

/// Derivatives by arc length at s = 0 of the curve with curvature sum kappa_k s^k and torsion
/// sum tau_k s^k, in the frame (x, y, z) at the origin, r_0 .. r_count, from the Frenet-Serret
/// equations t' = kappa n, n' = -kappa t + tau b, b' = -tau n as series.
inline PointSeries frenetCurve(const RealSeries& kappa, const RealSeries& tau, std::size_t count) {
  const auto at = [](const RealSeries& a, std::size_t k) { return k < a.size() ? a[k] : Real(0); };
  PointSeries t{Point<Real>(1, 0, 0)};
  PointSeries n{Point<Real>(0, 1, 0)};
  PointSeries b{Point<Real>(0, 0, 1)};
  for (std::size_t k = 0; k < count; ++k) {
    Point<Real> dt = Point<Real>::Constant(Real(0));
    Point<Real> dn = dt;
    Point<Real> db = dt;
    for (std::size_t j = 0; j <= k; ++j) {
      dt += at(kappa, j) * n[k - j];
      dn += at(tau, j) * b[k - j] - at(kappa, j) * t[k - j];
      db -= at(tau, j) * n[k - j];
    }
    const Real scale = Real(1) / Real(k + 1);
    t.push_back(Point<Real>(scale * dt));
    n.push_back(Point<Real>(scale * dn));
    b.push_back(Point<Real>(scale * db));
  }
  PointSeries r{Point<Real>(0, 0, 0)};
  for (std::size_t k = 1; k <= count; ++k)
    r.push_back(Point<Real>(factorial<Real>(static_cast<int>(k) - 1) * t[k - 1]));
  return r;
}

}  // namespace osculate::test
