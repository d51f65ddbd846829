// The energies of a finished curve, by adaptive quadrature on each Bézier segment.
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>

#include "osculate/construction/fairness.h"
#include "osculate/differential/arc_length.h"

namespace osculate {

namespace {

constexpr double kLeastEnergy = 1e-12;
constexpr double kSpeedShare = 0.3;
constexpr double kRelativeError = 1e-10;

struct Integrands {
  double bending;
  double variation;
  double speed;
};

/// Per parameter of the segment: kappa^2 v, |r_3|^2 v, and ln^2(v/L) for the parameter scaled by
/// `span`.
Integrands integrands(const BezierCurve& curve, double t, double span, double lengthMm) {
  const auto d = curve.derivatives(t, 3);
  const double v = d[1].norm();
  const double p = d[1].dot(d[2]);
  const Vector3 r2 = d[2] / std::pow(v, 2) - p * d[1] / std::pow(v, 4);
  const Vector3 r3 =
      d[3] / std::pow(v, 3) - 3.0 * p * d[2] / std::pow(v, 5) +
      (4.0 * p * p / std::pow(v, 7) - (d[2].squaredNorm() + d[1].dot(d[3])) / std::pow(v, 5)) *
          d[1];
  const double logarithm = std::log(v / (span * lengthMm));
  return {r2.squaredNorm() * v, r3.squaredNorm() * v, logarithm * logarithm};
}

template <class Function>
double integrate(const Function& function) {
  return boost::math::quadrature::gauss_kronrod<double, 31>::integrate(function, 0.0, 1.0, 10,
                                                                       kRelativeError);
}

}  // namespace

double Energies::objective(Fairness fairness) const {
  const double energy = fairness == Fairness::kBending ? bending : variation;
  return std::log(energy + kLeastEnergy) + kSpeedShare * speed;
}

Energies energies(const BSplineCurve& curve) {
  Energies sum;
  sum.lengthMm = length(curve);
  const double range = curve.last() - curve.first();
  for (int span = 0; span < curve.spanCount(); ++span) {
    const BezierSegment part = curve.segment(span);
    const double share = part.length() / range;
    const auto at = [&](double t) { return integrands(part.curve, t, share, sum.lengthMm); };
    sum.bending += integrate([&](double t) { return at(t).bending; });
    sum.variation += integrate([&](double t) { return at(t).variation; });
    sum.speed += share * integrate([&](double t) { return at(t).speed; });
  }
  sum.bending *= sum.lengthMm;
  sum.variation *= sum.lengthMm * sum.lengthMm * sum.lengthMm;
  return sum;
}

}  // namespace osculate
