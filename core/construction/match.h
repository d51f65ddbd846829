// A curve changed near one of its ends so that it meets another one.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "osculate/construction/attach.h"
#include "osculate/construction/curve_change.h"

namespace osculate {

struct MatchOptions {
  int order = 2;   ///< of contact at the join, 0 .. kMaxOrder
  int degree = 0;  ///< 0: the curve's own where that suffices, else the least that does
  int keep = 4;    ///< at the far end the derivatives 0 .. keep stay, by keeping its last poles
  int spans = 0;   ///< at most so many, from the join, may change; 0: as many as are useful
  /// Given numbers, see Match::beta; the others are chosen.
  std::array<std::optional<double>, kMaxOrder> beta{};
};

struct Match {
  BSplineCurve curve;
  CurveChange change{};
  /// beta[k-1] = (d^k s/dt^k at the join) / unit: s the arc length of the new curve and t the
  /// parameter of its span at the join over [0, 1], both from the join into the curve. The unit is
  /// the reach of that span as it was: the distance from its end at the join to its other end or
  /// its middle, the larger. So beta_1 is about 1 for a span of even speed.
  std::vector<double> beta{};
  std::vector<std::string> warnings{};  ///< sentences
};

/// Moves the poles at an end of the curve so that it continues the target, with the least
/// int |displacement|^2 ds, s the arc length of the curve as it was. The target's contact fixes the
/// first order+1 poles up to the numbers beta; those and the poles beyond are chosen. Weights and
/// knots stay; so do the orders of contact that the curve has with itself at its inner knots.
///
/// The degree is raised, as little as possible, where it is below the order, or where the curve has
/// too few poles for both ends; a periodic curve is opened at its seam. Throws
/// std::invalid_argument for numbers outside their range, ContactError where the degree or the
/// spans asked for cannot carry the order, with those that can.
Match match(const ContactJet& target, const BSplineCurve& curve, CurveEnd end,
            const MatchOptions& options = {});

/// The match of a curve that meets its target already: the same curve, with its own numbers.
Match unchanged(const BSplineCurve& curve, CurveEnd end, int order);

}  // namespace osculate
