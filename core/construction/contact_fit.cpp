#include "osculate/construction/contact_fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <vector>

#include "osculate/bezier/index.h"

namespace osculate {

namespace {

using Numbers = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, kMaxOrder, 1>;
using Hessian =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, kMaxOrder, kMaxOrder>;

/// The cost near some numbers, by sigma_1 .. sigma_m.
struct Model {
  Numbers gradient;
  Hessian hessian;
};

class Fit {
 public:
  Fit(const ContactJet& target, const FirstPoles& first, const FitOptions& options)
      : target_(target),
        first_(first),
        options_(options),
        root_(first.cost.llt().matrixU()),
        costByTaylor_(first.cost * first.byTaylor),
        form_(first.byTaylor.transpose() * costByTaylor_) {}

  /// A local minimum. Never worse than the start.
  ContactFit descend(const ArcLengthSeries& start) const;
  /// The best for given sigma_1 .. sigma_h, h half the order: the other numbers enter the Taylor
  /// coefficients linearly, as products of two of them belong to powers beyond the order.
  ContactFit projected(const ArcLengthSeries& start) const;

 private:
  /// Given numbers in their places, a free speed within its bound.
  ArcLengthSeries admissible(ArcLengthSeries sigma) const;
  ContactFit at(const ArcLengthSeries& sigma) const;
  Model modelAt(const ContactFit& fit) const;
  /// Rows and columns of numbers that stay become those of the identity, their gradient zero.
  void fix(const ArcLengthSeries& sigma, Model& model) const;
  /// A damped step that lowers the cost, or nothing where rounding is all that is left.
  std::optional<ContactFit> better(const ContactFit& fit, double& damping) const;

  const ContactJet& target_;
  const FirstPoles& first_;
  const FitOptions& options_;
  FirstPolesMatrix root_;          ///< cost = root' root
  FirstPolesMatrix costByTaylor_;  ///< cost byTaylor
  FirstPolesMatrix form_;          ///< byTaylor' cost byTaylor
};

ArcLengthSeries Fit::admissible(ArcLengthSeries sigma) const {
  for (std::size_t k = 0; k < index(target_.order); ++k)
    sigma[k] = options_.given[k].value_or(sigma[k]);
  if (!options_.given[0]) sigma[0] = std::max(sigma[0], options_.lowestSpeed);
  return sigma;
}

ContactFit Fit::at(const ArcLengthSeries& sigma) const {
  BoundedPoles taylor = attachedTaylor(target_, sigma);
  taylor.col(0).setZero();  // poles from the point of contact: that keeps digits
  ContactFit fit{sigma, taylor * first_.byTaylor.transpose(), 0.0};
  fit.poles.colwise() += target_.r[0];
  fit.cost = ((fit.poles - first_.old) * root_.transpose()).squaredNorm();
  return fit;
}

/// With c the Taylor coefficients, M = byTaylor, S = cost and d the displacements as columns:
/// df = 2 <d S M, dc>, d^2 f = 2 <dc M' S M, dc> + 2 <d S M, d^2 c>.
Model Fit::modelAt(const ContactFit& fit) const {
  const int m = target_.order;
  const BoundedPoles byTaylor = (fit.poles - first_.old) * costByTaylor_;
  std::array<BoundedPoles, kMaxOrder> slope;
  attachedTaylorDerivatives(target_, fit.sigma, slope);
  const BoundedPoles curvature = attachedTaylorCurvature(target_, fit.sigma);
  Model model{Numbers(m), Hessian(m, m)};
  for (int i = 1; i <= m; ++i) {
    const BoundedPoles& change = slope[index(i - 1)];
    model.gradient[i - 1] = 2.0 * byTaylor.cwiseProduct(change).sum();
    const BoundedPoles product = change * form_;
    for (int j = 1; j <= i; ++j) {
      double sum = product.cwiseProduct(slope[index(j - 1)]).sum();
      const int count = std::max(m + 1 - i - j, 0);
      sum += byTaylor.rightCols(count).cwiseProduct(curvature.leftCols(count)).sum();
      model.hessian(i - 1, j - 1) = model.hessian(j - 1, i - 1) = 2.0 * sum;
    }
  }
  return model;
}

void Fit::fix(const ArcLengthSeries& sigma, Model& model) const {
  for (int k = 0; k < target_.order; ++k) {
    const bool atBound = k == 0 && sigma[0] <= options_.lowestSpeed && model.gradient[0] > 0.0;
    if (!options_.given[index(k)] && !atBound) continue;
    model.gradient[k] = 0.0;
    model.hessian.row(k).setZero();
    model.hessian.col(k).setZero();
    model.hessian(k, k) = 1.0;
  }
}

std::optional<ContactFit> Fit::better(const ContactFit& fit, double& damping) const {
  constexpr double kMostDamping = 1e12;
  constexpr double kRounding = 1e-15;  // of the cost
  Model model = modelAt(fit);
  fix(fit.sigma, model);
  const Numbers scale = model.hessian.diagonal().cwiseAbs();
  for (; damping < kMostDamping; damping *= 10.0) {
    Hessian damped = model.hessian;
    damped.diagonal() += damping * scale;
    const Eigen::LLT<Hessian> factors(damped);
    if (factors.info() != Eigen::Success) continue;  // not convex so far
    const Numbers step = factors.solve(model.gradient);
    if (model.gradient.dot(step) <= kRounding * fit.cost) return {};
    ArcLengthSeries sigma = fit.sigma;
    for (int k = 0; k < target_.order; ++k)
      sigma[index(k)] -= step[k];
    ContactFit next = at(admissible(sigma));
    if (next.cost < fit.cost) return next;
  }
  return {};
}

ContactFit Fit::projected(const ArcLengthSeries& start) const {
  const int first = std::max(target_.order / 2, 1);
  const int count = target_.order - first;
  ContactFit fit = at(admissible(start));
  if (count == 0) return fit;
  Model model = modelAt(fit);
  fix(fit.sigma, model);
  const Numbers step = Hessian(model.hessian.bottomRightCorner(count, count))
                           .llt()
                           .solve(Numbers(model.gradient.tail(count)));
  for (int k = 0; k < count; ++k)
    fit.sigma[index(first + k)] -= step[k];
  return at(fit.sigma);
}

ContactFit Fit::descend(const ArcLengthSeries& start) const {
  constexpr int kMostSteps = 100;
  constexpr double kSmallestGain = 1e-13;  // of the cost
  constexpr double kLeastDamping = 1e-15;
  ContactFit best = at(admissible(start));
  double damping = 1e-4;
  for (int i = 0; i < kMostSteps; ++i) {
    const std::optional<ContactFit> next = better(best, damping);
    if (!next) break;
    const double gain = best.cost - next->cost;
    best = *next;
    if (gain <= kSmallestGain * best.cost) break;
    damping = std::max(0.01 * damping, kLeastDamping);
  }
  return best;
}

/// Local minima, the best first: no two of the same cost, at most so many.
class Minima {
 public:
  void add(ContactFit fit) {
    constexpr double kSame = 1e-6;
    constexpr std::size_t kMost = 3;
    const auto place = std::find_if(fits_.begin(), fits_.end(), [&](const ContactFit& other) {
      return fit.cost < other.cost * (1.0 + kSame);
    });
    const bool isKnown = place != fits_.end() && place->cost <= fit.cost * (1.0 + kSame);
    if (isKnown) {
      if (fit.cost < place->cost) *place = std::move(fit);
      return;
    }
    fits_.insert(place, std::move(fit));
    if (fits_.size() > kMost) fits_.pop_back();
  }

