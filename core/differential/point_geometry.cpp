#include "osculate/differential/point_geometry.h"

#include "osculate/differential/arc_invariants.h"
#include "osculate/differential/flatness.h"
#include "osculate/differential/segment_cut.h"
#include "osculate/differential/singular_end.h"

namespace osculate {

namespace {

CutSegment cutAt(const BSplineCurve& curve, double t, Side side) {
  const BezierSegment segment = curve.segment(curve.spanAt(t, side));
  return SegmentCutter(segment).at((t - segment.first) / segment.length());
}

}  // namespace

PointGeometry geometryAt(const BSplineCurve& curve, double t, Side side) {
  constexpr int kOrder = 4;
  const CutSegment cut = cutAt(curve, t, side);
  const BezierView view = cut.curve.view();
  const double sign = cut.sign();
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
  const double flatBelow = Flatness(curve).below(jet.point, curvatureError);
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
