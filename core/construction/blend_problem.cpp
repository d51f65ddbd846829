#include "osculate/construction/blend_problem.h"

#include <algorithm>
#include <cmath>

#include "osculate/bezier/bernstein.h"
#include "osculate/bezier/index.h"
#include "osculate/differential/arc_jet.h"

namespace osculate {

namespace {

// beyond these a curve is loops or a cusp to the eye; legs in units of chord/n, poles in chords
constexpr double kLeastSpeed = 0.02;
constexpr double kLargestSpeed = 30.0;
constexpr double kLongestLeg = 200.0;
constexpr double kFarthestPole = 100.0;

/// beta_k at this end where it is given there or, at symmetric ends, at the other one.
std::optional<double> givenNumber(const BlendOptions& options, int end, int k) {
  const auto& own = options.beta[index(end)][index(k - 1)];
  const bool isShared = options.symmetric && k <= options.order[index(1 - end)];
  return own || !isShared ? own : options.beta[index(1 - end)][index(k - 1)];
}

/// d leg_k / d sigma_l.
double legFactor(int k, int l, int degree) { return binomial(k - 1, l - 1) / binomial(degree, l); }

}  // namespace

BlendProblem::BlendProblem(const ContactJet& from, const ContactJet& to,
                           const BlendOptions& options, int degree, Quadrature quadrature)
    : targets_{from, to},
      degree_(degree),
      chord_((to.r[0] - from.r[0]).norm()),
      fairness_(degree, options.fairness.value_or(Fairness::kMinimumVariation), quadrature) {
  addNumbers(options);
  firstFreePole_ = options.order[0] + 1;
  freePoles_ = degree - options.order[0] - options.order[1] - 1;
  firstPoleUnknown_ = size();
  for (int i = 0; i < 3 * freePoles_; ++i)
    newUnknown(-kFarthestPole, kFarthestPole);
}

int BlendProblem::newUnknown(double lower, double upper) {
  lower_.push_back(lower);
  upper_.push_back(upper);
  return size() - 1;
}

void BlendProblem::addNumbers(const BlendOptions& options) {
  for (int end = 0; end < 2; ++end) {
    Unknowns& unknowns = numbers_[index(end)];
    unknowns.fill(-1);
    for (int k = 1; k <= options.order[index(end)]; ++k) {
      const std::size_t i = index(k - 1);
      const std::optional<double> number = givenNumber(options, end, k);
      const bool tied = end == 1 && options.symmetric && numbers_[0][i] >= 0;
      if (number) {
        given_[index(end)][i] = *number * chord_ / detail::kFactorials[index(k)];
      } else if (tied) {
        unknowns[i] = numbers_[0][i];
      } else {
        unknowns[i] = k == 1 ? newUnknown(std::log(kLeastSpeed), std::log(kLargestSpeed))
                             : newUnknown(-kLongestLeg, kLongestLeg);
      }
    }
  }
}

std::vector<double> BlendProblem::unknownsOf(const std::array<ArcLengthSeries, 2>& sigma) const {
  std::vector<double> unknowns(index(size()), 0.0);
  const double unit = degree_ / chord_;
  for (std::size_t end = 0; end < 2; ++end) {
    for (int k = 1; k <= targets_[end].order; ++k) {
      const int unknown = numbers_[end][index(k - 1)];
      if (unknown < 0) continue;
      double leg = 0.0;
      for (int l = 1; l <= k; ++l)
        leg += legFactor(k, l, degree_) * sigma[end][index(l - 1)];
      const std::size_t i = index(unknown);
      unknowns[i] = std::clamp(k == 1 ? std::log(unit * leg) : unit * leg, lower_[i], upper_[i]);
    }
  }
  return unknowns;
}

std::array<ArcLengthSeries, 2> BlendProblem::sigma(const std::vector<double>& unknowns) const {
  std::array<ArcLengthSeries, 2> sigma = given_;
  const double unit = chord_ / degree_;
  for (std::size_t end = 0; end < 2; ++end) {
    for (int k = 1; k <= targets_[end].order; ++k) {
      const int unknown = numbers_[end][index(k - 1)];
      if (unknown < 0) continue;
      const double x = unknowns[index(unknown)];
      double rest = unit * (k == 1 ? std::exp(x) : x);
      for (int l = 1; l < k; ++l)
        rest -= legFactor(k, l, degree_) * sigma[end][index(l - 1)];
      sigma[end][index(k - 1)] = rest / legFactor(k, k, degree_);
    }
  }
  return sigma;
}

std::array<BetaNumbers, 2> BlendProblem::beta(const std::vector<double>& unknowns) const {
  std::array<BetaNumbers, 2> beta = sigma(unknowns);
  for (BetaNumbers& end : beta) {
    for (std::size_t k = 0; k < end.size(); ++k)
      end[k] *= detail::kFactorials[k + 1] / chord_;
  }
  return beta;
}

std::vector<double> BlendProblem::start(double firstBeta, double secondBeta) const {
  std::array<ArcLengthSeries, 2> series = given_;
  const std::array<double, 2> beta{firstBeta, secondBeta};
  for (std::size_t end = 0; end < 2; ++end) {
    if (numbers_[end][0] >= 0) series[end][0] = beta[end] * chord_;
  }
  return unknownsOf(series);
}

std::vector<double> BlendProblem::startLike(const BezierCurve& curve) const {
  std::array<ArcLengthSeries, 2> series;
  for (std::size_t end = 0; end < 2; ++end) {
    const CurveEnd side = end == 0 ? CurveEnd::kStart : CurveEnd::kEnd;
    const auto arc = arcJet(endJet<kMaxOrder>(curve.view(), side, 0.0));
    std::copy_n(arc.arcLength.begin() + 1, kMaxOrder, series[end].begin());
  }
  return unknownsOf(series);
}

std::vector<double> BlendProblem::startFrom(const BlendProblem& lower,
                                            const std::vector<double>& solution) const {
  std::vector<double> unknowns = unknownsOf(lower.sigma(solution));
  const BezierCurve same = bezierFromPoles(lower.poles(solution).data(), lower.degree_)
                               .elevated(degree_ - lower.degree_);
  for (int i = 0; i < freePoles_; ++i) {
    const Vector3 pole = (same.pole(firstFreePole_ + i) - targets_[0].r[0]) / chord_;
    std::copy_n(pole.data(), 3, unknowns.begin() + firstPoleUnknown_ + 3 * i);
  }
  return unknowns;
}

BoundedPoles BlendProblem::poles(const std::vector<double>& unknowns) const {
  const auto series = sigma(unknowns);
  BoundedPoles poles(3, degree_ + 1);
  const BoundedPoles first = attach(targets_[0], series[0], degree_);
  const BoundedPoles last = attach(targets_[1], series[1], degree_);
  poles.leftCols(first.cols()) = first;
  poles.rightCols(last.cols()) = last.rowwise().reverse();
  for (int i = 0; i < freePoles_; ++i) {
    const double* x = unknowns.data() + firstPoleUnknown_ + 3 * i;
    poles.col(firstFreePole_ + i) = targets_[0].r[0] + chord_ * Eigen::Map<const Vector3>(x);
  }
  return poles;
}

/// Adds the derivatives by the unknowns that stand for beta numbers: by sigma, then, as each sigma
/// depends on those of lower orders, from the highest down by the leg.
void BlendProblem::addBySigma(const std::vector<double>& unknowns, const BoundedPoles& byPoles,
                              double* gradient) const {
  const auto series = sigma(unknowns);
  std::array<BoundedPoles, kMaxOrder> change;
  for (std::size_t end = 0; end < 2; ++end) {
    attachDerivatives(targets_[end], series[end], degree_, change);
    std::array<double, kMaxOrder> bySigma{};
    for (int k = targets_[end].order; k >= 1; --k) {
      const std::size_t i = index(k - 1);
      const BoundedPoles& d = change[i];
      bySigma[i] += end == 0
                        ? d.cwiseProduct(byPoles.leftCols(d.cols())).sum()
                        : d.cwiseProduct(byPoles.rightCols(d.cols()).rowwise().reverse()).sum();
      const int unknown = numbers_[end][i];
      if (unknown < 0) continue;
      const double byLeg = bySigma[i] / legFactor(k, k, degree_);
      for (int l = 1; l < k; ++l)
        bySigma[index(l - 1)] -= byLeg * legFactor(k, l, degree_);
      const double leg = chord_ / degree_ * (k == 1 ? std::exp(unknowns[index(unknown)]) : 1.0);
      gradient[unknown] += byLeg * leg;
    }
  }
}

double BlendProblem::objective(const std::vector<double>& unknowns, double* gradient) const {
  const BoundedPoles current = poles(unknowns);
  if (gradient == nullptr) return fairness_.evaluate(current, nullptr);
  BoundedPoles byPoles;
  const double value = fairness_.evaluate(current, &byPoles);
  std::fill_n(gradient, size(), 0.0);
  if (!std::isfinite(value)) return value;

  addBySigma(unknowns, byPoles, gradient);
  for (int i = 0; i < freePoles_; ++i) {
    Eigen::Map<Vector3>(gradient + firstPoleUnknown_ + 3 * i) =
        chord_ * byPoles.col(firstFreePole_ + i);
  }
  return value;
}

BoundedFunction functionOf(const BlendProblem& problem) {
  return {[&](const std::vector<double>& unknowns, double* gradient) {
            return problem.objective(unknowns, gradient);
          },
          problem.lowerBounds(), problem.upperBounds()};
}

}  // namespace osculate
