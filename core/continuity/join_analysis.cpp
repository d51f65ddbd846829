#include "osculate/continuity/join_analysis.h"

#include "osculate/bezier/bernstein.h"
#include "osculate/continuity/join_definitions.h"
#include "osculate/continuity/join_kernel.h"

namespace osculate {

namespace {

using kernel::Ends;

/// The derivatives 0..4 of both sides in the direction of travel as rows, in the frame.
template <int N>
[[gnu::always_inline]] inline void setDerivatives(const Ends<N>& ends, JoinReport& report) {
  const FrenetFrame& frame = report.frame;
  const LanesVector axes[3] = {frame.tangent.cast<Lanes>(), frame.normal->cast<Lanes>(),
                               frame.binormal->cast<Lanes>()};
  const Vector3 offset = ends.jets[1].point - ends.jets[0].point;
  for (int axis = 0; axis < 3; ++axis) {
    const auto set = [&](int row, const LanesVector& derivative, Lanes factor) {
      const Lanes component = factor * derivative.dot(axes[axis]);
      report.derivativesInFrame[0](row, axis) = component[0];
      report.derivativesInFrame[1](row, axis) = component[1];
    };
    set(0, zip(Vector3::Zero(), offset), Lanes(1.0));
    set(1, ends.c[1], Lanes(-1.0, 1.0));
    set(2, ends.c[2], Lanes(2.0));
    set(3, ends.c[3], Lanes(-6.0, 6.0));
    set(4, ends.c[4], Lanes(24.0));
  }
}

/// beta(t) = t_first(s_second(t)): equal arc lengths on both sides, as a truncated series.
template <int N>
[[gnu::always_inline]] inline void setBeta(const ArcJet<N, Lanes>& arc, JoinReport& report) {
  std::array<double, N + 1> s;  // of the second curve's parameter
  for (std::size_t k = 0; k <= N; ++k)
    s[k] = arc.arcLength[k][1];
  std::array<double, N + 1> sum{};
  std::array<double, N + 1> power = s;  // s^j
  for (std::size_t j = 1; j <= N; ++j) {
    const double outward = arc.parameter[j][0];
    const double forward = j % 2 == 1 ? outward : -outward;  // -t(-s) of the arriving curve
    for (std::size_t k = j; k <= N; ++k)
      sum[k] += forward * power[k];
    // from the highest coefficient down, so that s^(j+1) can take the place of s^j
    for (std::size_t k = N; k > j; --k) {
      power[k] =
          series::nextPower(s.data(), power.data(), static_cast<int>(j + 1), static_cast<int>(k));
    }
  }
  for (std::size_t k = 1; k <= N; ++k)
    report.beta[k - 1] = detail::kFactorials[k] * sum[k];
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
[[gnu::always_inline]] inline void describeSide(const JoinSide& side, const Ends<N>& ends,
                                                const ArcNumbers<Lanes>& numbers, int lane,
                                                JoinReport& report) {
  const auto i = static_cast<std::size_t>(lane);
  SideReport& out = report.sides[i];
  out.end = side.end;
  out.point = ends.jets[i].point;
  out.multiplicity = ends.multiplicity[i];
  out.smoothness = ends.multiplicity[i] > 1 ? ends.smoothness[i] : kMaxOrder;
  out.linearity =
      legsOnTangent(side.segment, side.end, lineTolerance(ends.jets[i].size, side.poleError));
  const double flatBelow = std::max(ends.arc.error[2][lane], kFlatness / report.scaleMm);
  storeNumbers(numbers, lane, ends.smoothness[i], flatBelow, out.frame, out.invariants);
}

/// Completes the first side's frame by the thesis's special cases.
void setFrame(const JoinSide& side, JoinReport& report) {
  const SideReport& first = report.sides[0];
  report.frame = first.frame;
  report.frameKind = first.multiplicity > 1 ? FrameKind::kFictitiousTangent : FrameKind::kFrenet;
  if (first.frame.normal) return;
  const EndFrame chosen = fictitiousFrame(side.segment, side.end, first.frame.tangent,
                                          first.multiplicity > 1, side.poleError);
  report.frame = chosen.frame;
  report.frameKind = chosen.kind;
}

std::optional<double> absoluteDifference(const std::optional<double>& a,
                                         const std::optional<double>& b) {
  if (!a || !b) return std::nullopt;
  return std::abs(*a - *b);
}

template <int N>
void setDeviation(const Ends<N>& ends, const ArcNumbers<Lanes>& numbers, JoinReport& report) {
  Deviation& deviation = report.deviation;
  const auto& [first, second] = report.sides;
  deviation.gapMm = report.residuals[0];
  const int exists = ends.commonSmoothness();
  if (exists >= 1) deviation.tangentAngleDegrees = report.residuals[1];
  if (exists >= 2) {
    deviation.curvatureVectorPerMm = std::sqrt(kernel::squaredDifference(ends.arc.r[2], 2));
    const double larger = std::max(numbers.curvature[0], numbers.curvature[1]);
    if (larger > 0.0)
      deviation.curvatureRelative = std::abs(numbers.curvature[0] - numbers.curvature[1]) / larger;
  }
  if (first.frame.binormal && second.frame.binormal) {
    deviation.osculatingPlaneAngleDegrees =
        kernel::kDegrees * kernel::angleBetween(*first.frame.binormal, *second.frame.binormal);
  }
  deviation.torsionPerMm = absoluteDifference(first.invariants.torsion, second.invariants.torsion);
  deviation.curvatureRatePerMm2 =
      absoluteDifference(first.invariants.curvatureRate, second.invariants.curvatureRate);
  deviation.torsionRatePerMm2 =
      absoluteDifference(first.invariants.torsionRate, second.invariants.torsionRate);
  deviation.curvatureRate2PerMm3 =
      absoluteDifference(first.invariants.curvatureRate2, second.invariants.curvatureRate2);
}

template <int N>
void setWarnings(const Ends<N>& ends, const std::array<BezierView, 2>& segments,
                 JoinReport& report) {
  for (std::size_t k = 0; k <= static_cast<std::size_t>(report.requestedOrder); ++k) {
    if (report.verdicts[k] == Verdict::kUndecided) report.warnings.add(Warning::kUndecided);
  }
  const auto& angle = report.deviation.tangentAngleDegrees;
  if (angle && *angle + report.tolerances[1] >= 180.0) report.warnings.add(Warning::kCusp);
  for (std::size_t i = 0; i < 2; ++i) {
    const SideReport& side = report.sides[i];
    if (side.multiplicity > 1) {
      report.warnings.add(Warning::kDegenerateTangent);
      if (side.smoothness < report.requestedOrder)
        report.warnings.add(Warning::kFractionalSmoothness);
    }
    const bool straight = side.linearity == segments[i].degree;
    if (side.smoothness >= 2 && !side.frame.normal && !straight)
      report.warnings.add(Warning::kNearFlat);
  }
  constexpr double kFar = 1e6;
  if (std::max(ends.jets[0].size, ends.jets[1].size) > kFar * report.scaleMm)
    report.warnings.add(Warning::kFarFromOrigin);
}

template <int N>
JoinReport analyze(const JoinSide& arriving, const JoinSide& leaving,
                   const AnalysisOptions& options) {
  JoinReport report;
  report.requestedOrder = options.order;
  report.preset = options.tolerances.name;
  report.metric = options.tolerances.metric;
  report.scaleMm = kernel::scaleOf(arriving, leaving, options);
  for (int k = 0; k <= options.order; ++k) {
    report.tolerances[static_cast<std::size_t>(k)] = options.tolerances.ofOrder(k);
  }
  const Ends<N> ends(arriving, leaving);
  kernel::decide(ends, arriving, leaving, report.scaleMm, options, report);
  if (ends.regular()) {
    report.betaCount = betaCount(report);
    if (report.betaCount > 0) setBeta(ends.arc, report);
  }
  const auto numbers = arcNumbers(inTravel(ends.arc.r, Lanes(-1.0, 1.0)));
  describeSide(arriving, ends, numbers, 0, report);
  describeSide(leaving, ends, numbers, 1, report);
  setFrame(arriving, report);
  setDerivatives(ends, report);
  setDeviation(ends, numbers, report);
  setDefinitions(options.tolerances, report);
  setWarnings(ends, {arriving.segment, leaving.segment}, report);
  return report;
}

template <int N>
JoinDecision decision(const JoinSide& arriving, const JoinSide& leaving,
                      const AnalysisOptions& options) {
  JoinDecision result;
  const double scale = kernel::scaleOf(arriving, leaving, options);
  kernel::decide(Ends<N>(arriving, leaving), arriving, leaving, scale, options, result);
  return result;
}

}  // namespace

JoinReport analyzeJoin(const JoinSide& arriving, const JoinSide& leaving,
                       const AnalysisOptions& options) {
  return options.order <= 4 ? analyze<4>(arriving, leaving, options)
                            : analyze<kMaxOrder>(arriving, leaving, options);
}

JoinDecision decideJoin(const JoinSide& arriving, const JoinSide& leaving,
                        const AnalysisOptions& options) {
  return options.order <= 4 ? decision<4>(arriving, leaving, options)
                            : decision<kMaxOrder>(arriving, leaving, options);
}

double reachOf(BezierView segment, CurveEnd end) {
  const int n = segment.degree;
  const double* binomials = detail::kBinomials[static_cast<std::size_t>(n)].data();
  // sums of C(n,i) w_i and of C(n,i) w_i b_i, 2^n times the homogeneous middle point; by component,
  // which the compiler makes more of here than of vectors
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
  double weights = segment.weights == nullptr ? static_cast<double>(1 << n) : 0.0;
  const double* pole = segment.poles;
  for (int i = 0; i <= n; ++i, pole += 3) {
    double factor = binomials[i];
    if (segment.weights != nullptr) weights += factor *= segment.weights[i];
    x += factor * pole[0];
    y += factor * pole[1];
    z += factor * pole[2];
  }
  const Vector3 join = segment.pole(end == CurveEnd::kStart ? 0 : n);
  const Vector3 other = segment.pole(end == CurveEnd::kStart ? n : 0);
  const Vector3 middle = Vector3(x, y, z) / weights;
  const double reach =
      std::sqrt(std::max((other - join).squaredNorm(), (middle - join).squaredNorm()));
  if (!isBackAtJoin(reach, segment, end)) [[likely]]
    return reach;
  const BezierCurve curve(segment);
  return std::max((curve.evaluate(kGoldenSection) - join).norm(),
                  (curve.evaluate(1.0 - kGoldenSection) - join).norm());
}

bool isBackAtJoin(double reach, BezierView segment, CurveEnd end) {
  constexpr double kNothing = 1e-6;
  const auto squaredLeg = [&](int i) {
    const int n = segment.degree;
    const auto pole = [&](int k) { return segment.pole(end == CurveEnd::kStart ? k : n - k); };
    return (pole(i) - pole(0)).squaredNorm();
  };
  const double leg = std::max(squaredLeg(1), squaredLeg((segment.degree + 1) / 2));
  return reach * reach <= kNothing * kNothing * leg;
}

}  // namespace osculate
