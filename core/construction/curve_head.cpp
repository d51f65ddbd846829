#include "osculate/construction/curve_head.h"

#include <algorithm>

namespace osculate {

namespace {

/// Flat knots from the end: 0 for those at it. Knots near each other subtract without error
/// (Sterbenz), so the spans at the end keep their proportions to the last bit.
std::vector<double> knotsFrom(const BSplineCurve& curve, CurveEnd end) {
  std::vector<double> flat = flatten(curve.data().knots);
  if (end == CurveEnd::kEnd) std::reverse(flat.begin(), flat.end());
  const double origin = flat.front();
  for (double& knot : flat)
    knot = end == CurveEnd::kEnd ? origin - knot : knot - origin;
  return flat;
}

}  // namespace

BSplineCurve openClamped(const BSplineCurve& curve) {
  return curve.trimmed(curve.first(), curve.last());
}

BSplineCurve curveHead(const BSplineCurve& curve, CurveEnd end, int spans) {
  const bool reversed = end == CurveEnd::kEnd;
  const BSplineData& own = curve.data();
  const int degree = curve.degree();
  const auto count = static_cast<int>(own.poles.cols());
  const int span = reversed ? curve.spanCount() - spans : spans - 1;
  const int first = curve.extraction(span).firstPole;
  const int poles = reversed ? count - first : first + degree + 1;

  std::vector<double> flat = knotsFrom(curve, end);
  flat.resize(static_cast<std::size_t>(poles) + static_cast<std::size_t>(degree) + 1);
  BSplineData head{.poles = own.poles.leftCols(poles),
                   .weights = {},
                   .knots = compress(flat),
                   .degree = degree,
                   .periodic = false,
                   .poleError = own.poleError};
  if (reversed) head.poles = own.poles.rightCols(poles).rowwise().reverse();
  for (int i = 0; i < poles && curve.isRational(); ++i)
    head.weights.push_back(own.weights[static_cast<std::size_t>(reversed ? count - 1 - i : i)]);
  return BSplineCurve(std::move(head));
}

}  // namespace osculate
