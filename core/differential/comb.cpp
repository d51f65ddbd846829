#include "osculate/differential/comb.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "osculate/differential/comb_length.h"
#include "osculate/differential/comb_marks.h"
#include "osculate/differential/comb_sampling.h"

namespace osculate {

namespace {

constexpr int kMostIntervals = 10000;
constexpr double kClosingGap = 1e-7;     ///< mm
constexpr double kOpposite = -0.999999;  ///< cosine of the angle between normals that are opposite
constexpr double kSameMagnitude = 1e-9;  ///< relative

/// A point with the segment it belongs to.
struct Placed {
  CombPoint point;
  double parameter;
  double arcLength;
};

void check(const CombOptions& options) {
  if (options.density < 2 || options.density > kMostIntervals) {
    throw std::invalid_argument("density: must be from 2 to " + std::to_string(kMostIntervals) +
                                ", got " + std::to_string(options.density));
  }
  if (!(options.tolerance >= 0.0 && options.tolerance < 1.0)) {
    throw std::invalid_argument("tolerance: must be from 0 to below 1, got " +
                                std::to_string(options.tolerance));
  }
}

std::vector<Placed> placedPoints(const BSplineCurve& curve, const CombOptions& options) {
  const Flatness flatness(curve);
  std::vector<Placed> placed;
  std::vector<CombPoint> points;
  double arcLength = 0.0;
  for (int span = 0; span < curve.spanCount(); ++span) {
    const SegmentSampler sampler(flatness, curve.segment(span));
    const BezierSegment& segment = sampler.segment();
    sampleSegment(sampler, options, points);
    markSegment(sampler, options, points);
    points.back().endsRun = true;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double parameter = i + 1 == points.size()
                                   ? segment.last
                                   : std::lerp(segment.first, segment.last, points[i].t);
      placed.push_back({points[i], parameter, arcLength});
      if (i > 0) arcLength += lengthBetween(sampler, points[i - 1], points[i]);
      placed.back().arcLength = arcLength;
    }
  }
  return placed;
}

/// The marks at the joins of runs.
class JoinMarks {
 public:
  JoinMarks(std::vector<Placed>& points, const CombOptions& options)
      : points_(points), options_(options) {}

  /// The point before a join and that after it.
  void mark(std::size_t before, std::size_t after) {
    CombPoint& a = points_[before].point;
    CombPoint& b = points_[after].point;
    if (isInflection(a, b)) b.marks |= bitOf(CombMarkKind::kInflection);
    for (std::size_t q = 0; q < kCombQuantities; ++q) {
      const int rising = isWanted(q) ? -trend(before, q, -1) : 0;
      const int falling = isWanted(q) ? -trend(after, q, 1) : 0;
      markAt(a, b, q, rising, falling);
    }
  }

  /// The end of an open curve; `into` is the direction from there into the curve.
  void markEnd(std::size_t end, int into) {
    for (std::size_t q = 0; q < kCombQuantities; ++q) {
      if (options_.shown[q] && trend(end, q, into) < 0) points_[end].point.marks |= bitOfPeak(q);
    }
  }

 private:
  bool isWanted(std::size_t q) const { return q == 0 || options_.shown[q]; }

  /// Whether the magnitude of a quantity grows (1) or shrinks (-1) from a point in a direction,
  /// within its run; 0 where it stays.
  int trend(std::size_t from, std::size_t q, int direction) const {
    for (std::size_t i = from;; i += static_cast<std::size_t>(direction)) {
      const CombPoint& p = points_[i].point;
      const int slope = signOf(p.value[kRateOf[q]], p.error[kRateOf[q]]);
      if (slope != 0) return p.value[q] < 0.0 ? -slope * direction : slope * direction;
      const bool isLast = direction > 0 ? p.endsRun : i == 0 || points_[i - 1].point.endsRun;
      if (isLast) return 0;
    }
  }

