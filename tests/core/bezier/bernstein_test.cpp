#include "osculate/bezier/bernstein.h"

#include "support/exact.h"
#include "support/random_curves.h"

namespace osculate::test {
namespace {

TEST(Binomial, EqualsTheExactCoefficientForEveryRow) {
  for (int n = 0; n <= kMaxDegree + 1; ++n) {
    for (int k = 0; k <= kMaxDegree + 1; ++k) {
      const Rational expected = k <= n ? choose<Rational>(n, k) : Rational(0);
      EXPECT_EQ(Rational(binomial(n, k)), expected) << n << " over " << k;
    }
  }
}

TEST(Bernstein, AgreesWithExactArithmetic) {
  Random random(1);
  for (int degree = 1; degree <= kMaxDegree; ++degree) {
    const double t = random.uniform(0.0, 1.0);
    const Eigen::VectorXd values = bernstein(degree, t);
    ASSERT_EQ(values.size(), degree + 1);
    for (int i = 0; i <= degree; ++i) {
      Rational expected = choose<Rational>(degree, i);
      for (int j = 0; j < degree; ++j)
        expected *= j < i ? Rational(t) : Rational(1) - Rational(t);
      EXPECT_NEAR(toDouble(Rational(Rational(values[i]) - expected)), 0.0,
                  2.0 * degree * kUnitRoundoff);
    }
  }
}

TEST(Bernstein, AtTheEndsIsTheFirstAndTheLastUnitVector) {
  EXPECT_EQ(bernstein(7, 0.0), Eigen::VectorXd::Unit(8, 0));
  EXPECT_EQ(bernstein(7, 1.0), Eigen::VectorXd::Unit(8, 7));
}

TEST(Net, KeepsPolynomialPolesAndMultipliesRationalOnesByTheirWeights) {
  Random random(2);
  const BezierCurve polynomial = randomBezier(random, 4, false);
  const Net plain = toNet(polynomial.view());
  ASSERT_EQ(plain.rows(), 3);
  for (int i = 0; i <= 4; ++i)
    EXPECT_EQ(Vector3(plain.col(i)), Vector3(polynomial.pole(i)));
  EXPECT_TRUE(identical(fromNet(plain), polynomial));

  const BezierCurve rational = randomBezier(random, 4, true);
  const Net weighted = toNet(rational.view());
  ASSERT_EQ(weighted.rows(), 4);
  for (int i = 0; i <= 4; ++i) {
    EXPECT_EQ(weighted(3, i), rational.weight(i));
    EXPECT_EQ(Vector3(weighted.col(i).head<3>()), Vector3(rational.weight(i) * rational.pole(i)));
    EXPECT_NEAR((project(weighted.col(i)) - rational.pole(i)).norm(), 0.0, 4e-15 * size(rational));
  }
}

TEST(ProjectDerivatives, DividesTheSeriesOfNumeratorAndWeight) {
  Random random(3);
  std::vector<NetPoint> derivatives;
  std::vector<Homogeneous<Rational>> series;
  for (int k = 0; k <= 8; ++k) {
    NetPoint point(4);
    point << random.vector(3.0), random.uniform(1.0, 2.0);
    derivatives.push_back(point);
    Homogeneous<Rational> coefficient;
    for (int row = 0; row < 4; ++row)
      coefficient[row] = Rational(point[row]) / factorial<Rational>(k);
    series.push_back(coefficient);
  }
  const std::vector<Vector3> found = projectDerivatives(derivatives);
  const std::vector<Point<Rational>> expected = divide(series);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t k = 0; k < found.size(); ++k) {
    const Point<Rational> derivative = factorial<Rational>(static_cast<int>(k)) * expected[k];
    EXPECT_LT(distance(derivative, found[k]), 1e-13 * (1.0 + toDouble(derivative).norm()))
        << "order " << k;
  }
}

TEST(ProjectDerivatives, LeavesPolynomialDerivativesAlone) {
  const std::vector<NetPoint> derivatives{NetPoint(Vector3(1, 2, 3)), NetPoint(Vector3(4, 5, 6))};
  const std::vector<Vector3> found = projectDerivatives(derivatives);
  EXPECT_EQ(found, (std::vector<Vector3>{{1, 2, 3}, {4, 5, 6}}));
}

}  // namespace
}  // namespace osculate::test
