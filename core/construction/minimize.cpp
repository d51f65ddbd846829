#include "osculate/construction/minimize.h"

#include <nlopt.h>
#include <algorithm>
#include <cmath>
#include <memory>

namespace osculate {

namespace {

/// What the optimiser evaluates, and the best it has seen.
struct Search {
  const SmoothFunction& function;
  const std::vector<Minimum>& known;
  nlopt_opt optimiser;
  Minimum best;

  /// It would find a known minimum again, or after some steps is so far above one that it is lost
  /// among loops: both seen often over the tasks of the tests, where no best was missed by it.
  bool isIdle(const std::vector<double>& unknowns, double value) const {
    constexpr double kNear = 0.3;    // of each unknown
    constexpr double kAbove = 0.05;  // of the objective, a logarithm
    constexpr int kPatience = 8;
    constexpr double kLost = 2.0;
    const bool isTried = nlopt_get_numevals(optimiser) >= kPatience;
    const auto isNear = [](double a, double b) { return std::abs(a - b) < kNear; };
    return std::any_of(known.begin(), known.end(), [&](const Minimum& minimum) {
      if (value > minimum.objective + kAbove)
        return isTried && best.objective > minimum.objective + kLost;
      return value >= minimum.objective &&
             std::equal(unknowns.begin(), unknowns.end(), minimum.unknowns.begin(), isNear);
    });
  }
};

double evaluate(unsigned count, const double* x, double* gradient, void* data) {
  constexpr double kStopped = 1e6;  // in place of infinity, which the line search cannot use
  Search& search = *static_cast<Search*>(data);
  const std::vector<double> unknowns(x, x + count);
  const double value = search.function(unknowns, gradient);
  if (value < search.best.objective) search.best = {unknowns, value};
  if (search.isIdle(unknowns, value)) nlopt_force_stop(search.optimiser);
  return std::isfinite(value) ? value : kStopped;
}

}  // namespace

Minimum minimize(const BoundedFunction& function, const std::vector<double>& start,
                 const std::vector<Minimum>& known) {
  constexpr double kTolerance = 1e-4;  // of the objective, a logarithm
  constexpr int kMostEvaluations = 400;
  Minimum asGiven{start, function.value(start, nullptr)};
  if (start.empty()) return asGiven;
  const std::unique_ptr<nlopt_opt_s, decltype(&nlopt_destroy)> optimiser(
      nlopt_create(NLOPT_LD_SLSQP, static_cast<unsigned>(start.size())), nlopt_destroy);
  Search search{function.value, known, optimiser.get(), asGiven};
  if (!function.lower.empty()) nlopt_set_lower_bounds(optimiser.get(), function.lower.data());
  if (!function.upper.empty()) nlopt_set_upper_bounds(optimiser.get(), function.upper.data());
  nlopt_set_min_objective(optimiser.get(), evaluate, &search);
  nlopt_set_ftol_abs(optimiser.get(), kTolerance);
  nlopt_set_maxeval(optimiser.get(), kMostEvaluations);
  std::vector<double> x = start;
  double value = 0.0;
  // the result code says why it stopped: the tolerance, the evaluations, rounding or a known
  // minimum, all good
  nlopt_optimize(optimiser.get(), x.data(), &value);
  return search.best;
}

}  // namespace osculate
