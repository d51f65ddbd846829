#include "osculate/bezier/simplex_net.h"

#include "support/simplex_samples.h"

namespace osculate::test {
namespace {

TEST(SimplexIndex, IsTheLexicographicOrder) {
  for (int degree = 1; degree <= 6; ++degree) {
    const auto indices = multiIndices<4>(degree);
    ASSERT_EQ(static_cast<int>(indices.size()), netSize<4>(degree));
    for (std::size_t i = 0; i < indices.size(); ++i) {
      EXPECT_EQ(netIndex<4>(indices[i]), static_cast<int>(i));
      if (i > 0) {
        EXPECT_GT(indices[i - 1], indices[i]);
      }
    }
  }
  EXPECT_EQ(multiIndices<4>(3).front(), (MultiIndex<4>{3, 0, 0, 0}));
  EXPECT_EQ(multiIndices<4>(3).back(), (MultiIndex<4>{0, 0, 0, 3}));
  EXPECT_EQ(multiIndices<3>(2)[4], (MultiIndex<3>{0, 1, 1}));
}

TEST(SimplexIndex, MultinomialsAreExact) {
  EXPECT_EQ((multinomial<4>({3, 3, 3, 3})), 369600.0);
  EXPECT_EQ((multinomial<4>({12, 0, 0, 0})), 1.0);
  EXPECT_EQ((multinomial<3>({1, 2, 1})), 12.0);
}

TEST(SimplexNet, BlossomsAreSymmetricAndMultiaffine) {
  Random random(40);
  const SimplexNet net = randomSolid(random, 4, false).homogeneous();
  std::vector<Barycentric<4>> arguments;
  for (int i = 0; i < 4; ++i)
    arguments.push_back(randomBary<4>(random));
  const auto value = [&](const std::vector<Barycentric<4>>& at) {
    SimplexNet reduced = net;
    blossomNet<4>(reduced, 4, at);
    return Vector3(reduced.col(0));
  };
  const Vector3 straight = value(arguments);
  EXPECT_LE((value({arguments[2], arguments[0], arguments[3], arguments[1]}) - straight).norm(),
            1e-14);
  auto first = arguments;
  auto second = arguments;
  first[1] = randomBary<4>(random);
  arguments[1] = 1.5 * first[1] - 0.5 * second[1];
  EXPECT_LE((value(arguments) - (1.5 * value(first) - 0.5 * value(second))).norm(), 1e-14);
}

TEST(SimplexNet, ProductsOfMonomialsMultiplyTheValues) {
  Random random(41);
  const Eigen::RowVectorXd a = Eigen::RowVectorXd::Random(netSize<4>(2));
  const Eigen::RowVectorXd b = Eigen::RowVectorXd::Random(netSize<4>(3));
  const auto product = multiplyMonomials<4>(a.cwiseProduct(multinomials<4>(2)), 2,
                                            b.cwiseProduct(multinomials<4>(3)), 3);
  const SimplexNet bernstein = product.cwiseQuotient(multinomials<4>(5));
  const Barycentric<4> u = randomBary<4>(random);
  const auto value = [&](SimplexNet net, int degree) {
    blossomNet<4>(net, degree, std::vector<Barycentric<4>>(static_cast<std::size_t>(degree), u));
    return net(0, 0);
  };
  EXPECT_NEAR(value(bernstein, 5), value(a, 2) * value(b, 3), 1e-15);
}

TEST(SimplexNet, ShiftedNetsArePartialDerivatives) {
  Random random(42);
  const BezierTetrahedron solid = randomSolid(random, 3, false);
  const Barycentric<4> u = randomBary<4>(random);
  for (int c = 0; c < 4; ++c) {
    SimplexNet net = shiftedNet<4>(solid.points(), 3, c);
    blossomNet<4>(net, 2, std::vector<Barycentric<4>>(2, u));
    MultiIndex<4> order{};
    order[static_cast<std::size_t>(c)] = 1;
    EXPECT_LE((3.0 * net.col(0) - solid.partial(u, order)).norm(), roundingOf(solid));
  }
}

}  // namespace
}  // namespace osculate::test
