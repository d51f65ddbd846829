// The first poles of a curve that has contact with another one, from its free numbers.
#pragma once

#include <array>

#include "osculate/construction/contact_jet.h"

namespace osculate {

/// Up to kMaxDegree + 1 poles as columns, in mm, without allocation.
using BoundedPoles = Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::ColMajor, 3, kMaxDegree + 1>;

/// sigma[k-1] is the Taylor coefficient of t^k in s(t), in mm.
using ArcLengthSeries = std::array<double, kMaxOrder>;

/// The Taylor coefficients q_0 .. q_m of a curve Q(t) = R(s(t)), m the order of the target.
BoundedPoles attachedTaylor(const ContactJet& target, const ArcLengthSeries& sigma);

/// d q_k / d sigma_l for l = 1..m, in derivative[l-1].
void attachedTaylorDerivatives(const ContactJet& target, const ArcLengthSeries& sigma,
                               std::array<BoundedPoles, kMaxOrder>& derivative);

/// d^2 q_k / d sigma_i d sigma_j is column k-i-j of this, zero where that is negative: R''(s(t)) up
/// to t^(m-2).
BoundedPoles attachedTaylorCurvature(const ContactJet& target, const ArcLengthSeries& sigma);

/// The poles C_0 .. C_m of a Bézier curve of degree n >= m from its Taylor coefficients q_0 .. q_m:
/// C_i = sum_k C(i,k)/C(n,k) q_k.
BoundedPoles polesOfTaylor(const BoundedPoles& taylor, int degree);

/// The poles C_0 .. C_m of a Bézier curve of degree n >= m, m the order of the target.
///
/// s(t) = sum sigma_k t^k, sigma_1 > 0, is the target's arc length in terms of the new curve's
/// parameter: Q = R(s(t)) up to t^m (Faa di Bruno as one series composition). Any sigma gives
/// contact of order m (Barsky and DeRose 1989: the beta constraints). Nothing is checked.
BoundedPoles attach(const ContactJet& target, const ArcLengthSeries& sigma, int degree);

/// d C_i / d sigma_l for l = 1..m, in derivative[l-1]: the same composition with R'(s(t)) t^l.
void attachDerivatives(const ContactJet& target, const ArcLengthSeries& sigma, int degree,
                       std::array<BoundedPoles, kMaxOrder>& derivative);

}  // namespace osculate
