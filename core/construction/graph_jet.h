// A contact jet as a graph over its tangent line; private to this floor.
#pragma once

#include "osculate/construction/attach.h"

namespace osculate {

/// u is the tangential coordinate from the point of contact, in mm. A curve meets the jet when its
/// part across the tangent is the same function of u, up to u^m: mathematics of the bachelor thesis
/// (CTU 2024, sec. 3.5), for any order.
struct GraphJet {
  /// r[0] the point, r[1] the unit tangent, r[k] = d^k P / du^k for k >= 2: across the tangent. As
  /// a target of attachedTaylor its series is u(t) in place of s(t).
  ContactJet overTangent;
  /// The Taylor coefficients of s(u), in mm^(1-k).
  std::array<double, kMaxOrder + 1> arcLength{};
};

/// The order of the contact must be at least 1.
GraphJet graphJet(const ContactJet& contact);

/// s(u(t)) of u(t), up to t^m: [k-1] is the coefficient of t^k.
ArcLengthSeries arcLengthOf(const GraphJet& graph, const ArcLengthSeries& u);
/// derivative[l-1][k-1] = d s_k / d u_l.
using SeriesDerivatives = std::array<ArcLengthSeries, kMaxOrder>;
SeriesDerivatives arcLengthDerivatives(const GraphJet& graph, const ArcLengthSeries& u);

/// u(s(t)) of s(t), up to t^m.
ArcLengthSeries tangentialOf(const ContactJet& contact, const ArcLengthSeries& sigma);

}  // namespace osculate
