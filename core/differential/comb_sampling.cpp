#include "osculate/differential/comb_sampling.h"

#include <algorithm>
#include <cmath>

namespace osculate {

namespace {

constexpr int kDeepest = 6;          ///< halvings of an even interval
constexpr double kTurn = 0.9659258;  ///< cosine of 15 degrees
constexpr double kNoise = 4.0;       ///< what is below so many error bounds is not looked at

/// Whether the tangent turns far between two points.
bool turns(const CombPoint& a, const CombPoint& b) { return !(a.tangent.dot(b.tangent) > kTurn); }

/// Whether a quantity with these values and rates bends away from its chord: the cubic with them
/// does so by ds |r_b - r_a| / 8 in the middle, to leading order.
bool bends(const CombPoint& a, const CombPoint& b, std::size_t quantity, double arc,
           double tolerance) {
  const Rate rate = kRateOf[quantity];
  const double bend = 0.125 * arc * std::abs(b.value[rate] - a.value[rate]);
  const double size = std::max(std::abs(a.value[quantity]), std::abs(b.value[quantity]));
  const double noise =
      a.error[quantity] + b.error[quantity] + 0.125 * arc * (a.error[rate] + b.error[rate]);
  return bend > tolerance * size + kNoise * noise;  // false for NaN
}

bool needsMore(const CombPoint& a, const CombPoint& b, const CombOptions& options) {
  if (turns(a, b)) return true;
  const double arc = 0.5 * (a.speed[0] + b.speed[0]) * (b.t - a.t);
  for (std::size_t q = 0; q < kCombQuantities; ++q) {
    if (options.shown[q] && bends(a, b, q, arc, options.tolerance)) return true;
  }
  return false;
}

/// Points at the given parameters, two at a time.
void evaluateAt(const SegmentSampler& sampler, const std::vector<double>& parameters,
                std::vector<CombPoint>& points) {
  points.resize(parameters.size());
  std::size_t i = 0;
  for (; i + 1 < parameters.size(); i += 2)
    sampler.at(parameters[i], parameters[i + 1], points[i], points[i + 1]);
  if (i < parameters.size()) points[i] = sampler.at(parameters[i]);
}

void sampleEvenly(const SegmentSampler& sampler, int intervals, std::vector<CombPoint>& points) {
  std::vector<double> parameters(static_cast<std::size_t>(intervals) + 1);
  for (std::size_t i = 0; i < parameters.size(); ++i)
    parameters[i] = static_cast<double>(i) / intervals;
  evaluateAt(sampler, parameters, points);
  if (points.front().isFlat) points.front() = sampler.at(0.0, Limit::kFromAfter);
  if (points.back().isFlat) points.back() = sampler.at(1.0, Limit::kFromBefore);
  for (CombPoint& point : points)
    point.isTooth = true;
}

/// Halves the intervals that need it; false if none did.
bool refineOnce(const SegmentSampler& sampler, const CombOptions& options,
                std::vector<CombPoint>& points) {
  std::vector<std::size_t> before;  // a new point follows each of these
  std::vector<double> parameters;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    if (!needsMore(points[i], points[i + 1], options)) continue;
    before.push_back(i);
    parameters.push_back(0.5 * (points[i].t + points[i + 1].t));
  }
  if (before.empty()) return false;
  std::vector<CombPoint> added;
  evaluateAt(sampler, parameters, added);
  std::size_t to = points.size() + added.size();
  std::size_t from = points.size();
  points.resize(to);
  for (std::size_t k = added.size(); k-- > 0;) {  // from behind, in place
    while (from > before[k] + 1)
      points[--to] = points[--from];
    points[--to] = added[k];
  }
  return true;
}

}  // namespace

void sampleSegment(const SegmentSampler& sampler, const CombOptions& options,
                   std::vector<CombPoint>& points) {
  const int intervals = std::max(options.density, 2 * sampler.segment().curve.degree());
  sampleEvenly(sampler, intervals, points);
  for (int depth = 0; options.tolerance > 0.0 && depth < kDeepest; ++depth) {
    if (!refineOnce(sampler, options, points)) return;
  }
}

}  // namespace osculate
