// Curves cut into pieces and disguised: the constructed truth that joins are tested with.
#pragma once

#include <vector>

#include "support/random_curves.h"

namespace osculate::test {

/// The parts of a curve between the given parameters; those of a periodic one go on to the first
/// plus the period.
inline std::vector<BSplineCurve> pieces(const BSplineCurve& curve,
                                        const std::vector<double>& cuts) {
  std::vector<double> ends = cuts;
  if (curve.isPeriodic()) {
    ends.push_back(cuts.front() + curve.last() - curve.first());
  } else {
    ends.insert(ends.begin(), curve.first());
    ends.push_back(curve.last());
  }
  std::vector<BSplineCurve> parts;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i)
    parts.push_back(curve.trimmed(ends[i], ends[i + 1]));
  return parts;
}

struct Disguise {
  bool reparametrise = true;
  bool reverse = true;
  int elevate = 0;      ///< the most by which a piece is raised; at least one piece is by this
  bool weights = true;  ///< all weights of a rational piece by a factor
};

inline BSplineCurve withWeightsScaled(const BSplineCurve& curve, double factor) {
  BSplineData data = curve.data();
  for (double& weight : data.weights)
    weight *= factor;
  return BSplineCurve(data);
}

/// The same point sets; the first piece keeps its parameter and its weights.
inline std::vector<BSplineCurve> disguised(Random& random, std::vector<BSplineCurve> parts,
                                           const Disguise& how) {
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i > 0 && how.reparametrise) {
      const double first = random.uniform(-3, 3);
      parts[i] = parts[i].reparametrised(first, first + random.uniform(0.2, 5));
    }
    if (i > 0 && how.weights) parts[i] = withWeightsScaled(parts[i], random.uniform(0.3, 3));
    const int times = i + 1 == parts.size() ? how.elevate : random.integer(0, how.elevate);
    parts[i] = parts[i].elevated(times);
    if (i > 0 && how.reverse && random.coin()) parts[i] = parts[i].reversed();
  }
  return parts;
}

/// Largest norm of the poles.
inline double size(const BSplineCurve& curve) {
  return curve.data().poles.colwise().norm().maxCoeff();
}

}  // namespace osculate::test
