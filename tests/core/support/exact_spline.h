// B-splines in exact arithmetic by the basis functions of Cox and de Boor: the independent second
// method beside blossoming.
#pragma once

#include "osculate/bezier/bspline_curve.h"
#include "support/exact.h"

namespace osculate::test {

/// A B-spline over all its flat knots; a periodic one is laid out over three periods and its own
/// range is the middle one.
template <class S>
struct ExactSpline {
  std::vector<S> flat;
  std::vector<Homogeneous<S>> net;
  int degree = 0;
};

template <class S>
std::vector<S> flatKnots(const KnotVector& knots) {
  std::vector<S> flat;
  for (std::size_t i = 0; i < knots.knots.size(); ++i) {
    for (int j = 0; j < knots.multiplicities[i]; ++j)
      flat.push_back(S(knots.knots[i]));
  }
  return flat;
}

/// The bi-infinite periodic knot sequence of Geom_BSplineCurve, cut to three periods: pole 0 stands
/// over the degree+2 knots that end with the first knot after the first `degree+1-m` ones, m the
/// multiplicity of the first knot.
template <class S>
ExactSpline<S> periodicSpline(const BSplineData& data, const std::vector<Homogeneous<S>>& own) {
  ExactSpline<S> spline;
  spline.degree = data.degree;
  const S period = S(data.knots.knots.back()) - S(data.knots.knots.front());
  std::vector<S> once = flatKnots<S>(data.knots);
  once.resize(once.size() -
              static_cast<std::size_t>(data.knots.multiplicities.back()));  // one turn
  const int turn = static_cast<int>(once.size());
  const int before = data.degree + 1 - data.knots.multiplicities.front();
  // knot number i of the infinite sequence, counted from the first knot's first occurrence
  const auto knot = [&](int i) -> S {
    const int turns = i >= 0 ? i / turn : -((turn - 1 - i) / turn);
    return once[static_cast<std::size_t>(i - turns * turn)] + S(turns) * period;
  };
  for (int i = -before - turn; i < 2 * turn + data.degree + 1; ++i)
    spline.flat.push_back(knot(i));
  const std::size_t poles = spline.flat.size() - static_cast<std::size_t>(data.degree) - 1;
  for (std::size_t i = 0; i < poles; ++i)
    spline.net.push_back(own[i % own.size()]);
  return spline;
}

template <class S>
ExactSpline<S> exactSpline(const BSplineData& data) {
  std::vector<Homogeneous<S>> net;
  for (Eigen::Index i = 0; i < data.poles.cols(); ++i) {
    const S weight(data.weights.empty() ? 1.0 : data.weights[static_cast<std::size_t>(i)]);
    Homogeneous<S> point;
    point << Point<S>(weight * exact<S>(data.poles.col(i))), weight;
    net.push_back(point);
  }
  if (data.periodic) return periodicSpline<S>(data, net);
  return {flatKnots<S>(data.knots), net, data.degree};
}

/// Taylor coefficients 0..count around t of the homogeneous curve on the span that contains t (at a
/// knot the one on that side): the recurrence N_i^k = (t-u_i)/(u_{i+k}-u_i) N_i^{k-1} +
/// (u_{i+k+1}-t)/(u_{i+k+1}-u_{i+1}) N_{i+1}^{k-1} (de Boor 1972; Cox 1972) with series for
/// numbers.
template <class S>
std::vector<Homogeneous<S>> homogeneousTaylor(const ExactSpline<S>& spline, const S& t, int count,
                                              Side side = Side::kRight) {
  const auto& u = spline.flat;
  const auto p = static_cast<std::size_t>(spline.degree);
  const auto length = static_cast<std::size_t>(count) + 1;
  std::size_t span = p;
  for (std::size_t i = p; i + p + 1 < u.size(); ++i) {
    const bool reached = side == Side::kRight ? u[i] <= t : u[i] < t;
    if (u[i] < u[i + 1] && (reached || u[span] == u[span + 1])) span = i;
  }
  std::vector<Series<S>> basis(p + 2, Series<S>(length, S(0)));  // basis[j] is N_{span-p+j}
  basis[p][0] = S(1);
  for (std::size_t k = 1; k <= p; ++k) {
    for (std::size_t j = p - k; j <= p; ++j) {
      const std::size_t i = span - p + j;
      Series<S> sum(length, S(0));
      const auto add = [&](const Series<S>& lower, const S& constant, const S& slope) {
        for (std::size_t h = 0; h < length; ++h) {
          sum[h] += constant * lower[h] + (h > 0 ? S(slope * lower[h - 1]) : S(0));
        }
      };
      const S left = u[i + k] - u[i];
      if (left != 0) add(basis[j], S((t - u[i]) / left), S(S(1) / left));
      const S right = u[i + k + 1] - u[i + 1];
      if (right != 0) add(basis[j + 1], S((u[i + k + 1] - t) / right), S(S(-1) / right));
      basis[j] = sum;
    }
  }
  std::vector<Homogeneous<S>> result(length, Homogeneous<S>::Constant(S(0)));
  for (std::size_t j = 0; j <= p; ++j) {
    for (std::size_t h = 0; h < length; ++h)
      result[h] += basis[j][h] * spline.net[span - p + j];
  }
  return result;
}

template <class S>
std::vector<Point<S>> taylor(const ExactSpline<S>& spline, const S& t, int count,
                             Side side = Side::kRight) {
  return divide(homogeneousTaylor(spline, t, count, side));
}

template <class S>
Point<S> evaluate(const ExactSpline<S>& spline, const S& t, Side side = Side::kRight) {
  return taylor(spline, t, 0, side).front();
}

/// The exact Bézier net of the span [a, b] of the spline, a and b neighbouring knots.
template <class S>
std::vector<Homogeneous<S>> spanNet(const ExactSpline<S>& spline, const S& a, const S& b) {
  std::vector<Homogeneous<S>> coefficients = homogeneousTaylor(spline, a, spline.degree);
  S factor(1);
  for (Homogeneous<S>& coefficient : coefficients) {
    coefficient *= factor;
    factor *= b - a;
  }
  return bezierNet(coefficients);
}

}  // namespace osculate::test
