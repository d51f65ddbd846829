// Frame, curvature, torsion and their rates from derivatives by arc length.
#pragma once

#include <array>

#include "osculate/differential/arc_jet.h"
#include "osculate/differential/frenet.h"

namespace osculate {

struct ArcInvariants {
  FrenetFrame frame;      ///< normal and binormal only where curvature exists and is not flat
  Invariants invariants;
  bool flat = false;      ///< curvature not above `flatBelow`: no normal, torsion, rates
};

/// From r_1 .. r_available in the direction of travel:
/// kappa = |r_2|, n = r_2/kappa, b = r_1 x n, kappa' = n.r_3, tau = b.r_3/kappa,
/// kappa'' = n.r_4 + kappa^3 + kappa tau^2, tau' = (b.r_4 - 2 kappa' tau)/kappa
/// (the derivatives of the Frenet-Serret formulas; do Carmo, Differential Geometry, sec. 1-5).
[[gnu::always_inline]] inline ArcInvariants arcInvariants(const std::array<Vector3, 5>& r, int available,
                                                          double flatBelow) {
  ArcInvariants result;
  if (available < 1) return result;
  result.frame.tangent = r[1];
  if (available < 2) return result;
  const double curvature = r[2].norm();
  result.invariants.curvature = curvature;
  result.flat = curvature <= flatBelow;
  if (result.flat) return result;
  const double radius = 1.0 / curvature;
  const Vector3 normal = radius * r[2];
  const Vector3 binormal = r[1].cross(normal);
  result.frame.normal = normal;
  result.frame.binormal = binormal;
  if (available < 3) return result;
  const double rate = normal.dot(r[3]);
  const double torsion = binormal.dot(r[3]) * radius;
  result.invariants.curvatureRate = rate;
  result.invariants.torsion = torsion;
  if (available < 4) return result;
  result.invariants.curvatureRate2 =
      normal.dot(r[4]) + curvature * (curvature * curvature + torsion * torsion);
  result.invariants.torsionRate = (binormal.dot(r[4]) - 2.0 * rate * torsion) * radius;
  return result;
}

/// The first four outward derivatives by arc length, turned into the direction of travel: a curve
/// that arrives at its end runs against them, r_k (-1)^k.
template <int N>
[[gnu::always_inline]] inline std::array<Vector3, 5> inTravel(const ArcJet<N>& arc, bool arrives) {
  static_assert(N >= 4);
  std::array<Vector3, 5> r;
  for (std::size_t k = 0; k < r.size(); ++k) r[k] = arrives && k % 2 == 1 ? Vector3(-arc.r[k]) : arc.r[k];
  return r;
}

/// Curvature below this share of 1/L is flat: normal, torsion and rates mean nothing there.
inline constexpr double kFlatness = 1e-6;

}  // namespace osculate
