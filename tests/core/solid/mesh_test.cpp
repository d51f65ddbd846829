#include "osculate/solid/mesh.h"

#include <map>
#include <set>

#include "osculate/solid/measure.h"
#include "osculate/solid/primitives.h"
#include "osculate/solid/slice.h"
#include "support/errors.h"
#include "support/simplex_samples.h"

namespace osculate::test {
namespace {

Vector3 pointOf(const std::vector<double>& points, int vertex) {
  return Eigen::Map<const Vector3>(points.data() + 3 * vertex);
}

double volumeOfTetrahedra(const SolidMesh& mesh) {
  double sum = 0.0;
  for (std::size_t i = 0; i < mesh.tetrahedra.size(); i += 4) {
    const auto p = [&](std::size_t k) { return pointOf(mesh.points, mesh.tetrahedra[i + k]); };
    sum += (p(1) - p(0)).cross(p(2) - p(0)).dot(p(3) - p(0)) / 6.0;
  }
  return sum;
}

double volumeInsideTriangles(const SolidMesh& mesh) {
  double sum = 0.0;
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
    const auto p = [&](std::size_t k) { return pointOf(mesh.points, mesh.triangles[i + k]); };
    sum += p(0).cross(p(1)).dot(p(2)) / 6.0;
  }
  return sum;
}

/// Inner sides of tetrahedra occur twice, the others are the boundary triangles.
void expectConforming(const SolidMesh& mesh) {
  std::map<std::set<int>, int> sides;
  for (std::size_t i = 0; i < mesh.tetrahedra.size(); i += 4) {
    for (std::size_t k = 0; k < 4; ++k) {
      std::set<int> side(mesh.tetrahedra.begin() + static_cast<std::ptrdiff_t>(i),
                         mesh.tetrahedra.begin() + static_cast<std::ptrdiff_t>(i + 4));
      side.erase(mesh.tetrahedra[i + k]);
      ++sides[side];
    }
  }
  std::size_t outer = 0;
  for (const auto& [side, count] : sides) {
    EXPECT_LE(count, 2);
    outer += count == 1 ? 1 : 0;
  }
  EXPECT_EQ(outer, mesh.triangles.size() / 3);
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
    const std::set<int> side{mesh.triangles[i], mesh.triangles[i + 1], mesh.triangles[i + 2]};
    EXPECT_EQ(sides[side], 1);
  }
}

TEST(Mesh, AUniformOneFillsTheSolid) {
  Random random(1);
  const BezierTetrahedron linear = randomSolid(random, 1, false);
  const double volume = measure(linear).volume;
  for (const int m : {1, 2, 3, 6}) {
    const SolidMesh mesh = uniformMesh(linear.elevated(2), m);
    EXPECT_EQ(mesh.tetrahedra.size(), 4U * static_cast<std::size_t>(m * m * m));
    EXPECT_EQ(mesh.triangles.size(), 3U * 4U * static_cast<std::size_t>(m * m));
    EXPECT_NEAR(volumeOfTetrahedra(mesh), volume, 1e-12 * volume);
    EXPECT_NEAR(volumeInsideTriangles(mesh), volume, 1e-12 * volume);
    expectConforming(mesh);
  }
}

TEST(Mesh, VerticesAreOnTheSolidAtTheirCoordinates) {
  Random random(2);
  const BezierTetrahedron solid = randomSolid(random, 3, true);
  for (const SolidMesh& mesh : {uniformMesh(solid, 5), adaptiveMesh(solid, 0.1)}) {
    for (std::size_t i = 0; i < mesh.points.size() / 3; ++i) {
      const Eigen::Map<const Barycentric<4>> u(mesh.coordinates.data() + 4 * i);
      EXPECT_LE((pointOf(mesh.points, static_cast<int>(i)) - solid.evaluate(u)).norm(),
                roundingOf(solid));
    }
  }
}

TEST(Mesh, OfACurvedSolidConvergesToItsVolume) {
  Random random(3);
  const BezierTetrahedron solid = randomSolid(random, 3, true);
  const double volume = measure(solid).volume;
  const double coarse = volumeInsideTriangles(uniformMesh(solid, 8)) - volume;
  const double fine = volumeInsideTriangles(uniformMesh(solid, 16)) - volume;
  EXPECT_NEAR(coarse / fine, 4.0, 0.3);
}

