// Frame, curvature, torsion and their rates from derivatives by arc length.
#pragma once

#include <array>

#include "osculate/differential/arc_jet.h"
#include "osculate/differential/frenet.h"

namespace osculate {

/// Curvature below this share of 1/L is flat: normal, torsion and rates mean nothing there.
inline constexpr double kFlatness = 1e-6;

/// r_0 .. r_4 in the direction of travel.
template <class Scalar>
using TravelJet = std::array<Eigen::Matrix<Scalar, 3, 1>, 5>;

/// From outward derivatives; `sign` is -1 for a curve that arrives at the point: it runs against
/// them, r_k (-1)^k.
template <class Vectors, class Scalar>
[[gnu::always_inline]] inline TravelJet<Scalar> inTravel(const Vectors& outward, Scalar sign) {
  TravelJet<Scalar> r;
  for (std::size_t k = 0; k < r.size(); ++k) {
    r[k] = outward[k];
    if (k % 2 == 1) r[k] *= sign;
  }
  return r;
}

/// The formulas without regard to whether the curvature is zero.
template <class Scalar>
struct ArcNumbers {
  Eigen::Matrix<Scalar, 3, 1> tangent, normal, binormal;
  Scalar curvature, torsion, curvatureRate, curvatureRate2, torsionRate;
};

/// kappa = |r_2|, n = r_2/kappa, b = r_1 x n, kappa' = n.r_3, tau = b.r_3/kappa,
/// kappa'' = n.r_4 + kappa^3 + kappa tau^2, tau' = (b.r_4 - 2 kappa' tau)/kappa
/// (the derivatives of the Frenet-Serret formulas; do Carmo, Differential Geometry, sec. 1-5).
template <class Scalar>
[[gnu::always_inline]] inline ArcNumbers<Scalar> arcNumbers(const TravelJet<Scalar>& r) {
  using std::sqrt;
  ArcNumbers<Scalar> n;
  n.tangent = r[1];
  n.curvature = sqrt(r[2].squaredNorm());
  const Scalar radius = Scalar(1.0) / n.curvature;
  n.normal = r[2] * radius;
  n.binormal = r[1].cross(n.normal);
  n.curvatureRate = n.normal.dot(r[3]);
  n.torsion = n.binormal.dot(r[3]) * radius;
  n.curvatureRate2 =
      n.normal.dot(r[4]) + n.curvature * (n.curvature * n.curvature + n.torsion * n.torsion);
  n.torsionRate = (n.binormal.dot(r[4]) - Scalar(2.0) * n.curvatureRate * n.torsion) * radius;
  return n;
}

/// Stores what exists: derivatives up to `available`, and what needs a normal only where the
/// curvature is above `flatBelow`. `lane` chooses the side of Lanes.
template <class Scalar>
[[gnu::always_inline]] inline void storeNumbers(const ArcNumbers<Scalar>& n, int side,
                                                int available, double flatBelow, FrenetFrame& frame,
                                                Invariants& invariants) {
  if (available < 1) return;
  frame.tangent = lane(n.tangent, side);
  if (available < 2) return;
  invariants.curvature = lane(n.curvature, side);
  if (!(*invariants.curvature > flatBelow)) return;
  frame.normal = lane(n.normal, side);
  frame.binormal = lane(n.binormal, side);
  if (available < 3) return;
  invariants.torsion = lane(n.torsion, side);
  invariants.curvatureRate = lane(n.curvatureRate, side);
  if (available < 4) return;
  invariants.curvatureRate2 = lane(n.curvatureRate2, side);
  invariants.torsionRate = lane(n.torsionRate, side);
}

}  // namespace osculate
