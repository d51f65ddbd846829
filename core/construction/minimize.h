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

/// The same minimum to rounding, so that the curve follows a task that moves a little by a little:
/// Newton's method with the Hessian from differences of the gradient of `model`, which may be the
/// same problem by a coarser quadrature: the minimum stays that of `problem`. Never worse than the
/// start.
Minimum polish(const BlendProblem& problem, const BlendProblem& model, const Minimum& start);

}  // namespace osculate
