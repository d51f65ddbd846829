#include "osculate/differential/segment_cut.h"

#include <algorithm>
#include <cmath>

#include "osculate/bezier/bernstein.h"

namespace osculate {

namespace {

/// Of `degree` convex combinations, each with three roundings (Higham, Accuracy and Stability,
/// sec. 3.1); numerators and weights round as far as the heaviest does and are then divided by a
/// weight that is at least the lightest.
double roundingOf(const BezierSegment& segment) {
  double largest = 0.0;
  double heaviest = 0.0;
  double lightest = segment.curve.weight(0);
  for (int i = 0; i <= segment.curve.degree(); ++i) {
    largest = std::max(largest, segment.curve.pole(i).squaredNorm());
    heaviest = std::max(heaviest, segment.curve.weight(i));
    lightest = std::min(lightest, segment.curve.weight(i));
  }
  const double polynomial = 3.0 * segment.curve.degree() * kUnitRoundoff * std::sqrt(largest);
  return segment.curve.isRational() ? 2.0 * heaviest / lightest * polynomial : polynomial;
}

}  // namespace

SegmentCutter::SegmentCutter(const BezierSegment& segment)
    : segment_(segment), rounding_(roundingOf(segment)) {
  const Net net = toNet(segment.curve.view());
  std::copy_n(net.data(), net.size(), net_.begin());
}

CutSegment SegmentCutter::at(double t) const {
  if (t <= 0.0) return {segment_.curve, CurveEnd::kStart, 1.0, segment_.poleError};
  if (t >= 1.0) return {segment_.curve, CurveEnd::kEnd, 1.0, segment_.poleError};
  return segment_.curve.isRational() ? cut<4>(t) : cut<3>(t);
}

template <int Dimension>
CutSegment SegmentCutter::cut(double t) const {
  const int n = segment_.curve.degree();
  Eigen::Matrix<double, Dimension, kMaxDegree + 1> q;
  for (int i = 0; i <= n; ++i)
    q.col(i) = Eigen::Map<const Eigen::Matrix<double, Dimension, 1>>(net_.data() + Dimension * i);
  // de Casteljau in place leaves the net of the part after t, or from the other side of that before
  const bool after = t < 0.5;
  for (int r = 1; r <= n && after; ++r) {
    for (int i = 0; i <= n - r; ++i)
      q.col(i) += t * (q.col(i + 1) - q.col(i));
  }
  for (int r = 1; r <= n && !after; ++r) {
    for (int i = n; i >= r; --i)
      q.col(i) += (1.0 - t) * (q.col(i - 1) - q.col(i));
  }
  BezierCurve part =
      Dimension == 3 ? bezierFromPoles(q.data(), n) : bezierFromHomogeneous(q.data(), n);
  return {std::move(part), after ? CurveEnd::kStart : CurveEnd::kEnd, after ? 1.0 - t : t,
          segment_.poleError + rounding_};
}

}  // namespace osculate
