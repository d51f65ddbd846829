#include "osculate/continuity/curve_side.h"

#include <algorithm>
#include <cmath>

namespace osculate {

double farthestFrom(const BSplineCurve& curve, CurveEnd end) {
  const Vector3& join = curve.endPoint(end);
  return std::sqrt(std::max((curve.endPoint(opposite(end)) - join).squaredNorm(),
                            (curve.middlePoint() - join).squaredNorm()));
}

double reachInside(const BSplineCurve& curve, const Vector3& join) {
  return std::sqrt(std::max({(curve.endPoint(CurveEnd::kStart) - join).squaredNorm(),
                             (curve.endPoint(CurveEnd::kEnd) - join).squaredNorm(),
                             (curve.middlePoint() - join).squaredNorm()}));
}

JoinSide sideOf(const BSplineCurve& curve, const BezierSegment& segment, CurveEnd end,
                double reach) {
  const BezierView view = segment.curve.view();
  if (isBackAtJoin(reach, view, end)) [[unlikely]] {
    const Vector3 join = view.pole(end == CurveEnd::kStart ? 0 : view.degree);
    const auto distance = [&](double share) {
      return (curve.evaluate(std::lerp(curve.first(), curve.last(), share)) - join).norm();
    };
    reach = std::max(distance(kGoldenSection), distance(1.0 - kGoldenSection));
  }
  return {view, end, reach, segment.length(), segment.poleError};
}

bool isApproximated(const BSplineCurve& curve) {
  constexpr double kRounding = 1000.0 * kUnitRoundoff;
  const double size = std::max({curve.endPoint(CurveEnd::kStart).norm(),
                                curve.endPoint(CurveEnd::kEnd).norm(), curve.middlePoint().norm()});
  return curve.poleError() > kRounding * size;
}

}  // namespace osculate
