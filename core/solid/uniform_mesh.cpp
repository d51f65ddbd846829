#include <cmath>
#include <stdexcept>
#include <string>

#include "osculate/bezier/simplex_evaluator.h"
#include "osculate/bezier/vector3.h"
#include "osculate/solid/mesh.h"

namespace osculate {

namespace {

constexpr int kMaxUniform = 200;

void checkDivisions(int m, int largest) {
  if (m < 1 || m > largest) {
    throw std::invalid_argument("n: the divisions must be 1 to " + std::to_string(largest) +
                                ", got " + std::to_string(m));
  }
}

void checkSpace(const BezierTetrahedron& solid) {
  if (solid.dimension() != 3)
    throw std::invalid_argument("mesh: of a solid in E3; project it from E4 first");
}

/// Positions in the net of degree m of the neighbours of a place (r1, r2) given by its rest sums:
/// the corner c adds to r1 = j+k+l for c >= 1, to r2 = k+l for c >= 2, to l for c = 3.
struct Place {
  int r1, r2, r3;

  int plus(int a, int b = 0, int c = 0) const {
    const int s1 = r1 + (a > 0) + (b > 0) + (c > 0);
    const int s2 = r2 + (a > 1) + (b > 1) + (c > 1);
    const int s3 = r3 + (a > 2) + (b > 2) + (c > 2);
    return s1 * (s1 + 1) * (s1 + 2) / 6 + s2 * (s2 + 1) / 2 + s3;
  }
};

/// Calls f(place) for every point of a net of this degree.
template <class F>
void forPlaces(int degree, F f) {
  for (int r1 = 0; r1 <= degree; ++r1) {
    for (int r2 = 0; r2 <= r1; ++r2) {
      for (int r3 = 0; r3 <= r2; ++r3)
        f(Place{r1, r2, r3});
    }
  }
}

std::vector<int> latticeTetrahedra(int m) {
  std::vector<int> result;
  result.reserve(4 * static_cast<std::size_t>(m) * static_cast<std::size_t>(m) *
                 static_cast<std::size_t>(m));
  const auto add = [&](int a, int b, int c, int d) { result.insert(result.end(), {a, b, c, d}); };
  forPlaces(m - 1, [&](Place p) { add(p.plus(0), p.plus(1), p.plus(2), p.plus(3)); });
  // octahedra, cut as in the refinement of a tetrahedron
  forPlaces(m - 2, [&](Place p) {
    add(p.plus(0, 1), p.plus(0, 2), p.plus(0, 3), p.plus(1, 3));
    add(p.plus(0, 1), p.plus(0, 2), p.plus(1, 3), p.plus(1, 2));
    add(p.plus(0, 2), p.plus(0, 3), p.plus(1, 3), p.plus(2, 3));
    add(p.plus(0, 2), p.plus(1, 2), p.plus(2, 3), p.plus(1, 3));
  });
  forPlaces(m - 3, [&](Place p) {
    add(p.plus(1, 2, 3), p.plus(0, 1, 3), p.plus(0, 2, 3), p.plus(0, 1, 2));
  });
  return result;
}

/// Triangles of a lattice of m divisions with vertices by at(r2, r3); turned over for odd faces,
/// whose corners in order turn right seen from outside.
template <class At, class Add>
void forTriangles(int m, bool turned, At at, Add add) {
  const auto addTurned = [&](int a, int b, int c) { turned ? add(a, c, b) : add(a, b, c); };
  for (int r2 = 0; r2 < m; ++r2) {
    for (int r3 = 0; r3 <= r2; ++r3) {
      addTurned(at(r2, r3), at(r2 + 1, r3), at(r2 + 1, r3 + 1));
      if (r3 < r2) addTurned(at(r2, r3), at(r2 + 1, r3 + 1), at(r2, r3 + 1));
    }
  }
}

void addBoundary(int m, SolidMesh& mesh) {
  for (int face = 0; face < 4; ++face) {
    const auto at = [&](int r2, int r3) {
      const std::array<int, 3> onFace{m - r2, r2 - r3, r3};
      MultiIndex<4> index{};
      for (int c = 0, next = 0; c < 4; ++c) {
        if (c != face)
          index[static_cast<std::size_t>(c)] = onFace[static_cast<std::size_t>(next++)];
      }
      return netIndex<4>(index);
    };
    forTriangles(m, face % 2 == 1, at, [&](int a, int b, int c) {
      mesh.triangles.insert(mesh.triangles.end(), {a, b, c});
      mesh.triangleFaces.push_back(face);
    });
  }
}

/// Point and unit normal of a face as a homogeneous net of three corners.
class FaceGeometry {
 public:
  FaceGeometry(const BezierTetrahedron& solid, int face)
      : degree_(solid.degree()),
        sign_(face % 2 == 0 ? 1.0 : -1.0),
        net_(faceNet<4>(solid.homogeneousWithWeights(), solid.degree(), face)) {
    const Eigen::ArrayXXd points =
        net_.topRows<3>().array().rowwise() / net_.row(3).array().max(1e-300);
    size_ = (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).matrix().norm();
  }