/// How far points of a face are from the triangles of a mesh of it, at the middles of its
/// triangles.
TEST(Mesh, TheDivisionsKeepTheChordalBound) {
  for (const double chordal : {1.0, 0.1, 0.01}) {
    const BezierTetrahedron octant = ballOctant(100.0);
    const int m = divisionsFor(octant, chordal);
    const FaceMesh mesh = faceMesh(octant, 3, m);
    double worst = 0.0;
    for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
      const Vector3 middle =
          (pointOf(mesh.points, mesh.triangles[i]) + pointOf(mesh.points, mesh.triangles[i + 1]) +
           pointOf(mesh.points, mesh.triangles[i + 2])) /
          3.0;
      worst = std::max(worst, 100.0 - middle.norm());
    }
    EXPECT_LE(worst, chordal);
    EXPECT_GE(worst, 0.05 * chordal) << "the bound should not waste much";
  }
}

TEST(Mesh, NormalsPointOutwards) {
  const BezierTetrahedron octant = ballOctant(10.0);
  const FaceMesh sphere = faceMesh(octant, 3, 6);
  for (std::size_t i = 0; i < sphere.points.size(); i += 3) {
    const Vector3 p = Eigen::Map<const Vector3>(sphere.points.data() + i);
    EXPECT_LE((Eigen::Map<const Vector3>(sphere.normals.data() + i) - p / 10.0).norm(), 1e-12);
  }
  for (int face = 0; face < 3; ++face) {
    const FaceMesh plane = faceMesh(octant, face, 6);
    for (std::size_t i = 0; i < plane.points.size(); i += 3) {
      const Eigen::Map<const Vector3> normal(plane.normals.data() + i);
      EXPECT_NEAR(normal.minCoeff(), -1.0, 1e-6);  // at the collapsed apex the limit
      EXPECT_NEAR(normal.norm(), 1.0, 1e-14);
    }
    for (std::size_t i = 0; i < plane.triangles.size(); i += 3) {
      const auto p = [&](std::size_t k) { return pointOf(plane.points, plane.triangles[i + k]); };
      const Vector3 turn = (p(1) - p(0)).cross(p(2) - p(0));
      EXPECT_GE(turn.dot(Eigen::Map<const Vector3>(plane.normals.data())), -1e-12);
    }
  }
}

TEST(Mesh, AnAdaptiveOneConformsAndKeepsItsBound) {
  Random random(4);
  for (const double chordal : {0.5, 0.05}) {
    for (const BezierTetrahedron& solid :
         {ballOctant(10.0), cone(5.0, 10.0), randomSolid(random, 3, true)}) {
      const SolidMesh mesh = adaptiveMesh(solid, chordal);
      expectConforming(mesh);
      EXPECT_NEAR(volumeOfTetrahedra(mesh), volumeInsideTriangles(mesh), 1e-9);
      const double area = 400.0;
      EXPECT_NEAR(volumeInsideTriangles(mesh), measure(solid).volume, area * chordal);
    }
  }
  for (const double chordal : {0.1, 0.01}) {
    const SolidMesh mesh = adaptiveMesh(ballOctant(10.0), chordal);
    for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
      if (mesh.triangleFaces[t / 3] != 3) continue;
      const Vector3 middle =
          (pointOf(mesh.points, mesh.triangles[t]) + pointOf(mesh.points, mesh.triangles[t + 1]) +
           pointOf(mesh.points, mesh.triangles[t + 2])) /
          3.0;
      EXPECT_LE(10.0 - middle.norm(), chordal);
    }
  }
}

TEST(Mesh, AnAdaptiveOneIsFineOnlyWhereTheFacesBend) {
  Eigen::MatrixXd points =
      linearTetrahedron({0, 0, 0}, {10, 0, 0}, {0, 10, 0}, {0, 0, 10}).elevated(2).points();
  points.col(netIndex<4>({0, 0, 1, 2})) += Vector3(0.0, 1.0, 1.0);
  const BezierTetrahedron bumped(3, points);
  const SolidMesh adaptive = adaptiveMesh(bumped, 0.01);
  const SolidMesh uniform = uniformMesh(bumped, divisionsFor(bumped, 0.01));
  EXPECT_LT(adaptive.triangles.size(), uniform.triangles.size() / 2);
}

