#include "osculate/differential/arc_length.h"

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/tools/roots.hpp>
#include <cstdint>
#include <stdexcept>
#include <string>

namespace osculate {

namespace {

constexpr double kRelativeError = 1e-12;

/// Length of the part [a, b] of one segment, in its own parameter [0, 1].
double segmentLength(const BezierCurve& curve, double a, double b) {
  // Over [0, 1]: Boost compares the error over [-1, 1] with the integral over [a, b], and where
  // that is short it would halve the interval without end.
  const auto speed = [&](double u) {
    return (b - a) * curve.derivatives(a + (b - a) * u, 1)[1].norm();
  };
  return boost::math::quadrature::gauss_kronrod<double, 15>::integrate(speed, 0.0, 1.0, 15,
                                                                       kRelativeError);
}

}  // namespace

double length(const BSplineCurve& curve) { return length(curve, curve.first(), curve.last()); }

double length(const BSplineCurve& curve, double a, double b) {
  if (!(curve.first() <= a && a <= b && b <= curve.last())) {
    throw std::invalid_argument("length: needs first <= a <= b <= last, got " + std::to_string(a) +
                                " and " + std::to_string(b));
  }
  double sum = 0.0;
  const int lastSpan = curve.spanAt(b, Side::kLeft);
  for (int span = curve.spanAt(a); span <= lastSpan; ++span) {
    const BezierSegment part = curve.segment(span);
    const auto local = [&](double t) {
      return std::clamp((t - part.first) / part.length(), 0.0, 1.0);
    };
    sum += segmentLength(part.curve, local(a), local(b));
  }
  return sum;
}

double parameterAtLength(const BSplineCurve& curve, double s) {
  double before = 0.0;
  for (int span = 0; s >= 0.0 && span < curve.spanCount(); ++span) {
    const BezierSegment part = curve.segment(span);
    const double own = segmentLength(part.curve, 0.0, 1.0);
    const bool isLast = span + 1 == curve.spanCount();
    if (s > before + own * (isLast ? 1.0 + kRelativeError : 1.0)) {
      before += own;
      continue;
    }
    if (s >= before + own) return part.last;
    if (s <= before) return part.first;
    const auto excess = [&](double t) { return before + segmentLength(part.curve, 0.0, t) - s; };
    std::uintmax_t steps = 100;
    const auto bracket =
        boost::math::tools::toms748_solve(excess, 0.0, 1.0, before - s, before + own - s,
                                          boost::math::tools::eps_tolerance<double>(50), steps);
    return part.first + part.length() * 0.5 * (bracket.first + bracket.second);
  }
  throw std::invalid_argument("length: must be from 0 to the curve's length " +
                              std::to_string(length(curve)) + " mm, got " + std::to_string(s));
}

}  // namespace osculate
