#include "osculate/solid/space4.h"

#include <Eigen/LU>
#include <cmath>
#include <stdexcept>
#include <string>

namespace osculate {

namespace {

/// The vector across three others in E4: the cofactors of a fourth column.
Eigen::Vector4d across(const Eigen::Matrix<double, 4, 3>& columns) {
  Eigen::Vector4d result;
  for (int row = 0; row < 4; ++row) {
    Eigen::Matrix3d minor;
    for (int i = 0, to = 0; i < 4; ++i) {
      if (i != row) minor.row(to++) = columns.row(i);
    }
    result[row] = (row % 2 == 0 ? -1.0 : 1.0) * minor.determinant();
  }
  return result;
}

void checkDimension(const BezierTetrahedron& solid, int wanted) {
  if (solid.dimension() != wanted) {
    throw std::invalid_argument("solid: must be in E" + std::to_string(wanted) + ", is in E" +
                                std::to_string(solid.dimension()));
  }
}

}  // namespace

Eigen::Matrix<double, 4, 3> hyperplaneBasis(const Eigen::Vector4d& a) {
  const double length = a.norm();
  if (!(std::isfinite(length) && length > 0.0)) {
    throw std::invalid_argument("direction: must be finite and not 0");
  }
  const Eigen::Vector4d unit = a / length;
  // the rotation in the plane of the fourth axis and a takes one to the other and the axes along;
  // for the opposite of the fourth axis any half turn does
  const Eigen::Vector4d last = Eigen::Vector4d::UnitW();
  const double cosine = unit[3];
  if (cosine < -1.0 + 1e-15) {
    Eigen::Matrix<double, 4, 3> turned = Eigen::Matrix<double, 4, 3>::Identity();
    turned(0, 0) = -1.0;
    return turned;
  }
  Eigen::Matrix<double, 4, 3> basis;
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector4d axis = Eigen::Vector4d::Unit(k);
    basis.col(k) = axis - (unit + last) * (unit[k] / (1.0 + cosine));
  }
  return basis;
}

BezierTetrahedron embedded(const BezierTetrahedron& solid, const Eigen::Vector4d& a) {
  checkDimension(solid, 3);
  return solid.transformed(hyperplaneBasis(a), SpacePoint::Zero(4));
}

BezierTetrahedron parallelProjection(const BezierTetrahedron& solid, const Eigen::Vector4d& a) {
  checkDimension(solid, 4);
  return solid.transformed(hyperplaneBasis(a).transpose(), SpacePoint::Zero(3));
}

BezierTetrahedron perspectiveProjection(const BezierTetrahedron& solid,
                                        const Eigen::Vector4d& centre, const Eigen::Vector4d& a) {
  checkDimension(solid, 4);
  const Eigen::Matrix<double, 4, 3> basis = hyperplaneBasis(a);
  if (!centre.allFinite()) throw std::invalid_argument("centre: coordinates must be finite");
  const double depth = a.dot(centre);
  if (!(std::abs(depth) > 1e-12 * a.norm() * centre.norm())) {
    throw std::invalid_argument("centre: must not lie in the hyperplane of projection");
  }
  const Eigen::RowVectorXd depths = (depth - (a.transpose() * solid.points()).array()).matrix();
  for (int i = 0; i < solid.size(); ++i) {
    if (solid.weight(i) > 0.0 && !(depths[i] * depths[0] > 0.0)) {
      throw std::invalid_argument(
          "centre: points of the solid lie on both sides of the hyperplane through the centre (or "
          "on it); move the "
          "centre away from the solid");
    }
  }
  // (P - X) m0 with m0 = a.P/(a.P - a.X): Q ~ (a.P) X - (a.X) P with the weight a.P - a.X
  Eigen::Matrix<double, 4, 5> map;
  map.topLeftCorner<3, 4>() =
      basis.transpose() * (depth * Eigen::Matrix4d::Identity() - centre * a.transpose());
  map.topRightCorner<3, 1>().setZero();
  map.bottomRows<1>() << -a.transpose(), depth;
  return solid.mapped(map);
}

Eigen::Vector4d tangentHyperplaneNormal(const BezierTetrahedron& solid, const Barycentric<4>& u) {
  checkDimension(solid, 4);
  Eigen::Matrix<double, 4, 3> derivatives;
  for (int c = 1; c < 4; ++c) {
    const std::array<Barycentric<4>, 1> direction{Barycentric<4>::Unit(c) -
                                                  Barycentric<4>::Unit(0)};
    derivatives.col(c - 1) = solid.derivative(u, direction);
  }
  const Eigen::Vector4d normal = across(derivatives);
  const double length = normal.norm();
  if (!(length > 1e-14 * derivatives.colwise().norm().prod())) return Eigen::Vector4d::Zero();
  return normal / length;
}

}  // namespace osculate
