#include "osculate/solid/space4.h"

#include <Eigen/LU>

#include "osculate/solid/net_shape.h"
#include "osculate/solid/primitives.h"
#include "support/errors.h"
#include "support/simplex_samples.h"

namespace osculate::test {
namespace {

Eigen::Vector4d randomVector4(Random& random) {
  return {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1),
          random.uniform(-1, 1)};
}

TEST(Space4, TheBasisIsOrthonormalAndTurnsAsTheAxes) {
  Random random(1);
  std::vector<Eigen::Vector4d> normals{Eigen::Vector4d::UnitW(), -Eigen::Vector4d::UnitW(),
                                       Eigen::Vector4d(1e-9, 0, 0, -1), Eigen::Vector4d::UnitX()};
  for (int i = 0; i < 20; ++i)
    normals.push_back(3.0 * randomVector4(random));
  for (const Eigen::Vector4d& a : normals) {
    Eigen::Matrix4d all;
    all << hyperplaneBasis(a), a.normalized();
    EXPECT_LE((all.transpose() * all - Eigen::Matrix4d::Identity()).norm(), 1e-6) << a.transpose();
    EXPECT_NEAR(all.determinant(), 1.0, 1e-6);
  }
  EXPECT_EQ(hyperplaneBasis(Eigen::Vector4d::UnitW()), (Eigen::Matrix<double, 4, 3>::Identity()));
}

TEST(Space4, EmbeddingAndParallelProjectionAreInverse) {
  Random random(2);
  const BezierTetrahedron solid = randomSolid(random, 3, true);
  const Eigen::Vector4d a = randomVector4(random);
  const BezierTetrahedron inE4 = embedded(solid, a);
  EXPECT_LE((a.transpose() * inE4.points()).norm(), 1e-12);
  EXPECT_EQ(dimensionOfNet(inE4), 3);
  EXPECT_LE((parallelProjection(inE4, a).points() - solid.points()).norm(), 1e-12);
}

// Section 2.1 of the thesis: the normal of a solid in a hyperplane is the hyperplane's.
TEST(Space4, TheNormalOfAnEmbeddedSolidIsThatOfItsHyperplane) {
  Random random(3);
  const Eigen::Vector4d a = randomVector4(random).normalized();
  const BezierTetrahedron inE4 = embedded(randomSolid(random, 3, true, 3, 0.1), a);
  for (int i = 0; i < 5; ++i)
    EXPECT_LE((tangentHyperplaneNormal(inE4, randomBary<4>(random)) - a).norm(), 1e-12);
}

TEST(Space4, TheTangentHyperplaneHoldsEveryDerivative) {
  Random random(4);
  const BezierTetrahedron solid = randomSolid(random, 4, true, 4);
  for (int i = 0; i < 10; ++i) {
    const Barycentric<4> u = randomBary<4>(random);
    const Eigen::Vector4d normal = tangentHyperplaneNormal(solid, u);
    EXPECT_NEAR(normal.norm(), 1.0, 1e-14);
    const std::vector<Barycentric<4>> direction{randomDirection<4>(random)};
    const SpacePoint derivative = solid.derivative(u, direction);
    EXPECT_LE(std::abs(normal.dot(derivative)), 1e-12 * derivative.norm());
  }
}

// 1.6.3 with corrections A2: Q = P - (P - X) m0, m0 = a.P / (a.P - a.X).
TEST(Space4, PerspectiveProjectsEveryPoint) {
  Random random(5);
  for (const bool rational : {false, true}) {
    const BezierTetrahedron solid = randomSolid(random, 3, rational, 4);
    const Eigen::Vector4d a(0.1, -0.2, 0.3, 1.0);
    const Eigen::Vector4d centre(1.0, 2.0, 3.0, 50.0);
    const BezierTetrahedron image = perspectiveProjection(solid, centre, a);
    EXPECT_TRUE(image.isRational());
    for (int i = 0; i < 5; ++i) {
      const Barycentric<4> u = randomBary<4>(random);
      const Eigen::Vector4d x = solid.evaluate(u);
      const Eigen::Vector4d q =
          centre - (centre - x) * (a.dot(centre) / (a.dot(centre) - a.dot(x)));
      EXPECT_NEAR(a.dot(q), 0.0, 1e-11);
      EXPECT_LE((image.evaluate(u) - hyperplaneBasis(a).transpose() * q).norm(), 1e-12);
    }
  }
}

TEST(Space4, RefusesWhatCannotBeProjected) {
  Random random(6);
  const BezierTetrahedron solid = randomTetrahedron(2, 1, 4);
  const Eigen::Vector4d a = Eigen::Vector4d::UnitW();
  EXPECT_ERROR(parallelProjection(randomTetrahedron(2, 1, 3), a), "solid: must be in E4, is in E3");
  EXPECT_ERROR(parallelProjection(solid, Eigen::Vector4d::Zero()),
               "direction: must be finite and not 0");
  EXPECT_ERROR(perspectiveProjection(solid, Eigen::Vector4d(1, 2, 3, 0), a),
               "must not lie in the hyperplane");
  EXPECT_ERROR(perspectiveProjection(solid, Eigen::Vector4d(1, 2, 3, 1e-3), a), "both sides");
  EXPECT_ERROR(embedded(solid, a), "solid: must be in E3");
}

}  // namespace
}  // namespace osculate::test
