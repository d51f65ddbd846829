// Curves as far from the given one as double coordinates, or a stated error of the poles, allow.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "support/exact_geometry.h"
#include "support/random_curves.h"

namespace osculate::test {

/// Half a unit in the last place of x.
inline double halfUnit(double x) {
  return 0.5 * (std::nextafter(std::abs(x), std::numeric_limits<double>::infinity()) - std::abs(x));
}

/// Every coordinate and weight off by half a unit in the last place, with random signs; every pole
/// besides by up to `poleError`.
inline ExactBezier<Real> perturbed(const BezierCurve& curve, Random& random,
                                   double poleError = 0.0) {
  ExactBezier<Real> result = exact<Real>(curve);
  for (int i = 0; i <= curve.degree(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (poleError > 0.0) {
      result.poles[k] += exact<Real>(poleError * random.direction());
    } else {
      for (int axis = 0; axis < 3; ++axis) {
        const double half = halfUnit(curve.pole(i)[axis]);
        result.poles[k][axis] += Real(random.coin() ? half : -half);
      }
    }
    if (curve.isRational()) {
      const double half = halfUnit(curve.weight(i));
      result.weights[k] += Real(random.coin() ? half : -half);
    }
  }
  return result;
}

/// Stated bounds beside the largest error that was found under each.
class BoundStatistics {
 public:
  void add(double bound, double found) {
    if (found > 0.0) entries_.push_back(bound / found);
  }
  /// Smallest bound / error: below 1 the bound does not hold.
  double smallest() const { return *std::min_element(entries_.begin(), entries_.end()); }
  double median() const {
    std::vector<double> sorted = entries_;
    std::nth_element(sorted.begin(),
                     sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2), sorted.end());
    return sorted[sorted.size() / 2];
  }

 private:
  std::vector<double> entries_;
};

}  // namespace osculate::test
