#include "osculate/solid/slice.h"

#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <unordered_map>

#include "osculate/solid/mesh.h"

namespace osculate {

namespace {

class Slicer {
 public:
  Slicer(const BezierTetrahedron& solid, const Vector3& origin, const Vector3& normal,
         const SolidMesh& mesh)
      : solid_(solid), origin_(origin), normal_(normal), mesh_(mesh) {
    for (std::size_t i = 0; i < mesh.points.size(); i += 3)
      heights_.push_back(normal.dot(Eigen::Map<const Vector3>(mesh.points.data() + i) - origin));
  }

  SolidSlice run() {
    for (std::size_t i = 0; i < mesh_.tetrahedra.size(); i += 4)
      cut(mesh_.tetrahedra.data() + i);
    return std::move(result_);
  }

 private:
  double height(int vertex) const { return heights_[static_cast<std::size_t>(vertex)]; }
  bool isAbove(int vertex) const { return height(vertex) > 0.0; }

  void cut(const int* vertices) {
    std::array<int, 4> above{};
    std::array<int, 4> below{};
    std::size_t a = 0;
    std::size_t b = 0;
    for (int k = 0; k < 4; ++k) {
      if (!std::isfinite(height(vertices[k]))) return;
      isAbove(vertices[k]) ? above[a++] = vertices[k] : below[b++] = vertices[k];
    }
    if (a == 0 || b == 0) return;
    if (a == 2) {
      addTriangle(between(above[0], below[0]), between(above[0], below[1]),
                  between(above[1], below[0]));
      addTriangle(between(above[1], below[0]), between(above[0], below[1]),
                  between(above[1], below[1]));
      return;
    }
    const int single = a == 1 ? above[0] : below[0];
    const auto& others = a == 1 ? below : above;
    addTriangle(between(single, others[0]), between(single, others[1]), between(single, others[2]));
  }

  Eigen::Map<const Vector3> point(int vertex) const {
    return Eigen::Map<const Vector3>(result_.points.data() + 3 * vertex);
  }

  void addTriangle(int p, int q, int r) {
    if (p == q || q == r || r == p) return;
    const Vector3 turn = (point(q) - point(p)).cross(point(r) - point(p));
    if (turn.dot(normal_) < 0.0) std::swap(q, r);
    result_.triangles.insert(result_.triangles.end(), {p, q, r});
  }

  Barycentric<4> coordinates(int vertex) const {
    return Eigen::Map<const Barycentric<4>>(mesh_.coordinates.data() + 4 * vertex);
  }

  /// The vertex where the line of the domain between two lattice points crosses the plane.
  int between(int p, int q) {
    const auto key = static_cast<std::uint64_t>(std::min(p, q)) << 32U |
                     static_cast<std::uint64_t>(std::max(p, q));
    const auto [entry, isNew] =
        vertices_.try_emplace(key, static_cast<int>(result_.points.size() / 3));
    if (!isNew) return entry->second;
    const Barycentric<4> from = coordinates(p);
    const Barycentric<4> along = coordinates(q) - from;
    const auto heightAt = [&](double s) {
      return normal_.dot(solid_.evaluate(from + s * along) - origin_);
    };
    double s = height(p) == 0.0 ? 0.0 : 1.0;
    if (height(p) != 0.0 && height(q) != 0.0) {
      std::uintmax_t steps = 60;
      const auto [low, high] =
          boost::math::tools::toms748_solve(heightAt, 0.0, 1.0, height(p), height(q),
                                            boost::math::tools::eps_tolerance<double>(52), steps);
      s = std::abs(heightAt(low)) < std::abs(heightAt(high)) ? low : high;
    }
    const Barycentric<4> u = from + s * along;
    const SpacePoint x = solid_.evaluate(u);
    result_.points.insert(result_.points.end(), x.data(), x.data() + 3);
    result_.coordinates.insert(result_.coordinates.end(), u.data(), u.data() + 4);
    return entry->second;
  }

  const BezierTetrahedron& solid_;
  Vector3 origin_;
  Vector3 normal_;
  const SolidMesh& mesh_;
  std::vector<double> heights_;
  std::unordered_map<std::uint64_t, int> vertices_;
  SolidSlice result_;
};

}  // namespace

SolidSlice slice(const BezierTetrahedron& solid, const Vector3& origin, const Vector3& normal,
                 int m) {
  if (!origin.allFinite() || !normal.allFinite() || !(normal.norm() > 0.0)) {
    throw std::invalid_argument("normal: must be finite and not 0, and the origin finite");
  }
  return Slicer(solid, origin, normal.normalized(), uniformMesh(solid, m)).run();
}

}  // namespace osculate
