#include "osculate/bezier/raised_net.h"

#include "osculate/bezier/knot_removal.h"

namespace osculate {

namespace {

/// The segments one behind the other; every inner knot has the multiplicity of the degree.
SplineNet segmentsNet(const BSplineCurve& curve, int times) {
  SplineNet net{.degree = curve.degree() + times,
                .rational = curve.isRational(),
                .flat = {curve.first()},
                .poles = {},
                .period = 0.0};
  for (int span = 0; span < curve.spanCount(); ++span) {
    const BezierSegment segment = curve.segment(span);
    const BezierCurve raised = segment.curve.elevated(times);
    net.flat.insert(net.flat.end(), static_cast<std::size_t>(net.degree), segment.first);
    for (int i = span == 0 ? 0 : 1; i <= net.degree; ++i) {
      net.poles.emplace_back();
      net.poles.back() << raised.weight(i) * raised.pole(i), raised.weight(i);
    }
  }
  net.flat.insert(net.flat.end(), static_cast<std::size_t>(net.degree) + 1, curve.last());
  return net;
}

}  // namespace

SplineNet raisedNet(const BSplineCurve& curve, int times) {
  if (times == 0) return clampedNet(curve);
  SplineNet net = segmentsNet(curve, times);
  for (const BSplineCurve::InnerKnot& knot : curve.innerKnots()) {
    const int surplus = curve.degree() - knot.multiplicity;
    if (surplus > 0) apply(proposeRemoval(net, net.find(knot.parameter), surplus), net);
  }
  return net;
}

}  // namespace osculate
