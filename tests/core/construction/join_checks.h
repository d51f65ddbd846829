// What the tests of joined curves share.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "osculate/construction/construction.h"
#include "osculate/construction/contact_error.h"
#include "osculate/construction/curve_chain.h"
#include "support/cut_curves.h"
#include "support/knot_insertion.h"

namespace osculate::test {

/// A clamped spline over [0, 4] with inner knots at 0.8, 2 and 2.5.
inline BSplineCurve randomSpline(Random& random, int degree, int maxMultiplicity, bool rational) {
  KnotVector knots{{0, 0.8, 2, 2.5, 4}, {degree + 1, 1, 1, 1, degree + 1}};
  for (std::size_t i = 1; i <= 3; ++i)
    knots.multiplicities[i] = random.integer(1, maxMultiplicity);
  return BSplineCurve(randomSplineData(random, degree, knots, rational));
}

inline BSplineCurve segment(const Vector3& from, const Vector3& to) {
  return BSplineCurve(BezierCurve(std::vector<Vector3>{from, to}));
}

/// An arc of the circle of radius 10 around the origin, less than half of it.
inline BSplineCurve arc(double fromDegrees, double toDegrees) {
  const double a = fromDegrees * std::numbers::pi / 180.0;
  const double b = toDegrees * std::numbers::pi / 180.0;
  const double w = std::cos(0.5 * (b - a));
  const double middle = 0.5 * (a + b);
  const std::vector<Vector3> poles{{10 * std::cos(a), 10 * std::sin(a), 0},
                                   {10 / w * std::cos(middle), 10 / w * std::sin(middle), 0},
                                   {10 * std::cos(b), 10 * std::sin(b), 0}};
  const std::vector<double> weights{1.0, w, 1.0};
  return BSplineCurve(BezierCurve(poles, weights));
}

inline void expectSameCurve(const BSplineCurve& actual, const BSplineCurve& expected,
                            double tolerance) {
  const BSplineData& own = actual.data();
  const BSplineData& other = expected.data();
  EXPECT_EQ(own.degree, other.degree);
  EXPECT_EQ(own.periodic, other.periodic);
  ASSERT_EQ(own.knots.multiplicities, other.knots.multiplicities);
  for (std::size_t i = 0; i < own.knots.knots.size(); ++i)
    EXPECT_NEAR(own.knots.knots[i], other.knots.knots[i], tolerance) << "knot " << i;
  for (Eigen::Index i = 0; i < own.poles.cols(); ++i)
    EXPECT_LE((own.poles.col(i) - other.poles.col(i)).norm(), tolerance) << "pole " << i;
  ASSERT_EQ(own.weights.size(), other.weights.size());
  for (std::size_t i = 0; i < own.weights.size(); ++i)
    EXPECT_NEAR(own.weights[i], other.weights[i], tolerance) << "weight " << i;
}

/// The largest distance of points of the inputs, in the order of the chain, from the points of the
/// result at the parameters that the linear re-parametrisations give.
inline double tracedDistance(const Construction& result, const std::vector<BSplineCurve>& curves,
                             double toleranceMm = 0.0) {
  const CurveChain chain = orderChain(curves, toleranceMm);
  double largest = 0.0;
  double first = result.curve.first();
  for (std::size_t i = 0; i < chain.links.size(); ++i) {
    const bool isLast = i + 1 == chain.links.size();
    const double last = isLast ? result.curve.last() : *result.joins[i].parameter;
    const BSplineCurve& own = curves[chain.links[i].index];
    const BSplineCurve curve = chain.links[i].reversed ? own.reversed() : own;
    for (int k = 0; k <= 50; ++k) {
      const Vector3 point = curve.evaluate(std::lerp(curve.first(), curve.last(), k / 50.0));
      const Vector3 traced = result.curve.evaluate(std::lerp(first, last, k / 50.0));
      largest = std::max(largest, (point - traced).norm());
    }
    first = last;
  }
  return largest;
}

/// The result runs through the points of the inputs, and its displacement is that within a share of
/// their coordinates.
inline void expectTraces(const Construction& result, const std::vector<BSplineCurve>& curves,
                         double share) {
  double largest = 0.0;
  for (const BSplineCurve& curve : curves)
    largest = std::max(largest, size(curve));
  EXPECT_LE(*result.maxDisplacementMm, share * largest);
  // parameters round too
  EXPECT_LE(tracedDistance(result, curves), 10.0 * share * largest);
}

}  // namespace osculate::test
