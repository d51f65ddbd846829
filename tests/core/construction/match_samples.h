// Pairs of curves near each other, and what the tests of matches measure.
#pragma once

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "osculate/construction/match_curves.h"
#include "support/random_curves.h"

namespace osculate::test {

/// A spline along +x from near the origin, 10 mm a span.
inline BSplineCurve waveFrom(Random& random, int degree, const KnotVector& knots, bool rational) {
  BSplineData data = randomSplineData(random, degree, knots, rational);
  for (Eigen::Index i = 0; i < data.poles.cols(); ++i) {
    const double x = 10.0 * static_cast<double>(i) / degree * (degree > 3 ? 2.0 : 1.5);
    data.poles.col(i) = Vector3(x, 0.0, 0.0) + random.vector(1.5);
  }
  if (rational) data.weights = randomWeights(random, static_cast<int>(data.poles.cols()), 2.0);
  return BSplineCurve(std::move(data));
}

inline KnotVector simpleKnots(int degree, int spans) {
  KnotVector knots;
  for (int i = 0; i <= spans; ++i) {
    knots.knots.push_back(i);
    knots.multiplicities.push_back(i == 0 || i == spans ? degree + 1 : 1);
  }
  return knots;
}

inline BSplineCurve wave(Random& random, int degree, int spans, bool rational = false) {
  return waveFrom(random, degree, simpleKnots(degree, spans), rational);
}

/// A quintic that arrives near the origin in about the direction +x.
inline BSplineCurve arrival(Random& random, bool rational = false) {
  std::vector<Vector3> poles;
  for (int i = 0; i <= 5; ++i)
    poles.emplace_back(Vector3(8.0 * (i - 5) - 1.0, 1.0, -1.0) + random.vector(1.0));
  if (!rational) return BSplineCurve(BezierCurve(poles));
  return BSplineCurve(BezierCurve(poles, randomWeights(random, 6, 2.0)));
}

inline MatchOptions ofOrder(int order) { return {.order = order}; }

/// `second` changed at its start so that it meets the end of `first`.
inline Construction matched(const BSplineCurve& first, const BSplineCurve& second,
                            const MatchOptions& options) {
  return matchCurves(first, {.end = CurveEnd::kEnd}, second, CurveEnd::kStart, options);
}

/// int |a - b|^2 ds over a's arc length by Gauss-Legendre quadrature on parts of each span.
inline double integralOfSquares(const BSplineCurve& a, const BSplineCurve& b, int parts = 8) {
  double sum = 0.0;
  for (int span = 0; span < a.spanCount(); ++span) {
    const BezierSegment part = a.segment(span);
    const auto integrand = [&](double t) {
      const auto point = a.derivatives(t, 1);
      return (b.evaluate(t) - point[0]).squaredNorm() * point[1].norm();
    };
    for (int i = 0; i < parts; ++i) {
      sum += boost::math::quadrature::gauss<double, 20>::integrate(
          integrand, part.first + part.length() * i / parts,
          part.first + part.length() * (i + 1) / parts);
    }
  }
  return sum;
}

/// The largest distance at equal parameters that samples see.
inline double sampledDistance(const BSplineCurve& a, const BSplineCurve& b) {
  constexpr int kSteps = 20000;
  double largest = 0.0;
  for (int i = 0; i <= kSteps; ++i) {
    const double t = std::lerp(a.first(), a.last(), static_cast<double>(i) / kSteps);
    largest = std::max(largest, (a.evaluate(t) - b.evaluate(t)).norm());
  }
  return largest;
}

}  // namespace osculate::test
