#include "osculate/differential/series.h"

#include "support/exact_geometry.h"
#include "support/random_curves.h"

namespace osculate::test {
namespace {

constexpr int kLength = 8;

std::vector<double> randomSeries(Random& random, double first) {
  std::vector<double> coefficients{first};
  while (coefficients.size() <= kLength)
    coefficients.push_back(random.uniform(-1.0, 1.0));
  return coefficients;
}

RealSeries real(const std::vector<double>& a) { return {a.begin(), a.end()}; }

void expectNear(const std::vector<double>& found, const RealSeries& expected) {
  for (std::size_t k = 0; k < expected.size(); ++k) {
    EXPECT_NEAR(found[k], toDouble(expected[k]), 1e-13 * (1.0 + std::abs(toDouble(expected[k]))))
        << "coefficient " << k;
  }
}

TEST(Series, PowersHalfAndMinusHalfAreTheRootAndItsInverse) {
  Random random(100);
  for (int round = 0; round < 20; ++round) {
    const std::vector<double> a = randomSeries(random, 1.0);
    std::vector<double> root(a.size(), 1.0);
    series::power(a.data(), 0.5, root.data(), kLength);
    expectNear(root, squareRoot(real(a)));
    std::vector<double> inverseRoot(a.size(), 1.0);
    series::power(a.data(), -0.5, inverseRoot.data(), kLength);
    expectNear(inverseRoot, inverse(squareRoot(real(a))));
  }
}

TEST(Series, WholePowersAreRepeatedProducts) {
  Random random(101);
  const std::vector<double> a = randomSeries(random, 1.0);
  std::vector<double> cube(a.size(), 1.0);
  series::power(a.data(), 3.0, cube.data(), kLength);
  expectNear(cube, real(a) * real(a) * real(a));
  std::vector<double> inverseSquare(a.size(), 1.0);
  series::power(a.data(), -2.0, inverseSquare.data(), kLength);
  expectNear(inverseSquare, inverse(real(a) * real(a)));
}

TEST(Series, MultiplyIsTheCauchyProduct) {
  Random random(102);
  const std::vector<double> a = randomSeries(random, 0.5);
  const std::vector<double> b = randomSeries(random, -2.0);
  std::vector<double> c(a.size());
  series::multiply(a.data(), b.data(), c.data(), kLength);
  expectNear(c, real(a) * real(b));
}

TEST(Series, NextPowerGivesEveryCoefficientOfAPower) {
  Random random(103);
  const std::vector<double> x = randomSeries(random, 0.0);
  const RealSeries square = real(x) * real(x);
  const RealSeries cube = square * real(x);
  std::vector<double> lower(x.size(), 0.0);
  for (int k = 2; k <= kLength; ++k)
    lower[static_cast<std::size_t>(k)] = series::nextPower(x.data(), x.data(), 2, k);
  expectNear(lower, square);
  for (int k = 3; k <= kLength; ++k) {
    EXPECT_NEAR(series::nextPower(x.data(), lower.data(), 3, k),
                toDouble(cube[static_cast<std::size_t>(k)]), 1e-14);
  }
}

}  // namespace
}  // namespace osculate::test
