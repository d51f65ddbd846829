// Exact and 100-digit arithmetic that tests measure the double code against, and the Taylor
// expansion of Bézier curves in it, by formulas that the code under test does not use.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <boost/multiprecision/eigen.hpp>
#include <vector>

#include "osculate/bezier/bezier_curve.h"

namespace osculate::test {

/// Exact; takes doubles without rounding.
using Rational = boost::multiprecision::number<boost::multiprecision::cpp_rational_backend,
                                               boost::multiprecision::et_off>;
/// 100 decimal digits; takes doubles without rounding.
using Real = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>,
                                           boost::multiprecision::et_off>;

template <class S>
using Point = Eigen::Matrix<S, 3, 1>;
/// (w x, w y, w z, w)
template <class S>
using Homogeneous = Eigen::Matrix<S, 4, 1>;

/// Coefficients of a truncated power series: [k] belongs to h^k.
template <class S>
using Series = std::vector<S>;

template <class S>
Point<S> exact(const Vector3& p) {
  return {S(p.x()), S(p.y()), S(p.z())};
}

template <class S>
double toDouble(const S& value) {
  return value.template convert_to<double>();
}

template <class S>
Vector3 toDouble(const Point<S>& p) {
  return {toDouble(p.x()), toDouble(p.y()), toDouble(p.z())};
}

/// |a - b|; the difference is taken before anything is rounded.
template <class S>
double distance(const Point<S>& a, const Vector3& b) {
  return toDouble(Point<S>(a - exact<S>(b))).norm();
}

/// C(n, k).
template <class S>
S choose(int n, int k) {
  S result(1);
  for (int i = 1; i <= k; ++i)
    result = result * S(n - k + i) / S(i);
  return result;
}

template <class S>
S factorial(int n) {
  S result(1);
  for (int i = 2; i <= n; ++i)
    result *= S(i);
  return result;
}

/// A Bézier curve of exact numbers; the weights of a polynomial one are 1.
template <class S>
struct ExactBezier {
  std::vector<Point<S>> poles;
  std::vector<S> weights;

  int degree() const { return static_cast<int>(poles.size()) - 1; }
  Homogeneous<S> net(int i) const {
    const auto k = static_cast<std::size_t>(i);
    Homogeneous<S> point;
    point << Point<S>(weights[k] * poles[k]), weights[k];
    return point;
  }
};

template <class S>
ExactBezier<S> exact(const BezierCurve& curve) {
  ExactBezier<S> result;
  for (int i = 0; i <= curve.degree(); ++i) {
    result.poles.push_back(exact<S>(curve.pole(i)));
    result.weights.push_back(S(curve.weight(i)));
  }
  return result;
}

template <class S>
ExactBezier<S> reversed(ExactBezier<S> curve) {
  std::reverse(curve.poles.begin(), curve.poles.end());
  std::reverse(curve.weights.begin(), curve.weights.end());
  return curve;
}

/// (constant + slope h)^n up to h^count.
template <class S>
Series<S> linearPower(const S& constant, const S& slope, int n, int count) {
  Series<S> result(static_cast<std::size_t>(count) + 1, S(0));
  result[0] = S(1);
  for (int step = 0; step < n; ++step) {
    for (std::size_t k = result.size(); k-- > 0;) {
      result[k] = constant * result[k] + (k > 0 ? S(slope * result[k - 1]) : S(0));
    }
  }
  return result;
}

/// Taylor coefficients 0..count of (A, w) around t, by expanding every Bernstein polynomial
/// C(n,i) (t+h)^i (1-t-h)^(n-i).
template <class S>
std::vector<Homogeneous<S>> homogeneousTaylor(const ExactBezier<S>& curve, const S& t, int count) {
  const int n = curve.degree();
  std::vector<Homogeneous<S>> result(static_cast<std::size_t>(count) + 1,
                                     Homogeneous<S>::Constant(S(0)));
  for (int i = 0; i <= n; ++i) {
    const Series<S> up = linearPower(t, S(1), i, count);
    const Series<S> down = linearPower(S(S(1) - t), S(-1), n - i, count);
    const Homogeneous<S> scaled = choose<S>(n, i) * curve.net(i);
    for (std::size_t k = 0; k < result.size(); ++k) {
      S basis(0);
      for (std::size_t j = 0; j <= k; ++j)
        basis += up[j] * down[k - j];
      result[k] += basis * scaled;
    }
  }
  return result;
}

/// The quotient A / w of the series.
template <class S>
std::vector<Point<S>> divide(const std::vector<Homogeneous<S>>& series) {
  std::vector<Point<S>> result;
  for (std::size_t k = 0; k < series.size(); ++k) {
    Point<S> sum = series[k].template head<3>();
    for (std::size_t j = 1; j <= k; ++j)
      sum -= series[j][3] * result[k - j];
    result.push_back(Point<S>(sum / series[0][3]));
  }
  return result;
}

/// Taylor coefficients 0..count of the curve around t.
template <class S>
std::vector<Point<S>> taylor(const ExactBezier<S>& curve, const S& t, int count) {
  return divide(homogeneousTaylor(curve, t, count));
}

template <class S>
Point<S> evaluate(const ExactBezier<S>& curve, const S& t) {
  return taylor(curve, t, 0).front();
}

/// The Bézier net over [0, 1] of the polynomial with these Taylor coefficients at 0, all of them
/// given: b_i = sum_k C(i,k)/C(n,k) a_k.
template <class Coefficient, class S = typename Coefficient::Scalar>
std::vector<Coefficient> bezierNet(const std::vector<Coefficient>& coefficients) {
  const int n = static_cast<int>(coefficients.size()) - 1;
  std::vector<Coefficient> net;
  for (int i = 0; i <= n; ++i) {
    Coefficient sum = Coefficient::Constant(S(0));
    for (int k = 0; k <= i; ++k) {
      sum += S(choose<S>(i, k) / choose<S>(n, k)) * coefficients[static_cast<std::size_t>(k)];
    }
    net.push_back(sum);
  }
  return net;
}

/// Largest norm of the poles.
inline double size(const BezierCurve& curve) {
  double largest = 0.0;
  for (int i = 0; i <= curve.degree(); ++i)
    largest = std::max(largest, curve.pole(i).norm());
  return largest;
}

}  // namespace osculate::test
