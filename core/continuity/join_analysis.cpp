#include "osculate/continuity/join_analysis.h"

#include "osculate/bezier/bernstein.h"
#include "osculate/continuity/join_definitions.h"
#include "osculate/continuity/join_kernel.h"

namespace osculate {

namespace {

using kernel::End;

/// The derivatives 0..4 in the direction of travel as rows, in the frame.
template <int N>
Eigen::Matrix<double, 5, 3> derivativesIn(const FrenetFrame& frame, const Jet<N>& jet, bool arrives,
                                          const Vector3& origin) {
  Eigen::Matrix<double, 5, 3> rows;
  const auto components = [&](const Vector3& v) {
    return Eigen::RowVector3d(v.dot(frame.tangent), v.dot(*frame.normal), v.dot(*frame.binormal));
  };
  rows.row(0) = components(jet.point - origin);
  for (int k = 1; k <= 4; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const double sign = arrives && k % 2 == 1 ? -1.0 : 1.0;
    rows.row(k) = sign * detail::kFactorials[i] * components(jet.c[i]);
  }
  return rows;
}

/// beta(t) = t_first(s_second(t)): equal arc lengths on both sides, as a truncated series.
template <int N>
void setBeta(const ArcJet<N>& arriving, const ArcJet<N>& leaving, JoinReport& report) {
  std::array<double, N + 1> forward;  // t(s) in the direction of travel
  for (std::size_t k = 0; k <= N; ++k) forward[k] = k % 2 == 1 ? arriving.parameter[k] : -arriving.parameter[k];
  std::array<double, N + 1> sum{};
  std::array<double, N + 1> power = leaving.arcLength;
  for (std::size_t j = 1; j <= N; ++j) {
    for (std::size_t k = j; k <= N; ++k) sum[k] += forward[j] * power[k];
    std::array<double, N + 1> next{};
    for (std::size_t k = j + 1; k <= N; ++k) {
      next[k] = series::nextPower(leaving.arcLength.data(), power.data(), static_cast<int>(j + 1), static_cast<int>(k));
    }
    power = next;
  }
  for (std::size_t k = 1; k <= N; ++k) report.beta[k - 1] = detail::kFactorials[k] * sum[k];
}

/// beta_k exists up to the order before the first that fails, between regular ends.
int betaCount(const JoinReport& report) {
  int count = 0;
  if (report.verdicts[0] == Verdict::kFail) return 0;
  while (count < report.requestedOrder &&
         report.verdicts[static_cast<std::size_t>(count) + 1] != Verdict::kFail) {
    ++count;
  }
  return count;
}

template <int N>
[[gnu::always_inline]] inline SideReport describeSide(const JoinSide& side, const End<N>& end, bool arrives,
                                                      double scale) {
  SideReport report;
  report.end = side.end;
  report.point = end.jet.point;
  const double flatBelow = std::max(end.arc.error[2], kFlatness / scale);
  const ArcInvariants arc = arcInvariants(inTravel(end.arc, arrives), end.arc.smoothness, flatBelow);
  report.frame = arc.frame;
  report.invariants = arc.invariants;
  report.linearity = linearity(side.segment, side.end, side.poleError);
  report.multiplicity = end.arc.multiplicity;
  report.smoothness = end.singular ? end.arc.smoothness : kMaxOrder;
  return report;
}

/// Completes the first side's frame by the thesis's special cases.
void setFrame(const JoinSide& side, JoinReport& report) {
  const SideReport& first = report.sides[0];
  report.frame = first.frame;
  report.frameKind = first.multiplicity > 1 ? FrameKind::kFictitiousTangent : FrameKind::kFrenet;
  if (first.frame.normal) return;
  const EndFrame chosen =
      fictitiousFrame(side.segment, side.end, first.frame.tangent, first.multiplicity > 1, side.poleError);
  report.frame = chosen.frame;
  report.frameKind = chosen.kind;
}

std::optional<double> absoluteDifference(const std::optional<double>& a, const std::optional<double>& b) {
  if (!a || !b) return std::nullopt;
  return std::abs(*a - *b);
}

template <int N>
void setDeviation(const End<N>& a, const End<N>& b, JoinReport& report) {
  Deviation& deviation = report.deviation;
  const auto& [first, second] = report.sides;
  deviation.gapMm = report.residuals[0];
  const int exists = std::min(a.arc.smoothness, b.arc.smoothness);
  if (exists >= 1) deviation.tangentAngleDegrees = report.residuals[1];
  if (exists >= 2) {
    deviation.curvatureVectorPerMm = (a.arc.r[2] - b.arc.r[2]).norm();
    const double larger = std::max(a.arc.norm[2], b.arc.norm[2]);
    if (larger > 0.0) deviation.curvatureRelative = std::abs(a.arc.norm[2] - b.arc.norm[2]) / larger;
  }
  if (first.frame.binormal && second.frame.binormal) {
    deviation.osculatingPlaneAngleDegrees =
        kernel::kDegrees * kernel::angleBetween(*first.frame.binormal, *second.frame.binormal);
  }
  deviation.torsionPerMm = absoluteDifference(first.invariants.torsion, second.invariants.torsion);
  deviation.curvatureRatePerMm2 =
      absoluteDifference(first.invariants.curvatureRate, second.invariants.curvatureRate);
  deviation.torsionRatePerMm2 = absoluteDifference(first.invariants.torsionRate, second.invariants.torsionRate);
  deviation.curvatureRate2PerMm3 =
      absoluteDifference(first.invariants.curvatureRate2, second.invariants.curvatureRate2);
}

template <int N>
void setWarnings(const End<N>& a, const End<N>& b, const std::array<BezierView, 2>& segments, JoinReport& report) {
  for (std::size_t k = 0; k <= static_cast<std::size_t>(report.requestedOrder); ++k) {
    if (report.verdicts[k] == Verdict::kUndecided) report.warnings.add(Warning::kUndecided);
  }
  const auto& angle = report.deviation.tangentAngleDegrees;
  if (angle && *angle + report.tolerances[1] >= 180.0) report.warnings.add(Warning::kCusp);
  for (std::size_t i = 0; i < 2; ++i) {
    const SideReport& side = report.sides[i];
    if (side.multiplicity > 1) {
      report.warnings.add(Warning::kDegenerateTangent);
      if (side.smoothness < report.requestedOrder) report.warnings.add(Warning::kFractionalSmoothness);
    }
    const bool straight = side.linearity == segments[i].degree;
    if (side.smoothness >= 2 && !side.frame.normal && !straight) report.warnings.add(Warning::kNearFlat);
  }
  constexpr double kFar = 1e6;
  if (std::max(a.jet.size, b.jet.size) > kFar * report.scaleMm) report.warnings.add(Warning::kFarFromOrigin);
}

template <int N>
JoinReport analyze(const JoinSide& arriving, const JoinSide& leaving, const AnalysisOptions& options) {
  JoinReport report;
  report.requestedOrder = options.order;
  report.preset = options.tolerances.name;
  report.metric = options.tolerances.metric;
  report.scaleMm = kernel::scaleOf(arriving, leaving, options);
  for (int k = 0; k <= options.order; ++k) {
    report.tolerances[static_cast<std::size_t>(k)] = options.tolerances.ofOrder(k);
  }
  const End<N> a = kernel::makeEnd<N>(arriving);
  const End<N> b = kernel::makeEnd<N>(leaving);
  kernel::decide(a, b, arriving, leaving, report.scaleMm, options, report);
  if (!a.singular && !b.singular) {
    report.betaCount = betaCount(report);
    if (report.betaCount > 0) setBeta(a.arc, b.arc, report);
  }
  report.sides = {describeSide(arriving, a, true, report.scaleMm), describeSide(leaving, b, false, report.scaleMm)};
  setFrame(arriving, report);
  report.derivativesInFrame = {derivativesIn(report.frame, a.jet, true, a.jet.point),
                               derivativesIn(report.frame, b.jet, false, a.jet.point)};
  setDeviation(a, b, report);
  setDefinitions(options.tolerances, report);
  setWarnings(a, b, {arriving.segment, leaving.segment}, report);
  return report;
}

template <int N>
JoinDecision decision(const JoinSide& arriving, const JoinSide& leaving, const AnalysisOptions& options) {
  JoinDecision result;
  const double scale = kernel::scaleOf(arriving, leaving, options);
  const End<N> a = kernel::makeEnd<N>(arriving);
  const End<N> b = kernel::makeEnd<N>(leaving);
  kernel::decide(a, b, arriving, leaving, scale, options, result);
  return result;
}

}  // namespace

JoinReport analyzeJoin(const JoinSide& arriving, const JoinSide& leaving, const AnalysisOptions& options) {
  return options.order <= 4 ? analyze<4>(arriving, leaving, options) : analyze<kMaxOrder>(arriving, leaving, options);
}

JoinDecision decideJoin(const JoinSide& arriving, const JoinSide& leaving, const AnalysisOptions& options) {
  return options.order <= 4 ? decision<4>(arriving, leaving, options)
                            : decision<kMaxOrder>(arriving, leaving, options);
}

double reachOf(BezierView segment, CurveEnd end) {
  const int n = segment.degree;
  const Vector3 join = segment.pole(end == CurveEnd::kStart ? 0 : n);
  const Vector3 other = segment.pole(end == CurveEnd::kStart ? n : 0);
  Vector3 middle = Vector3::Zero();  // sum of C(n,i) w_i (b_i - join), the weights not yet divided out
  double weights = 0.0;
  for (int i = 0; i <= n; ++i) {
    const double weight = binomial(n, i) * segment.weight(i);
    middle += weight * (segment.pole(i) - join);
    weights += weight;
  }
  return std::sqrt(std::max((other - join).squaredNorm(), middle.squaredNorm() / (weights * weights)));
}

}  // namespace osculate
