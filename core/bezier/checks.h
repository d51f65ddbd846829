// The checks of poles and weights that curves share; private to this floor.
#pragma once

#include <cmath>
#include <span>
#include <stdexcept>
#include <string>

#include "osculate/bezier/vector3.h"

namespace osculate {

inline void checkFinite(const Vector3& pole) {
  if (!pole.allFinite())
    throw std::invalid_argument("poles: every coordinate must be finite (found NaN or infinity)");
}

inline void checkWeights(std::span<const double> weights, std::size_t poleCount) {
  if (!weights.empty() && weights.size() != poleCount) {
    throw std::invalid_argument("weights: one for each pole is needed, got " +
                                std::to_string(weights.size()) + " for " +
                                std::to_string(poleCount) + " poles");
  }
  for (const double weight : weights) {
    if (!(std::isfinite(weight) && weight > 0.0)) {
      throw std::invalid_argument("weights: every weight must be finite and > 0, got " +
                                  std::to_string(weight));
    }
  }
}

}  // namespace osculate
