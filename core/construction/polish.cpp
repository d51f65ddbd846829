#include <Eigen/Eigenvalues>
#include <cmath>
#include <optional>

#include "osculate/construction/minimize.h"

namespace osculate {

namespace {

struct Point {
  Eigen::VectorXd x;
  Eigen::VectorXd gradient;
  double objective;
};

Point pointAt(const SmoothFunction& function, const Eigen::VectorXd& x) {
  Point point{x, Eigen::VectorXd(x.size()), 0.0};
  const std::vector<double> unknowns(x.begin(), x.end());
  point.objective = function(unknowns, point.gradient.data());
  return point;
}

Eigen::Map<const Eigen::VectorXd> asVector(const std::vector<double>& numbers) {
  return {numbers.data(), static_cast<Eigen::Index>(numbers.size())};
}

/// The inverse of the Hessian with its eigenvalues made positive: away from saddles, along each
/// axis downhill by as much as the curvature there says.
class Metric {
 public:
  /// `upper` are the bounds of the unknowns, or empty.
  Metric(const SmoothFunction& function, const std::vector<double>& upper, const Eigen::VectorXd& x)
      : axes_(hessian(function, upper, x)) {
    constexpr double kFlattest = 1e-10;
    const Eigen::VectorXd bend = axes_.eigenvalues().cwiseAbs();
    inverse_ = bend.cwiseMax(kFlattest * bend.maxCoeff()).cwiseInverse();
  }

  Eigen::VectorXd step(const Eigen::VectorXd& gradient) const {
    const auto& axes = axes_.eigenvectors();
    return -(axes * inverse_.cwiseProduct(axes.transpose() * gradient));
  }

 private:
  /// Forward differences of the gradient, made symmetric.
  static Eigen::MatrixXd hessian(const SmoothFunction& function, const std::vector<double>& upper,
                                 const Eigen::VectorXd& x) {
    const Point point = pointAt(function, x);
    Eigen::MatrixXd hessian(x.size(), x.size());
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      double h = 1e-6 * std::max(1.0, std::abs(x[i]));
      if (!upper.empty() && x[i] + h > upper[static_cast<std::size_t>(i)]) h = -h;
      Eigen::VectorXd beside = x;
      beside[i] += h;
      hessian.col(i) = (pointAt(function, beside).gradient - point.gradient) / (beside[i] - x[i]);
    }
    return 0.5 * (hessian + hessian.transpose());
  }

  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> axes_;
  Eigen::VectorXd inverse_;
};

/// Halves the step until it lowers the objective; nothing where it does not.
std::optional<Point> descend(const BoundedFunction& function, const Point& from,
                             const Eigen::VectorXd& step) {
  constexpr int kMostHalvings = 16;  // the model may bend far more than the function
  double share = 1.0;
  for (int i = 0; i <= kMostHalvings; ++i, share *= 0.5) {
    Eigen::VectorXd x = from.x + share * step;
    if (!function.lower.empty()) x = x.cwiseMax(asVector(function.lower));
    if (!function.upper.empty()) x = x.cwiseMin(asVector(function.upper));
    Point next = pointAt(function.value, x);
    if (next.objective < from.objective) return next;
  }
  return {};
}

}  // namespace

Minimum polish(const BoundedFunction& function, const SmoothFunction& model, const Minimum& start) {
  constexpr int kMostSteps = 30;
  constexpr double kSmallestGain = 1e-14;  // of the objective, a logarithm
  constexpr double kSlow = 0.05;           // a step that gains more than this share of the last
  if (start.unknowns.empty() || !std::isfinite(start.objective)) return start;
  Point best = pointAt(function.value, asVector(start.unknowns));
  Metric metric(model, function.upper, best.x);
  double lastGain = 0.0;
  for (int i = 0; i < kMostSteps; ++i) {
    const std::optional<Point> next = descend(function, best, metric.step(best.gradient));
    if (!next) break;
    const double gain = best.objective - next->objective;
    best = *next;
    if (gain < kSmallestGain) break;
    if (i > 0 && gain > kSlow * lastGain) metric = Metric(model, function.upper, best.x);
    lastGain = gain;
  }
  return {std::vector<double>(best.x.begin(), best.x.end()), best.objective};
}

}  // namespace osculate
