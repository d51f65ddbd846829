#include "osculate/solid/inversion.h"

#include "osculate/solid/primitives.h"
#include "support/errors.h"
#include "support/simplex_samples.h"

namespace osculate::test {
namespace {

TEST(Inversion, FindsTheCoordinatesOfPointsInside) {
  Random random(1);
  for (const int degree : {1, 2, 3, 5}) {
    for (const bool rational : {false, true}) {
      const BezierTetrahedron solid = randomSolid(random, degree, rational, 3, 0.1);
      for (int i = 0; i < 5; ++i) {
        const Barycentric<4> u = randomBary<4>(random);
        const auto found = locate(solid, solid.evaluate(u));
        ASSERT_EQ(found.size(), 1U);
        EXPECT_LE((found[0] - u).norm(), 1e-8);
      }
    }
  }
}

TEST(Inversion, FindsPointsOfFacesEdgesAndCorners) {
  Random random(2);
  const BezierTetrahedron solid = randomSolid(random, 3, true, 3, 0.1);
  for (const Barycentric<4>& u :
       {Barycentric<4>(0.0, 0.2, 0.3, 0.5), {0.0, 0.25, 0.75, 0.0}, {0.0, 0.0, 0.0, 1.0}}) {
    const auto found = locate(solid, solid.evaluate(u));
    ASSERT_EQ(found.size(), 1U);
    EXPECT_LE((found[0] - u).norm(), 1e-7);
  }
}

TEST(Inversion, PointsOutsideHaveNone) {
  const BezierTetrahedron octant = ballOctant(10.0);
  EXPECT_TRUE(locate(octant, Vector3(6.0, 6.0, 6.0)).empty());  // outside by 0.39 mm
  EXPECT_TRUE(locate(octant, Vector3(-1.0, 2.0, 2.0)).empty());
  EXPECT_EQ(locate(octant, Vector3(5.7, 5.7, 5.7)).size(), 1U);
}

TEST(Inversion, AFoldedSolidHasSeveral) {
  // x = u -> a map that goes forth, back and forth along x
  Eigen::MatrixXd points(3, netSize<4>(3));
  Eigen::Index position = 0;
  const std::array<double, 4> x{0.0, 3.0, -2.0, 1.0};
  for (const MultiIndex<4>& i : multiIndices<4>(3))
    points.col(position++) << x[static_cast<std::size_t>(i[1])], i[2], i[3];
  const BezierTetrahedron solid(3, points);
  const auto found = locate(solid, Vector3(0.5, 0.0, 0.0));
  ASSERT_EQ(found.size(), 3U);
  for (const Barycentric<4>& u : found)
    EXPECT_LE((solid.evaluate(u) - Vector3(0.5, 0.0, 0.0)).norm(), 1e-9);
}

TEST(Inversion, RefusesBadArguments) {
  Random random(3);
  EXPECT_ERROR(locate(randomSolid(random, 2, false, 4), Vector3::Zero()),
               "project it from E4 first");
  const BezierTetrahedron solid = randomSolid(random, 2, false);
  EXPECT_ERROR(locate(solid, Vector3::Constant(NAN)), "point: coordinates must be finite");
  EXPECT_ERROR(locate(solid, Vector3::Zero(), {.toleranceMm = 0.0}),
               "tolerance: must be finite and > 0");
}

}  // namespace
}  // namespace osculate::test
