// The free numbers of a blend as one vector, and its objective by them; private to this floor.
#pragma once

#include "osculate/construction/blend.h"
#include "osculate/construction/minimize.h"

namespace osculate {

/// The unknowns of a blend of one degree: for each end, in place of the beta_k that are not given,
/// the legs of the control polygon that they would make on a straight line, leg_k = sum_{l<=k}
/// C(k-1,l-1)/C(n,l) sigma_l; then the free poles. Legs are in units of chord/n (the first as a
/// logarithm), poles in chords: all are about 1, where beta_4 may be in the thousands.
class BlendProblem {
 public:
  BlendProblem(const ContactJet& from, const ContactJet& to, const BlendOptions& options,
               int degree, Quadrature quadrature);

  int size() const { return static_cast<int>(lower_.size()); }
  const std::vector<double>& lowerBounds() const { return lower_; }
  const std::vector<double>& upperBounds() const { return upper_; }
  double chord() const { return chord_; }

  /// The unknowns where the chosen beta_1 have these values and all other chosen numbers are 0.
  std::vector<double> start(double firstBeta, double secondBeta) const;
  /// The unknowns whose numbers are those of another curve between the same ends. No free poles.
  std::vector<double> startLike(const BezierCurve& curve) const;
  /// The unknowns of a solution of a lower degree: the same curve, its degree raised.
  std::vector<double> startFrom(const BlendProblem& lower,
                                const std::vector<double>& solution) const;

  BoundedPoles poles(const std::vector<double>& unknowns) const;
  std::array<BetaNumbers, 2> beta(const std::vector<double>& unknowns) const;
  /// The objective; `gradient`, where not null, has size() numbers.
  double objective(const std::vector<double>& unknowns, double* gradient) const;

 private:
  using Unknowns = std::array<int, kMaxOrder>;  ///< which unknown stands for each number; -1: given

  void addNumbers(const BlendOptions& options);
  int newUnknown(double lower, double upper);
  std::array<ArcLengthSeries, 2> sigma(const std::vector<double>& unknowns) const;
  void addBySigma(const std::vector<double>& unknowns, const BoundedPoles& byPoles,
                  double* gradient) const;
  /// The unknowns that stand for these series, within the bounds; free poles 0.
  std::vector<double> unknownsOf(const std::array<ArcLengthSeries, 2>& sigma) const;

  std::array<ContactJet, 2> targets_;
  int degree_;
  double chord_;
  FairnessObjective fairness_;
  std::array<ArcLengthSeries, 2> given_{};
  std::array<Unknowns, 2> numbers_;
  int firstFreePole_ = 0;
  int freePoles_ = 0;
  int firstPoleUnknown_ = 0;
  std::vector<double> lower_;
  std::vector<double> upper_;
};

/// Its objective within its bounds, as long as the problem lives.
BoundedFunction functionOf(const BlendProblem& problem);

}  // namespace osculate
