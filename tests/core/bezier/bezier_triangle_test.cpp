#include "osculate/bezier/bezier_triangle.h"

#include "support/errors.h"
#include "support/simplex_samples.h"

namespace osculate::test {
namespace {

TEST(BezierTriangle, EdgesAreCurves) {
  forSimplices<3>(50, [](Random& random, const BezierTriangle& triangle) {
    if (triangle.dimension() == 4) return;
    const double t = random.uniform(0.0, 1.0);
    for (int a = 0; a < 3; ++a) {
      const int b = (a + 1) % 3;
      const Barycentric<3> u = (1.0 - t) * Barycentric<3>::Unit(a) + t * Barycentric<3>::Unit(b);
      EXPECT_LE((edgeCurve(triangle, a, b).evaluate(t) - triangle.evaluate(u)).norm(),
                roundingOf(triangle));
    }
  });
}

TEST(BezierTriangle, ARationalQuadraticHoldsAQuarterCircle) {
  Eigen::MatrixXd points(3, 6);
  points << 1, 1, 0.5, 0, 0, 0,  //
      0, 1, 0, 1, 0.5, 0,        //
      0, 0, 0, 0, 0, 0;
  const double w = std::sqrt(0.5);
  const BezierTriangle sector(2, points, {1, w, 1, 1, 1, 1});
  for (const double t : {0.0, 0.1, 0.5, 0.9, 1.0})
    EXPECT_NEAR(edgeCurve(sector, 0, 1).evaluate(t).norm(), 1.0, 1e-15);
}

TEST(BezierTriangle, RefusesEdgesThatAreNone) {
  Random random(51);
  EXPECT_ERROR(edgeCurve(randomSimplex<3>(random, 2, false), 0, 3), "corners from 0 to 2");
  EXPECT_ERROR(edgeCurve(randomSimplex<3>(random, 2, false, 4), 0, 1), "E4");
}

}  // namespace
}  // namespace osculate::test
