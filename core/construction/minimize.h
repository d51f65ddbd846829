// The least value of a smooth function near a start; private to this floor.
#pragma once

#include <functional>
#include <vector>

namespace osculate {

/// Of as many unknowns as it is given; `gradient`, where not null, has as many numbers.
using SmoothFunction = std::function<double(const std::vector<double>& unknowns, double* gradient)>;

/// A function where each unknown has bounds; empty: none.
struct BoundedFunction {
  SmoothFunction value;
  std::vector<double> lower{};
  std::vector<double> upper{};
};

struct Minimum {
  std::vector<double> unknowns;
  double objective;
};

/// A local minimum by sequential quadratic programming (Kraft 1988, as NLopt has it): with bounds
/// only, a quasi-Newton method. Never worse than the start; the best seen counts, wherever it
/// stops. It stops early where it comes near one of `known`, minima that it would find again, or
/// stays far above them.
Minimum minimize(const BoundedFunction& function, const std::vector<double>& start,
                 const std::vector<Minimum>& known = {});

/// The same minimum to rounding, so that the curve follows a task that moves a little by a little:
/// Newton's method with the Hessian from differences of the gradient of `model`, which may be the
/// same function by a coarser quadrature: the minimum stays that of `function`. Never worse than
/// the start.
Minimum polish(const BoundedFunction& function, const SmoothFunction& model, const Minimum& start);

}  // namespace osculate
