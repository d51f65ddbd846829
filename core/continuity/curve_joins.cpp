#include "osculate/continuity/curve_joins.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <tuple>

#include "osculate/continuity/curve_side.h"

namespace osculate {

namespace {

void markApproximated(const BSplineCurve& curve, JoinReport& report) {
  if (isApproximated(curve)) report.warnings.add(Warning::kApproximated);
}

CurveJoin joinAt(const BSplineCurve& first, const BSplineCurve& second, JoinEnds ends,
                 const AnalysisOptions& options) {
  BezierSegment arriving = first.endSegment(ends.first);
  BezierSegment leaving = second.endSegment(ends.second);
  JoinReport report =
      analyzeJoin(sideOf(first, arriving, ends.first, farthestFrom(first, ends.first)),
                  sideOf(second, leaving, ends.second, farthestFrom(second, ends.second)), options);
  markApproximated(first, report);
  markApproximated(second, report);
  return {report, arriving, leaving, std::nullopt};
}

/// The join of two neighbouring segments of one curve.
JoinReport innerReport(const BSplineCurve& curve, const BezierSegment& before,
                       const BezierSegment& after, const AnalysisOptions& options) {
  const double reach = reachInside(curve, after.curve.pole(0));
  JoinReport report = analyzeJoin(sideOf(curve, before, CurveEnd::kEnd, reach),
                                  sideOf(curve, after, CurveEnd::kStart, reach), options);
  markApproximated(curve, report);
  return report;
}

CurveJoin innerJoin(const BSplineCurve& curve, const BezierSegment& before,
                    const BezierSegment& after, const AnalysisOptions& options) {
  return {innerReport(curve, before, after, options), before, after, after.first};
}

}  // namespace

double reachFrom(const BSplineCurve& curve, CurveEnd end) {
  return sideOf(curve, curve.endSegment(end), end, farthestFrom(curve, end)).reach;
}

NearestEnds nearestEnds(const BSplineCurve& first, const BSplineCurve& second,
                        double gapTolerance) {
  using enum CurveEnd;
  const auto distance = [&](JoinEnds ends) {
    return (first.endPoint(ends.first) - second.endPoint(ends.second)).norm();
  };
  constexpr std::array<JoinEnds, 4> kPairs{
      {{kEnd, kStart}, {kStart, kEnd}, {kEnd, kEnd}, {kStart, kStart}}};
  std::array<double, 4> distances;
  std::transform(kPairs.begin(), kPairs.end(), distances.begin(), distance);
  const double least = *std::min_element(distances.begin(), distances.end());
  const auto chosen = std::find_if(distances.begin(), distances.end(),
                                   [&](double d) { return d <= least + gapTolerance; });
  const bool across = std::max(distances[0], distances[1]) <= gapTolerance;
  const bool along = std::max(distances[2], distances[3]) <= gapTolerance;
  return {kPairs[static_cast<std::size_t>(chosen - distances.begin())], across || along};
}

void checkOptions(const AnalysisOptions& options) {
  if (options.order < 0 || options.order > kMaxOrder) {
    throw std::invalid_argument("order: must be from 0 to " + std::to_string(kMaxOrder) + ", got " +
                                std::to_string(options.order));
  }
  if (!(std::isfinite(options.scaleMm) && options.scaleMm >= 0.0)) {
    throw std::invalid_argument("scale_mm: must be finite and > 0, got " +
                                std::to_string(options.scaleMm));
  }
  options.tolerances.check();
}

CurveJoin analyzeCurves(const BSplineCurve& first, const BSplineCurve& second,
                        const AnalysisOptions& options, std::optional<JoinEnds> ends) {
  checkOptions(options);
  if (ends) return joinAt(first, second, *ends, options);
  const NearestEnds nearest = nearestEnds(first, second, options.tolerances.gapMm);
  CurveJoin join = joinAt(first, second, nearest.ends, options);
  if (nearest.touchesAtBothEnds) join.report.warnings.add(Warning::kTouchesAtBothEnds);
  return join;
}

JoinReport reportCurves(const BSplineCurve& first, const BSplineCurve& second,
                        const AnalysisOptions& options, JoinEnds ends) {
  const BezierSegment arriving = first.endSegment(ends.first);
  const BezierSegment leaving = second.endSegment(ends.second);
  return analyzeJoin(sideOf(first, arriving, ends.first, farthestFrom(first, ends.first)),
                     sideOf(second, leaving, ends.second, farthestFrom(second, ends.second)),
                     options);
}

CurveJoin analyzeClosing(const BSplineCurve& curve, const AnalysisOptions& options) {
  checkOptions(options);
  return joinAt(curve, curve, {CurveEnd::kEnd, CurveEnd::kStart}, options);
}

CurveJoin analyzeAt(const BSplineCurve& curve, double parameter, const AnalysisOptions& options) {
  checkOptions(options);
  if (!(curve.first() < parameter && parameter < curve.last())) {
    throw std::invalid_argument("parameter: must be inside (" + std::to_string(curve.first()) +
                                ", " + std::to_string(curve.last()) + "), got " +
                                std::to_string(parameter));
  }
  const int before = curve.spanAt(parameter, Side::kLeft);
  const int after = curve.spanAt(parameter, Side::kRight);
  BezierSegment arriving = curve.segment(before);
  if (before != after) return innerJoin(curve, arriving, curve.segment(after), options);
  BezierSegment leaving = arriving;
  const double share = (parameter - arriving.first) / arriving.length();
  std::tie(arriving.curve, leaving.curve) = arriving.curve.split(share);
  arriving.last = leaving.first = parameter;
  return innerJoin(curve, arriving, leaving, options);
}

void visitInnerKnots(const BSplineCurve& curve, const AnalysisOptions& options,
                     const KnotVisitor& visit) {
  const auto knots = curve.innerKnots();
  if (knots.empty()) return;
  BezierSegment before = curve.segment(0);
  for (std::size_t i = 0; i < knots.size(); ++i) {
    const BezierSegment after = curve.segment(knots[i].spanAfter);
    const JoinReport report = innerReport(curve, before, after, options);
    const double done = static_cast<double>(i + 1) / static_cast<double>(knots.size());
    if (!visit({report, before, after, knots[i].parameter, done})) return;
    before = after;
  }
}

std::vector<CurveJoin> analyzeInnerJoins(const BSplineCurve& curve, const AnalysisOptions& options,
                                         const Progress& progress) {
  checkOptions(options);
  std::vector<CurveJoin> joins;
  if (progress && curve.spanCount() > 1 && !progress(0.0)) return joins;
  bool stopped = false;
  visitInnerKnots(curve, options, [&](const KnotJoin& knot) {
    joins.push_back({knot.report, knot.before, knot.after, knot.parameter});
    stopped = progress && knot.done < 1.0 && !progress(knot.done);
    return !stopped;
  });
  if (stopped) return joins;
  if (curve.isClosed(options.tolerances.gapMm)) joins.push_back(analyzeClosing(curve, options));
  if (progress) progress(1.0);
  return joins;
}

}  // namespace osculate
