#include "osculate/continuity/curve_tip.h"

#include <algorithm>

#include "osculate/continuity/curve_side.h"

namespace osculate {

CurveTip::CurveTip(const BSplineCurve& curve, CurveEnd end)
    : approximated_(osculate::isApproximated(curve)) {
  const BezierSegment segment = curve.endSegment(end);
  side_ = sideOf(curve, segment, end, farthestFrom(curve, end));
  const BezierView whole = side_.segment;
  const auto count = static_cast<std::size_t>(whole.degree) + 1;
  const std::size_t weights = whole.weights == nullptr ? 0 : count;
  numbers_ = std::make_unique_for_overwrite<double[]>(3 * count + weights);
  std::copy_n(whole.poles, 3 * count, numbers_.get());
  side_.segment.poles = numbers_.get();
  if (weights == 0) return;
  std::copy_n(whole.weights, count, numbers_.get() + 3 * count);
  side_.segment.weights = numbers_.get() + 3 * count;
}

JoinReport analyzeTips(const CurveTip& arriving, const CurveTip& leaving,
                       const AnalysisOptions& options) {
  JoinReport report = analyzeJoin(arriving.side(), leaving.side(), options);
  if (arriving.isApproximated() || leaving.isApproximated())
    report.warnings.add(Warning::kApproximated);
  return report;
}

}  // namespace osculate
