// New B-splines from old ones. Every new pole is a blossom at the knots it stands over.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <string>

#include "osculate/bezier/bspline_state.h"

namespace osculate {

namespace {

/// A span of the curve on which a pole over the knots [low, high] has influence.
int spanBetween(const BSplineCurve& curve, const BSplineCurve::State& state, double low,
                double high) {
  const double middle = 0.5 * (std::max(low, state.first) + std::min(high, state.last));
  return state.spans[static_cast<std::size_t>(curve.spanAt(middle))];
}

bool isClamped(const BSplineCurve::State& state) {
  return state.flat.front() == state.first && state.flat.back() == state.last;
}

/// The knot that t misses by no more than the rounding of a shift by a period, or t.
double snapped(const BSplineCurve::State& state, double t) {
  const double tolerance =
      8.0 * kUnitRoundoff * std::max(std::abs(state.first), std::abs(state.last));
  const auto above = std::lower_bound(state.flat.begin(), state.flat.end(), t - tolerance);
  return above != state.flat.end() && *above <= t + tolerance ? *above : t;
}

void setPole(BSplineData& data, Eigen::Index i, const NetPoint& point) {
  data.poles.col(i) = project(point);
  if (point.rows() == 4) data.weights[static_cast<std::size_t>(i)] = point[3];
}

/// The pole that the curve itself has over these knots, or -1. `guess`: where it would be.
Eigen::Index poleOver(const BSplineCurve::State& state, std::span<const double> knots,
                      Eigen::Index guess) {
  const auto count = static_cast<Eigen::Index>(state.flat.size());
  if (guess < 0 || guess + 1 + static_cast<Eigen::Index>(knots.size()) > count) return -1;
  return std::equal(knots.begin(), knots.end(), state.flat.begin() + guess + 1) ? guess : -1;
}

BSplineData emptyData(const std::vector<double>& flat, int degree, const BSplineData& like) {
  BSplineData data{.poles = Poles(3, static_cast<Eigen::Index>(flat.size()) - degree - 1),
                   .weights = {},
                   .knots = compress(flat),
                   .degree = degree,
                   .periodic = false,
                   .poleError = like.poleError};
  if (!like.weights.empty()) data.weights.resize(static_cast<std::size_t>(data.poles.cols()));
  return data;
}

/// f(v) for a degree raised by one: the mean of the blossoms with one argument left out.
NetPoint raisedBlossom(const BSplineCurve::State& state, int span,
                       std::span<const double> arguments) {
  NetPoint sum = NetPoint::Zero(state.data.weights.empty() ? 3 : 4);
  for (std::size_t omitted = 0; omitted < arguments.size(); ++omitted) {
    std::vector<double> rest(arguments.begin(), arguments.end());
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(omitted));
    sum += blossom(state, span, rest);
  }
  return sum / static_cast<double>(arguments.size());
}

/// Flat knots of a raised curve that is not periodic: degree+1 knots at or before the first of its
/// range and at or after the last. More would widen the range of an unclamped curve.
std::vector<double> raisedFlatKnots(const BSplineData& raised, double first, double last) {
  const std::vector<double> flat = flatten(raised.knots);
  const auto begin = std::upper_bound(flat.begin(), flat.end(), first) - raised.degree - 1;
  const auto end = std::lower_bound(flat.begin(), flat.end(), last) + raised.degree + 1;
  return {begin, end};
}

}  // namespace

BSplineCurve BSplineCurve::reversed() const {
  BSplineData data = state_->data;
  const double sum = first() + last();
  std::reverse(data.knots.knots.begin(), data.knots.knots.end());
  std::reverse(data.knots.multiplicities.begin(), data.knots.multiplicities.end());
  for (double& knot : data.knots.knots)
    knot = sum - knot;
  const Eigen::Index count = data.poles.cols();
  // a periodic curve begins with the pole over the end of its range: see periodicFlatKnots
  const Eigen::Index top =
      data.periodic ? data.degree - data.knots.multiplicities.front() + count : count - 1;
  for (Eigen::Index i = 0; i < count; ++i) {
    const Eigen::Index from = (top - i) % count;
    data.poles.col(i) = state_->data.poles.col(from);
    if (isRational()) {
      data.weights[static_cast<std::size_t>(i)] =
          state_->data.weights[static_cast<std::size_t>(from)];
    }
  }
  return BSplineCurve(std::move(data));
}

