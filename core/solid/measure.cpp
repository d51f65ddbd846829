#include "osculate/solid/measure.h"

#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace osculate {

namespace {

constexpr int kMaxParts = 20000;  // of a face

/// (flux of the position / 3, moments: the fluxes of x^2/2 along x, ..) and the sums of moduli.
using Fluxes = Eigen::Vector4d;

/// Nodes and weights on [0, 1].
struct Rule {
  std::vector<double> nodes;
  std::vector<double> weights;
};

template <unsigned Count>
Rule makeRule() {
  using Gauss = boost::math::quadrature::gauss<double, Count>;
  Rule rule;
  for (std::size_t i = 0; i < Gauss::abscissa().size(); ++i) {
    const double x = Gauss::abscissa()[i];
    const double w = 0.5 * Gauss::weights()[i];
    rule.nodes.push_back(0.5 * (1.0 + x));
    rule.weights.push_back(w);
    if (x == 0.0) continue;
    rule.nodes.push_back(0.5 * (1.0 - x));
    rule.weights.push_back(w);
  }
  return rule;
}

/// The fluxes have degree 4n-2, and one more along the collapsed square: 2 count - 1 >= 4n - 1.
const Rule& ruleFor(const BezierTetrahedron& solid) {
  static const Rule small = makeRule<8>();
  static const Rule middle = makeRule<16>();
  static const Rule large = makeRule<24>();
  if (solid.isRational()) return middle;
  return solid.degree() <= 4 ? small : solid.degree() <= 8 ? middle : large;
}

/// A face as homogeneous points about the centre of the solid.
struct Face {
  SimplexNet net;
  int degree;
};

Fluxes fluxAt(const Face& face, const Barycentric<3>& u) {
  SimplexNet net = face.net;
  for (int d = face.degree; d > 1; --d)
    reduceNet<3>(net, d, u);
  const Eigen::Vector4d point = net.leftCols<3>() * u;
  const Vector3 x = point.head<3>() / point[3];
  const auto along = [&](int corner) -> Vector3 {
    const Eigen::Vector4d d = face.degree * (net.col(corner) - net.col(0));
    return (d.head<3>() - d[3] * x) / point[3];
  };
  const Vector3 normal = along(1).cross(along(2));
  Fluxes result;
  result << x.dot(normal) / 3.0, 0.5 * x.cwiseProduct(x).cwiseProduct(normal);
  return result;
}

/// Over the part of the face between three points of its domain.
Fluxes integrate(const Face& face, const PartCornersOf<3>& corners, const Rule& rule) {
  Eigen::Matrix3d domain;
  domain << corners[0], corners[1], corners[2];
  Fluxes sum = Fluxes::Zero();
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    for (std::size_t j = 0; j < rule.nodes.size(); ++j) {
      const double s = rule.nodes[i];
      const double r = rule.nodes[j];
      const Barycentric<3> u = domain * Barycentric<3>(1.0 - s, s * (1.0 - r), s * r);
      sum += rule.weights[i] * rule.weights[j] * s * fluxAt(face, u);
    }
  }
  return std::abs(domain.determinant()) * sum;
}

class FaceIntegrator {
 public:
  FaceIntegrator(const Face& face, const Rule& rule, Fluxes allowed)
      : face_(face), rule_(rule), allowed_(std::move(allowed)) {}

  Fluxes value = Fluxes::Zero();
  Fluxes error = Fluxes::Zero();

  void add(const PartCornersOf<3>& corners, const Fluxes& whole) {
    const Barycentric<3> m01 = 0.5 * (corners[0] + corners[1]);
    const Barycentric<3> m12 = 0.5 * (corners[1] + corners[2]);
    const Barycentric<3> m20 = 0.5 * (corners[2] + corners[0]);
    const std::array<PartCornersOf<3>, 4> quarters{
        {{corners[0], m01, m20}, {m01, corners[1], m12}, {m20, m12, corners[2]}, {m12, m20, m01}}};
    std::array<Fluxes, 4> parts;
    Fluxes sum = Fluxes::Zero();
    for (std::size_t i = 0; i < 4; ++i)
      sum += parts[i] = integrate(face_, quarters[i], rule_);
    const Fluxes change = (sum - whole).cwiseAbs();
    if (++parts_ > kMaxParts || !(change.array() > allowed_.array()).any()) {
      value += sum;
      error += change;
      return;
    }
    for (std::size_t i = 0; i < 4; ++i)
      add(quarters[i], parts[i]);
  }

 private:
  const Face& face_;
  const Rule& rule_;
  Fluxes allowed_;
  int parts_ = 0;
};

Face centredFace(const BezierTetrahedron& solid, int corner, const Vector3& centre) {
  SimplexNet net = solid.homogeneousWithWeights();
  net.topRows<3>() -= centre * net.row(3);
  return {faceNet<4>(net, solid.degree(), corner), solid.degree()};
}

/// The fluxes out of the whole solid.
struct Totals {
  Fluxes value = Fluxes::Zero();
  Fluxes error = Fluxes::Zero();
  double volumeScale = 0.0;  ///< the sum of the moduli of the fluxes of volume
};

Totals totalFluxes(const BezierTetrahedron& solid, const Vector3& centre, double size,
                   double relativeTolerance) {
  const Rule& rule = ruleFor(solid);
  Totals total;
  std::array<Fluxes, 4> whole;
  std::array<Face, 4> faces;
  for (std::size_t c = 0; c < 4; ++c) {
    faces[c] = centredFace(solid, static_cast<int>(c), centre);
    whole[c] = integrate(faces[c], unitCorners<3>(), rule);
    total.volumeScale += std::abs(whole[c][0]);
  }
  Fluxes allowed = Fluxes::Constant(relativeTolerance * total.volumeScale * size);
  allowed[0] = relativeTolerance * total.volumeScale;
  for (std::size_t c = 0; c < 4; ++c) {
    // faces opposite to even corners turn outwards with their corners in order, the others inwards
    const double sign = c % 2 == 0 ? 1.0 : -1.0;
    if (!solid.isRational()) {
      total.value += sign * whole[c];
      continue;
    }
    FaceIntegrator integrator(faces[c], rule, allowed);
    integrator.add(unitCorners<3>(), whole[c]);
    total.value += sign * integrator.value;
    total.error += integrator.error;
  }
  return total;
}

}  // namespace

SolidMeasure measure(const BezierTetrahedron& solid, double relativeTolerance) {
  if (solid.dimension() != 3)
    throw std::invalid_argument("measure: of a solid in E3; project it from E4 first");
  const auto [low, high] = solid.box();
  const Vector3 centre = 0.5 * (low + high);
  const double size = (high - low).norm();
  const Totals total = totalFluxes(solid, centre, size, relativeTolerance);
  constexpr double kRounding = 64.0 * kUnitRoundoff;
  SolidMeasure result;
  result.volume = total.value[0];
  result.volumeError = total.error[0] + kRounding * total.volumeScale;
  if (result.volume == 0.0) {
    result.centroid.setConstant(std::numeric_limits<double>::quiet_NaN());
    return result;
  }
  const Vector3 offset = total.value.tail<3>() / result.volume;
  result.centroid = centre + offset;
  result.centroidErrorMm = (total.error.tail<3>().norm() + offset.norm() * result.volumeError) /
                               std::abs(result.volume) +
                           kRounding * (size + centre.norm());
  return result;
}

}  // namespace osculate
