// A slow search for the best blends of the case set: many random starts, fine quadrature.
//   osculate_search_best_blends <starts> > tests/data/best_blends.json
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>

#include "construction/blend_cases.h"
#include "osculate/bezier/bernstein.h"
#include "osculate/construction/blend_problem.h"
#include "osculate/construction/minimize.h"

namespace {

using namespace osculate;

/// Speeds from a twentieth to eight chords, the other numbers as large as the speeds.
std::vector<double> randomStart(const BlendProblem& problem, int order, std::mt19937& generator) {
  std::uniform_real_distribution<double> logSpeed(std::log(0.05), std::log(8.0));
  std::normal_distribution<double> number(0.0, 1.0);
  std::vector<double> start = problem.start(1.0, 1.0);
  for (std::size_t i = 0; i < start.size(); ++i) {
    start[i] = i % static_cast<std::size_t>(order) == 0
                   ? logSpeed(generator)
                   : std::exp(logSpeed(generator)) + 0.3 * number(generator);
  }
  return start;
}

/// A near stop between the nodes of the quadrature looks fair but is not: adaptive quadrature
/// tells.
bool isResolved(const BlendProblem& problem, const Minimum& minimum) {
  const BoundedPoles poles = problem.poles(minimum.unknowns);
  const BSplineCurve curve(bezierFromPoles(poles.data(), static_cast<int>(poles.cols()) - 1));
  const double objective = energies(curve).objective(Fairness::kMinimumVariation);
  return std::abs(objective - minimum.objective) < 1e-3;
}

double searchBest(const test::BlendCase& task, int order, int starts) {
  const ContactJet from = contactJet(task.first, {.end = CurveEnd::kEnd}, order);
  const ContactJet to = contactJet(task.second, {.end = CurveEnd::kStart}, order);
  BlendOptions options;
  options.order = {order, order};
  const BlendProblem problem(from, to, options, 2 * order + 1, Quadrature::kFine);
  std::mt19937 generator(20261123);
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i < starts; ++i) {
    const Minimum minimum =
        polish(functionOf(problem), functionOf(problem).value,
               minimize(functionOf(problem), randomStart(problem, order, generator)));
    if (minimum.objective < best && isResolved(problem, minimum)) best = minimum.objective;
  }
  return best;
}

}  // namespace

int main(int argc, char** argv) {
  const int starts = argc > 1 ? std::atoi(argv[1]) : 200;
  nlohmann::ordered_json all;
  all["about"] =
      "Least objective (mvc) found for the blends of the case set, of the least degree, by " +
      std::to_string(starts) + " random starts; made by search_best_blends.cpp.";
  for (const auto& task : osculate::test::blendCases()) {
    for (const int order : {2, 3, 4})
      all[std::string("G").append(std::to_string(order))][task.name] =
          searchBest(task, order, starts);
    std::cerr << task.name << "\n";
  }
  std::cout << all.dump(1) << "\n";
}
