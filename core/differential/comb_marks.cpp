#include "osculate/differential/comb_marks.h"

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

namespace osculate {

namespace {

constexpr double kClosest = 1e-9;     ///< a sample as near as this to a mark gives way to it
constexpr double kLocated = 1e-12;    ///< to so much of the interval roots are found
constexpr double kStandstill = 1e-8;  ///< a speed below this share of its surroundings is none

/// A number along the curve and the bound of its error.
struct Reading {
  double value;
  double error;
};

Reading growthOf(const CombPoint& p) { return {p.growth, p.growthError}; }

/// The derivative of |dP/dt|, which changes its sign at a cusp.
Reading accelerationOf(const CombPoint& p) { return {p.speed[1], 0.0}; }

/// The root between two points where the reading has opposite signs, and how far off it can be.
template <class Read>
CombPoint rootBetween(const SegmentSampler& sampler, const CombPoint& a, const CombPoint& b,
                      const Read& read) {
  const auto value = [&](double t) { return read(sampler.at(t)).value; };
  const auto isLocated = [](double low, double high) { return high - low <= kLocated; };
  std::uintmax_t steps = 60;
  const double atA = read(a).value;
  const double atB = read(b).value;
  const auto [low, high] =
      boost::math::tools::toms748_solve(value, a.t, b.t, atA, atB, isLocated, steps);
  CombPoint root = sampler.at(0.5 * (low + high));
  const double slope = std::abs(atB - atA) / (b.t - a.t);
  root.uncertainty = root.speed[0] * (0.5 * (high - low) + read(root).error / slope);
  return root;
}

/// Calls `found(i, j, sign)` for points i < j of one run between which the reading turns to `sign`;
/// between them are only points where rounding hides its sign.
template <class Read, class Found>
void forEachChange(const std::vector<CombPoint>& points, const Read& read, const Found& found) {
  std::size_t last = 0;
  int sign = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Reading reading = read(points[i]);
    if (std::isnan(reading.value)) sign = 0;
    const int own = signOf(reading.value, reading.error);
    if (own != 0) {
      if (sign == -own) found(last, i, own);
      last = i;
      sign = own;
    }
    if (points[i].endsRun) sign = 0;
  }
}

/// A new point, or the two sides of a break.
struct Addition {
  CombPoint first;
  std::optional<CombPoint> second;
};
using Additions = std::vector<Addition>;

void addBreak(const SegmentSampler& sampler, const CombPoint& at, Contact contact,
              Additions& additions) {
  CombPoint before = sampler.at(at.t, Limit::kFromBefore, contact);
  CombPoint after = sampler.at(at.t, Limit::kFromAfter, contact);
  before.endsRun = true;
  after.marks = at.marks;
  before.uncertainty = after.uncertainty = at.uncertainty;
  additions.push_back({before, after});
}

/// An extremum of the curvature: an inflection, a point where it touches zero, or a vertex.
void addExtremum(const SegmentSampler& sampler, const CombPoint& a, const CombPoint& b, int sign,
                 const CombOptions& options, Additions& additions) {
  CombPoint root = rootBetween(sampler, a, b, growthOf);
  const bool isLeast = sign > 0;
  if (isLeast && root.isFlat) {
    const bool reverses = a.curvatureVector.dot(b.curvatureVector) < 0.0;
    root.marks = bitOf(reverses ? CombMarkKind::kInflection : CombMarkKind::kVertex);
    addBreak(sampler, root, reverses ? Contact::kTurning : Contact::kTouching, additions);
    return;
  }
  root.marks = bitOf(CombMarkKind::kVertex);
  if (!isLeast && options.shown[0]) root.marks |= bitOfPeak(0);
  additions.push_back({root, {}});
}

/// The two sides of a cusp: nothing but the tangents exists there.
void addCusp(const SegmentSampler& sampler, const CombPoint& at, Additions& additions) {
  CombPoint before = sampler.at(at.t - kClosest);
  CombPoint after = sampler.at(at.t + kClosest);
  for (CombPoint* side : {&before, &after}) {
    side->t = at.t;
    side->point = at.point;
    side->normal.setConstant(kNaN);
    side->binormal.setConstant(kNaN);
    side->value.fill(kNaN);
    side->growth = kNaN;
    side->speed.fill(kNaN);
    side->uncertainty = at.uncertainty;
  }
  before.endsRun = true;
  after.marks = bitOf(CombMarkKind::kCusp);
  additions.push_back({before, after});
}

/// Between neighbours whose tangents are opposite: where the speed is zero, or nowhere.
void addCuspBetween(const SegmentSampler& sampler, const CombPoint& a, const CombPoint& b,
                    Additions& additions) {
  if (!(a.speed[1] < 0.0 && b.speed[1] > 0.0)) return;
  const CombPoint root = rootBetween(sampler, a, b, accelerationOf);
  const bool stands = root.isSingular || root.speed[0] < kStandstill * (a.speed[0] + b.speed[0]);
  if (stands) addCusp(sampler, root, additions);
}

/// A sample may lie on a cusp.
void addCusps(const SegmentSampler& sampler, const std::vector<CombPoint>& points,
              Additions& additions) {
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const CombPoint& a = points[i];
    const CombPoint& b = points[i + 1];
    if (b.isSingular && i + 2 < points.size()) {
      if (a.tangent.dot(points[i + 2].tangent) < 0.0) addCusp(sampler, b, additions);
    } else if (!a.isSingular && a.tangent.dot(b.tangent) < 0.0) {
      addCuspBetween(sampler, a, b, additions);
    }
  }
}