TEST(Mesh, ALinearSolidNeedsOneTetrahedron) {
  const SolidMesh mesh =
      adaptiveMesh(linearTetrahedron({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}), 1e-6);
  EXPECT_EQ(mesh.tetrahedra, (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(divisionsFor(linearTetrahedron({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}), 1e-6), 1);
}

TEST(Mesh, ACornerOfWeightZeroDoesNotAskForTheFinestDivision) {
  const BezierTetrahedron octant = ballOctant(10.0);
  std::vector<double> weights = octant.weights();
  weights[static_cast<std::size_t>(netIndex<4>({4, 0, 0, 0}))] = 0.0;
  const int divisions = divisionsFor(BezierTetrahedron(4, octant.points(), weights), 0.01);
  EXPECT_GT(divisions, divisionsFor(octant, 0.01) / 4);
  EXPECT_LT(divisions, 1000);
}

TEST(Mesh, RefusesBadArguments) {
  Random random(5);
  const BezierTetrahedron solid = randomSolid(random, 2, false);
  EXPECT_ERROR(uniformMesh(solid, 0), "n: the divisions must be 1 to 200, got 0");
  EXPECT_ERROR(faceMesh(solid, 4, 2), "face: must be 0 to 3");
  EXPECT_ERROR(divisionsFor(solid, 0.0), "chordal_mm: must be finite and > 0");
  EXPECT_ERROR(adaptiveMesh(solid, -1.0), "chordal_mm: must be finite and > 0");
  EXPECT_ERROR(uniformMesh(randomSolid(random, 2, false, 4), 2), "project it from E4 first");
  EXPECT_THROW(adaptiveMesh(randomSolid(random, 3, true), 1e-6, 1000), std::runtime_error);
}

double areaOf(const SolidSlice& found) {
  double area = 0.0;
  for (std::size_t i = 0; i < found.triangles.size(); i += 3) {
    const auto p = [&](std::size_t k) { return pointOf(found.points, found.triangles[i + k]); };
    area += 0.5 * (p(1) - p(0)).cross(p(2) - p(0)).norm();
  }
  return area;
}

TEST(Slice, LiesOnThePlaneAndHasTheAreaOfTheSection) {
  const BezierTetrahedron solid = cone(3.0, 6.0);
  const Vector3 normal(0.0, 0.0, 2.0);
  const SolidSlice found = slice(solid, Vector3(0.0, 0.0, 2.0), normal, 30);
  for (std::size_t i = 0; i < found.points.size() / 3; ++i) {
    const Vector3 p = pointOf(found.points, static_cast<int>(i));
    EXPECT_NEAR(p.z(), 2.0, 1e-12);
    const Eigen::Map<const Barycentric<4>> u(found.coordinates.data() + 4 * i);
    EXPECT_LE((p - solid.evaluate(u)).norm(), 1e-13);
  }
  EXPECT_NEAR(areaOf(found), M_PI * 4.0, 0.03 * M_PI * 4.0);
  for (std::size_t i = 0; i < found.triangles.size(); i += 3) {
    const auto p = [&](std::size_t k) { return pointOf(found.points, found.triangles[i + k]); };
    EXPECT_GE((p(1) - p(0)).cross(p(2) - p(0)).z(), 0.0);
  }
}

TEST(Slice, ThroughLatticePointsHasNoHoles) {
  const BezierTetrahedron solid = linearTetrahedron({0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4});
  EXPECT_NEAR(areaOf(slice(solid, Vector3(0.0, 0.0, 2.0), Vector3::UnitZ(), 4)), 2.0, 1e-12);
  EXPECT_NEAR(areaOf(slice(solid, Vector3(0.0, 0.0, 2.0), -Vector3::UnitZ(), 4)), 2.0, 1e-12);
  EXPECT_TRUE(slice(solid, Vector3(0.0, 0.0, 5.0), Vector3::UnitZ(), 4).triangles.empty());
}

TEST(Slice, RefusesBadPlanes) {
  Random random(6);
  EXPECT_ERROR(slice(randomSolid(random, 2, false), Vector3::Zero(), Vector3::Zero(), 4),
               "normal: must be finite");
}

}  // namespace
}  // namespace osculate::test
