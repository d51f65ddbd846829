#include "osculate/differential/comb_point.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "osculate/differential/arc_invariants.h"
#include "osculate/differential/singular_end.h"

namespace osculate {

namespace {

constexpr int kOrder = 5;

/// r_0 .. r_5 in the direction of travel.
template <class Scalar>
using FullJet = std::array<Eigen::Matrix<Scalar, 3, 1>, kOrder + 1>;

/// Every number, and bounds of their errors, without regard to whether the curvature is zero.
template <class Scalar>
struct Rates {
  ArcNumbers<Scalar> frame;
  std::array<Scalar, kRateCount> value;
  std::array<Scalar, kRateCount> error;
  Scalar growth;
  Scalar growthError;
};

/// The next derivatives, from d/ds of the Frenet-Serret formulas for r_4:
/// n.r_5 = kappa''' - 6 kappa^2 kappa' - 3 kappa' tau^2 - 3 kappa tau tau',
/// b.r_5 = kappa tau'' + 3 kappa' tau' + 3 kappa'' tau - kappa^3 tau - kappa tau^3.
template <class Scalar>
[[gnu::always_inline]] inline void setValues(const FullJet<Scalar>& r, Rates<Scalar>& rates) {
  const TravelJet<Scalar> travel{r[0], r[1], r[2], r[3], r[4]};
  rates.frame = arcNumbers(travel);
  const ArcNumbers<Scalar>& n = rates.frame;
  const Scalar k = n.curvature;
  const Scalar three(3.0);
  const Scalar squares = k * k + n.torsion * n.torsion;
  const Scalar rate3 = n.normal.dot(r[5]) + three * (k * k + squares) * n.curvatureRate +
                       three * k * n.torsion * n.torsionRate;
  const Scalar torsionRate2 = (n.binormal.dot(r[5]) - three * (n.curvatureRate * n.torsionRate +
                                                               n.curvatureRate2 * n.torsion)) /
                                  k +
                              n.torsion * squares;
  rates.value = {k,     n.torsion,   n.curvatureRate, n.curvatureRate2, n.torsionRate,
                 rate3, torsionRate2};
  rates.growth = r[2].dot(r[3]);
}

/// Bounds to first order: each derivative r_k is off by e_k, the normal by 2 e_2 / kappa, the
/// binormal by that and by e_1.
template <class Scalar>
[[gnu::always_inline]] inline void setErrors(const ArcJet<kOrder, Scalar>& arc,
                                             Rates<Scalar>& rates) {
  using std::abs;
  const auto& [k, tau, k1, k2, tau1, k3, tau2] = rates.value;
  const auto& e = arc.error;
  const Scalar radius = Scalar(1.0) / k;
  const Scalar two(2.0);
  const Scalar three(3.0);
  const Scalar normal = two * e[2] * radius;
  const Scalar binormal = normal + e[1];
  const Scalar t = abs(tau);
  const Scalar d0 = e[2];
  const Scalar d1 = e[3] + arc.norm[3] * normal;
  const Scalar dt = radius * (e[3] + arc.norm[3] * binormal + t * d0);
  const Scalar d2 = e[4] + arc.norm[4] * normal + (three * k * k + t * t) * d0 + two * k * t * dt;
  const Scalar dt1 =
      radius * (e[4] + arc.norm[4] * binormal + two * (t * d1 + abs(k1) * dt) + abs(tau1) * d0);
  const Scalar d3 = e[5] + arc.norm[5] * normal +
                    three * ((two * k * k + t * t) * d1 + two * (two * k * d0 + t * dt) * abs(k1) +
                             k * t * dt1 + k * abs(tau1) * dt + t * abs(tau1) * d0);
  const Scalar dt2 =
      radius * (e[5] + arc.norm[5] * binormal +
                three * (abs(k1) * dt1 + abs(tau1) * d1 + t * d2 + abs(k2) * dt) + abs(tau2) * d0) +
      (k * k + three * t * t) * dt + two * k * t * d0;
  rates.error = {d0, dt, d1, d2, dt1, d3, dt2};
  rates.growthError = d0 * arc.norm[3] + k * e[3];
}

/// Vectors and numbers of one lane.
template <class Scalar>
void store(const FullJet<Scalar>& r, const Rates<Scalar>& rates, int side, CombPoint& p) {
  p.tangent = lane(r[1], side);
  p.curvatureVector = lane(r[2], side);
  p.normal = lane(rates.frame.normal, side);
  p.binormal = lane(rates.frame.binormal, side);
  for (std::size_t i = 0; i < kRateCount; ++i) {
    p.value[i] = lane(rates.value[i], side);
    p.error[i] = lane(rates.error[i], side);
  }
  p.growth = lane(rates.growth, side);
  p.growthError = lane(rates.growthError, side);
}

/// What remains where the curvature is zero.
void forgetNormal(CombPoint& p) {
  p.isFlat = true;
  p.normal.setConstant(kNaN);
  p.binormal.setConstant(kNaN);
  std::fill(p.value.begin() + 1, p.value.end(), kNaN);
}

/// Limits from one side at a point of zero curvature, from the derivatives outward to that side:
/// n = r_m/|r_m|, kappa = |r_m| s^(m-2)/(m-2)! + n.r_{m+1} s^(m-1)/(m-1)! + ..., and
/// tau = b.n' = b.r_{m+1} / ((m-1) |r_m|).
template <class Scalar>
void takeLimits(const FullJet<Scalar>& r, const ArcJet<kOrder, Scalar>& arc, int side, double into,
                Contact contact, CombPoint& p) {
  const auto outward = [&](std::size_t k) {
    return Vector3((k % 2 == 1 ? into : 1.0) * lane(r[k], side));
  };
  const auto off = [&](std::size_t k) {
    return Vector3(outward(k) - outward(k).dot(p.tangent) * p.tangent);
  };
  const auto vanishes = [&](std::size_t m) { return off(m).norm() <= lane(arc.error[m], side); };
  std::size_t m = static_cast<std::size_t>(contact);
  if (contact == Contact::kEither) m = vanishes(3) ? 4 : 3;
  if (vanishes(m)) return;
  p.normal = off(m).normalized();
  p.binormal = p.tangent.cross(p.normal);
  const double size = off(m).norm();
  p.value[kCurvatureValue] = 0.0;
  p.value[kCurvatureRateValue] = m == 3 ? into * size : 0.0;
  p.value[kCurvatureRate2Value] = m == 3 ? p.normal.dot(outward(4)) : size;
  // the outward frame has the opposite binormal where outward runs backwards
  p.value[kTorsionValue] =
      into * p.binormal.dot(outward(m + 1)) / (static_cast<double>(m - 1) * size);
}

/// |dP/dt| and its derivatives by the segment's parameter from s(t) outward along the cut part.
template <class Scalar>
void setSpeed(const ArcJet<kOrder, Scalar>& arc, const CutSegment& cut, int side, CombPoint& p) {
  const double sign = cut.sign();
  const double perLength = 1.0 / cut.length;
  double scale = perLength;
  for (std::size_t j = 0; j < p.speed.size(); ++j) {
    p.speed[j] = detail::kFactorials[j + 1] * lane(arc.arcLength[j + 1], side) * scale;
    scale *= sign * perLength;
  }
}

/// A point without first derivative: its derivatives by arc length as far as they exist.
void setSingular(const CutSegment& cut, double flatBelow, CombPoint& p) {
  const SingularEnd end = singularEnd(cut.curve.view(), cut.end, cut.poleError, 4);
  FrenetFrame frame;
  Invariants invariants;
  const double limit = std::max(flatBelow, end.error[2]);
  storeNumbers(arcNumbers(inTravel(end.r, cut.sign())), 0, end.smoothness, limit, frame,
               invariants);
  const Vector3 none = Vector3::Constant(kNaN);
  p.tangent = end.smoothness > 0 ? frame.tangent : none;
  p.normal = frame.normal.value_or(none);
  p.binormal = frame.binormal.value_or(none);
  p.curvatureVector = end.smoothness > 1 ? end.r[2] : none;
  p.value = {invariants.curvature.value_or(kNaN),
             invariants.torsion.value_or(kNaN),
             invariants.curvatureRate.value_or(kNaN),
             invariants.curvatureRate2.value_or(kNaN),
             invariants.torsionRate.value_or(kNaN),
             kNaN,
             kNaN};
  p.error.fill(std::numeric_limits<double>::infinity());
  p.growth = kNaN;
  p.growthError = kNaN;
  p.speed.fill(kNaN);
  p.isFlat = !frame.normal;
  p.isSingular = true;
}

}  // namespace

SegmentSampler::SegmentSampler(const Flatness& flatness, const BezierSegment& segment)
    : cutter_(segment), flatness_(flatness) {}

CombPoint SegmentSampler::at(double t, Limit limit, Contact contact) const {
  CombPoint p;
  evaluate<double, 1>({t}, {&p}, limit, contact);
  return p;
}

void SegmentSampler::at(double first, double second, CombPoint& firstPoint,
                        CombPoint& secondPoint) const {
  evaluate<Lanes, 2>({first, second}, {&firstPoint, &secondPoint}, Limit::kNone, Contact::kEither);
}

namespace {

inline double joined(const std::array<double, 1>& values) { return values[0]; }
inline Lanes joined(const std::array<double, 2>& values) { return {values[0], values[1]}; }
inline Vector3 joined(const std::array<Vector3, 1>& values) { return values[0]; }
inline LanesVector joined(const std::array<Vector3, 2>& values) {
  return zip(values[0], values[1]);
}

/// All that follows from the Taylor coefficients at one or two points.
template <class Scalar, std::size_t Count>
struct Expansion {
  std::array<Jet<kOrder>, Count> jets;
  ArcJet<kOrder, Scalar> arc;  ///< outward
  FullJet<Scalar> r;           ///< in the direction of travel
  Rates<Scalar> rates;
};

template <class Scalar, std::size_t Count>
void expand(const std::array<CutSegment, Count>& cuts, Expansion<Scalar, Count>& e) {
  const auto each = [](const auto& of) {
    std::array<decltype(of(0)), Count> values{};
    for (std::size_t i = 0; i < Count; ++i)
      values[i] = of(i);
    return joined(values);
  };
  for (std::size_t i = 0; i < Count; ++i)
    e.jets[i] = endJet<kOrder>(cuts[i].curve.view(), cuts[i].end, cuts[i].poleError);
  std::array<Eigen::Matrix<Scalar, 3, 1>, kOrder + 1> c;
  std::array<Scalar, kOrder + 1> error;
  for (std::size_t k = 1; k <= kOrder; ++k) {
    c[k] = each([&](std::size_t i) { return e.jets[i].c[k]; });
    error[k] = each([&](std::size_t i) { return e.jets[i].error[k]; });
  }
  setArcJet<kOrder, Scalar>(c, error, e.arc);
  e.r = e.arc.r;
  const Scalar sign = each([&](std::size_t i) { return cuts[i].sign(); });
  for (std::size_t k = 1; k <= kOrder; k += 2)
    e.r[k] *= sign;
  setValues<Scalar>(e.r, e.rates);
  setErrors<Scalar>(e.arc, e.rates);
}

std::array<CutSegment, 1> cutAt(const SegmentCutter& cutter, const std::array<double, 1>& t) {
  return {cutter.at(t[0])};
}
std::array<CutSegment, 2> cutAt(const SegmentCutter& cutter, const std::array<double, 2>& t) {
  return {cutter.at(t[0]), cutter.at(t[1])};
}

}  // namespace

template <class Scalar, std::size_t Count>
void SegmentSampler::evaluate(const std::array<double, Count>& parameters,
                              const std::array<CombPoint*, Count>& points, Limit limit,
                              Contact contact) const {
  const std::array<CutSegment, Count> cuts = cutAt(cutter_, parameters);
  Expansion<Scalar, Count> e;
  expand(cuts, e);
  for (std::size_t i = 0; i < Count; ++i) {
    CombPoint& p = *points[i];
    const int side = static_cast<int>(i);
    static_cast<CombNotes&>(p) = CombNotes{};
    p.t = parameters[i];
    p.point = e.jets[i].point;
    const double flat = flatness_.below(p.point, lane(e.arc.error[2], side));
    if (isSingular(e.jets[i])) [[unlikely]] {
      setSingular(cuts[i], flat, p);
      continue;
    }
    store(e.r, e.rates, side, p);
    setSpeed(e.arc, cuts[i], side, p);
    if (p.value[kCurvatureValue] > flat) [[likely]]
      continue;
    forgetNormal(p);
    if (limit != Limit::kNone) takeLimits(e.r, e.arc, side, static_cast<double>(limit), contact, p);
  }
}

}  // namespace osculate
