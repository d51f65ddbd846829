#include "osculate/differential/point_geometry.h"

#include <algorithm>

#include "osculate/differential/arc_invariants.h"
#include "osculate/differential/singular_end.h"

namespace osculate {

namespace {

/// The segment cut so that t is one of its ends.
struct CutSegment {
  BezierCurve curve;
  CurveEnd end;
  double poleError;
};

CutSegment cutAt(const BSplineCurve& curve, double t, Side side) {
  const BezierSegment segment = curve.segment(curve.spanAt(t, side));
  const double local = (t - segment.first) / segment.length();
  if (local <= 0.0) return {segment.curve, CurveEnd::kStart, segment.poleError};
  if (local >= 1.0) return {segment.curve, CurveEnd::kEnd, segment.poleError};
  auto [before, after] = segment.curve.split(local);
  if (local < 0.5) return {after, CurveEnd::kStart, segment.poleError};
  return {before, CurveEnd::kEnd, segment.poleError};
}

/// Largest distance of the curve's ends and middle from the point.
double reachFrom(const BSplineCurve& curve, const Vector3& point) {
  return std::max({(curve.endPoint(CurveEnd::kStart) - point).norm(),
                   (curve.endPoint(CurveEnd::kEnd) - point).norm(),
                   (curve.middlePoint() - point).norm()});
}

}  // namespace

PointGeometry geometryAt(const BSplineCurve& curve, double t, Side side) {
  constexpr int kOrder = 4;
  const CutSegment cut = cutAt(curve, t, side);
  const BezierView view = cut.curve.view();
  const double sign = cut.end == CurveEnd::kEnd ? -1.0 : 1.0;
  const Jet<kOrder> jet = endJet<kOrder>(view, cut.end, cut.poleError);
  const bool singular = isSingular(jet);

  PointGeometry result;
  result.point = jet.point;
  TravelJet<double> r;
  double curvatureError = 0.0;
  if (singular) {
    const SingularEnd arc = singularEnd(view, cut.end, cut.poleError, kOrder);
    result.smoothness = arc.smoothness;
    r = inTravel(arc.r, sign);
    curvatureError = arc.error[2];
  } else {
    const auto arc = arcJet(jet);
    result.smoothness = kOrder;
    r = inTravel(arc.r, sign);
    curvatureError = arc.error[2];
  }
  const double flatBelow = std::max(curvatureError, kFlatness / reachFrom(curve, jet.point));
  storeNumbers(arcNumbers(r), 0, result.smoothness, flatBelow, result.frame, result.invariants);
  if (!result.frame.normal) {
    const EndFrame chosen =
        fictitiousFrame(view, cut.end, result.frame.tangent, singular, cut.poleError);
    result.kind = chosen.kind;
    result.frame.tangent = chosen.frame.tangent;
  } else if (singular) {
    result.kind = FrameKind::kFictitiousTangent;
  }
  return result;
}

}  // namespace osculate
