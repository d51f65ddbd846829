// A curve between two curves that meets each with its own order of contact.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "osculate/construction/contact_jet.h"
#include "osculate/construction/fairness.h"

namespace osculate {

/// beta[k-1] = (d^k s/dt^k at the end) / chord: s the arc length of the new curve, t its parameter
/// in [0, 1], both measured from the end into the curve, so that a symmetric task has equal
/// numbers.
using BetaNumbers = std::array<double, kMaxOrder>;

struct BlendOptions {
  std::array<int, 2> order{3, 3};  ///< of contact at each end, 0 .. kMaxOrder
  int degree = 0;                  ///< 0: the least, order[0] + order[1] + 1
  /// Given numbers; the others are chosen.
  std::array<std::array<std::optional<double>, kMaxOrder>, 2> beta{};
  /// Up to the lower order, numbers not given at either end are equal at both, and one given at one
  /// end holds at the other too.
  bool symmetric = false;
  /// What chooses; nothing: beta_1 = 1, the others 0, and further poles by raising the degree.
  std::optional<Fairness> fairness = Fairness::kMinimumVariation;
};

struct Blend {
  BezierCurve curve;
  std::array<BetaNumbers, 2> beta{};  ///< those up to each end's order are set
  double chordMm = 0.0;
  std::optional<double> objective;    ///< what was minimised, where anything was free
  std::vector<std::string> warnings;  ///< sentences
};

/// `from` and `to` are the directions in which the new curve leaves each curve, with the orders of
/// the options. The optimum is the best of several starts; the same input gives the same curve.
/// Throws std::invalid_argument for numbers outside their range (order, degree, beta_1 <= 0, not
/// finite), ContactError where no curve can be: coinciding ends, a degree too low for the orders.
Blend blend(const ContactJet& from, const ContactJet& to, const BlendOptions& options = {});

}  // namespace osculate
