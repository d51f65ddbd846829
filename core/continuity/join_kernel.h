// The decision of a join for a fixed number of derivatives; private to this floor. Everything is
// inlined into one function per N, so that the loops unroll.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "osculate/continuity/join_analysis.h"
#include "osculate/differential/arc_invariants.h"
#include "osculate/differential/singular_end.h"

namespace osculate::kernel {

inline constexpr double kDegrees = 180.0 / std::numbers::pi;

/// Both sides of a join, each outward from the join: the arriving curve in the first lane, the
/// leaving one in the second.
template <int N>
struct Ends {
  std::array<Jet<N>, 2> jets;
  std::array<LanesVector, N + 1> c;  ///< Taylor coefficients of both
  std::array<Lanes, N + 1> error;    ///< bounds of their errors
  ArcJet<N, Lanes> arc;
  std::array<int, 2> multiplicity{1, 1};
  std::array<int, 2> smoothness{N, N};

  [[gnu::always_inline]] inline Ends(const JoinSide& arriving, const JoinSide& leaving);

  bool regular() const { return multiplicity[0] == 1 && multiplicity[1] == 1; }
  int commonSmoothness() const { return std::min(smoothness[0], smoothness[1]); }
};

inline Lanes withLane(Lanes both, std::size_t i, double value) {
  return i == 0 ? Lanes(value, both[1]) : Lanes(both[0], value);
}

/// Puts the expansion of a singular end in place of what the regular formulas gave.
template <int N>
[[gnu::noinline]] void replaceSingular(const JoinSide& side, std::size_t i, Ends<N>& ends) {
  const SingularEnd singular = singularEnd(side.segment, side.end, side.poleError, N);
  ends.multiplicity[i] = singular.multiplicity;
  ends.smoothness[i] = singular.smoothness;
  for (std::size_t k = 1; k <= N; ++k) {
    for (int axis = 0; axis < 3; ++axis) {
      ends.arc.r[k][axis] = withLane(ends.arc.r[k][axis], i, singular.r[k][axis]);
    }
    ends.arc.norm[k] = withLane(ends.arc.norm[k], i, singular.r[k].norm());
    ends.arc.error[k] = withLane(ends.arc.error[k], i, singular.error[k]);
  }
}

template <int N>
inline Ends<N>::Ends(const JoinSide& arriving, const JoinSide& leaving)
    : jets{endJet<N>(arriving.segment, arriving.end, arriving.poleError),
           endJet<N>(leaving.segment, leaving.end, leaving.poleError)} {
  const auto& [a, b] = jets;
#pragma GCC unroll 8
  for (std::size_t k = 1; k <= N; ++k) {
    c[k] = zip(a.c[k], b.c[k]);
    error[k] = Lanes(a.error[k], b.error[k]);
  }
  setArcJet<N, Lanes>(c, error, arc);
  if (isSingular(a)) [[unlikely]]
    replaceSingular(arriving, 0, *this);
  if (isSingular(b)) [[unlikely]]
    replaceSingular(leaving, 1, *this);
}

inline double scaleOf(const JoinSide& arriving, const JoinSide& leaving,
                      const AnalysisOptions& options) {
  if (options.scaleMm > 0.0) return options.scaleMm;
  const auto reach = [](const JoinSide& side) {
    return side.reach > 0.0 ? side.reach : reachOf(side.segment, side.end);
  };
  return std::min(reach(arriving), reach(leaving));
}

/// Angle in radians, 0..pi, between unit vectors; exact for small and for nearly opposite ones
/// alike.
inline double angleBetween(const Vector3& a, const Vector3& b) {
  const double half = 0.5 * (a - b).norm();
  if (half < 0.05) {
    // 2 asin(half): the next term of the series is below 1e-16 of the sum
    const double x = half * half;
    return 2.0 * half *
           (1.0 + x * (1.0 / 6 + x * (3.0 / 40 + x * (15.0 / 336 +
                                                      x * (105.0 / 3456 + x * (945.0 / 42240))))));
  }
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

inline Verdict judge(double residual, double uncertainty, double tolerance) {
  if (residual + uncertainty <= tolerance) return Verdict::kPass;
  return residual - uncertainty > tolerance ? Verdict::kFail : Verdict::kUndecided;
}

/// |x_a - x_b|^2 for derivatives of order k taken outward on both sides: forward those of the
/// arriving side change sign with odd k.
[[gnu::always_inline]] inline double squaredDifference(const LanesVector& x, std::size_t k) {
  const Vector3 first = lane(x, 0);
  const Vector3 second = lane(x, 1);
  return k % 2 == 1 ? (first + second).squaredNorm() : (first - second).squaredNorm();
}

template <int N>
[[gnu::always_inline]] inline void setResiduals(const Ends<N>& ends, double scale,
                                                JoinDecision& decision) {
  const auto& [a, b] = ends.jets;
  const auto& arc = ends.arc;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  decision.residuals[0] = (a.point - b.point).norm();
  decision.uncertainties[0] =
      a.pointError + b.pointError + 4.0 * kUnitRoundoff * decision.residuals[0];
  const int exists = ends.commonSmoothness();
  decision.residuals[1] =
      exists < 1 ? kInfinity : kDegrees * angleBetween(-lane(arc.r[1], 0), lane(arc.r[1], 1));
  decision.uncertainties[1] =
      exists < 1 ? 0.0 : std::min(180.0, kDegrees * (arc.error[1][0] + arc.error[1][1]));
  const double inverseScale = 1.0 / scale;
  double least = 1.0;
#pragma GCC unroll 8
  for (std::size_t k = 2; k <= N; ++k) {
    least *= inverseScale;  // L^(1-k)
    if (static_cast<int>(k) > exists) {
      decision.residuals[k] = kInfinity;
      decision.uncertainties[k] = 0.0;
      continue;
    }
    const double inverse = 1.0 / std::max({arc.norm[k][0], arc.norm[k][1], least});
    const double residual = inverse * std::sqrt(squaredDifference(arc.r[k], k));
    decision.residuals[k] = residual;
    // the error of the difference, and that of the size it is divided by
    decision.uncertainties[k] = inverse * (arc.error[k][0] + arc.error[k][1]) * (1.0 + residual);
  }
}

/// The residuals of C^m: |P^(k) - Q^(k)| / max(|P^(k)|, |Q^(k)|, v^k L^(1-k)), v the larger speed,
/// up to the first that fails.
template <int N>
[[gnu::always_inline]] inline void setParametricOrder(const Ends<N>& ends, const JoinSide& arriving,
                                                      const JoinSide& leaving, double scale,
                                                      const AnalysisOptions& options,
                                                      JoinDecision& decision) {
  decision.parametricResiduals[0] = decision.residuals[0];
  decision.parametricOrder = decision.verdicts[0] == Verdict::kPass ? 0 : -1;
  const Lanes perUnit = Lanes(1.0) / Lanes(arriving.span, leaving.span);
  Lanes factor(1.0);
  double least = scale;
  double speedOverScale = 0.0;
  for (std::size_t k = 1; k <= N && decision.parametricOrder == static_cast<int>(k) - 1; ++k) {
    if (static_cast<int>(k) > options.order) break;
    factor *= perUnit * Lanes(static_cast<double>(k));
    const LanesVector derivative = ends.c[k] * factor;
    const Lanes squared = derivative.squaredNorm();
    const Lanes roots =
        sqrt(Lanes(std::max(squared[0], squared[1]), squaredDifference(derivative, k)));
    if (k == 1) speedOverScale = roots[0] / scale;
    least *= speedOverScale;
    const double size = std::max(roots[0], least);
    const Lanes errors = factor * ends.error[k];
    decision.parametricResiduals[k] = size > 0.0 ? roots[1] / size : 0.0;
    const double tolerance = k == 1 ? options.tolerances.angleDegrees / kDegrees
                                    : options.tolerances.ofOrder(static_cast<int>(k));
    if (roots[1] + errors[0] + errors[1] <= tolerance * size)
      decision.parametricOrder = static_cast<int>(k);
  }
}

template <int N>
[[gnu::always_inline]] inline void decide(const Ends<N>& ends, const JoinSide& arriving,
                                          const JoinSide& leaving, double scale,
                                          const AnalysisOptions& options, JoinDecision& decision) {
  setResiduals(ends, scale, decision);
  decision.order = -1;
#pragma GCC unroll 9
  for (int k = 0; k <= N; ++k) {
    if (k > options.order) break;
    const auto i = static_cast<std::size_t>(k);
    decision.verdicts[i] =
        judge(decision.residuals[i], decision.uncertainties[i], options.tolerances.ofOrder(k));
    if (decision.order == k - 1 && decision.verdicts[i] == Verdict::kPass) decision.order = k;
  }
  setParametricOrder(ends, arriving, leaving, scale, options, decision);
}

}  // namespace osculate::kernel
