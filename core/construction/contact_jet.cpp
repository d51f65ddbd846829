#include "osculate/construction/contact_jet.h"

#include <string>

#include "osculate/construction/contact_error.h"
#include "osculate/differential/arc_jet.h"
#include "osculate/differential/singular_end.h"

namespace osculate {

namespace {

/// A segment with the point of departure at one of its ends.
struct Source {
  BezierCurve curve;
  CurveEnd end;
  double poleError;
};

Source sourceOf(const BSplineCurve& curve, const Departure& departure) {
  if (!departure.inside) {
    const BezierSegment segment = curve.endSegment(departure.end);
    return {segment.curve, departure.end, segment.poleError};
  }
  const double t = departure.parameter;
  if (!(curve.first() <= t && t <= curve.last())) {
    throw std::invalid_argument("parameter: must be from " + std::to_string(curve.first()) +
                                " to " + std::to_string(curve.last()) + ", got " +
                                std::to_string(t));
  }
  if (t == (departure.forward ? curve.first() : curve.last())) {
    throw std::invalid_argument(
        "parameter: nothing of the curve is left to continue there; turn the direction");
  }
  // the part of the curve that the new one takes the place of the continuation of
  const Side side = departure.forward ? Side::kLeft : Side::kRight;
  const BezierSegment segment = curve.segment(curve.spanAt(t, side));
  const double local = (t - segment.first) / segment.length();
  const CurveEnd end = departure.forward ? CurveEnd::kEnd : CurveEnd::kStart;
  if (departure.forward)
    return {local >= 1.0 ? segment.curve : segment.curve.split(local).first, end,
            segment.poleError};
  return {local <= 0.0 ? segment.curve : segment.curve.split(local).second, end, segment.poleError};
}

}  // namespace

ContactJet contactJet(const BSplineCurve& curve, const Departure& departure, int order) {
  if (order < 0 || order > kMaxOrder) {
    throw std::invalid_argument("order: must be from 0 to " + std::to_string(kMaxOrder) + ", got " +
                                std::to_string(order));
  }
  const Source source = sourceOf(curve, departure);
  const BezierView view = source.curve.view();
  const auto jet = endJet<kMaxOrder>(view, source.end, source.poleError);
  ContactJet contact;
  contact.order = order;
  contact.r[0] = jet.point;
  std::array<Vector3, kMaxOrder + 1> inward;
  if (isSingular(jet)) {
    const SingularEnd singular =
        singularEnd(view, source.end, source.poleError, std::max(order, 1));
    if (singular.smoothness < order) {
      throw ContactError(
          "order: the curve's end is singular (repeated poles) and has derivatives by arc length "
          "up to order " +
          std::to_string(singular.smoothness) + " only, asked for " + std::to_string(order));
    }
    inward = singular.r;
  } else {
    inward = arcJet(jet).r;
  }
  // the new curve goes on where the old one arrives: r_k (-1)^k of the derivatives into the old one
  for (int k = 1; k <= order; ++k) {
    const auto i = static_cast<std::size_t>(k);
    contact.r[i] = k % 2 == 1 ? Vector3(-inward[i]) : inward[i];
  }
  return contact;
}

}  // namespace osculate
