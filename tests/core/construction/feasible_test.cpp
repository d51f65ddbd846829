// Restoring and minimising on curves and surfaces whose points and minima are known.
#include "osculate/construction/feasible.h"

#include <gtest/gtest.h>

#include <cmath>

namespace osculate {
namespace {

using Eigen::VectorXd;

VectorXd vectorOf(std::initializer_list<double> numbers) {
  VectorXd vector(static_cast<Eigen::Index>(numbers.size()));
  std::copy(numbers.begin(), numbers.end(), vector.begin());
  return vector;
}

/// |x| = 1, twice: dependent conditions.
Conditions sphereTwice(const VectorXd& x) {
  Conditions conditions;
  const double excess = x.squaredNorm() - 1.0;
  conditions.values = vectorOf({excess, 3.0 * excess});
  conditions.jacobian.resize(2, x.size());
  conditions.jacobian.row(0) = 2.0 * x.transpose();
  conditions.jacobian.row(1) = 6.0 * x.transpose();
  return conditions;
}

/// x^2 + y^2 = -1.
Conditions impossible(const VectorXd& x) {
  Conditions conditions;
  conditions.values = vectorOf({x.squaredNorm() + 1.0});
  conditions.jacobian = 2.0 * x.transpose();
  return conditions;
}

TEST(Feasible, RestoresToTheNearestPointOfASphere) {
  const auto point = restore(sphereTwice, vectorOf({3.0, 4.0, 0.0}));
  ASSERT_TRUE(point);
  EXPECT_NEAR((*point)[0], 0.6, 1e-9);
  EXPECT_NEAR((*point)[1], 0.8, 1e-9);
  EXPECT_NEAR(point->norm(), 1.0, 1e-13);
  EXPECT_EQ(freedomsAt(sphereTwice, *point), 2);
}

TEST(Feasible, ConvergesWhereConditionsAreDependentAtTheSolutionOnly) {
  // (y, x y) vanishes on y = 0, where the second gradient is x times the first
  const auto conditions = [](const VectorXd& x) {
    Conditions result;
    result.values = vectorOf({x[1] + x[1] * x[1], x[0] * x[1]});
    result.jacobian.resize(2, 2);
    result.jacobian << 0.0, 1.0 + 2.0 * x[1], x[1], x[0];
    return result;
  };
  const auto point = restore(conditions, vectorOf({0.7, 0.4}));
  ASSERT_TRUE(point);
  EXPECT_NEAR((*point)[1], 0.0, 1e-10);
  EXPECT_EQ(freedomsAt(conditions, *point), 1);
}

TEST(Feasible, FindsNothingWhereNothingIs) {
  EXPECT_FALSE(restore(impossible, vectorOf({0.3, 0.2})));
}

TEST(Feasible, MinimisesOnASphereToRounding) {
  // the least of a linear function on the sphere is against its gradient
  const VectorXd gradient = vectorOf({1.0, 2.0, -2.0});
  const SmoothFunction function = [&](const std::vector<double>& x, double* g) {
    if (g != nullptr) std::copy(gradient.begin(), gradient.end(), g);
    return gradient[0] * x[0] + gradient[1] * x[1] + gradient[2] * x[2];
  };
  const FeasibleMinimum found = minimizeAmong(sphereTwice, function, vectorOf({0.6, -0.8, 0.0}));
  EXPECT_NEAR(found.value, -3.0, 1e-3);
  const FeasibleMinimum best = polishAmong(sphereTwice, function, found.unknowns);
  EXPECT_NEAR(best.value, -3.0, 1e-14);
  EXPECT_LE((best.unknowns + gradient / 3.0).norm(), 1e-7);
}

TEST(Feasible, WithoutConditionsItIsThePlainMinimum) {
  const ConditionFunction none = [](const VectorXd& x) {
    return Conditions{VectorXd(0), Eigen::MatrixXd(0, x.size())};
  };
  const SmoothFunction function = [](const std::vector<double>& x, double* g) {
    if (g != nullptr) {
      g[0] = 2.0 * (x[0] - 1.0);
      g[1] = 8.0 * (x[1] + 2.0);
    }
    return std::pow(x[0] - 1.0, 2) + 4.0 * std::pow(x[1] + 2.0, 2);
  };
  const auto start = restore(none, vectorOf({5.0, 5.0}));
  ASSERT_TRUE(start);
  const FeasibleMinimum best =
      polishAmong(none, function, minimizeAmong(none, function, *start).unknowns);
  EXPECT_NEAR(best.unknowns[0], 1.0, 1e-7);
  EXPECT_NEAR(best.unknowns[1], -2.0, 1e-7);
}

TEST(Feasible, APointWithoutFreedomStays) {
  const ConditionFunction fixed = [](const VectorXd& x) {
    return Conditions{x - vectorOf({1.0, 2.0}), Eigen::MatrixXd::Identity(2, 2)};
  };
  const SmoothFunction function = [](const std::vector<double>& x, double* g) {
    if (g != nullptr) g[0] = g[1] = 1.0;
    return x[0] + x[1];
  };
  const auto point = restore(fixed, vectorOf({0.0, 0.0}));
  ASSERT_TRUE(point);
  EXPECT_EQ(freedomsAt(fixed, *point), 0);
  EXPECT_EQ(minimizeAmong(fixed, function, *point).unknowns, *point);
  EXPECT_EQ(polishAmong(fixed, function, *point).unknowns, *point);
}

}  // namespace
}  // namespace osculate
