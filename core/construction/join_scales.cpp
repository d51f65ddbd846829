#include "osculate/construction/join_scales.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "osculate/bezier/bernstein.h"
#include "osculate/construction/curve_chain.h"
#include "osculate/continuity/tolerances.h"
#include "osculate/differential/arc_length.h"

namespace osculate {

namespace {

/// How far the mean speeds of linked curves may be apart before their knots crowd.
constexpr double kLargestSpeedRatio = 0x1p20;

/// How a curve moves at one of its ends, in the direction of travel.
struct EndMotion {
  int order = 0;                         ///< of the first derivative that is not zero
  Vector3 derivative = Vector3::Zero();  ///< by the curve's own parameter
  double legMm = 0.0;                    ///< of the control polygon
};

/// Nothing where the end segment is a point.
std::optional<EndMotion> endMotion(const BSplineCurve& curve, CurveEnd end, double rounding) {
  const bool isEnd = end == CurveEnd::kEnd;
  const BezierSegment segment = curve.segment(isEnd ? curve.spanCount() - 1 : 0);
  const BezierCurve outward = isEnd ? segment.curve.reversed() : segment.curve;
  double factor = 1.0;
  for (int m = 1; m <= outward.degree(); ++m) {
    // while P_1 .. P_{m-1} = P_0: the m-th derivative is n! / (n-m)! w_m / w_0 (P_m - P_0)
    factor *= (outward.degree() - m + 1) / segment.length() * (isEnd ? -1.0 : 1.0);
    const Vector3 leg = outward.pole(m) - outward.pole(0);
    if (leg.norm() <= rounding) continue;
    return EndMotion{m, factor * outward.weight(m) / outward.weight(0) * leg, leg.norm()};
  }
  return {};
}

/// scale(second) / scale(first) that makes the derivatives agree; nothing at a corner.
std::optional<double> matchingRatio(const BSplineCurve& first, const BSplineCurve& second,
                                    double toleranceMm) {
  const double rounding = roundingMm(first, second);
  const auto before = endMotion(first, CurveEnd::kEnd, rounding);
  const auto after = endMotion(second, CurveEnd::kStart, rounding);
  if (!before || !after || before->order != after->order) return {};
  const Vector3 turn = after->derivative.normalized() - before->derivative.normalized();
  const double angle = 2.0 * std::asin(std::min(1.0, 0.5 * turn.norm()));
  constexpr double kDegrees = 180.0 / std::numbers::pi;
  const double legs = before->legMm * after->legMm / (before->legMm + after->legMm);
  const bool smooth =
      angle * kDegrees <= Tolerances{}.angleDegrees || legs * turn.norm() <= toleranceMm;
  if (!smooth) return {};
  const double ratio =
      std::pow(after->derivative.norm() / before->derivative.norm(), 1.0 / before->order);
  // parts of one curve keep its parameter: 1 where the poles do not tell it from that
  const double uncertainty = rounding / 16.0 / std::min(before->legMm, after->legMm);
  return std::abs(ratio - 1.0) <= uncertainty ? 1.0 : ratio;
}

double interval(const BSplineCurve& curve) { return curve.last() - curve.first(); }

/// Scales along the chain, run by run: a run is what smooth joins link.
class Runs {
 public:
  Runs(std::span<const BSplineCurve> curves, bool closed, double toleranceMm)
      : curves_(curves), ratios_(curves.size()), result_{} {
    for (std::size_t i = 0; i < curves.size(); ++i) {
      if (i + 1 == curves.size() && !closed) continue;
      ratios_[i] = matchingRatio(curves[i], curves[(i + 1) % curves.size()], toleranceMm);
    }
    result_.scales.assign(curves.size(), 0.0);
  }

  JoinScales solve() && {
    const std::size_t count = curves_.size();
    const std::size_t begin = runStart();
    double speed = 0.0;
    for (std::size_t done = 0; done < count;) {
      const std::size_t first = (begin + done) % count;
      const std::size_t size = fillRun(first, count - done);
      if (size < count) {
        const double own = meanSpeed(first, size);
        if (done == 0) speed = own;
        scaleRun(first, size, own / speed);
      }
      done += size;
    }
    scaleRun(0, count, 1.0 / result_.scales[0]);
    return std::move(result_);
  }

 private:
  /// Where the run of the first curve begins: it may reach back across the closing.
  std::size_t runStart() const {
    std::size_t begin = 0;
    do {
      const std::size_t previous = (begin + curves_.size() - 1) % curves_.size();
      if (!ratios_[previous]) return begin;
      begin = previous;
    } while (begin != 0);
    return 0;
  }

  /// Scales from 1 on, relative to the first curve of the run. Returns how many curves it has.
  std::size_t fillRun(std::size_t begin, std::size_t most) {
    const std::size_t count = curves_.size();
    result_.scales[begin] = 1.0;
    const double speed = polygonLength(curves_[begin]) / interval(curves_[begin]);
    for (std::size_t size = 1; size < most; ++size) {
      const std::size_t last = (begin + size - 1) % count;
      const std::size_t next = (begin + size) % count;
      if (!ratios_[last]) return size;
      const double scale = result_.scales[last] * *ratios_[last];
      const double share = polygonLength(curves_[next]) / (scale * interval(curves_[next])) / speed;
      if (!(share <= kLargestSpeedRatio && share >= 1.0 / kLargestSpeedRatio)) return size;
      result_.scales[next] = scale;
    }
    return most;
  }

  void scaleRun(std::size_t begin, std::size_t size, double factor) {
    for (std::size_t i = 0; i < size; ++i)
      result_.scales[(begin + i) % curves_.size()] *= factor;
  }

  double meanSpeed(std::size_t begin, std::size_t size) const {
    double lengths = 0.0;
    double intervals = 0.0;
    for (std::size_t i = begin; i < begin + size; ++i) {
      const std::size_t k = i % curves_.size();
      lengths += length(curves_[k]);
      intervals += result_.scales[k] * interval(curves_[k]);
    }
    return lengths / intervals;
  }

  std::span<const BSplineCurve> curves_;
  std::vector<std::optional<double>> ratios_;
  JoinScales result_;
};

/// The weight of the pole at an end of a clamped curve.
double endWeight(const BSplineCurve& curve, CurveEnd end) {
  if (!curve.isRational()) return 1.0;
  return end == CurveEnd::kStart ? curve.data().weights.front() : curve.data().weights.back();
}

}  // namespace

JoinScales joinScales(std::span<const BSplineCurve> curves, bool closed, double toleranceMm) {
  JoinScales result = Runs(curves, closed, toleranceMm).solve();
  result.weights.push_back(1.0);
  for (std::size_t i = 1; i < curves.size(); ++i) {
    result.weights.push_back(result.weights.back() * endWeight(curves[i - 1], CurveEnd::kEnd) /
                             endWeight(curves[i], CurveEnd::kStart));
  }
  return result;
}

}  // namespace osculate
