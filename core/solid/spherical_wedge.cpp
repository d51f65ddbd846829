// Exact parts of spheres and balls (mathematics C2, C3, C4).
#include <cmath>
#include <stdexcept>
#include <string>

#include "osculate/solid/primitives.h"

namespace osculate {

namespace {

/// Corners on the unit sphere.
struct SphericalCorners {
  Vector3 centre;
  double radius;
  Vector3 a, b, c;
};

SphericalCorners cornersOf(const Vector3& centre, const Vector3& a, const Vector3& b,
                           const Vector3& c) {
  if (!centre.allFinite() || !a.allFinite() || !b.allFinite() || !c.allFinite()) {
    throw std::invalid_argument("corners: coordinates must be finite");
  }
  const double radius = (a - centre).norm();
  const auto isOff = [&](const Vector3& point) {
    return !(std::abs((point - centre).norm() - radius) <= 1e-9 * radius);
  };
  if (!(radius > 0.0)) throw std::invalid_argument("corners: must differ from the centre");
  if (isOff(b) || isOff(c)) {
    throw std::invalid_argument("corners: must be at the same distance from the centre, got " +
                                std::to_string(radius) + ", " +
                                std::to_string((b - centre).norm()) + " and " +
                                std::to_string((c - centre).norm()) + " mm");
  }
  SphericalCorners corners{centre, radius, (a - centre).normalized(), (b - centre).normalized(),
                           (c - centre).normalized()};
  if (std::abs(corners.a.dot(corners.b.cross(corners.c))) < 1e-12) {
    throw std::invalid_argument("corners: lie on one great circle, the triangle is flat");
  }
  return corners;
}

/// One side X-Y of the triangle: cosine of half its angle, its middle, and X x Y / (2c).
struct Side {
  double c;
  Vector3 v;
  Vector3 x;

  Side(const Vector3& from, const Vector3& to) : c(std::sqrt(0.5 * (1.0 + from.dot(to)))) {
    if (!(c > 1e-6))
      throw std::invalid_argument("corners: two of them are opposite points of the sphere");
    v = (from + to) / (2.0 * c);
    x = from.cross(to) / (2.0 * c);
  }
};

/// Solid angle by van Oosterom and Strackee 1983, signed.
double solidAngle(const Vector3& a, const Vector3& b, const Vector3& c) {
  return 2.0 * std::atan2(a.dot(b.cross(c)), 1.0 + a.dot(b) + b.dot(c) + c.dot(a));
}

/// The homogeneous net of degree 4 on the unit sphere.
class QuarticNet {
 public:
  QuarticNet(const Vector3& a, const Vector3& b, const Vector3& c) : net_(4, netSize<3>(4)) {
    const double g = solidAngle(a, b, c) / 6.0;
    corner({4, 0, 0}, a);
    corner({0, 4, 0}, b);
    corner({0, 0, 4}, c);
    const Side ab(a, b);
    const Side bc(b, c);
    const Side ca(c, a);
    side({3, 1, 0}, {2, 2, 0}, {1, 3, 0}, a, b, ab, g);
    side({0, 3, 1}, {0, 2, 2}, {0, 1, 3}, b, c, bc, g);
    side({1, 0, 3}, {2, 0, 2}, {3, 0, 1}, c, a, ca, g);
    inner({2, 1, 1}, a, ab, bc, ca, g);
    inner({1, 2, 1}, b, bc, ca, ab, g);
    inner({1, 1, 2}, c, ca, ab, bc, g);
  }
  const SimplexNet& net() const { return net_; }

 private:
  void set(const MultiIndex<3>& index, const Vector3& numerator, double weight) {
    net_.col(netIndex<3>(index)) << numerator, weight;
  }
  void corner(const MultiIndex<3>& index, const Vector3& x) { set(index, x, 1.0); }
  void side(const MultiIndex<3>& near, const MultiIndex<3>& middle, const MultiIndex<3>& far,
            const Vector3& x, const Vector3& y, const Side& xy, double g) {
    const double cosG = std::cos(g);
    set(near, (xy.v + cosG * x) / 2.0, (xy.c + cosG) / 2.0);
    set(middle, (x + y) * (1.0 / 6.0 + cosG / (3.0 * xy.c)), (1.0 + 2.0 * xy.c * cosG) / 3.0);
    set(far, (xy.v + cosG * y) / 2.0, (xy.c + cosG) / 2.0);
  }
  /// For the corner x between the sides `out` (which leaves it) and `in`; `across` is opposite.
  void inner(const MultiIndex<3>& index, const Vector3& x, const Side& out, const Side& across,
             const Side& in, double g) {
    const double c1 = std::cos(g);
    const double c2 = std::cos(2.0 * g);
    const double c3 = std::cos(3.0 * g);
    const Vector3 numerator = c2 * (x + out.v + in.v) + c1 * (out.v + in.v) + c3 * across.v +
                              (std::sin(2.0 * g) + std::sin(g)) * (out.x + in.x) +
                              std::sin(3.0 * g) * across.x;
    set(index, numerator / 6.0, ((out.c + in.c) * (c2 + c1) + across.c * c3 + c2) / 6.0);
  }

