// Joins of two Bézier curves for the tests, and their residuals to 100 digits.
#pragma once

#include <numbers>
#include <vector>

#include "osculate/continuity/join_analysis.h"
#include "support/designed_curves.h"
#include "support/random_curves.h"

namespace osculate::test {

inline JoinSide arriving(const BezierCurve& curve, CurveEnd end = CurveEnd::kEnd) {
  return {curve.view(), end};
}
inline JoinSide leaving(const BezierCurve& curve, CurveEnd end = CurveEnd::kStart) {
  return {curve.view(), end};
}

inline AnalysisOptions withPreset(std::string_view preset, int order = 4) {
  AnalysisOptions options;
  options.order = order;
  options.tolerances = Tolerances::preset(preset);
  return options;
}

/// The end of the first curve against the start of the second.
inline JoinReport join(const BezierCurve& first, const BezierCurve& second,
                       const AnalysisOptions& options = {}) {
  return analyzeJoin(arriving(first), leaving(second), options);
}

inline BezierCurve bezier(const std::vector<Vector3>& poles,
                          const std::vector<double>& weights = {}) {
  return BezierCurve(poles, weights);
}

/// The same trace by another parameter: weights times rho^i (Farin, NURBS, sec. 7.2).
inline BezierCurve moebius(const BezierCurve& curve, double rho) {
  std::vector<double> weights;
  for (int i = 0; i <= curve.degree(); ++i)
    weights.push_back(curve.weight(i) * std::pow(rho, i));
  return BezierCurve(polesOf(curve), weights);
}

/// The residuals 0..count as the contract defines them, from derivatives by arc length in the
/// direction of travel (r_0 the point): mm, degrees, then |r_k - r_k'| / max(|r_k|, |r_k'|,
/// L^(1-k)).
inline std::vector<double> residuals(const PointSeries& first, const PointSeries& second,
                                     double scaleMm) {
  std::vector<double> result;
  for (std::size_t k = 0; k < std::min(first.size(), second.size()); ++k) {
    const Real difference = Point<Real>(first[k] - second[k]).norm();
    if (k == 0) {
      result.push_back(toDouble(difference));
    } else if (k == 1) {
      const Real half = difference / 2;
      result.push_back(toDouble(Real(2 * asin(half < 1 ? half : Real(1)))) * 180.0 /
                       std::numbers::pi);
    } else {
      const Real least = pow(Real(scaleMm), 1 - static_cast<int>(k));
      const Real a = first[k].norm();
      const Real b = second[k].norm();
      result.push_back(toDouble(Real(difference / std::max({a, b, least}))));
    }
  }
  return result;
}

/// r_0 .. r_count of an arriving curve at its end and of a leaving one at its start, in the
/// direction of travel.
inline PointSeries arrivingDerivatives(const ExactBezier<Real>& curve, int count) {
  return backwards(arcDerivatives(outwardTaylor(curve, CurveEnd::kEnd, count)));
}
inline PointSeries leavingDerivatives(const ExactBezier<Real>& curve, int count) {
  return arcDerivatives(outwardTaylor(curve, CurveEnd::kStart, count));
}

/// Random derivatives by arc length: a curve that bends and twists at about 1/5 per mm.
inline PointSeries randomArc(Random& random, std::size_t count) {
  RealSeries kappa{Real(random.uniform(0.05, 0.25))};
  RealSeries tau{Real(random.uniform(-0.2, 0.2))};
  for (std::size_t k = 1; k < count; ++k) {
    const double size = 0.2 * std::pow(0.2, k);
    kappa.push_back(Real(random.uniform(-size, size)));
    tau.push_back(Real(random.uniform(-size, size)));
  }
  return frenetCurve(kappa, tau, count);
}

/// s(t) = sum sigma_k t^k / k! of degree n for a curve about 5 mm long.
inline RealSeries randomSigma(Random& random, int degree) {
  RealSeries sigma{Real(0), Real(random.uniform(3.0, 6.0))};
  for (int k = 2; k <= degree; ++k)
    sigma.push_back(Real(random.uniform(-1.5, 1.5)));
  return sigma;
}

struct JoinedPair {
  BezierCurve first;
  BezierCurve second;
};

/// The same curve with the derivative of one order changed by much.
inline PointSeries changedAt(PointSeries arc, std::size_t order, Random& random) {
  if (order >= arc.size()) return arc;
  if (order == 0) {
    arc[0] += exact<Real>(0.5 * random.direction());
  } else if (order == 1) {
    const Real angle(random.uniform(0.2, 1.0));
    arc[1] = Point<Real>(cos(angle), 0, sin(angle));
  } else {
    // across the tangent: along it the derivatives by arc length are not free
    const int k = static_cast<int>(order);
    const Real change = Real(random.uniform(0.2, 0.5)) * factorial<Real>(k) / pow(Real(5), k - 1);
    arc[order] += Point<Real>(0, change, k > 2 ? change : Real(0));
  }
  return arc;
}

/// Two curves with contact of exactly this order (all orders above the degree), in random
/// parametrisations.
inline JoinedPair randomJoin(Random& random, int order, int degree) {
  const PointSeries arc = randomArc(random, static_cast<std::size_t>(degree));
  const PointSeries other = changedAt(arc, static_cast<std::size_t>(order) + 1, random);
  return {endingWith(arc, randomSigma(random, degree)),
          startingWith(other, randomSigma(random, degree))};
}

}  // namespace osculate::test
