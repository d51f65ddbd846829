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

/// One side: its Taylor coefficients and its derivatives by arc length, both outward from the join.
template <int N>
struct End {
  Jet<N> jet;
  ArcJet<N> arc;
  bool singular;
};

/// The first N orders of a singular end's derivatives.
template <int N>
ArcJet<N> singularArcJet(const JoinSide& side, int order) {
  const auto full = singularEnd(side.segment, side.end, side.poleError, order);
  ArcJet<N> arc{};
  for (std::size_t k = 0; k <= N; ++k) {
    arc.r[k] = full.r[k];
    arc.norm[k] = full.norm[k];
    arc.error[k] = full.error[k];
  }
  arc.multiplicity = full.multiplicity;
  arc.smoothness = full.smoothness;
  return arc;
}

template <int N>
[[gnu::always_inline]] inline End<N> makeEnd(const JoinSide& side) {
  End<N> end;
  end.jet = endJet<N>(side.segment, side.end, side.poleError);
  end.singular = isSingular(end.jet);
  if (end.singular) [[unlikely]] {
    end.arc = singularArcJet<N>(side, N);
  } else {
    end.arc = arcJet(end.jet);
  }
  return end;
}

inline double scaleOf(const JoinSide& arriving, const JoinSide& leaving, const AnalysisOptions& options) {
  if (options.scaleMm > 0.0) return options.scaleMm;
  const auto reach = [](const JoinSide& side) {
    return side.reach > 0.0 ? side.reach : reachOf(side.segment, side.end);
  };
  return std::min(reach(arriving), reach(leaving));
}

/// Angle in radians, 0..pi, between unit vectors; exact for small and for nearly opposite ones alike.
inline double angleBetween(const Vector3& a, const Vector3& b) {
  const double half = 0.5 * (a - b).norm();
  if (half < 0.05) {
    // 2 asin(half): the next term of the series is below 1e-16 of the sum
    const double x = half * half;
    return 2.0 * half * (1.0 + x * (1.0 / 6 + x * (3.0 / 40 + x * (15.0 / 336 + x * (105.0 / 3456 + x * (945.0 / 42240))))));
  }
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

inline Verdict judge(double residual, double uncertainty, double tolerance) {
  if (residual + uncertainty <= tolerance) return Verdict::kPass;
  return residual - uncertainty > tolerance ? Verdict::kFail : Verdict::kUndecided;
}

/// |x_a - x_b| for derivatives of order k taken outward on both sides: forward those of the
/// arriving side change sign with odd k.
inline double differenceNorm(const Vector3& arriving, const Vector3& leaving, std::size_t k) {
  return k % 2 == 1 ? (arriving + leaving).norm() : (arriving - leaving).norm();
}

template <int N>
[[gnu::always_inline]] inline void setResiduals(const End<N>& a, const End<N>& b, double scale,
                                                JoinDecision& decision) {
  decision.residuals[0] = (a.jet.point - b.jet.point).norm();
  decision.uncertainties[0] = a.jet.pointError + b.jet.pointError;
  const double inverseScale = 1.0 / scale;
  const int exists = std::min(a.arc.smoothness, b.arc.smoothness);
  if (exists >= 1) {
    decision.residuals[1] = kDegrees * angleBetween(-a.arc.r[1], b.arc.r[1]);
    const double radians = a.arc.error[1] + b.arc.error[1];
    decision.uncertainties[1] = std::min(180.0, kDegrees * radians);
  } else {
    decision.residuals[1] = std::numeric_limits<double>::infinity();
    decision.uncertainties[1] = 0.0;
  }
  double least = 1.0;
  for (std::size_t k = 2; k <= N; ++k) {
    least *= inverseScale;  // L^(1-k)
    if (static_cast<int>(k) > exists) {
      decision.residuals[k] = std::numeric_limits<double>::infinity();
      decision.uncertainties[k] = 0.0;
      continue;
    }
    const double inverse = 1.0 / std::max({a.arc.norm[k], b.arc.norm[k], least});
    const double residual = inverse * differenceNorm(a.arc.r[k], b.arc.r[k], k);
    decision.residuals[k] = residual;
    // the error of the difference, and that of the size it is divided by
    decision.uncertainties[k] = inverse * (a.arc.error[k] + b.arc.error[k]) * (1.0 + residual);
  }
}

/// The residuals of C^m: |P^(k) - Q^(k)| / max(|P^(k)|, |Q^(k)|, v^k L^(1-k)), v the larger speed.
template <int N>
[[gnu::always_inline]] inline int parametricOrder(const End<N>& a, const End<N>& b, const JoinSide& arriving,
                                                  const JoinSide& leaving, double scale,
                                                  const AnalysisOptions& options, JoinDecision& decision) {
  decision.parametricResiduals[0] = decision.residuals[0];
  int order = decision.verdicts[0] == Verdict::kPass ? 0 : -1;
  const double perUnitA = 1.0 / arriving.span;
  const double perUnitB = 1.0 / leaving.span;
  double factorA = 1.0;
  double factorB = 1.0;
  double least = scale;
  double speedOverScale = 0.0;
  for (std::size_t k = 1; k <= N && static_cast<int>(k) <= options.order; ++k) {
    factorA *= perUnitA * static_cast<double>(k);
    factorB *= perUnitB * static_cast<double>(k);
    const Vector3 p = factorA * a.jet.c[k];
    const Vector3 q = factorB * b.jet.c[k];
    const double larger = std::sqrt(std::max(p.squaredNorm(), q.squaredNorm()));
    if (k == 1) speedOverScale = larger / scale;
    least *= speedOverScale;
    const double size = std::max(larger, least);
    const double error = factorA * a.jet.error[k] + factorB * b.jet.error[k];
    const double difference = differenceNorm(p, q, k);
    decision.parametricResiduals[k] = size > 0.0 ? difference / size : 0.0;
    const double tolerance = k == 1 ? options.tolerances.angleDegrees / kDegrees
                                    : options.tolerances.ofOrder(static_cast<int>(k));
    if (order == static_cast<int>(k) - 1 && difference + error <= tolerance * size) order = static_cast<int>(k);
  }
  return order;
}

template <int N>
[[gnu::always_inline]] inline void decide(const End<N>& a, const End<N>& b, const JoinSide& arriving,
                                          const JoinSide& leaving, double scale,
                                          const AnalysisOptions& options, JoinDecision& decision) {
  setResiduals(a, b, scale, decision);
  decision.order = -1;
  for (int k = 0; k <= N && k <= options.order; ++k) {
    const auto i = static_cast<std::size_t>(k);
    decision.verdicts[i] =
        judge(decision.residuals[i], decision.uncertainties[i], options.tolerances.ofOrder(k));
    if (decision.order == k - 1 && decision.verdicts[i] == Verdict::kPass) decision.order = k;
  }
  decision.parametricOrder = parametricOrder(a, b, arriving, leaving, scale, options, decision);
}

}  // namespace osculate::kernel
