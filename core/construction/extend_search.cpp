#include "osculate/construction/extend_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "osculate/bezier/bernstein.h"
#include "osculate/bezier/index.h"
#include "osculate/construction/beta_chord.h"
#include "osculate/construction/contact_error.h"
#include "osculate/differential/arc_jet.h"

namespace osculate {

namespace {

using Eigen::VectorXd;

BezierCurve curveOf(const BoundedPoles& poles) {
  return bezierFromPoles(poles.data(), static_cast<int>(poles.cols()) - 1);
}

/// It does not nearly stop anywhere, nor at its far end.
bool isSensible(const BoundedPoles& poles) {
  constexpr double kLeastSpeed = 1e-3;  // of the mean
  const Eigen::Index n = poles.cols() - 1;
  const double length = lengthOf(poles, Quadrature::kFine, nullptr);
  const double atEnd = static_cast<double>(n) * (poles.col(n) - poles.col(n - 1)).norm();
  return std::isfinite(length) && std::min(leastSpeed(poles), atEnd) > kLeastSpeed * length;
}

/// It arrives in the direction asked for, not against it.
bool isForward(const BoundedPoles& poles, const ExtendTargets& targets) {
  if (!targets.direction) return true;
  const Eigen::Index n = poles.cols() - 1;
  return targets.direction->dot(poles.col(n) - poles.col(n - 1)) > 0.0;
}

/// A problem as functions of its unknowns.
struct Functions {
  ConditionFunction conditions;
  SmoothFunction objective;
};

Functions functionsOf(const ExtendProblem& problem) {
  return {[&](const VectorXd& x) { return problem.conditions(x); },
          [&](const std::vector<double>& x, double* gradient) {
            return problem.objective(Eigen::Map<const VectorXd>(x.data(), problem.size()),
                                     gradient);
          }};
}

/// Solutions that are sensible, all different.
class Solutions {
 public:
  Solutions(const ExtendProblem& problem, const ExtendTask& task)
      : problem_(problem), task_(task), conditions_(functionsOf(problem).conditions) {}

  void addFrom(const VectorXd& start) {
    const std::optional<VectorXd> x = restore(conditions_, start);
    if (!x || isKnown(*x)) return;
    const BoundedPoles poles = problem_.poles(*x);
    if (isSensible(poles) && isForward(poles, task_.targets))
      list_.push_back({*x, problem_.objective(*x, nullptr)});
  }
  bool isEmpty() const { return list_.empty(); }
  /// The fairest first.
  std::vector<FeasibleMinimum> take() && {
    std::stable_sort(list_.begin(), list_.end(),
                     [](const auto& a, const auto& b) { return a.value < b.value; });
    return std::move(list_);
  }

 private:
  bool isKnown(const VectorXd& x) const {
    constexpr double kSame = 1e-6;
    return std::any_of(list_.begin(), list_.end(),
                       [&](const auto& known) { return (known.unknowns - x).norm() < kSame; });
  }

