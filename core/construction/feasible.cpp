#include "osculate/construction/feasible.h"

#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <limits>

namespace osculate {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kSatisfied = 1e-10;
constexpr double kRounding = 1e-14;
constexpr double kGood = 1e-12;
constexpr double kDependent = 1e-9;  // of the largest singular value

/// The shortest x with A x = b in the sense of least squares, whatever the rank of A.
VectorXd shortest(const MatrixXd& matrix, const VectorXd& right) {
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> decomposition;
  decomposition.setThreshold(kDependent);
  return decomposition.compute(matrix).solve(right);
}

/// The step of Levenberg and Marquardt, damped by the violation itself: that converges fast even
/// where the conditions are dependent at the solution but not beside it (Yamashita and Fukushima
/// 2001), as a direction and a vanishing curvature there are.
VectorXd dampedStep(const Conditions& now) {
  const Eigen::Index rows = now.jacobian.rows();
  const Eigen::Index columns = now.jacobian.cols();
  MatrixXd matrix(rows + columns, columns);
  matrix << now.jacobian, now.values.norm() * MatrixXd::Identity(columns, columns);
  VectorXd right = VectorXd::Zero(rows + columns);
  right.head(rows) = -now.values;
  return shortest(matrix, right);
}

/// The directions that change the conditions, and those that do not (to first order).
struct Directions {
  MatrixXd across;
  MatrixXd along;
};

Directions directionsAt(const MatrixXd& jacobian) {
  if (jacobian.rows() == 0)
    return {MatrixXd(jacobian.cols(), 0), MatrixXd::Identity(jacobian.cols(), jacobian.cols())};
  Eigen::JacobiSVD<MatrixXd> svd(jacobian, Eigen::ComputeFullV);
  svd.setThreshold(kDependent);
  const Eigen::Index rank = svd.rank();
  return {svd.matrixV().leftCols(rank), svd.matrixV().rightCols(jacobian.cols() - rank)};
}

/// The points that satisfy conditions, by coordinates in the plane that touches them at one.
class Chart {
 public:
  Chart(const ConditionFunction& conditions, const VectorXd& centre)
      : conditions_(conditions),
        centre_(centre),
        directions_(directionsAt(conditions(centre).jacobian)) {}

  Eigen::Index size() const { return directions_.along.cols(); }

  /// The point over `coordinates`, with its Jacobian by them; nothing where there is none near.
  struct Point {
    VectorXd unknowns;
    MatrixXd byCoordinates;
  };
  std::optional<Point> at(const VectorXd& coordinates) const {
    constexpr int kMostSteps = 20;
    Point point{centre_ + directions_.along * coordinates, {}};
    double before = std::numeric_limits<double>::infinity();
    for (int step = 0; step < kMostSteps; ++step) {
      const Conditions now = conditions_(point.unknowns);
      const MatrixXd across = now.jacobian * directions_.across;
      const double violation = now.values.size() == 0 ? 0.0 : now.values.lpNorm<Eigen::Infinity>();
      if (!(violation < before) || violation <= kGood) {
        if (!(std::min(violation, before) <= kSatisfied)) return {};
        point.byCoordinates = directions_.along;
        if (across.cols() > 0) {
          const MatrixXd along = now.jacobian * directions_.along;
          point.byCoordinates -= directions_.across * solved(across, along);
        }
        return point;
      }
      before = violation;
      if (across.cols() > 0) point.unknowns -= directions_.across * shortest(across, now.values);
    }
    return {};
  }

 private:
  static MatrixXd solved(const MatrixXd& matrix, const MatrixXd& right) {
    Eigen::CompleteOrthogonalDecomposition<MatrixXd> decomposition;
    decomposition.setThreshold(kDependent);
    return decomposition.compute(matrix).solve(right);
  }

  const ConditionFunction& conditions_;
  VectorXd centre_;
  Directions directions_;
};

std::vector<double> listOf(const VectorXd& numbers) {
  return {numbers.data(), numbers.data() + numbers.size()};
}

/// The objective by the coordinates of a chart.
SmoothFunction reduced(const Chart& chart, const SmoothFunction& objective) {
  return [&](const std::vector<double>& y, double* gradient) {
    const auto count = static_cast<Eigen::Index>(y.size());
    const auto point = chart.at(Eigen::Map<const VectorXd>(y.data(), count));
    if (!point) {
      if (gradient != nullptr) std::fill_n(gradient, count, 0.0);
      return std::numeric_limits<double>::infinity();
    }
    VectorXd byUnknowns(point->unknowns.size());
    const double value =
        objective(listOf(point->unknowns), gradient == nullptr ? nullptr : byUnknowns.data());
    if (gradient != nullptr)
      Eigen::Map<VectorXd>(gradient, count) = point->byCoordinates.transpose() * byUnknowns;
    return value;
  };
}

FeasibleMinimum pointOf(const Chart& chart, const Minimum& minimum) {
  const auto count = static_cast<Eigen::Index>(minimum.unknowns.size());
  const auto point = chart.at(Eigen::Map<const VectorXd>(minimum.unknowns.data(), count));
  return {point->unknowns, minimum.objective};
}

/// The chart's own centre.
std::vector<double> centreOf(const Chart& chart) {
  return std::vector<double>(static_cast<std::size_t>(chart.size()), 0.0);
}

}  // namespace

std::optional<VectorXd> restore(const ConditionFunction& conditions, VectorXd start) {
  constexpr int kMostSteps = 200;
  constexpr double kLongestStep = 1.5;
  constexpr double kShortestShare = 1e-3;
  Conditions now = conditions(start);
  for (int step = 0; step < kMostSteps && now.values.norm() > kRounding; ++step) {
    VectorXd change = dampedStep(now);
    const double largest = change.lpNorm<Eigen::Infinity>();
    if (largest > kLongestStep) change *= kLongestStep / largest;
    double share = 1.0;
    Conditions next = conditions(start + change);
    while (!(next.values.norm() < now.values.norm()) && share > kShortestShare) {
      share *= 0.5;
      next = conditions(start + share * change);
    }
    if (!(next.values.norm() < now.values.norm())) break;
    start += share * change;
    now = std::move(next);
  }
  if (!(now.values.norm() <= kSatisfied)) return {};
  return start;
}

int freedomsAt(const ConditionFunction& conditions, const VectorXd& point) {
  return static_cast<int>(Chart(conditions, point).size());
}

FeasibleMinimum minimizeAmong(const ConditionFunction& conditions, const SmoothFunction& objective,
                              const VectorXd& start) {
  constexpr int kMostCharts = 3;
  constexpr double kImproved = 1e-2;
  FeasibleMinimum best{start, objective(listOf(start), nullptr)};
  for (int i = 0; i < kMostCharts; ++i) {
    const Chart chart(conditions, best.unknowns);
    if (chart.size() == 0) break;
    const double before = best.value;
    const Minimum found = minimize({reduced(chart, objective)}, centreOf(chart));
    if (!(found.objective < before)) break;
    best = pointOf(chart, found);
    if (best.value > before - kImproved) break;
  }
  return best;
}

FeasibleMinimum polishAmong(const ConditionFunction& conditions, const SmoothFunction& objective,
                            const VectorXd& start) {
  const double value = objective(listOf(start), nullptr);
  const Chart chart(conditions, start);
  if (chart.size() == 0) return {start, value};
  const SmoothFunction function = reduced(chart, objective);
  return pointOf(chart, polish({function}, function, {centreOf(chart), value}));
}

}  // namespace osculate
