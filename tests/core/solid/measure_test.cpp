#include "osculate/solid/measure.h"

#include "osculate/solid/jacobian.h"
#include "osculate/solid/primitives.h"
#include "support/errors.h"
#include "support/simplex_samples.h"

namespace osculate::test {
namespace {

TEST(Measure, OfATetrahedron) {
  const BezierTetrahedron solid = linearTetrahedron({1, 1, 1}, {4, 1, 1}, {1, 3, 1}, {1, 1, 6});
  const SolidMeasure found = measure(solid);
  EXPECT_NEAR(found.volume, 5.0, 1e-14);
  EXPECT_LE((found.centroid - Vector3(1.75, 1.5, 2.25)).norm(), 1e-14);
  EXPECT_NEAR(measure(solid.relabelled({1, 0, 2, 3})).volume, -5.0, 1e-14);
}

// A second method: the integral of the Jacobian is the mean of its Bernstein coefficients / 6.
TEST(Measure, OfAPolynomialSolidIsExact) {
  Random random(1);
  for (int degree = 1; degree <= 8; ++degree) {
    const BezierTetrahedron solid = randomSolid(random, degree, false);
    const double expected = jacobianNumerator(solid).coefficients.mean() / 6.0;
    EXPECT_NEAR(measure(solid).volume, expected, 1e-12 * std::abs(expected)) << degree;
    EXPECT_LE(measure(solid).volumeError, 1e-11 * std::abs(expected));
  }
}

TEST(Measure, OfPartsIsThatOfTheWhole) {
  Random random(2);
  const BezierTetrahedron solid = randomSolid(random, 3, true);
  const SolidMeasure whole = measure(solid);
  double volume = 0.0;
  Vector3 moment = Vector3::Zero();
  for (const BezierTetrahedron& part : solid.refined()) {
    const SolidMeasure found = measure(part);
    volume += found.volume;
    moment += found.volume * found.centroid;
  }
  EXPECT_NEAR(volume, whole.volume, 1e-11 * whole.volume);
  EXPECT_LE((moment / volume - whole.centroid).norm(), 1e-11);
}

TEST(Measure, MovesWithTheSolidAndKeepsItsDigitsFarAway) {
  Random random(3);
  const BezierTetrahedron solid = randomSolid(random, 3, true);
  const Vector3 far(1e5, -2e5, 3e5);
  const SolidMeasure here = measure(solid);
  const SolidMeasure there = measure(solid.transformed(Eigen::Matrix3d::Identity(), far));
  EXPECT_NEAR(there.volume, here.volume, 1e-9 * here.volume);
  EXPECT_LE((there.centroid - far - here.centroid).norm(), 1e-9);
}

TEST(Measure, HandlesWeightsOfAnyRatio) {
  Random random(4);
  const BezierTetrahedron flat = randomSolid(random, 1, false);
  std::vector<double> weights{1.0, 1e-4, 50.0, 1.0};
  const SolidMeasure found = measure(BezierTetrahedron(1, flat.points(), weights));
  const double expected = measure(flat).volume;
  EXPECT_NEAR(found.volume, expected, std::max(found.volumeError, 1e-9 * expected));
  EXPECT_LE(found.volumeError, 1e-6 * expected);
}

TEST(Measure, OfACollapsedSolidIsZeroWithoutCentroid) {
  const BezierTetrahedron point(1, Eigen::MatrixXd::Constant(3, 4, 2.0));
  EXPECT_EQ(measure(point).volume, 0.0);
  EXPECT_TRUE(measure(point).centroid.hasNaN());
}

TEST(Measure, RefusesE4) {
  Random random(5);
  EXPECT_ERROR(measure(randomSolid(random, 2, false, 4)), "project it from E4 first");
}

}  // namespace
}  // namespace osculate::test
