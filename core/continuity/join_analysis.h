// The analysis of a join of two Bézier segments: the kernel behind every other entry.
#pragma once

#include "osculate/bezier/bezier_curve.h"
#include "osculate/continuity/join_report.h"

namespace osculate {

/// One of the two curves at a join.
struct JoinSide {
  BezierView segment;             ///< the segment that has the join at one of its ends
  CurveEnd end = CurveEnd::kEnd;  ///< which end of the segment lies at the join
  double reach =
      0.0;  ///< from the join to the curve's other end or middle point, mm; 0: of the segment
  double span = 1.0;       ///< length of the segment's interval in the curve's own parameter
  double poleError = 0.0;  ///< error of the poles beyond half a unit in the last place, mm
};

struct AnalysisOptions {
  int order = 4;  ///< 0 .. kMaxOrder; not checked here
  Tolerances tolerances;
  double scaleMm = 0.0;  ///< > 0 overrides L
};

/// The full report. The first side arrives at the join, the second leaves it. Throws nothing,
/// allocates nothing (except at singular ends and for figures of eight).
JoinReport analyzeJoin(const JoinSide& arriving, const JoinSide& leaving,
                       const AnalysisOptions& options = {});

/// The same decision, without sides, frames, betas and definitions: what a batch needs.
JoinDecision decideJoin(const JoinSide& arriving, const JoinSide& leaving,
                        const AnalysisOptions& options = {});

/// Distance from the end at the join to the segment's other end or to its middle point, the larger.
/// Where that is nothing (see isBackAtJoin), the larger of those to the points at the golden
/// sections.
double reachOf(BezierView segment, CurveEnd end);

/// True where the reach is nothing beside the segment at the join: a closed curve that is back
/// there at its middle, as a figure of eight at its crossing. As L it would make every order pass.
bool isBackAtJoin(double reach, BezierView segment, CurveEnd end);
/// The golden section of the parameter range, where no symmetric curve is back at the join.
inline constexpr double kGoldenSection = 0.38196601125010515;

}  // namespace osculate
