// The edge of a net as a curve; private to this floor.
#pragma once

#include <stdexcept>

#include "osculate/bezier/bernstein.h"
#include "osculate/bezier/simplex_net.h"

namespace osculate {

/// From homogeneous columns, weight last. A curve has weights > 0: zero weights inside are lifted
/// by raising the degree, b*_i = i/(n+1) b_{i-1} + (1 - i/(n+1)) b_i (Farin, CAGD, sec. 6.1).
inline BezierCurve curveFromEdgeNet(SimplexNet net, int dimension, bool rational) {
  if (dimension != 3)
    throw std::invalid_argument("edge: a curve is in E3; project the solid from E4 first");
  const auto isZero = [&](Eigen::Index i) { return !(net(3, i) > 0.0); };
  if (isZero(0) || isZero(net.cols() - 1)) {
    throw std::invalid_argument("edge: an end has weight 0, no curve begins or ends there");
  }
  while (!(net.row(3).array() > 0.0).all()) {
    const Eigen::Index n = net.cols() - 1;
    if (n == kMaxDegree) throw std::invalid_argument("edge: too many weights are 0");
    SimplexNet raised(4, n + 2);
    raised.col(0) = net.col(0);
    raised.col(n + 1) = net.col(n);
    for (Eigen::Index i = 1; i <= n; ++i) {
      const double a = static_cast<double>(i) / static_cast<double>(n + 1);
      raised.col(i) = a * net.col(i - 1) + (1.0 - a) * net.col(i);
    }
    net = raised;
  }
  const int degree = static_cast<int>(net.cols()) - 1;
  if (rational) return bezierFromHomogeneous(net.data(), degree);
  const Eigen::Matrix3Xd poles = net.topRows<3>();
  return bezierFromPoles(poles.data(), degree);
}

}  // namespace osculate