/// Puts an addition in the place of a sample that is as good as there.
void replace(const CombPoint& old, Addition& addition) {
  CombPoint& last = addition.second ? *addition.second : addition.first;
  last.isTooth = old.isTooth;
  last.marks |= old.marks;
  last.endsRun = old.endsRun;
}

/// Merges the additions, which are in their order, into the points; what is as good as at an end of
/// the segment is left to the joins.
void insert(Additions& additions, std::vector<CombPoint>& points) {
  if (additions.empty()) return;
  std::vector<CombPoint> merged;
  merged.reserve(points.size() + 2 * additions.size());
  auto next = additions.begin();
  const auto place = [&](const auto& addition) { return addition->first.t; };
  while (next != additions.end() && place(next) <= kClosest)
    ++next;
  for (const CombPoint& point : points) {
    bool isReplaced = false;
    for (; next != additions.end() && place(next) <= point.t + kClosest; ++next) {
      if (place(next) >= 1.0 - kClosest) continue;
      isReplaced = place(next) >= point.t - kClosest;
      if (isReplaced) replace(point, *next);
      merged.push_back(next->first);
      if (next->second) merged.push_back(*next->second);
    }
    if (!isReplaced) merged.push_back(point);
  }
  points = std::move(merged);
}

void markPeaks(const SegmentSampler& sampler, std::size_t quantity,
               std::vector<CombPoint>& points) {
  const Rate rate = kRateOf[quantity];
  const auto read = [&](const CombPoint& p) { return Reading{p.value[rate], p.error[rate]}; };
  Additions additions;
  forEachChange(points, read, [&](std::size_t i, std::size_t j, int sign) {
    CombPoint root = rootBetween(sampler, points[i], points[j], read);
    if (!(sign * root.value[quantity] < -root.error[quantity])) return;  // least in magnitude
    root.marks = bitOfPeak(quantity);
    additions.push_back({root, {}});
  });
  insert(additions, points);
}

}  // namespace

void markSegment(const SegmentSampler& sampler, const CombOptions& options,
                 std::vector<CombPoint>& points) {
  Additions additions;
  addCusps(sampler, points, additions);
  insert(additions, points);
  additions.clear();
  forEachChange(points, growthOf, [&](std::size_t i, std::size_t j, int sign) {
    addExtremum(sampler, points[i], points[j], sign, options, additions);
  });
  insert(additions, points);
  for (std::size_t q = 1; q < kCombQuantities; ++q) {
    if (options.shown[q]) markPeaks(sampler, q, points);
  }
}

}  // namespace osculate
