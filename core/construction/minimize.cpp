#include "osculate/construction/minimize.h"

#include <nlopt.h>
#include <cmath>
#include <memory>

namespace osculate {

namespace {

/// What the optimiser evaluates, and the best it has seen.
struct Search {
  const SmoothFunction& function;
  Minimum best;
};

double evaluate(unsigned count, const double* x, double* gradient, void* data) {
  constexpr double kStopped = 1e6;  // in place of infinity, which the line search cannot use
  Search& search = *static_cast<Search*>(data);
  const std::vector<double> unknowns(x, x + count);
  const double value = search.function(unknowns, gradient);
  if (value < search.best.objective) search.best = {unknowns, value};
  return std::isfinite(value) ? value : kStopped;
}

}  // namespace

Minimum minimize(const BoundedFunction& function, const std::vector<double>& start) {
  constexpr double kTolerance = 1e-4;  // of the objective, a logarithm
  constexpr int kMostEvaluations = 400;
  Search search{function.value, {start, function.value(start, nullptr)}};
  if (start.empty()) return search.best;
  const std::unique_ptr<nlopt_opt_s, decltype(&nlopt_destroy)> optimiser(
      nlopt_create(NLOPT_LD_SLSQP, static_cast<unsigned>(start.size())), nlopt_destroy);
  if (!function.lower.empty()) nlopt_set_lower_bounds(optimiser.get(), function.lower.data());
  if (!function.upper.empty()) nlopt_set_upper_bounds(optimiser.get(), function.upper.data());
  nlopt_set_min_objective(optimiser.get(), evaluate, &search);
  nlopt_set_ftol_abs(optimiser.get(), kTolerance);
  nlopt_set_maxeval(optimiser.get(), kMostEvaluations);
  std::vector<double> x = start;
  double value = 0.0;
  // the result code says why it stopped: the tolerance, the evaluations or rounding, all good
  nlopt_optimize(optimiser.get(), x.data(), &value);
  return search.best;
}

}  // namespace osculate
