#include "osculate/bezier/spline_net.h"

#include <algorithm>
#include <cmath>

namespace osculate {

namespace {

/// How many whole periods of `count` the index i lies above the first.
int turnsOf(int i, int count) { return i >= 0 ? i / count : -((count - 1 - i) / count); }

BSplineData openData(const SplineNet& net) {
  BSplineData data;
  data.degree = net.degree;
  data.knots = compress(net.flat);
  data.poles.resize(3, net.poleCount());
  for (int i = 0; i < net.poleCount(); ++i) {
    data.poles.col(i) = project(net.pole(i));
    if (net.rational) data.weights.push_back(net.pole(i)[3]);
  }
  return data;
}

/// Pole 0 of a periodic B-spline stands over the degree+2 knots that end with the first knot after
/// its first one: see periodicFlatKnots.
BSplineData periodicData(const SplineNet& net) {
  SplineNet turned = net;
  const int multiplicity = net.find(net.flat.front()).multiplicity;
  for (int i = 0; i < net.poleCount(); ++i) {
    turned.poles[static_cast<std::size_t>(i)] = net.pole(i - (net.degree + 1 - multiplicity));
  }
  turned.flat.insert(turned.flat.end(), static_cast<std::size_t>(multiplicity),
                     net.flat.front() + net.period);
  BSplineData data = openData(turned);
  data.periodic = true;
  return data;
}

/// The blossom of the span [knot(span), knot(span+1)] at b (`upper` times) and a (else), by de
/// Boor's algorithm with an argument for each step (Ramshaw 1989).
Eigen::Vector4d blossomAt(const SplineNet& net, int span, double a, double b, int upper) {
  const int p = net.degree;
  Eigen::Matrix<double, 4, kMaxDegree + 1> q;
  for (int j = 0; j <= p; ++j)
    q.col(j) = net.pole(span - p + j);
  for (int r = 1; r <= p; ++r) {
    const double x = r <= p - upper ? a : b;
    for (int j = p; j >= r; --j) {
      const double low = net.knot(span - p + j);
      const double alpha = (x - low) / (net.knot(span + j - r + 1) - low);
      q.col(j) = (1.0 - alpha) * q.col(j - 1) + alpha * q.col(j);
    }
  }
  return q.col(p);
}

}  // namespace

double SplineNet::knot(int i) const {
  if (!isPeriodic()) return flat[static_cast<std::size_t>(i)];
  const int turns = turnsOf(i, poleCount());
  return flat[static_cast<std::size_t>(i - turns * poleCount())] + turns * period;
}

const Eigen::Vector4d& SplineNet::pole(int i) const {
  const int turns = isPeriodic() ? turnsOf(i, poleCount()) : 0;
  return poles[static_cast<std::size_t>(i - turns * poleCount())];
}

SplineNet::Occurrence SplineNet::find(double u) const {
  const auto range = std::equal_range(flat.begin(), flat.end(), u);
  return {static_cast<int>(range.first - flat.begin()),
          static_cast<int>(range.second - range.first)};
}

SplineNet clampedNet(const BSplineCurve& curve) {
  const BSplineCurve clamped = curve.trimmed(curve.first(), curve.last());
  const BSplineData& data = clamped.data();
  SplineNet net{.degree = data.degree,
                .rational = clamped.isRational(),
                .flat = flatten(data.knots),
                .poles = {},
                .period = 0.0};
  for (Eigen::Index i = 0; i < data.poles.cols(); ++i) {
    const double weight = net.rational ? data.weights[static_cast<std::size_t>(i)] : 1.0;
    net.poles.emplace_back();
    net.poles.back() << weight * data.poles.col(i), weight;
  }
  return net;
}

SplineNet periodicNet(const SplineNet& clamped) {
  SplineNet net = clamped;
  net.period = clamped.flat.back() - clamped.flat.front();
  net.flat.erase(net.flat.begin());
  net.flat.resize(net.flat.size() - static_cast<std::size_t>(net.degree) - 1);
  net.poles.erase(net.poles.begin());
  return net;
}

SplineNet openedNet(const SplineNet& periodic) {
  SplineNet net = periodic;
  const auto end = static_cast<std::size_t>(net.degree) + 1;
  net.flat.insert(net.flat.begin(), net.flat.front());
  net.flat.insert(net.flat.end(), end, periodic.flat.front() + periodic.period);
  net.poles.insert(net.poles.begin(), net.poles.back());
  net.period = 0.0;
  return net;
}

BSplineCurve curveOf(const SplineNet& net, double poleError) {
  BSplineData data = net.isPeriodic() ? periodicData(net) : openData(net);
  data.poleError = poleError;
  return BSplineCurve(std::move(data));
}

Net bezierNet(const SplineNet& net, double a, double b) {
  const int p = net.degree;
  const double middle = 0.5 * (a + b);
  const auto above = std::upper_bound(net.flat.begin(), net.flat.end(), middle);
  const int span = static_cast<int>(above - net.flat.begin()) - 1;
  Net result(net.rational ? 4 : 3, p + 1);
  for (int j = 0; j <= p; ++j)
    result.col(j) = blossomAt(net, span, a, b, j).head(result.rows());
  return result;
}

}  // namespace osculate
