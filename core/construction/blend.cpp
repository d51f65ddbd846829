#include "osculate/construction/blend.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "osculate/bezier/bernstein.h"
#include "osculate/bezier/index.h"
#include "osculate/construction/blend_problem.h"
#include "osculate/construction/contact_error.h"
#include "osculate/construction/minimize.h"

namespace osculate {

namespace {

constexpr double kQuadratureTolerance = 0.01;

void checkOrders(const ContactJet& from, const ContactJet& to, const BlendOptions& options) {
  for (const int order : options.order) {
    if (order < 0 || order > kMaxOrder) {
      throw std::invalid_argument("order: must be from 0 to " + std::to_string(kMaxOrder) +
                                  " at each end, got " + std::to_string(order));
    }
  }
  if (from.order != options.order[0] || to.order != options.order[1]) {
    throw std::invalid_argument("order: the derivatives given belong to other orders");
  }
  const int least = options.order[0] + options.order[1] + 1;
  if (options.degree != 0 && (options.degree < least || options.degree > kMaxDegree)) {
    throw ContactError("degree: orders " + std::to_string(options.order[0]) + " and " +
                       std::to_string(options.order[1]) + " need a degree from " +
                       std::to_string(least) + " to " + std::to_string(kMaxDegree) + ", got " +
                       std::to_string(options.degree));
  }
}

void checkBeta(const BlendOptions& options) {
  for (std::size_t end = 0; end < 2; ++end) {
    for (std::size_t k = 0; k < kMaxOrder; ++k) {
      const auto& number = options.beta[end][k];
      if (!number) continue;
      if (!std::isfinite(*number) || (k == 0 && *number <= 0.0)) {
        throw std::invalid_argument(
            k == 0 ? "beta: beta_1 must be finite and > 0 (at 0 the curve stops)"
                   : "beta: every number must be finite");
      }
    }
  }
}

void checkDistance(const ContactJet& from, const ContactJet& to) {
  const double size = std::max(from.r[0].norm(), to.r[0].norm());
  if ((to.r[0] - from.r[0]).norm() <= 1e-12 * size) {
    throw ContactError(
        "ends: they coincide, so there is no gap to blend; choose other ends or trim the curves");
  }
}

constexpr std::array<double, 5> kSpeeds{0.4, 0.75, 1.25, 2.0, 3.5};
constexpr int kSpeedCount = static_cast<int>(kSpeeds.size());
using Grid = Eigen::Array<double, kSpeedCount, kSpeedCount>;

/// No neighbour on the grid has less.
bool isLocalMinimum(const Grid& value, int i, int j) {
  const int top = std::max(i - 1, 0);
  const int left = std::max(j - 1, 0);
  const int rows = std::min(i + 1, kSpeedCount - 1) - top + 1;
  const int columns = std::min(j + 1, kSpeedCount - 1) - left + 1;
  return value(i, j) <= value.block(top, left, rows, columns).minCoeff();
}

/// The local minima of the objective over a grid of beta_1, the best first, at most three.
std::vector<std::vector<double>> starts(const BlendProblem& problem) {
  const auto start = [&](int i, int j) {
    return problem.start(kSpeeds[index(i)], kSpeeds[index(j)]);
  };
  Grid value;
  for (int j = 0; j < kSpeedCount; ++j) {
    for (int i = 0; i < kSpeedCount; ++i)
      value(i, j) = problem.objective(start(i, j), nullptr);
  }
  std::vector<std::pair<int, int>> minima;
  for (int j = 0; j < kSpeedCount; ++j) {
    for (int i = 0; i < kSpeedCount; ++i) {
      if (isLocalMinimum(value, i, j)) minima.emplace_back(i, j);
    }
  }
  std::stable_sort(minima.begin(), minima.end(), [&](const auto& a, const auto& b) {
    return value(a.first, a.second) < value(b.first, b.second);
  });
  constexpr std::size_t kMost = 3;
  if (minima.size() > kMost) minima.resize(kMost);
  std::vector<std::vector<double>> result;
  for (const auto& [i, j] : minima)
    result.push_back(start(i, j));
  return result;
}

ContactJet lowered(const ContactJet& jet) {
  ContactJet lower = jet;
  lower.order = std::max(jet.order - 1, 0);
  return lower;
}

/// The best of the minima from the grid and of that which continues the optimum of orders one
/// lower: high orders have many poor minima, low ones few.
Minimum solveLeastDegree(const ContactJet& from, const ContactJet& to, const BlendOptions& options,
                         Quadrature quadrature) {
  const int degree = options.order[0] + options.order[1] + 1;
  const BlendProblem problem(from, to, options, degree, quadrature);
  std::vector<Minimum> found;
  const auto consider = [&](const std::vector<double>& start) {
    found.push_back(minimize(functionOf(problem), start, found));
  };
  if (std::max(options.order[0], options.order[1]) > 2) {
    BlendOptions lower = options;
    for (int& order : lower.order)
      order = std::max(order - 1, 0);
    const Minimum below = solveLeastDegree(lowered(from), lowered(to), lower, quadrature);
    const int lowerDegree = lower.order[0] + lower.order[1] + 1;
    const BlendProblem lowerProblem(lowered(from), lowered(to), lower, lowerDegree, quadrature);
    consider(
        problem.startLike(bezierFromPoles(lowerProblem.poles(below.unknowns).data(), lowerDegree)));
  }
  for (const auto& start : starts(problem))
    consider(start);
  const auto worse = [](const Minimum& a, const Minimum& b) { return a.objective < b.objective; };
  return *std::min_element(found.begin(), found.end(), worse);
}

/// The optimum of the least degree, from which that of the degree asked for starts: never worse.
std::vector<double> solve(const ContactJet& from, const ContactJet& to, const BlendOptions& options,
                          int degree, Quadrature quadrature) {
  const int least = options.order[0] + options.order[1] + 1;
  const BlendProblem leastProblem(from, to, options, least, quadrature);
  std::vector<double> unknowns = solveLeastDegree(from, to, options, quadrature).unknowns;
  if (degree == least) return unknowns;
  const BlendProblem problem(from, to, options, degree, quadrature);
  return minimize(functionOf(problem), problem.startFrom(leastProblem, unknowns)).unknowns;
}

/// The optimum by the fine quadrature of `problem`, found by the coarse one where that sees enough.
Minimum fairest(const ContactJet& from, const ContactJet& to, const BlendOptions& options,
                const BlendProblem& problem, int degree) {
  const BlendProblem coarse(from, to, options, degree, Quadrature::kCoarse);
  const auto withObjective = [&](std::vector<double> unknowns) {
    const double objective = problem.objective(unknowns, nullptr);
    return Minimum{std::move(unknowns), objective};
  };
  const Minimum found = withObjective(solve(from, to, options, degree, Quadrature::kCoarse));
  if (found.objective - coarse.objective(found.unknowns, nullptr) < kQuadratureTolerance)
    return polish(functionOf(problem), functionOf(coarse).value, found);
  // a stop or a sharp turn between the nodes: only more of them see it
  return polish(functionOf(problem), functionOf(problem).value,
                withObjective(solve(from, to, options, degree, Quadrature::kFine)));
}

/// beta_1 = 1 and 0 for the other numbers that are not given; further poles by raising the degree.
std::vector<double> plainest(const ContactJet& from, const ContactJet& to,
                             const BlendOptions& options, const BlendProblem& problem, int degree) {
  const int least = options.order[0] + options.order[1] + 1;
  if (degree == least) return problem.start(1.0, 1.0);
  const BlendProblem leastProblem(from, to, options, least, Quadrature::kCoarse);
  return problem.startFrom(leastProblem, leastProblem.start(1.0, 1.0));
}

void addWarnings(const BlendOptions& options, Blend& result) {
  constexpr double kCramped = 0.1;
  for (std::size_t end = 0; end < 2; ++end) {
    if (options.order[end] >= 1 && result.beta[end][0] < kCramped) {
      result.warnings.push_back(std::string("cramped: at the ") + (end == 0 ? "first" : "second") +
                                " end beta_1 is below a tenth of a chord; the poles crowd there");
    }
  }
}

}  // namespace

Blend blend(const ContactJet& from, const ContactJet& to, const BlendOptions& options) {
  checkOrders(from, to, options);
  checkBeta(options);
  checkDistance(from, to);
  const int least = options.order[0] + options.order[1] + 1;
  const int degree = options.degree == 0 ? least : options.degree;

  const BlendProblem problem(from, to, options, degree, Quadrature::kFine);
  // where every number is given there is nothing to choose
  const bool isFair = options.fairness && problem.size() > 0;
  const Minimum found = isFair ? fairest(from, to, options, problem, degree)
                               : Minimum{plainest(from, to, options, problem, degree), 0.0};
  const std::optional<double> objective = isFair ? std::optional(found.objective) : std::nullopt;
  Blend result{bezierFromPoles(problem.poles(found.unknowns).data(), degree),
               problem.beta(found.unknowns),
               problem.chord(),
               objective,
               {}};
  addWarnings(options, result);
  return result;
}

}  // namespace osculate