  static bool isInflection(const CombPoint& a, const CombPoint& b) {
    return a.normal.dot(b.normal) < kOpposite && a.tangent.dot(b.tangent) > 0.0;
  }

  void markAt(CombPoint& a, CombPoint& b, std::size_t q, int rising, int falling) const {
    const double before = std::abs(a.value[q]);
    const double after = std::abs(b.value[q]);
    const double noise = a.error[q] + b.error[q] + kSameMagnitude * (before + after);
    if (std::abs(before - after) <= noise) {
      const bool isStationary = signOf(a.value[kRateOf[q]], a.error[kRateOf[q]]) == 0 &&
                                signOf(b.value[kRateOf[q]], b.error[kRateOf[q]]) == 0;
      const bool turns = rising * falling > 0;
      if (q == 0 && turns && isStationary && !a.isFlat) b.marks |= bitOf(CombMarkKind::kVertex);
      if (options_.shown[q] && rising > 0 && falling > 0) b.marks |= bitOfPeak(q);
    } else if (options_.shown[q] && rising > 0 && !(after > before)) {
      a.marks |= bitOfPeak(q);
    } else if (options_.shown[q] && falling > 0 && !(before > after)) {
      b.marks |= bitOfPeak(q);
    }
  }

  std::vector<Placed>& points_;
  const CombOptions& options_;
};

void markJoins(const BSplineCurve& curve, const CombOptions& options, std::vector<Placed>& points) {
  JoinMarks marks(points, options);
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    if (points[i].point.endsRun) marks.mark(i, i + 1);
  }
  if (curve.isClosed(kClosingGap)) {
    marks.mark(points.size() - 1, 0);
  } else {
    marks.markEnd(0, 1);
    marks.markEnd(points.size() - 1, -1);
  }
}

CombSample sampleOf(const Placed& placed) {
  const CombPoint& p = placed.point;
  CombSample sample{.parameter = placed.parameter,
                    .arcLength = placed.arcLength,
                    .point = p.point,
                    .tangent = p.tangent,
                    .normal = p.normal,
                    .binormal = p.binormal,
                    .value = {},
                    .isTooth = p.isTooth};
  std::copy_n(p.value.begin(), kCombQuantities, sample.value.begin());
  return sample;
}

void addMarks(const CombPoint& point, std::size_t sample, std::vector<CombMark>& marks) {
  for (const auto kind : {CombMarkKind::kInflection, CombMarkKind::kVertex, CombMarkKind::kCusp}) {
    if (point.marks & bitOf(kind))
      marks.push_back({kind, CombQuantity::kCurvature, sample, point.uncertainty});
  }
  for (std::size_t q = 0; q < kCombQuantities; ++q) {
    if (point.marks & bitOfPeak(q)) {
      marks.push_back(
          {CombMarkKind::kPeak, static_cast<CombQuantity>(q), sample, point.uncertainty});
    }
  }
}

}  // namespace

std::string_view name(CombQuantity quantity) {
  constexpr std::array<std::string_view, kCombQuantities> kNames{
      "curvature", "torsion", "curvature_rate", "curvature_rate2", "torsion_rate"};
  return kNames[static_cast<std::size_t>(quantity)];
}

std::string_view name(CombMarkKind kind) {
  constexpr std::array<std::string_view, 4> kNames{"inflection", "vertex", "cusp", "peak"};
  return kNames[static_cast<std::size_t>(kind)];
}

Comb comb(const BSplineCurve& curve, const CombOptions& options) {
  check(options);
  std::vector<Placed> points = placedPoints(curve, options);
  markJoins(curve, options, points);
  Comb result;
  result.samples.reserve(points.size());
  result.length = points.back().arcLength;
  std::size_t first = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    result.samples.push_back(sampleOf(points[i]));
    addMarks(points[i].point, i, result.marks);
    if (!points[i].point.endsRun) continue;
    result.runs.push_back({first, i});
    first = i + 1;
  }
  return result;
}

}  // namespace osculate
