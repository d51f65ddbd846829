// Curves whose combs are known in closed form.
#pragma once

#include <cmath>
#include <numbers>

#include "support/designed_curves.h"
#include "support/random_curves.h"

namespace osculate::test {

/// The curve of curvature k0 + k1 s and torsion tau over s in [0, length], whose parameter is
/// s / length, from the Taylor series of degree 25: exact to rounding for a few units of turning.
/// The curvature may change its sign: then it is the Frenet frame that turns over.
inline BSplineCurve curveOf(double k0, double k1, double tau, double length) {
  const PointSeries arc = frenetCurve({Real(k0), Real(k1)}, {Real(tau)}, kMaxDegree);
  RealSeries sigma(kMaxDegree + 1, Real(0));
  sigma[1] = Real(length);
  return BSplineCurve(startingWith(arc, sigma));
}

/// Four rational quadratics over [0, 4] from (cos a, sin a) once around.
inline BSplineData unitCircle(double a = 0.0) {
  BSplineData data;
  data.degree = 2;
  data.poles.resize(3, 9);
  for (int i = 0; i <= 8; ++i) {
    const double angle = a + i * std::numbers::pi / 4.0;
    const double radius = i % 2 == 0 ? 1.0 : std::numbers::sqrt2;
    data.poles.col(i) << radius * std::cos(angle), radius * std::sin(angle), 0.0;
    data.weights.push_back(i % 2 == 0 ? 1.0 : std::numbers::sqrt2 / 2.0);
  }
  data.poles.col(8) = data.poles.col(0);
  data.knots = {{0, 1, 2, 3, 4}, {3, 2, 2, 2, 3}};
  return data;
}

inline BSplineCurve circle(double radius, double from = 0.0) {
  BSplineData data = unitCircle(from);
  data.poles *= radius;
  return BSplineCurve(std::move(data));
}

/// (a cos u, b sin u) once around, from u = `from`.
struct Ellipse {
  double a, b;

  BSplineCurve curve(double from) const {
    BSplineData data = unitCircle(from);
    data.poles.row(0) *= a;
    data.poles.row(1) *= b;
    return BSplineCurve(std::move(data));
  }
  double angle(const Vector3& p) const { return std::atan2(p.y() / b, p.x() / a); }
  double speed(double u) const { return std::hypot(a * std::sin(u), b * std::cos(u)); }
  double curvature(double u) const { return a * b / std::pow(speed(u), 3.0); }
  /// d/ds = (1/v) d/du of a b v^-3 with v^2 = a^2 sin^2 u + b^2 cos^2 u, (v^2)' = (a^2 - b^2) sin
  /// 2u
  double curvatureRate(double u) const {
    return -1.5 * a * b * (a * a - b * b) * std::sin(2.0 * u) * std::pow(speed(u), -6.0);
  }
  double curvatureRate2(double u) const {
    const double c = a * a - b * b;
    const double v2 = speed(u) * speed(u);
    const double sine = std::sin(2.0 * u);
    return -1.5 * a * b * c * std::pow(v2, -4.5) *
           (2.0 * std::cos(2.0 * u) * v2 - 3.0 * c * sine * sine);
  }
};

}  // namespace osculate::test
