#include "osculate/bezier/bernstein.h"

#include <algorithm>

namespace osculate {

/// Makes curves from data that are known to be right.
class BezierBuilder {
 public:
  static BezierCurve polynomial(const double* poles, int degree) {
    BezierCurve curve;
    curve.degree_ = degree;
    std::copy_n(poles, 3 * (degree + 1), curve.poles_.begin());
    return curve;
  }

  static BezierCurve copy(BezierView arrays) {
    BezierCurve curve = polynomial(arrays.poles, arrays.degree);
    curve.rational_ = arrays.weights != nullptr;
    if (curve.rational_) std::copy_n(arrays.weights, arrays.degree + 1, curve.weights_.begin());
    return curve;
  }

  static BezierCurve rational(const double* points, int degree) {
    BezierCurve curve;
    curve.degree_ = degree;
    curve.rational_ = true;
    for (int i = 0; i <= degree; ++i) {
      const Eigen::Map<const Eigen::Vector4d> point(points + 4 * i);
      Eigen::Map<Vector3>(curve.poles_.data() + 3 * i) = point.head<3>() / point[3];
      curve.weights_[static_cast<std::size_t>(i)] = point[3];
    }
    return curve;
  }
};

BezierCurve bezierFromPoles(const double* poles, int degree) {
  return BezierBuilder::polynomial(poles, degree);
}

BezierCurve bezierFromArrays(BezierView arrays) { return BezierBuilder::copy(arrays); }

BezierCurve bezierFromHomogeneous(const double* points, int degree) {
  return BezierBuilder::rational(points, degree);
}

BezierCurve fromNet(const Net& net) {
  const int degree = static_cast<int>(net.cols()) - 1;
  return net.rows() == 3 ? bezierFromPoles(net.data(), degree)
                         : bezierFromHomogeneous(net.data(), degree);
}

Net toNet(BezierView curve) {
  Net net(curve.weights == nullptr ? 3 : 4, curve.degree + 1);
  for (int i = 0; i <= curve.degree; ++i) {
    net.col(i).head<3>() = curve.weight(i) * curve.pole(i);
    if (curve.weights != nullptr) net(3, i) = curve.weights[i];
  }
  return net;
}

Vector3 project(const NetPoint& point) {
  if (point.rows() == 3) return point;
  return point.head<3>() / point[3];
}

Eigen::VectorXd bernstein(int degree, double t) {
  Eigen::VectorXd values = Eigen::VectorXd::Zero(degree + 1);
  values[0] = 1.0;
  for (int n = 1; n <= degree; ++n) {
    for (int i = n; i > 0; --i)
      values[i] = (1.0 - t) * values[i] + t * values[i - 1];
    values[0] *= 1.0 - t;
  }
  return values;
}

std::vector<Vector3> projectDerivatives(const std::vector<NetPoint>& homogeneous) {
  std::vector<Vector3> result;
  result.reserve(homogeneous.size());
  for (std::size_t k = 0; k < homogeneous.size(); ++k) {
    Vector3 numerator = homogeneous[k].head<3>();
    if (homogeneous[k].rows() == 4) {
      double choose = 1.0;
      for (std::size_t j = 1; j <= k; ++j) {
        choose *= static_cast<double>(k - j + 1) / static_cast<double>(j);
        numerator -= choose * homogeneous[j][3] * result[k - j];
      }
      numerator /= homogeneous[0][3];
    }
    result.push_back(numerator);
  }
  return result;
}

}  // namespace osculate
