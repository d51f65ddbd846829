#include "osculate/bezier/bezier_curve.h"

#include <cmath>
#include <stdexcept>
#include <string>

#include "osculate/bezier/bernstein.h"
#include "osculate/bezier/checks.h"

namespace osculate {

namespace {

/// de Casteljau: turns the net into that of [0, t]; `rest` gets that of [t, 1].
void splitNet(Net& net, Net& rest, double t) {
  const Eigen::Index n = net.cols() - 1;
  rest = net;
  for (Eigen::Index r = 1; r <= n; ++r) {
    for (Eigen::Index i = 0; i <= n - r; ++i) {
      rest.col(i) = (1.0 - t) * rest.col(i) + t * rest.col(i + 1);
    }
    net.col(r) = rest.col(0);
  }
}

NetPoint evaluateNet(Net net, double t) {
  for (Eigen::Index n = net.cols() - 1; n > 0; --n) {
    for (Eigen::Index i = 0; i < n; ++i)
      net.col(i) = (1.0 - t) * net.col(i) + t * net.col(i + 1);
  }
  return net.col(0);
}

/// The curve of a part of another; a part beyond [0, 1] can have weights that no curve has.
BezierCurve partFromNet(const Net& net) {
  if (net.rows() == 4 && !(net.row(3).array() > 0.0).all()) {
    throw std::invalid_argument("t: beyond [0, 1] this rational curve has weights <= 0");
  }
  return fromNet(net);
}

/// The net of the derivative: n (b_{i+1} - b_i), one column less.
Net derivativeNet(const Net& net) {
  const Eigen::Index n = net.cols() - 1;
  return static_cast<double>(n) * (net.rightCols(n) - net.leftCols(n));
}

}  // namespace

BezierCurve::BezierCurve(std::span<const Vector3> poles, std::span<const double> weights) {
  if (poles.size() < 2 || poles.size() > kMaxDegree + 1) {
    throw std::invalid_argument("poles: a Bézier curve has 2 to " + std::to_string(kMaxDegree + 1) +
                                " poles (degree 1 to 25), got " + std::to_string(poles.size()));
  }
  for (const Vector3& pole : poles)
    checkFinite(pole);
  checkWeights(weights, poles.size());
  degree_ = static_cast<int>(poles.size()) - 1;
  rational_ = !weights.empty();
  for (std::size_t i = 0; i < poles.size(); ++i) {
    setPole(static_cast<int>(i), poles[i]);
    if (rational_) weights_[i] = weights[i];
  }
}

namespace {

std::vector<Vector3> polesOf(BezierView view) {
  std::vector<Vector3> poles;
  for (int i = 0; i <= view.degree; ++i)
    poles.emplace_back(view.pole(i));
  return poles;
}

std::span<const double> weightsOf(BezierView view) {
  if (view.weights == nullptr) return {};
  return {view.weights, static_cast<std::size_t>(view.degree) + 1};
}

}  // namespace

BezierCurve::BezierCurve(BezierView view) : BezierCurve(polesOf(view), weightsOf(view)) {}

void BezierCurve::setPole(int i, const Vector3& pole) {
  Eigen::Map<Vector3>(poles_.data() + 3 * i) = pole;
}

Vector3 BezierCurve::evaluate(double t) const { return project(evaluateNet(toNet(view()), t)); }

std::vector<Vector3> BezierCurve::derivatives(double t, int count) const {
  std::vector<NetPoint> homogeneous;
  Net net = toNet(view());
  for (int k = 0; k <= count; ++k) {
    if (k > degree_) {
      homogeneous.emplace_back(NetPoint::Zero(net.rows()));
      continue;
    }
    homogeneous.push_back(evaluateNet(net, t));
    if (k < degree_) net = derivativeNet(net);
  }
  return projectDerivatives(homogeneous);
}

BezierCurve BezierCurve::reversed() const {
  BezierCurve turned(*this);
  for (int i = 0; i <= degree_; ++i) {
    turned.setPole(i, pole(degree_ - i));
    if (rational_) turned.weights_[static_cast<std::size_t>(i)] = weight(degree_ - i);
  }
  return turned;
}

BezierCurve BezierCurve::elevated(int times) const {
  if (times < 0 || degree_ + times > kMaxDegree) {
    throw std::invalid_argument("times: the degree " + std::to_string(degree_) +
                                " can be raised by 0 to " + std::to_string(kMaxDegree - degree_) +
                                ", got " + std::to_string(times));
  }
  Net net = toNet(view());
  for (int step = 0; step < times; ++step) {
    // b*_i = i/(n+1) b_{i-1} + (1 - i/(n+1)) b_i in homogeneous form (Farin, CAGD, sec. 6.1)
    const Eigen::Index n = net.cols() - 1;
    Net raised(net.rows(), n + 2);
    raised.col(0) = net.col(0);
    raised.col(n + 1) = net.col(n);
    for (Eigen::Index i = 1; i <= n; ++i) {
      const double a = static_cast<double>(i) / static_cast<double>(n + 1);
      raised.col(i) = a * net.col(i - 1) + (1.0 - a) * net.col(i);
    }
    net = raised;
  }
  BezierCurve raised = fromNet(net);
  raised.setPole(0, pole(0));
  raised.setPole(raised.degree_, pole(degree_));
  return raised;
}

std::pair<BezierCurve, BezierCurve> BezierCurve::split(double t) const {
  if (!std::isfinite(t)) throw std::invalid_argument("split: t must be finite");
  Net leftNet = toNet(view());
  Net rightNet;
  splitNet(leftNet, rightNet, t);
  std::pair<BezierCurve, BezierCurve> parts{partFromNet(leftNet), partFromNet(rightNet)};
  parts.first.setPole(0, pole(0));
  parts.second.setPole(degree_, pole(degree_));
  return parts;
}

BezierCurve BezierCurve::segment(double a, double b) const {
  if (!std::isfinite(a) || !std::isfinite(b))
    throw std::invalid_argument("segment: a and b must be finite");
  if (a == b)
    throw std::invalid_argument("segment: a and b must differ, both are " + std::to_string(a));
  if (a > b) return segment(b, a).reversed();
  Net part = toNet(view());
  Net rest;
  if (std::abs(1.0 - a) >= std::abs(b)) {
    splitNet(part, rest, a);
    part = rest;
    splitNet(part, rest, (b - a) / (1.0 - a));
    return partFromNet(part);
  }
  splitNet(part, rest, b);
  splitNet(part, rest, a / b);
  return partFromNet(rest);
}

BezierCurve BezierCurve::transformed(const Eigen::Affine3d& map) const {
  std::vector<Vector3> moved = polesOf(view());
  for (Vector3& pole : moved)
    pole = map * pole;
  return BezierCurve(moved, weightsOf(view()));
}

}  // namespace osculate
