#include "osculate/solid/solid_contact.h"

#include "osculate/solid/neighbour.h"
#include "support/errors.h"
#include "support/simplex_samples.h"

namespace osculate::test {
namespace {

const Barycentric<4> kApex(-0.25, 0.5, 0.25, 0.5);

TEST(SolidContact, FindsTheOrderOfANeighbourUnderAnyLabels) {
  Random random(1);
  for (const bool rational : {false, true}) {
    for (const int dimension : {3, 4}) {
      for (const int degree : {2, 3, 4}) {
        const BezierTetrahedron solid = randomSolid(random, degree, rational, dimension, 0.2);
        for (int order = 0; order <= degree; ++order) {
          const BezierTetrahedron next = neighbour(solid, 0, kApex, order).relabelled({2, 0, 3, 1});
          const SolidContact found = contact(solid, next);
          SCOPED_TRACE("degree " + std::to_string(degree) + " order " + std::to_string(order));
          ASSERT_TRUE(found.meets);
          EXPECT_EQ(found.faces.first, 0);
          EXPECT_EQ(found.faces.second, 1);
          EXPECT_EQ(found.faces.corners, (MultiIndex<4>{1, 3, 0, 2}));
          EXPECT_EQ(found.homogeneous.order, order);
          EXPECT_EQ(found.cartesian.order, order);
          EXPECT_FALSE(found.overlaps);
          if (order >= 1) {
            EXPECT_LE((found.cartesian.apex - kApex).norm(), 1e-9);
          }
        }
      }
    }
  }
}

TEST(SolidContact, TwoLinearTetrahedraAreAlwaysSmoothForSomeDomain) {
  Random random(9);
  const BezierTetrahedron solid = randomSolid(random, 1, false);
  const SpacePoint apex = Vector3(-3.0, 1.0, 2.0);
  EXPECT_EQ(contact(solid, neighbour(solid, 0, kApex, 0, {.apexPoint = apex})).cartesian.order, 1);
}

TEST(SolidContact, ACommonFactorOfTheWeightsHidesContactFromTheHomogeneousNetsOnly) {
  Random random(2);
  const BezierTetrahedron solid = randomSolid(random, 2, true, 3, 0.1);
  const BezierTetrahedron next = neighbour(solid, 0, kApex, 2);
  // the same map with numerator and weight times a linear function that is not constant
  SimplexNet net = next.homogeneous();
  SimplexNet scaled(4, netSize<4>(3));
  for (Eigen::Index row = 0; row < 4; ++row) {
    const Eigen::RowVectorXd monomials = net.row(row).cwiseProduct(multinomials<4>(2));
    scaled.row(row) = multiplyMonomials<4>(monomials, 2, Eigen::RowVector4d(1.0, 2.0, 1.5, 1.2), 1)
                          .cwiseQuotient(multinomials<4>(3));
  }
  const SolidContact found = contact(solid, BezierTetrahedron::fromHomogeneous(3, 3, scaled));
  EXPECT_TRUE(found.meets);
  EXPECT_EQ(found.cartesian.order, 3);
  EXPECT_EQ(found.homogeneous.order, -1);
  EXPECT_LE((found.cartesian.apex - kApex).norm(), 1e-9);
}

TEST(SolidContact, AConstantFactorOfTheWeightsChangesNothing) {
  Random random(3);
  const BezierTetrahedron solid = randomSolid(random, 3, true, 3, 0.1);
  const BezierTetrahedron next = neighbour(solid, 0, kApex, 2);
  std::vector<double> weights = next.weights();
  for (double& weight : weights)
    weight *= 7.0;
  EXPECT_EQ(contact(solid, BezierTetrahedron(3, next.points(), weights)).homogeneous.order, 2);
}

TEST(SolidContact, DegreesMayDiffer) {
  Random random(4);
  const BezierTetrahedron solid = randomSolid(random, 3, false);
  const BezierTetrahedron next = neighbour(solid, 2, Barycentric<4>(0.5, 0.5, -0.5, 0.5), 1);
  const SolidContact found = contact(solid, next.elevated(2));
  EXPECT_EQ(found.degree, 5);
  EXPECT_EQ(found.cartesian.order, 1);
}

TEST(SolidContact, ASolidOverlapsItsOwnParts) {
  Random random(5);
  const BezierTetrahedron solid = randomSolid(random, 3, true);
  const auto parts = solid.subdivided(Barycentric<4>(0.4, 0.2, 0.2, 0.2));
  const SolidContact found = contact(solid, parts[0]);
  EXPECT_TRUE(found.overlaps);
  EXPECT_EQ(found.cartesian.order, 3);
  EXPECT_LE((found.cartesian.apex - Barycentric<4>(0.4, 0.2, 0.2, 0.2)).norm(), 1e-9);
  const SolidContact between = contact(parts[0], parts[1]);
  EXPECT_FALSE(between.overlaps);
  EXPECT_EQ(between.cartesian.order, 3);
}

TEST(SolidContact, ResidualsAreTheDisplacementsOfTheLayers) {
  Random random(6);
  const BezierTetrahedron solid = randomSolid(random, 4, false);
  const BezierTetrahedron next = neighbour(solid, 0, kApex, 3);
  Eigen::MatrixXd points = next.points();
  points(2, netIndex<4>({2, 1, 1, 0})) += 0.125;
  SolidContactOptions options;
  options.apex = kApex;
  const SolidContact found = contact(solid, BezierTetrahedron(4, points), options);
  EXPECT_EQ(found.homogeneous.order, 1);
  EXPECT_NEAR(found.homogeneous.residualsMm[2], 0.125, 1e-12);
  EXPECT_LE(found.homogeneous.residualsMm[1], 1e-13);
}

TEST(SolidContact, FacesThatDoNotMeetHaveAGapAndNoOrder) {
  Random random(7);
  const BezierTetrahedron solid = randomSolid(random, 2, false);
  const BezierTetrahedron next = neighbour(solid, 0, kApex, 1);
  const BezierTetrahedron moved =
      next.transformed(Eigen::Matrix3d::Identity(), Vector3(0.01, 0.0, 0.0));
  const SolidContact found = contact(solid, moved);
  EXPECT_FALSE(found.meets);
  EXPECT_NEAR(found.gapMm, 0.01, 1e-12);
  EXPECT_EQ(found.faces.first, 0);
  EXPECT_EQ(found.cartesian.order, -1);
  EXPECT_TRUE(found.cartesian.residualsMm.empty());
  SolidContactOptions loose;
  loose.toleranceMm = 0.1;
  EXPECT_GE(contact(solid, moved, loose).cartesian.order, 0);
}

TEST(SolidContact, RefusesBadArguments) {
  Random random(8);
  const BezierTetrahedron solid = randomSolid(random, 2, false);
  EXPECT_ERROR(contact(solid, randomSolid(random, 2, false, 4)),
               "one solid is in E3, the other in E4");
  SolidContactOptions options;
  options.toleranceMm = 0.0;
  EXPECT_ERROR(contact(solid, solid, options), "tolerance: must be finite and > 0");
}

}  // namespace
}  // namespace osculate::test