  SimplexNet net_;
};

/// M + R p for a net on the unit sphere; corners of weight 1 keep their bits.
BezierTriangle placed(SimplexNet net, int degree, const SphericalCorners& corners) {
  const Eigen::RowVectorXd weights = net.row(3);
  net.topRows<3>() = corners.radius * net.topRows<3>() + corners.centre * weights;
  return BezierTriangle::fromHomogeneous(degree, 3, net);
}

bool allPositive(const SimplexNet& net) { return (net.row(3).array() > 0.0).all(); }

/// Base and apex so that the solid is oriented right: the corners turn left seen from the centre.
BezierTetrahedron orientedWedge(const BezierTriangle& base, const Vector3& centre,
                                bool turnsLeftOutside) {
  return wedgeOver(turnsLeftOutside ? base.relabelled({0, 2, 1}) : base, centre);
}

/// The middle of the side from a to b, on the sphere of the corners.
Vector3 middleOf(const Vector3& centre, const Vector3& a, const Vector3& b) {
  const Vector3 sum = (a - centre) + (b - centre);
  return centre + (a - centre).norm() * sum.normalized();
}

void addWedges(const Vector3& centre, const Vector3& a, const Vector3& b, const Vector3& c,
               std::vector<BezierTetrahedron>& solids) {
  const SphericalCorners corners = cornersOf(centre, a, b, c);
  const double angle = solidAngle(corners.a, corners.b, corners.c);
  const QuarticNet quartic(corners.a, corners.b, corners.c);
  // up to a solid angle of pi no weight <= 0 and no folding is known (mathematics C3)
  if (std::abs(angle) < 3.0 && allPositive(quartic.net())) {
    solids.push_back(orientedWedge(placed(quartic.net(), 4, corners), centre, angle > 0.0));
    return;
  }
  const double ab = corners.a.dot(corners.b);
  const double bc = corners.b.dot(corners.c);
  const double ca = corners.c.dot(corners.a);
  if (bc < ab && bc <= ca) return addWedges(centre, b, c, a, solids);
  if (ca < ab && ca < bc) return addWedges(centre, c, a, b, solids);
  const Vector3 middle = middleOf(centre, a, b);
  addWedges(centre, a, middle, c, solids);
  addWedges(centre, middle, b, c, solids);
}

}  // namespace

BezierTriangle sphericalTriangle(const Vector3& centre, const Vector3& a, const Vector3& b,
                                 const Vector3& c) {
  const SphericalCorners corners = cornersOf(centre, a, b, c);
  const QuarticNet quartic(corners.a, corners.b, corners.c);
  if (!allPositive(quartic.net())) {
    throw std::invalid_argument(
        "corners: the triangle is too large for one patch (a weight is not > 0); split it");
  }
  return placed(quartic.net(), 4, corners);
}

BezierTriangle sphericalTriangleByCircles(const Vector3& centre, const Vector3& a, const Vector3& b,
                                          const Vector3& c, const Vector3& pole) {
  const SphericalCorners corners = cornersOf(centre, a, b, c);
  if (!(std::abs((pole - centre).norm() - corners.radius) <= 1e-9 * corners.radius)) {
    throw std::invalid_argument("pole: must be a point of the sphere");
  }
  const Vector3 o = (pole - centre).normalized();
  const std::array<Vector3, 3> x{corners.a, corners.b, corners.c};
  SimplexNet net(4, 6);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    MultiIndex<3> corner{};
    MultiIndex<3> edge{};
    corner[i] = 2;
    edge[i] = edge[j] = 1;
    // inverse stereographic projection, then scaled so that the corners have weight 1
    const double lengthI = (x[i] - o).norm();
    const double lengthJ = (x[j] - o).norm();
    const double weight = (x[i] - o).dot(x[j] - o);
    if (!(weight > 0.0)) {
      throw std::invalid_argument(
          "pole: sees a side of the triangle under 90 degrees or more; choose another");
    }
    const Vector3 numerator =
        (lengthI * lengthI * x[j] + lengthJ * lengthJ * x[i] - (x[i] - x[j]).squaredNorm() * o) /
        2.0;
    net.col(netIndex<3>(corner)) << x[i], 1.0;
    net.col(netIndex<3>(edge)) << numerator / (lengthI * lengthJ), weight / (lengthI * lengthJ);
  }
  return placed(net, 2, corners);
}

std::vector<BezierTetrahedron> sphereWedge(const Vector3& centre, const Vector3& a,
                                           const Vector3& b, const Vector3& c) {
  std::vector<BezierTetrahedron> solids;
  addWedges(centre, a, b, c, solids);
  return solids;
}

BezierTetrahedron sphereWedgeByCircles(const Vector3& centre, const Vector3& a, const Vector3& b,
                                       const Vector3& c) {
  const SphericalCorners corners = cornersOf(centre, a, b, c);
  const Vector3 pole = centre - corners.radius * (corners.a + corners.b + corners.c).normalized();
  return orientedWedge(sphericalTriangleByCircles(centre, a, b, c, pole), centre,
                       solidAngle(corners.a, corners.b, corners.c) > 0.0);
}

BezierTetrahedron ballOctant(double radius) {
  if (!(std::isfinite(radius) && radius > 0.0)) {
    throw std::invalid_argument("radius: must be finite and > 0, got " + std::to_string(radius));
  }
  return sphereWedge(Vector3::Zero(), {radius, 0.0, 0.0}, {0.0, radius, 0.0}, {0.0, 0.0, radius})
      .front();
}

}  // namespace osculate