BSplineCurve BSplineCurve::elevated(int times) const {
  if (times < 0 || degree() + times > kMaxDegree) {
    throw std::invalid_argument("times: the degree " + std::to_string(degree()) +
                                " can be raised by 0 to " + std::to_string(kMaxDegree - degree()) +
                                ", got " + std::to_string(times));
  }
  if (times == 0) return *this;
  BSplineData raised = state_->data;
  raised.degree += 1;
  for (int& multiplicity : raised.knots.multiplicities)
    ++multiplicity;
  const std::vector<double> flat =
      isPeriodic() ? periodicFlatKnots(raised, 1) : raisedFlatKnots(raised, first(), last());
  if (!isPeriodic()) raised.knots = compress(flat);
  const auto degree = static_cast<std::size_t>(raised.degree);
  Eigen::Index count = static_cast<Eigen::Index>(flat.size()) - raised.degree - 1;
  if (isPeriodic()) count -= raised.degree + 1 - raised.knots.multiplicities.front();
  raised.poles.resize(3, count);
  raised.weights.resize(isRational() ? static_cast<std::size_t>(count) : 0);
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const int span = spanBetween(*this, *state_, flat[k], flat[k + degree + 1]);
    setPole(raised, i, raisedBlossom(*state_, span, std::span(flat).subspan(k + 1, degree)));
  }
  return BSplineCurve(std::move(raised)).elevated(times - 1);
}

BSplineCurve BSplineCurve::trimmed(double a, double b) const {
  const double period = last() - first();
  const bool reachable = isPeriodic() ? b <= a + period : (first() <= a && b <= last());
  if (!(a < b && reachable)) {
    throw std::invalid_argument("trim: needs a < b " +
                                (isPeriodic() ? std::string("and at most one period")
                                              : "inside [" + std::to_string(first()) + ", " +
                                                    std::to_string(last()) + "]") +
                                ", got " + std::to_string(a) + " and " + std::to_string(b));
  }
  if (isPeriodic()) {
    const double shift = period * std::floor((a - first()) / period);
    const BSplineCurve open(unrollPeriods(state_->data, 2));
    const double from = snapped(*open.state_, a - shift);
    const double to = snapped(*open.state_, std::min(b - shift, open.last()));
    return open.trimmed(from, to).reparametrised(a, b);
  }
  if (a == first() && b == last() && isClamped(*state_)) return *this;
  const auto p = static_cast<std::size_t>(degree());
  std::vector<double> flat(p + 1, a);
  std::copy_if(state_->flat.begin(), state_->flat.end(), std::back_inserter(flat),
               [&](double knot) { return a < knot && knot < b; });
  flat.insert(flat.end(), p + 1, b);
  BSplineData part = emptyData(flat, degree(), state_->data);
  const auto skipped = std::upper_bound(state_->flat.begin(), state_->flat.end(), a);
  const Eigen::Index offset = skipped - state_->flat.begin() - degree() - 1;
  for (Eigen::Index i = 0; i < part.poles.cols(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const auto over = std::span(flat).subspan(k + 1, p);
    if (const Eigen::Index own = poleOver(*state_, over, i + offset); own >= 0) {
      part.poles.col(i) = Eigen::Map<const Vector3>(state_->poles() + 3 * own);
      if (isRational()) part.weights[k] = state_->weights()[own];
      continue;
    }
    const int span = spanBetween(*this, *state_, flat[k], flat[k + p + 1]);
    setPole(part, i, blossom(*state_, span, over));
  }
  return BSplineCurve(std::move(part));
}

std::pair<BSplineCurve, BSplineCurve> BSplineCurve::split(double t) const {
  if (!(first() < t && t < last())) {
    throw std::invalid_argument("split: t must be inside (" + std::to_string(first()) + ", " +
                                std::to_string(last()) + "), got " + std::to_string(t));
  }
  return {trimmed(first(), t), trimmed(t, last())};
}

BSplineCurve BSplineCurve::transformed(const Eigen::Affine3d& map) const {
  BSplineData data = state_->data;
  data.poles = map * data.poles;
  return BSplineCurve(std::move(data));
}

BSplineCurve BSplineCurve::reparametrised(double first, double last) const {
  if (!(first < last)) throw std::invalid_argument("range: first must be below last");
  BSplineData data = state_->data;
  const double scale = (last - first) / (this->last() - this->first());
  for (double& knot : data.knots.knots) {
    knot = knot == this->last() ? last : first + scale * (knot - this->first());
  }
  return BSplineCurve(std::move(data));
}

BSplineCurve BSplineCurve::withPoleError(double poleError) const {
  BSplineData data = state_->data;
  data.poleError = poleError;
  return BSplineCurve(std::move(data));
}

}  // namespace osculate
