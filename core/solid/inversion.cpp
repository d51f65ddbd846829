#include "osculate/solid/inversion.h"

#include <Eigen/QR>
#include <cmath>
#include <optional>
#include <stdexcept>

namespace osculate {

namespace {

constexpr double kSmallPart = 0.07;     // the edge of a part, that of the domain being sqrt 2
constexpr double kSameSolution = 1e-6;  // in barycentric coordinates
constexpr int kNewtonSteps = 30;

struct Part {
  SimplexNet net;
  PartCornersOf<4> corners;

  std::pair<int, int> longestEdge() const {
    std::pair<int, int> longest{0, 1};
    double length = 0.0;
    for (int a = 0; a < 4; ++a) {
      for (int b = a + 1; b < 4; ++b) {
        const double d = (corner(a) - corner(b)).norm();
        if (d > length) {
          length = d;
          longest = {a, b};
        }
      }
    }
    return longest;
  }
  const Barycentric<4>& corner(int c) const { return corners[static_cast<std::size_t>(c)]; }
  Barycentric<4> middle() const { return 0.25 * (corner(0) + corner(1) + corner(2) + corner(3)); }
};

/// The solid moved so that the point is the origin.
class Locator {
 public:
  Locator(const BezierTetrahedron& solid, const Vector3& point, const InversionOptions& options)
      : degree_(solid.degree()), net_(solid.homogeneousWithWeights()), options_(options) {
    net_.topRows<3>() -= point * net_.row(3);
  }

  std::vector<Barycentric<4>> run() {
    std::vector<Part> stack{{net_, unitCorners<4>()}};
    for (int parts = 0; !stack.empty() && parts < options_.maxParts; ++parts) {
      Part part = std::move(stack.back());
      stack.pop_back();
      if (misses(part)) continue;
      const auto [a, b] = part.longestEdge();
      if ((part.corner(a) - part.corner(b)).norm() <= kSmallPart) {
        addSolution(part.middle());
        continue;
      }
      Part other{bisectNet<4>(part.net, degree_, a, b), part.corners};
      const Barycentric<4> middle = 0.5 * (part.corner(a) + part.corner(b));
      part.corners[static_cast<std::size_t>(b)] = middle;
      other.corners[static_cast<std::size_t>(a)] = middle;
      stack.push_back(std::move(part));
      stack.push_back(std::move(other));
    }
    return std::move(solutions_);
  }

 private:
  /// A coordinate has one sign on all control points of positive weight: (w x, w) tells x -+
  /// tolerance.
  bool misses(const Part& part) const {
    for (Eigen::Index row = 0; row < 3; ++row) {
      const auto low = part.net.row(row) - options_.toleranceMm * part.net.row(3);
      const auto high = part.net.row(row) + options_.toleranceMm * part.net.row(3);
      if ((low.array() > 0.0).all() || (high.array() < 0.0).all()) return true;
    }
    return false;
  }

  void addSolution(const Barycentric<4>& start) {
    const std::optional<Barycentric<4>> found = newton(start);
    if (!found) return;
    for (const Barycentric<4>& known : solutions_) {
      if ((known - *found).norm() < kSameSolution) return;
    }
    solutions_.push_back(*found);
  }

  /// Value and derivatives along the edges from corner 0, as columns.
  Eigen::Matrix<double, 3, 4> linearized(const Barycentric<4>& u) const {
    SimplexNet net = net_;
    for (int d = degree_; d > 1; --d)
      reduceNet<4>(net, d, u);
    const Eigen::Vector4d point = net.leftCols<4>() * u;
    Eigen::Matrix<double, 3, 4> result;
    result.col(0) = point.head<3>() / point[3];
    for (int c = 1; c < 4; ++c) {
      const Eigen::Vector4d along = degree_ * (net.col(c) - net.col(0));
      result.col(c) = (along.head<3>() - along[3] * result.col(0)) / point[3];
    }
    return result;
  }

  /// On the domain: steps that leave it end on its boundary.
  std::optional<Barycentric<4>> newton(Barycentric<4> u) const {
    for (int step = 0; step < kNewtonSteps; ++step) {
      const Eigen::Matrix<double, 3, 4> at = linearized(u);
      if (!at.allFinite()) return {};
      const double distance = at.col(0).norm();
      const Vector3 change =
          at.rightCols<3>().completeOrthogonalDecomposition().solve(Vector3(-at.col(0)));
      if (distance <= options_.toleranceMm && (change.norm() < 1e-14 || step > kNewtonSteps / 2))
        return clamped(u);
      Barycentric<4> next = u;
      next.tail<3>() += change;
      next[0] -= change.sum();
      next = clamped(next);
      if ((next - u).norm() < 1e-15)
        return distance <= options_.toleranceMm ? std::optional(u) : std::nullopt;
      u = next;
    }
    return linearized(u).col(0).norm() <= options_.toleranceMm ? std::optional(u) : std::nullopt;
  }

  static Barycentric<4> clamped(Barycentric<4> u) {
    u = u.cwiseMax(0.0);
    return u / u.sum();
  }

  int degree_;
  SimplexNet net_;
  InversionOptions options_;
  std::vector<Barycentric<4>> solutions_;
};

}  // namespace

std::vector<Barycentric<4>> locate(const BezierTetrahedron& solid, const Vector3& point,
                                   const InversionOptions& options) {
  if (solid.dimension() != 3)
    throw std::invalid_argument("locate: in a solid in E3; project it from E4 first");
  if (!point.allFinite()) throw std::invalid_argument("point: coordinates must be finite");
  if (!(std::isfinite(options.toleranceMm) && options.toleranceMm > 0.0)) {
    throw std::invalid_argument("tolerance: must be finite and > 0");
  }
  return Locator(solid, point, options).run();
}

}  // namespace osculate
