#include "osculate/bezier/bezier_tetrahedron.h"

#include "support/errors.h"
#include "support/simplex_samples.h"

namespace osculate::test {
namespace {

/// The point of the solid that belongs to a point of a face.
Barycentric<4> onFace(int opposite, const Barycentric<3>& u) {
  Barycentric<4> result = Barycentric<4>::Zero();
  for (int c = 0, next = 0; c < 4; ++c) {
    if (c != opposite) result[c] = u[next++];
  }
  return result;
}

// Theorem 1.3.4.
TEST(BezierTetrahedron, FacesAreBezierTriangles) {
  forSimplices<4>(20, [](Random& random, const BezierTetrahedron& solid) {
    for (int opposite = 0; opposite < 4; ++opposite) {
      const Barycentric<3> u = randomBary<3>(random);
      const BezierTriangle triangle = face(solid, opposite);
      EXPECT_EQ(triangle.isRational(), solid.isRational());
      EXPECT_LE((triangle.evaluate(u) - solid.evaluate(onFace(opposite, u))).norm(),
                roundingOf(solid));
    }
  });
}

TEST(BezierTetrahedron, EdgesAreBezierCurvesOfTheFacesToo) {
  forSimplices<4>(21, [](Random& random, const BezierTetrahedron& solid) {
    if (solid.dimension() == 4) return;
    const double t = random.uniform(0.0, 1.0);
    for (int a = 0; a < 4; ++a) {
      for (int b = 0; b < 4; ++b) {
        if (a == b) continue;
        const Barycentric<4> u = (1.0 - t) * Barycentric<4>::Unit(a) + t * Barycentric<4>::Unit(b);
        EXPECT_LE((edgeCurve(solid, a, b).evaluate(t) - solid.evaluate(u)).norm(),
                  roundingOf(solid));
      }
    }
    EXPECT_TRUE(identical(edgeCurve(face(solid, 0), 0, 2), edgeCurve(solid, 1, 3)));
  });
}

TEST(BezierTetrahedron, CutsAreExactSurfacesInside) {
  forSimplices<4>(22, [](Random& random, const BezierTetrahedron& solid) {
    const PartCornersOf<4, 3> corners{randomBary<4>(random), randomBary<4>(random),
                                      randomBary<4>(random)};
    const Barycentric<3> u = randomBary<3>(random);
    const Barycentric<4> inside = u[0] * corners[0] + u[1] * corners[1] + u[2] * corners[2];
    EXPECT_LE((cut(solid, corners).evaluate(u) - solid.evaluate(inside)).norm(),
              4 * roundingOf(solid));
    const Barycentric<4> iso = onFace(2, 0.7 * u) + 0.3 * Barycentric<4>::Unit(2);
    EXPECT_LE((isoSurface(solid, 2, 0.3).evaluate(u) - solid.evaluate(iso)).norm(),
              4 * roundingOf(solid));
  });
}

TEST(BezierTetrahedron, TheIsoSurfaceAtZeroIsTheFace) {
  Random random(23);
  const BezierTetrahedron solid = randomSolid(random, 3, false);
  EXPECT_EQ(isoSurface(solid, 1, 0.0), face(solid, 1));
}

TEST(BezierTetrahedron, EdgesWithZeroWeightsInsideAreRaisedUntilTheyAreCurves) {
  Eigen::MatrixXd points = Eigen::MatrixXd::Random(3, 10);
  std::vector<double> weights(10, 1.0);
  weights[1] = 0.0;  // (1, 1, 0, 0)
  const BezierTetrahedron solid(2, points, weights);
  const BezierCurve edge = edgeCurve(solid, 0, 1);
  EXPECT_EQ(edge.degree(), 3);
  EXPECT_LE((edge.evaluate(0.3) - solid.evaluate({0.7, 0.3, 0.0, 0.0})).norm(), 1e-15);
  weights[0] = 0.0;
  EXPECT_ERROR(edgeCurve(BezierTetrahedron(2, points, weights), 0, 1), "an end has weight 0");
}

TEST(BezierTetrahedron, RefusesWhatIsNoFaceOrEdge) {
  const BezierTetrahedron solid(1, Eigen::MatrixXd::Random(3, 4));
  EXPECT_ERROR(face(solid, 4), "face: must be 0 to 3");
  EXPECT_ERROR(edgeCurve(solid, 0, 0), "edge: needs two different corners");
  EXPECT_ERROR(isoSurface(solid, 0, 1.0), "c: must be from 0 to below 1");
  EXPECT_ERROR(isoSurface(solid, 5, 0.5), "coordinate: must be 0 to 3");
  const BezierTetrahedron inE4(1, Eigen::MatrixXd::Random(4, 4));
  EXPECT_ERROR(edgeCurve(inE4, 0, 1), "project the solid from E4 first");
}

}  // namespace
}  // namespace osculate::test