  void at(const Barycentric<3>& u, double* point, double* normal) {
    Eigen::Map<Vector3> x(point);
    Eigen::Map<Vector3> n(normal);
    n = cross(u, &x);
    // where the face collapses: a little towards its middle
    for (double step = 1e-7; !(n.norm() > 1e-12 * size_ * size_ * step) && step < 0.1; step *= 10.0)
      n = cross((1.0 - step) * u + step * Barycentric<3>::Constant(1.0 / 3.0), nullptr);
    n = sign_ * n.normalized();
  }

 private:
  Vector3 cross(const Barycentric<3>& u, Eigen::Map<Vector3>* point) {
    work_ = net_;
    for (int d = degree_; d > 1; --d)
      reduceNet<3>(work_, d, u);
    const Eigen::Vector4d h = work_.leftCols<3>() * u;
    const Vector3 x = h.head<3>() / h[3];
    if (point != nullptr) *point = x;
    const auto along = [&](int c) -> Vector3 {
      const Eigen::Vector4d d = work_.col(c) - work_.col(0);
      return (d.head<3>() - d[3] * x) * (degree_ / h[3]);
    };
    return along(1).cross(along(2));
  }

  int degree_;
  double sign_;
  double size_;
  SimplexNet net_;
  SimplexNet work_;
};

}  // namespace

SolidMesh uniformMesh(const BezierTetrahedron& solid, int m) {
  checkSpace(solid);
  checkDivisions(m, kMaxUniform);
  SolidMesh mesh;
  mesh.points.resize(3 * TetrahedronEvaluator::gridSize(m));
  TetrahedronEvaluator(solid).grid(m, mesh.points);
  mesh.coordinates.reserve(4 * TetrahedronEvaluator::gridSize(m));
  forPlaces(m, [&](Place p) {
    for (const int count : {m - p.r1, p.r1 - p.r2, p.r2 - p.r3, p.r3})
      mesh.coordinates.push_back(static_cast<double>(count) / m);
  });
  mesh.tetrahedra = latticeTetrahedra(m);
  addBoundary(m, mesh);
  return mesh;
}

FaceMesh faceMesh(const BezierTetrahedron& solid, int face, int m) {
  checkSpace(solid);
  checkDivisions(m, kMaxDivisions);
  if (face < 0 || face > 3)
    throw std::invalid_argument("face: must be 0 to 3, got " + std::to_string(face));
  FaceGeometry geometry(solid, face);
  FaceMesh mesh;
  const auto count = static_cast<std::size_t>(netSize<3>(m));
  mesh.points.resize(3 * count);
  mesh.normals.resize(3 * count);
  std::size_t next = 0;
  for (int r2 = 0; r2 <= m; ++r2) {
    for (int r3 = 0; r3 <= r2; ++r3, next += 3)
      geometry.at(Barycentric<3>(m - r2, r2 - r3, r3) / m, mesh.points.data() + next,
                  mesh.normals.data() + next);
  }
  mesh.triangles.reserve(3 * static_cast<std::size_t>(m) * static_cast<std::size_t>(m));
  forTriangles(
      m, face % 2 == 1, [](int r2, int r3) { return r2 * (r2 + 1) / 2 + r3; },
      [&](int a, int b, int c) {
        mesh.triangles.insert(mesh.triangles.end(), {a, b, c});
      });
  return mesh;
}

}  // namespace osculate
