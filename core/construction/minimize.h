// The least value of a blend's objective near a start; private to this floor.
#pragma once

#include "osculate/construction/blend_problem.h"

namespace osculate {

struct Minimum {
  std::vector<double> unknowns;
  double objective;
};

/// A local minimum by sequential quadratic programming (Kraft 1988, as NLopt has it): with bounds
/// only, a quasi-Newton method. Never worse than the start; the best seen counts, wherever it
/// stops.
Minimum minimize(const BlendProblem& problem, const std::vector<double>& start);

}  // namespace osculate
