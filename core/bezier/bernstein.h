// Binomial coefficients, Bernstein polynomials, and nets of homogeneous control points.
#pragma once

#include <array>

#include "osculate/bezier/bezier_curve.h"

namespace osculate {

namespace detail {
inline constexpr int kBinomialRows = kMaxDegree + 2;

consteval auto makeBinomials() {
  std::array<std::array<double, kBinomialRows>, kBinomialRows> table{};
  for (std::size_t n = 0; n < table.size(); ++n) {
    table[n][0] = 1.0;
    for (std::size_t k = 1; k <= n; ++k) {
      table[n][k] = table[n - 1][k - 1] + (k < n ? table[n - 1][k] : 0.0);
    }
  }
  return table;
}
inline constexpr auto kBinomials = makeBinomials();
}  // namespace detail

/// C(n, k) for 0 <= n <= kMaxDegree + 1, exact; 0 for k > n.
constexpr double binomial(int n, int k) {
  return detail::kBinomials[static_cast<std::size_t>(n)][static_cast<std::size_t>(k)];
}

/// Control points as columns: 3 rows for a polynomial curve, 4 (w x, w y, w z, w) for a rational
/// one.
using Net =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 4, kMaxDegree + 1>;
using NetPoint = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 4, 1>;

/// Between a curve and its net of control points. Weights are not checked.
Net toNet(BezierView curve);
BezierCurve fromNet(const Net& net);
/// A polynomial curve from degree+1 points x y z, a rational one from degree+1 points w x, w y, w
/// z, w.
BezierCurve bezierFromPoles(const double* poles, int degree);
/// The same bits, without a check.
BezierCurve bezierFromArrays(BezierView arrays);
BezierCurve bezierFromHomogeneous(const double* points, int degree);

/// The point of space a net point stands for.
Vector3 project(const NetPoint& point);

/// Values of the Bernstein polynomials B_0^n .. B_n^n at t.
Eigen::VectorXd bernstein(int degree, double t);

/// The Cartesian derivatives of a rational curve from the homogeneous ones (A, w)^(k), k =
/// 0..count: P^(k) = (A^(k) - sum_{j>=1} C(k,j) w^(j) P^(k-j)) / w (Piegl-Tiller, The NURBS Book,
/// eq. 4.8).
std::vector<Vector3> projectDerivatives(const std::vector<NetPoint>& homogeneous);

}  // namespace osculate
