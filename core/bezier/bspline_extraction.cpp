// Bézier segments of a B-spline by blossoming (Ramshaw 1989; Farin, CAGD, ch. 8: a B-spline pole is
// the blossom at the knots it stands over, a Bézier pole the blossom at repeated span ends).
#include <algorithm>
#include <cmath>

#include "osculate/bezier/bspline_state.h"

namespace osculate {

namespace {

template <int Dim>
using LocalNet = Eigen::Matrix<double, Dim, kMaxDegree + 1>;

/// The knots u_1 .. u_2p around a span [a, b] = [u_p, u_{p+1}], numbered from 1.
struct LocalKnots {
  const double* u;  ///< u[0] is u_1
  int degree;
  double at(int i) const { return u[i - 1]; }
  double a() const { return at(degree); }
  double b() const { return at(degree + 1); }
};

/// From f(u_{j+1} .. u_{j+p}) to f(a^{p-j}, u_{p+1} .. u_{p+j}). Returns the passes that did
/// something.
template <class Net>
int clampLeft(Net& q, LocalKnots knots) {
  const int p = knots.degree;
  const double a = knots.a();
  int passes = 0;
  for (int r = 1; r < p; ++r) {
    if (knots.at(r) == a) break;  // this knot and all up to u_p are a
    ++passes;
    for (int j = 0; j < p - r; ++j) {
      // q_j^r = f(a^r, u_{j+r+1} .. u_{j+p})
      const double low = knots.at(j + r);
      q.col(j) += (a - low) / (knots.at(j + p + 1) - low) * (q.col(j + 1) - q.col(j));
    }
  }
  return passes;
}

/// From f(a^{p-j}, u_{p+1} .. u_{p+j}) to f(a^{p-j}, b^j).
template <class Net>
int clampRight(Net& q, LocalKnots knots) {
  const int p = knots.degree;
  const double a = knots.a();
  const double b = knots.b();
  int passes = 0;
  for (int r = 1; r < p; ++r) {
    if (knots.at(2 * p + 1 - r) == b) break;
    ++passes;
    for (int j = p; j > r; --j) {
      // q_j^r = f(a^{p-j}, b^r, u_{p+1} .. u_{p+j-r})
      const double high = knots.at(p + j - r + 1);
      q.col(j) += (high - b) / (high - a) * (q.col(j - 1) - q.col(j));
    }
  }
  return passes;
}

/// Rounding of `passes` convex combinations of poles of this size: each rounds its result, and its
/// factor and difference to three units (Higham, Accuracy and Stability, sec. 3.1).
double roundingBound(int passes, double largestNorm) {
  return 4.0 * passes * kUnitRoundoff * largestNorm;
}

/// The same for numerators w p and weights w: they round as far as the heaviest does and are then
/// divided by their own weight; the multiplication and the division by it round once more.
double rationalRoundingBound(int passes, double largestNorm, double heaviest, double lightest) {
  return roundingBound(1, largestNorm) +
         2.0 * heaviest / lightest * roundingBound(passes, largestNorm);
}

BezierSegment extractPolynomial(const BSplineCurve::State& state, int span, LocalKnots knots) {
  const int p = knots.degree;
  LocalNet<3> q;
  double largest = 0.0;
  int j = 0;
  do {
    q.col(j) = Eigen::Map<const Vector3>(state.poles() + 3 * (span - p + j));
    largest = std::max(largest, q.col(j).squaredNorm());
  } while (++j <= p);
  const int passes = clampLeft(q, knots) + clampRight(q, knots);
  return {bezierFromPoles(q.data(), p), knots.a(), knots.b(),
          state.data.poleError + roundingBound(passes, std::sqrt(largest))};
}

BezierSegment extractRational(const BSplineCurve::State& state, int span, LocalKnots knots) {
  const int p = knots.degree;
  LocalNet<4> q;
  double largest = 0.0;
  double heaviest = 0.0;
  for (int j = 0; j <= p; ++j) {
    const Eigen::Map<const Vector3> pole(state.poles() + 3 * (span - p + j));
    const double weight = state.weights()[span - p + j];
    q.col(j) << weight * pole, weight;
    largest = std::max(largest, pole.squaredNorm());
    heaviest = std::max(heaviest, weight);
  }
  const int left = clampLeft(q, knots);
  const int right = clampRight(q, knots);
  if (left + right == 0) {  // the poles are Bézier poles already: no detour by homogeneous ones
    const BezierView own{state.poles() + 3 * (span - p), state.weights() + (span - p), p};
    return {bezierFromArrays(own), knots.a(), knots.b(), state.data.poleError};
  }
  double lightest = heaviest;
  for (int j = 0; j <= p; ++j)
    lightest = std::min(lightest, q(3, j));
  return {bezierFromHomogeneous(q.data(), p), knots.a(), knots.b(),
          state.data.poleError +
              rationalRoundingBound(left + right, std::sqrt(largest), heaviest, lightest)};
}

}  // namespace

BezierSegment extractSegment(const BSplineCurve::State& state, int flatSpan) {
  const int p = state.data.degree;
  const LocalKnots knots{state.flat.data() + flatSpan - p + 1, p};
  return state.weights() == nullptr ? extractPolynomial(state, flatSpan, knots)
                                    : extractRational(state, flatSpan, knots);
}

SpanExtraction extractionOf(const BSplineCurve::State& state, int flatSpan) {
  const int p = state.data.degree;
  SpanExtraction result{flatSpan - p, {}};
  result.factors.setIdentity(p + 1, p + 1);
  const LocalKnots knots{state.flat.data() + flatSpan - p + 1, p};
  clampLeft(result.factors, knots);
  clampRight(result.factors, knots);
  return result;
}

NetPoint blossom(const BSplineCurve::State& state, int flatSpan,
                 std::span<const double> arguments) {
  const int p = state.data.degree;
  Net q(state.weights() == nullptr ? 3 : 4, p + 1);
  for (int j = 0; j <= p; ++j)
    q.col(j) = state.netPole(flatSpan - p + j);
  for (int r = 1; r <= p; ++r) {
    const double x = arguments[static_cast<std::size_t>(r) - 1];
    for (int j = p; j >= r; --j) {
      const double low = state.knot(flatSpan - p + j);
      const double high = state.knot(flatSpan + j - r + 1);
      const double alpha = (x - low) / (high - low);
      q.col(j) = (1.0 - alpha) * q.col(j - 1) + alpha * q.col(j);
    }
  }
  return q.col(p);
}

}  // namespace osculate
