// The joins of whole curves: two curves at their ends, one curve at its inner knots and its
// closing.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "osculate/bezier/bspline_curve.h"
#include "osculate/continuity/join_analysis.h"

namespace osculate {

/// Which end of the first and of the second curve meet.
struct JoinEnds {
  CurveEnd first = CurveEnd::kEnd;
  CurveEnd second = CurveEnd::kStart;
  bool operator==(const JoinEnds&) const = default;
};

/// A join with the segments that meet there.
struct CurveJoin {
  JoinReport report;
  BezierSegment firstSegment;
  BezierSegment secondSegment;
  std::optional<double> parameter;  ///< of an inner knot
};

/// The ends that lie nearest; (end, start) where several pairs are equally near within the gap
/// tolerance.
struct NearestEnds {
  JoinEnds ends;
  bool touchesAtBothEnds = false;
};
NearestEnds nearestEnds(const BSplineCurve& first, const BSplineCurve& second, double gapTolerance);

/// Distance in mm from an end to the curve's other end or to its middle point, the larger; to the
/// points at the golden sections where that is nothing: the L of residuals where this curve is the
/// shorter.
double reachFrom(const BSplineCurve& curve, CurveEnd end);

/// Throws std::invalid_argument: order outside 0..kMaxOrder, bad tolerances, negative scale.
void checkOptions(const AnalysisOptions& options);

/// Two curves at the given ends, or at the nearest ones. Throws std::invalid_argument for bad
/// options.
CurveJoin analyzeCurves(const BSplineCurve& first, const BSplineCurve& second,
                        const AnalysisOptions& options = {}, std::optional<JoinEnds> ends = {});
/// The report alone, without allocation: what the benchmarks time.
JoinReport reportCurves(const BSplineCurve& first, const BSplineCurve& second,
                        const AnalysisOptions& options, JoinEnds ends);

/// The closing join of one closed curve (its end against its start).
CurveJoin analyzeClosing(const BSplineCurve& curve, const AnalysisOptions& options = {});

/// The join at a parameter inside the range: of the segments that meet there at a knot, else of the
/// two parts of one segment. Throws std::invalid_argument for a parameter outside or at an end.
CurveJoin analyzeAt(const BSplineCurve& curve, double parameter,
                    const AnalysisOptions& options = {});

/// The join at an inner knot while it is visited.
struct KnotJoin {
  const JoinReport& report;
  const BezierSegment& before;
  const BezierSegment& after;
  double parameter;
  double done;  ///< share of the knots that have been visited, this one included
};
/// Returns false to stop.
using KnotVisitor = std::function<bool(const KnotJoin&)>;
/// Every inner knot in the order of the parameter; keeps nothing. Options are not checked.
void visitInnerKnots(const BSplineCurve& curve, const AnalysisOptions& options,
                     const KnotVisitor& visit);

/// Every inner knot, then the closing join if the curve is closed within the gap tolerance.
/// `progress` gets the share done (0..1); returning false stops, and what was done is returned.
using Progress = std::function<bool(double)>;
std::vector<CurveJoin> analyzeInnerJoins(const BSplineCurve& curve,
                                         const AnalysisOptions& options = {},
                                         const Progress& progress = {});

}  // namespace osculate
