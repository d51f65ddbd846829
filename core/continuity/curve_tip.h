// One end of a curve, ready for joins, without the rest of the curve: what an audit keeps of an
// edge.
#pragma once

#include <memory>

#include "osculate/bezier/bspline_curve.h"
#include "osculate/continuity/join_analysis.h"

namespace osculate {

/// Owns its poles; as small as they are.
class CurveTip {
 public:
  CurveTip(const BSplineCurve& curve, CurveEnd end);

  /// For as long as the tip lives, wherever it is moved.
  const JoinSide& side() const { return side_; }
  /// The curve was converted with an error beyond rounding.
  bool isApproximated() const { return approximated_; }

 private:
  std::unique_ptr<double[]> numbers_;  ///< poles, then weights of a rational segment
  JoinSide side_;
  bool approximated_;
};

/// The report of two curves at these ends: what analyzeCurves says of them.
JoinReport analyzeTips(const CurveTip& arriving, const CurveTip& leaving,
                       const AnalysisOptions& options = {});

}  // namespace osculate
