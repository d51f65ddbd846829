#include "osculate/bezier/simplex_evaluator.h"

#include "support/simplex_samples.h"

namespace osculate::test {
namespace {

TEST(TetrahedronEvaluator, AgreesWithDeCasteljauAtAnyNumberOfPoints) {
  forSimplices<4>(30, [](Random& random, const BezierTetrahedron& solid) {
    const TetrahedronEvaluator evaluator(solid);
    for (const int count : {0, 1, 3, 4, 7}) {
      std::vector<double> at;
      for (int i = 0; i < count; ++i) {
        const Barycentric<4> u = randomBary<4>(random);
        at.insert(at.end(), u.data(), u.data() + 4);
      }
      const auto d = static_cast<std::size_t>(solid.dimension());
      std::vector<double> out(static_cast<std::size_t>(count) * d);
      evaluator.points(at, out);
      for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        const Eigen::Map<const Eigen::VectorXd> found(out.data() + d * i, solid.dimension());
        const Eigen::Map<const Barycentric<4>> u(at.data() + 4 * i);
        EXPECT_LE((found - solid.evaluate(u)).norm(), roundingOf(solid));
      }
    }
  });
}

TEST(TetrahedronEvaluator, GridIsInTheOrderOfANet) {
  forSimplices<4>(31, [](Random&, const BezierTetrahedron& solid) {
    const TetrahedronEvaluator evaluator(solid);
    for (const int m : {1, 2, 5, 9}) {
      const auto d = static_cast<std::size_t>(solid.dimension());
      ASSERT_EQ(TetrahedronEvaluator::gridSize(m), static_cast<std::size_t>(netSize<4>(m)));
      std::vector<double> out(TetrahedronEvaluator::gridSize(m) * d);
      evaluator.grid(m, out);
      std::size_t position = 0;
      for (const MultiIndex<4>& index : multiIndices<4>(m)) {
        const Barycentric<4> u = Barycentric<4>(index[0], index[1], index[2], index[3]) / m;
        const Eigen::Map<const Eigen::VectorXd> found(out.data() + d * position++,
                                                      solid.dimension());
        EXPECT_LE((found - solid.evaluate(u)).norm(), roundingOf(solid));
      }
    }
  });
}

TEST(TetrahedronEvaluator, IsAsAccurateAsDeCasteljau) {
  Random random(32);
  const BezierTetrahedron solid = randomSolid(random, 12, true);
  const TetrahedronEvaluator evaluator(solid);
  for (int i = 0; i < 20; ++i) {
    const Barycentric<4> u = randomBary<4>(random);
    Vector3 found;
    evaluator.points({u.data(), 4}, {found.data(), 3});
    EXPECT_LE(distance(exactPoint<4>(solid, exactBary<4, Rational>(u)), found),
              roundingOf(solid) / 4);
  }
}

}  // namespace
}  // namespace osculate::test
