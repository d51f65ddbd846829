// How finely a solid must be divided: bounds of second derivatives from differences of control
// points.
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "osculate/bezier/vector3.h"
#include "osculate/solid/mesh.h"

namespace osculate {

namespace {

constexpr int kRefinements = 2;

/// Largest norms of the differences of a homogeneous net: of its points in space, and of its
/// weights.
struct Differences {
  double space = 0.0;
  double weight = 0.0;

  void add(const Eigen::Vector4d& difference, double factor) {
    space = std::max(space, factor * difference.head<3>().norm());
    weight = std::max(weight, factor * std::abs(difference[3]));
  }
};

/// A bound of |D_d D_e B| for all edges d, e of a triangle that share a corner, d and e of length
/// one edge. With A = W B: W B_de = A_de - W_d B_e - W_e B_d - W_de B, W B_d = A_d - W_d B.
double secondDerivativeBound(const BezierTriangle& patch) {
  SimplexNet net = patch.homogeneousWithWeights();
  const auto [low, high] = patch.box();
  net.topRows<3>() -= 0.5 * (low + high) * net.row(3);
  const int n = patch.degree();
  Differences first;
  Differences second;
  for (const MultiIndex<3>& j : multiIndices<3>(n - 1)) {
    for (int a = 0; a < 3; ++a) {
      const int b = (a + 1) % 3;
      first.add(net.col(netIndex<3>(shifted<3>(j, a))) - net.col(netIndex<3>(shifted<3>(j, b))), n);
    }
  }
  for (const MultiIndex<3>& j : n < 2 ? std::vector<MultiIndex<3>>{} : multiIndices<3>(n - 2)) {
    const auto at = [&](int p, int q) {
      return net.col(netIndex<3>(shifted<3>(shifted<3>(j, p), q)));
    };
    for (int a = 0; a < 3; ++a) {
      const int b = (a + 1) % 3;
      const int c = (a + 2) % 3;
      second.add(at(a, a) - 2.0 * at(a, b) + at(b, b), n * (n - 1));
      second.add(at(a, a) - at(a, b) - at(a, c) + at(b, c), n * (n - 1));
    }
  }
  const double wLeast = net.row(3).minCoeff();
  const double extent = 0.5 * (high - low).norm();
  const double firstBound = (first.space + first.weight * extent) / wLeast;
  return (second.space + 2.0 * first.weight * firstBound + second.weight * extent) / wLeast;
}

/// The bound over the whole, from parts 1/2^depth the size; parts with a control point of weight 0,
/// which have none, are left out.
double boundInParts(const BezierTriangle& patch, int depth) {
  if (depth == 0) {
    const double bound = secondDerivativeBound(patch);
    return std::isfinite(bound) ? bound : 0.0;
  }
  double bound = 0.0;
  for (const BezierTriangle& part : patch.refined())
    bound = std::max(bound, 4.0 * boundInParts(part, depth - 1));
  return bound;
}

}  // namespace

int divisionsFor(const BezierTetrahedron& solid, double chordalMm) {
  if (!(std::isfinite(chordalMm) && chordalMm > 0.0)) {
    throw std::invalid_argument("chordal_mm: must be finite and > 0, got " +
                                std::to_string(chordalMm));
  }
  if (solid.dimension() != 3)
    throw std::invalid_argument("mesh: of a solid in E3; project it from E4 first");
  double bound = 0.0;
  for (int corner = 0; corner < 4; ++corner)
    bound = std::max(bound, boundInParts(face(solid, corner), kRefinements));
  // |B - L| <= 1/2 sum l_i |B''[v_i - x]^2| <= M/2 sum l_i (1 - l_i)^2 <= 2/9 M for a triangle
  // whose edges are 1, by Taylor's theorem at x; edges of 1/m divide it by m^2
  const double m = std::ceil(std::sqrt(2.0 / 9.0 * bound / chordalMm));
  return m < kMaxDivisions ? std::max(1, static_cast<int>(m)) : kMaxDivisions;
}

}  // namespace osculate