  const ExtendProblem& problem_;
  const ExtendTask& task_;
  ConditionFunction conditions_;
  std::vector<FeasibleMinimum> list_;
};

/// The curve's own parametrisation, stretched to the size of the task.
VectorXd ownStart(const ExtendProblem& problem, const ExtendTask& task, ArcLengthSeries own) {
  const double stretch = task.unit / own[0];
  double scale = 1.0;
  for (double& coefficient : own) {
    scale *= stretch;
    coefficient *= scale;
  }
  return problem.startFrom(own);
}

std::vector<VectorXd> startsOf(const ExtendProblem& problem, const ExtendTask& task,
                               const ExtendRequest& request, const FoundExtension* lower) {
  // speed and growth of the steps along the tangent
  constexpr std::array<std::pair<double, double>, 5> kSteps{
      {{1.0, 1.0}, {0.6, 1.0}, {1.6, 1.0}, {0.6, 1.4}, {1.4, 0.7}}};
  std::vector<VectorXd> starts;
  if (lower) {
    starts.push_back(problem.startFrom(lower->curve.elevated(task.degree - lower->curve.degree())));
  }
  if (task.degree <= request.order() && request.ownSeries()[0] > 0.0)
    starts.push_back(ownStart(problem, task, request.ownSeries()));
  for (const auto& [speed, growth] : kSteps)
    starts.push_back(problem.start(speed, growth));
  return starts;
}

/// The start moved by numbers in [-size, size), the same ones on every machine.
VectorXd movedFrom(const VectorXd& start, double size, std::mt19937_64& generator) {
  VectorXd moved = start;
  for (double& x : moved)
    x += size * (static_cast<double>(generator() >> 11U) * 0x1p-52 - 1.0);
  return moved;
}

/// Solutions from the starts; where that finds none, and below the order of contact, where the
/// conditions are far from linear, from many more around them.
std::vector<FeasibleMinimum> solutionsFrom(const std::vector<VectorXd>& starts,
                                           const ExtendProblem& problem, const ExtendTask& task) {
  constexpr std::size_t kMore = 32;
  constexpr double kAround = 2.0;
  constexpr std::uint64_t kSeed = 20;
  Solutions solutions(problem, task);
  for (const VectorXd& start : starts)
    solutions.addFrom(start);
  if (solutions.isEmpty() || task.degree < task.jet.overTangent.order) {
    std::mt19937_64 generator(kSeed);
    for (std::size_t i = 0; i < kMore; ++i)
      solutions.addFrom(movedFrom(starts[i % starts.size()], kAround, generator));
  }
  return std::move(solutions).take();
}

/// The fairest that can be reached from the solutions.
FeasibleMinimum fairest(const std::vector<FeasibleMinimum>& solutions,
                        const ExtendProblem& problem) {
  constexpr std::size_t kMostMinimised = 3;
  const Functions functions = functionsOf(problem);
  FeasibleMinimum best = solutions.front();
  for (std::size_t i = 0; i < std::min(solutions.size(), kMostMinimised); ++i) {
    FeasibleMinimum candidate =
        minimizeAmong(functions.conditions, functions.objective, solutions[i].unknowns);
    if (candidate.value < best.value) best = std::move(candidate);
  }
  return best;
}

void checkDetermined(int freeNumbers) {
  if (freeNumbers == 0) return;
  throw ContactError("under-determined: " + std::to_string(freeNumbers) +
                     " numbers are left free; give more, or a fairness that chooses them");
}

/// The best by one quadrature.
std::optional<FeasibleMinimum> search(const ExtendRequest& request, const ExtendTask& task,
                                      const ExtendProblem& problem, const FoundExtension* lower) {
  const std::vector<FeasibleMinimum> solutions =
      solutionsFrom(startsOf(problem, task, request, lower), problem, task);
  if (solutions.empty()) return {};
  if (!request.options().fairness)
    checkDetermined(freedomsAt(functionsOf(problem).conditions, solutions.front().unknowns));
  return fairest(solutions, problem);
}

/// The curve where nothing is unknown, if it meets the conditions.
std::optional<FoundExtension> findFixed(const ExtendProblem& problem) {
  constexpr double kSatisfied = 1e-9;
  const VectorXd nothing;
  if (!(problem.conditions(nothing).values.norm() <= kSatisfied)) return {};
  return FoundExtension{curveOf(problem.poles(nothing))};
}

std::optional<FoundExtension> findFree(const ExtendRequest& request, const ExtendTask& task,
                                       const FoundExtension* lower) {
  constexpr double kQuadratureTolerance = 0.01;
  const std::optional<Fairness> wanted = request.options().fairness;
  const Fairness fairness = wanted.value_or(Fairness::kMinimumVariation);
  const ExtendProblem fine(task, fairness, Quadrature::kFine);
  if (fine.size() == 0) return findFixed(fine);
  const Functions functions = functionsOf(fine);
  for (const Quadrature quadrature : {Quadrature::kCoarse, Quadrature::kFine}) {
    const ExtendProblem problem(task, fairness, quadrature);
    const std::optional<FeasibleMinimum> found = search(request, task, problem, lower);
    if (!found) return {};
    const std::optional<VectorXd> x = restore(functions.conditions, found->unknowns);
    // a stop or a sharp turn between the nodes: only more of them see it
    const bool isSeen = x && fine.objective(*x, nullptr) - found->value < kQuadratureTolerance;
    if (!x || (!isSeen && quadrature == Quadrature::kCoarse)) continue;
    const FeasibleMinimum best = polishAmong(functions.conditions, functions.objective, *x);
    const VectorXd exact = restore(functions.conditions, best.unknowns).value_or(best.unknowns);
    return FoundExtension{curveOf(fine.poles(exact)),
                          wanted ? std::optional(best.value) : std::nullopt,
                          freedomsAt(functions.conditions, exact)};
  }
  return {};
}

/// Where the numbers beta alone fix the curve: of several chords the one whose curve is nearest in
/// length to what the task would take.
std::optional<FoundExtension> findByBeta(const ExtendRequest& request, int degree) {
  constexpr double kSame = 1e-6;
  const ExtendTask task = request.task(degree);
  const ExtendProblem problem(task, Fairness::kMinimumVariation, Quadrature::kFine);
  const ConditionFunction conditions = functionsOf(problem).conditions;
  std::optional<FoundExtension> best;
  double least = std::numeric_limits<double>::infinity();
  for (const double chord : chordsOfBeta(request.contact(), task.beta, degree, task.unit)) {
    ArcLengthSeries sigma{};
    for (int k = 1; k <= request.order(); ++k)
      sigma[index(k - 1)] = *task.beta[index(k - 1)] * chord / detail::kFactorials[index(k)];
    const VectorXd x = problem.startFrom(tangentialOf(request.contact(), sigma));
    const std::optional<VectorXd> exact = restore(conditions, x);
    if (!exact || !((*exact - x).norm() < kSame * (1.0 + x.norm()))) continue;
    const BoundedPoles poles = problem.poles(*exact);
    if (!isSensible(poles) || !isForward(poles, task.targets)) continue;
    const double away =
        std::abs(std::log(lengthOf(poles, Quadrature::kCoarse, nullptr) / task.unit));
    if (away < least) best = FoundExtension{curveOf(poles)};
    least = std::min(least, away);
  }
  return best;
}

}  // namespace

std::optional<FoundExtension> findExtension(const ExtendRequest& request, int degree,
                                            const FoundExtension* lower) {
  constexpr double kCramped = 0.05;
  if (!request.canBeParametric(degree)) return {};
  if (request.isFixedByBeta(degree)) return findByBeta(request, degree);
  ExtendTask task = request.task(degree);
  auto found = findFree(request, task, lower);
  if (found || task.leastStep <= kCramped) return found;
  task.leastStep = kCramped;
  return findFree(request, task, lower);
}

}  // namespace osculate
