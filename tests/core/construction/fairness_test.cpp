#include "osculate/construction/fairness.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "osculate/bezier/bernstein.h"

namespace osculate {
namespace {

BoundedPoles randomPoles(int degree, std::mt19937& generator) {
  std::uniform_real_distribution<double> off(-2.0, 2.0);
  BoundedPoles poles(3, degree + 1);
  for (int i = 0; i <= degree; ++i)
    poles.col(i) << 5.0 * i + off(generator), off(generator), off(generator);
  return poles;
}

TEST(Energies, OfACircularArcAreThePowersOfItsAngle) {
  // kappa = 1/R, |d(kappa n)/ds| = 1/R^2: bending = (L/R)^2, mvc = (L/R)^4
  const double half = std::numbers::pi / 4;
  const std::vector<Vector3> poles{{10, 0, 0}, {10, 10, 0}, {0, 10, 0}};
  const std::vector<double> weights{1.0, std::cos(half), 1.0};
  const Energies energy = energies(BSplineCurve(BezierCurve(poles, weights)));
  const double angle = std::numbers::pi / 2;
  EXPECT_NEAR(energy.lengthMm, 10.0 * angle, 1e-11);
  EXPECT_NEAR(energy.bending, std::pow(angle, 2), 1e-9);
  EXPECT_NEAR(energy.variation, std::pow(angle, 4), 1e-8);
}

TEST(Energies, OfAnEvenLineAreZero) {
  const std::vector<Vector3> poles{{0, 0, 0}, {3, 4, 0}};
  const Energies energy = energies(BSplineCurve(BezierCurve(poles)));
  EXPECT_EQ(energy.bending, 0.0);
  EXPECT_EQ(energy.variation, 0.0);
  EXPECT_NEAR(energy.speed, 0.0, 1e-24);
}

TEST(Energies, SpeedOfAQuadraticLineHasItsClosedForm) {
  // x = t^2 + t over L = 2: int_0^1 ln^2((2t+1)/2) dt = [x ln^2 x - 2 x ln x + 2 x] from 1/2 to 3/2
  const std::vector<Vector3> poles{{0, 0, 0}, {0.5, 0, 0}, {2, 0, 0}};
  const auto primitive = [](double x) {
    return x * (std::log(x) * std::log(x) - 2.0 * std::log(x) + 2.0);
  };
  EXPECT_NEAR(energies(BSplineCurve(BezierCurve(poles))).speed, primitive(1.5) - primitive(0.5),
              1e-12);
}

TEST(Energies, DoNotChangeWithScaleAndCutting) {
  std::mt19937 generator(5);
  const BSplineCurve curve(bezierFromPoles(randomPoles(6, generator).data(), 6));
  const Energies own = energies(curve);
  const Energies scaled = energies(curve.transformed(Eigen::Affine3d(Eigen::Scaling(25.0))));
  EXPECT_NEAR(scaled.bending, own.bending, 1e-8 * own.bending);
  EXPECT_NEAR(scaled.variation, own.variation, 1e-8 * own.variation);
  EXPECT_NEAR(scaled.speed, own.speed, 1e-8 * own.speed);
}

TEST(FairnessObjective, AgreesWithTheEnergies) {
  std::mt19937 generator(6);
  for (const Fairness fairness : {Fairness::kMinimumVariation, Fairness::kBending}) {
    for (int degree = 2; degree <= kMaxDegree; ++degree) {
      const BoundedPoles poles = randomPoles(degree, generator);
      const double expected =
          energies(BSplineCurve(bezierFromPoles(poles.data(), degree))).objective(fairness);
      const FairnessObjective objective(degree, fairness, Quadrature::kFine);
      EXPECT_NEAR(objective.evaluate(poles, nullptr), expected, 1e-6 * (1.0 + std::abs(expected)))
          << degree;
    }
  }
}

TEST(FairnessObjective, GradientAgreesWithDifferences) {
  std::mt19937 generator(7);
  for (const Fairness fairness : {Fairness::kMinimumVariation, Fairness::kBending}) {
    for (const int degree : {2, 3, 5, 9, 14}) {
      const BoundedPoles poles = randomPoles(degree, generator);
      const FairnessObjective objective(degree, fairness, Quadrature::kCoarse);
      BoundedPoles gradient;
      objective.evaluate(poles, &gradient);
      for (Eigen::Index i = 0; i < poles.size(); ++i) {
        constexpr double kStep = 1e-5;
        BoundedPoles above = poles;
        BoundedPoles below = poles;
        above.data()[i] += kStep;
        below.data()[i] -= kStep;
        const double slope =
            (objective.evaluate(above, nullptr) - objective.evaluate(below, nullptr)) /
            (2.0 * kStep);
        EXPECT_NEAR(gradient.data()[i], slope, 1e-6 * (1.0 + gradient.norm()))
            << "degree " << degree;
      }
    }
  }
}

TEST(FairnessObjective, IsInfiniteWhereTheCurveStops) {
  BoundedPoles poles = BoundedPoles::Zero(3, 4);
  EXPECT_TRUE(std::isinf(
      FairnessObjective(3, Fairness::kBending, Quadrature::kCoarse).evaluate(poles, nullptr)));
}

}  // namespace
}  // namespace osculate
