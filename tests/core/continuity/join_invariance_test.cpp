// What must not change the analysis of a join: identities with fixed seeds.
#include "support/joins.h"

namespace osculate::test {
namespace {

constexpr int kRounds = 40;

/// A join of order -1 to 5 of random curves.
JoinedPair sample(Random& random, int round) { return randomJoin(random, round % 7 - 1, 6); }

/// Equal verdicts and residuals up to the uncertainties; gaps and angles within them too.
void expectSame(const JoinReport& found, const JoinReport& expected, double gapScale = 1.0) {
  EXPECT_EQ(found.order, expected.order);
  EXPECT_NEAR(found.residuals[0], gapScale * expected.residuals[0],
              found.uncertainties[0] + gapScale * expected.uncertainties[0]);
  for (std::size_t k = 0; k <= static_cast<std::size_t>(expected.requestedOrder); ++k) {
    EXPECT_EQ(found.verdicts[k], expected.verdicts[k]) << "order " << k;
    if (k == 0) continue;
    EXPECT_NEAR(found.residuals[k], expected.residuals[k],
                found.uncertainties[k] + expected.uncertainties[k])
        << "order " << k;
    EXPECT_LE(found.uncertainties[k], 1e-4 * found.tolerances[k])
        << "the comparison must mean something";
  }
}

TEST(JoinInvariance, UnderRationalReparametrisation) {
  Random random(220);
  for (int round = 0; round < kRounds; ++round) {
    const auto [first, second] = sample(random, round);
    AnalysisOptions options = withPreset("osculate", 6);
    const JoinReport plain = join(first, second, options);
    options.scaleMm = plain.scaleMm;  // the middle of the parameter range moves, so L may
    const double rho = random.uniform(0.5, 2.0);
    expectSame(join(moebius(first, rho), second, options), plain);
    expectSame(join(first, moebius(second, rho), options), plain);
    expectSame(join(moebius(first, 1.0 / rho), moebius(second, rho), options), plain);
  }
}

TEST(JoinInvariance, UnderRationalReparametrisationOnlyTheScaleMayChange) {
  const BezierCurve first = bezier({{-9, 0, 0}, {-5, 4, 0}, {0, 0, 0}});
  const BezierCurve second = bezier({{0, 0, 0}, {3, -2, 0}, {8, 0, 1}});
  EXPECT_EQ(join(first, moebius(second, 3.0)).scaleMm, join(first, second).scaleMm)
      << "the far end decides";
}

TEST(JoinInvariance, UnderAnyWeightsTimesAConstant) {
  Random random(221);
  for (int round = 0; round < kRounds; ++round) {
    const BezierCurve first = randomBezier(random, 4, true);
    const BezierCurve second = randomBezier(random, 5, true);
    const auto scaled = [](const BezierCurve& curve, double factor) {
      std::vector<double> weights = weightsOf(curve);
      for (double& weight : weights)
        weight *= factor;
      return BezierCurve(polesOf(curve), weights);
    };
    const JoinReport plain = join(first, second);
    const JoinReport found = join(scaled(first, 1024.0), scaled(second, 0x1p-20));
    EXPECT_EQ(found.residuals, plain.residuals) << "powers of two do not round";
    EXPECT_EQ(found.uncertainties, plain.uncertainties);
  }
}

TEST(JoinInvariance, UnderDegreeElevation) {
  Random random(222);
  for (int round = 0; round < kRounds; ++round) {
    const auto [first, second] = sample(random, round);
    const JoinReport plain = join(first, second);
    expectSame(join(first.elevated(2), second), plain);
    expectSame(join(first, second.elevated(5)), plain);
    EXPECT_NEAR(join(first.elevated(3), second.elevated(1)).scaleMm, plain.scaleMm,
                1e-13 * plain.scaleMm);
  }
}

TEST(JoinInvariance, UnderRigidMotion) {
  Random random(223);
  for (int round = 0; round < kRounds; ++round) {
    const auto [first, second] = sample(random, round);
    const Eigen::Affine3d motion = Eigen::Translation3d(random.vector(20.0)) *
                                   Eigen::AngleAxisd(random.uniform(0.0, 3.0), random.direction());
    expectSame(join(first.transformed(motion), second.transformed(motion)), join(first, second));
  }
}

TEST(JoinInvariance, UnderMirroringTorsionChangesItsSignAlone) {
  Random random(224);
  for (int round = 0; round < kRounds; ++round) {
    const auto [first, second] = sample(random, round);
    const Eigen::Affine3d mirror(Eigen::Scaling(1.0, 1.0, -1.0));
    const JoinReport plain = join(first, second);
    const JoinReport found = join(first.transformed(mirror), second.transformed(mirror));
    expectSame(found, plain);
    EXPECT_EQ(*found.sides[1].invariants.torsion, -*plain.sides[1].invariants.torsion);
    EXPECT_EQ(*found.sides[1].invariants.curvatureRate, *plain.sides[1].invariants.curvatureRate);
  }
}

TEST(JoinInvariance, UnderReversalOfBothWithTheSidesExchanged) {
  Random random(225);
  for (int round = 0; round < kRounds; ++round) {
    const auto [first, second] = sample(random, round);
    const JoinReport plain = join(first, second);
    const JoinReport back = join(second.reversed(), first.reversed());
    expectSame(back, plain);
    EXPECT_EQ(back.parametricOrder, plain.parametricOrder);
    EXPECT_NEAR(*back.sides[0].invariants.torsion, *plain.sides[1].invariants.torsion, 1e-11);
    EXPECT_NEAR(*back.sides[0].invariants.curvatureRate, -*plain.sides[1].invariants.curvatureRate,
                1e-11);
    EXPECT_NEAR(*back.sides[1].invariants.curvatureRate2, *plain.sides[0].invariants.curvatureRate2,
                1e-10);
  }
}

TEST(JoinInvariance, DimensionlessResidualsAndAnglesUnderScaling) {
  Random random(226);
  for (int round = 0; round < kRounds; ++round) {
    const auto [first, second] = sample(random, round);
    const JoinReport plain = join(first, second);
    for (const double factor : {1e-3, 25.4, 1e4}) {
      const Eigen::Affine3d scaling(Eigen::Scaling(factor));
      AnalysisOptions options;
      options.tolerances.gapMm *= factor;
      const JoinReport found =
          join(first.transformed(scaling), second.transformed(scaling), options);
      expectSame(found, plain, factor);
      EXPECT_NEAR(*found.sides[0].invariants.curvature * factor,
                  *plain.sides[0].invariants.curvature, 1e-12);
      EXPECT_NEAR(*found.sides[0].invariants.curvatureRate2 * std::pow(factor, 3),
                  *plain.sides[0].invariants.curvatureRate2, 1e-11);
    }
  }
}

TEST(JoinInvariance, ScalingByAPowerOfTwoChangesNoBit) {
  Random random(227);
  for (int round = 0; round < kRounds; ++round) {
    const auto [first, second] = sample(random, round);
    const Eigen::Affine3d scaling(Eigen::Scaling(256.0));
    const JoinReport plain = join(first, second);
    const JoinReport found = join(first.transformed(scaling), second.transformed(scaling));
    for (std::size_t k = 1; k <= 4; ++k)
      EXPECT_EQ(found.residuals[k], plain.residuals[k]) << "order " << k;
    EXPECT_EQ(found.residuals[0], 256.0 * plain.residuals[0]);
  }
}

TEST(JoinInvariance, UnderCuttingTheCurvesShorterBesideTheJoin) {
  Random random(228);
  for (int round = 0; round < kRounds; ++round) {
    const auto [first, second] = sample(random, round);
    AnalysisOptions options;
    const JoinReport plain = join(first, second, options);
    options.scaleMm = plain.scaleMm;
    expectSame(join(first.segment(0.25, 1.0), second.segment(0.0, 0.5), options), plain);
  }
}

}  // namespace
}  // namespace osculate::test