  const std::vector<ContactFit>& best() const { return fits_; }

 private:
  std::vector<ContactFit> fits_;
};

constexpr int kSpeedSteps = 17;
constexpr std::array<double, 11> kSeconds{-12, -8, -5, -3, -1.5, 0, 1.5, 3, 5, 8, 12};
constexpr int kSecondCount = static_cast<int>(kSeconds.size());

/// Where the cost is least among its neighbours on a grid of sigma_1, from half of that of the
/// start to eight times it, and, from order 4 on, sigma_2, all others being best: the best first.
std::vector<ContactFit> gridMinima(const Fit& fit, int order, const ArcLengthSeries& start) {
  constexpr std::size_t kMost = 4;
  const int seconds = order >= 4 ? kSecondCount : 1;
  Eigen::ArrayXXd cost(kSpeedSteps, seconds);
  std::vector<ContactFit> all;
  for (int j = 0; j < seconds; ++j) {
    for (int i = 0; i < kSpeedSteps; ++i) {
      const double speed = 0.5 * std::exp2(0.25 * i);
      all.push_back(
          fit.projected({speed * start[0], seconds == 1 ? 0.0 : kSeconds[index(j)] * start[0]}));
      cost(i, j) = all.back().cost;
    }
  }
  std::vector<ContactFit> minima;
  for (int j = 0; j < seconds; ++j) {
    for (int i = 0; i < kSpeedSteps; ++i) {
      const int top = std::max(i - 1, 0);
      const int left = std::max(j - 1, 0);
      const auto around = cost.block(top, left, std::min(i + 2, kSpeedSteps) - top,
                                     std::min(j + 2, seconds) - left);
      if (cost(i, j) <= around.minCoeff()) minima.push_back(all[index(j * kSpeedSteps + i)]);
    }
  }
  std::stable_sort(minima.begin(), minima.end(),
                   [](const ContactFit& a, const ContactFit& b) { return a.cost < b.cost; });
  if (minima.size() > kMost) minima.resize(kMost);
  return minima;
}

/// The same problem for one order less: the last pole is free then, and what the others cost is the
/// Schur complement.
FirstPoles withoutLast(const FirstPoles& first) {
  const Eigen::Index count = first.old.cols() - 1;
  const auto last = first.cost.col(count).head(count);
  return {
      first.old.leftCols(count), first.byTaylor.topLeftCorner(count, count),
      first.cost.topLeftCorner(count, count) - last * last.transpose() / first.cost(count, count)};
}

std::vector<ContactFit> minimaOf(const ContactJet& target, const FirstPoles& first,
                                 const FitOptions& options) {
  constexpr int kGridSees = 5;  // up to this order the numbers beyond the grid are linear
  const Fit fit(target, first, options);
  Minima minima;
  minima.add(fit.descend(options.start));
  if (target.order >= 1) {
    for (const ContactFit& found : gridMinima(fit, target.order, options.start))
      minima.add(fit.descend(found.sigma));
  }
  if (target.order <= kGridSees) return minima.best();
  ContactJet lower = target;
  lower.order = target.order - 1;
  for (const ContactFit& found : minimaOf(lower, withoutLast(first), options))
    minima.add(fit.descend(fit.projected(found.sigma).sigma));
  return minima.best();
}

}  // namespace

ContactFit fitContact(const ContactJet& target, const FirstPoles& first,
                      const FitOptions& options) {
  return minimaOf(target, first, options).front();
}

}  // namespace osculate
