#include "osculate/differential/jet.h"

#include <limits>

#include "support/curve_ends.h"
#include "support/perturbation.h"

namespace osculate::test {
namespace {

TEST(EndJet, CoefficientsAreTheExactOnesWithinTheirStatedErrors) {
  forEnds(110, kEndDegrees, [](Random&, const BezierCurve& curve, CurveEnd end) {
    const auto jet = endJet<8>(curve.view(), end, 0.0);
    const PointSeries expected = outwardTaylor(exact<Real>(curve), end, 8);
    EXPECT_EQ(jet.point, toDouble(expected[0]));
    EXPECT_EQ(jet.c[0], Vector3::Zero());
    for (std::size_t k = 1; k <= 8; ++k) {
      EXPECT_LE(distance(expected[k], jet.c[k]), jet.error[k]) << "order " << k;
    }
  });
}

TEST(EndJet, FourOrdersAreTheFirstOfEight) {
  forEnds(111, kEndDegrees, [](Random&, const BezierCurve& curve, CurveEnd end) {
    const auto shorter = endJet<4>(curve.view(), end, 0.0);
    const auto longer = endJet<8>(curve.view(), end, 0.0);
    for (std::size_t k = 1; k <= 4; ++k) {
      EXPECT_LE((shorter.c[k] - longer.c[k]).norm(), shorter.error[k]) << "order " << k;
    }
  });
}

/// bound / largest error over `rounds` perturbations, for every order.
template <int N>
void collect(const BezierCurve& curve, CurveEnd end, double poleError, Random& random,
             BoundStatistics& statistics) {
  const auto jet = endJet<N>(curve.view(), end, poleError);
  std::array<double, N + 1> largest{};
  for (int round = 0; round < 12; ++round) {
    const PointSeries moved = outwardTaylor(perturbed(curve, random, poleError), end, N);
    for (std::size_t k = 1; k <= N; ++k)
      largest[k] = std::max(largest[k], distance(moved[k], jet.c[k]));
  }
  for (int k = 1; k <= (curve.isRational() ? N : std::min(N, curve.degree())); ++k) {
    statistics.add(jet.error[static_cast<std::size_t>(k)], largest[static_cast<std::size_t>(k)]);
  }
}

TEST(EndJet, StatedErrorsBoundWhatHalfAUnitInTheLastPlaceOfPolesAndWeightsDoes) {
  BoundStatistics statistics;
  forEnds(112, kEndDegrees, [&](Random& random, const BezierCurve& curve, CurveEnd end) {
    collect<8>(curve, end, 0.0, random, statistics);
  });
  EXPECT_GE(statistics.smallest(), 1.0);
  EXPECT_LE(statistics.median(), 1e4) << "a bound this loose says nothing";
}

TEST(EndJet, StatedErrorsBoundWhatTheErrorOfThePolesDoes) {
  BoundStatistics statistics;
  forEnds(113, kEndDegrees, [&](Random& random, const BezierCurve& curve, CurveEnd end) {
    collect<8>(curve, end, 1e-6, random, statistics);
  });
  EXPECT_GE(statistics.smallest(), 1.0);
  EXPECT_LE(statistics.median(), 1e4);
}

TEST(EndJet, PointErrorIsHalfAUnitOfTheSizeOrTheErrorOfThePoles) {
  const BezierCurve curve(std::vector<Vector3>{{3, 4, 0}, {30, 40, 0}, {300, 400, 0}});
  const auto jet = endJet<4>(curve.view(), CurveEnd::kStart, 0.0);
  EXPECT_EQ(jet.size, 500.0);
  EXPECT_EQ(jet.pointError, 500.0 * kUnitRoundoff);
  EXPECT_EQ(endJet<4>(curve.view(), CurveEnd::kStart, 1e-3).pointError, 1e-3);
}

TEST(EndJet, ReadsOnlyThePolesNextToTheEnd) {
  Random random(114);
  for (const bool rational : {false, true}) {
    const BezierCurve curve = randomBezier(random, 9, rational);
    std::vector<Vector3> poles = polesOf(curve);
    std::vector<double> weights = weightsOf(curve);
    for (std::size_t i = 5; i < poles.size(); ++i) {
      poles[i].setConstant(1e300);
      if (rational) weights[i] = 1e300;
    }
    const BezierCurve poisoned(poles, weights);
    const auto expected = endJet<4>(curve.view(), CurveEnd::kStart, 0.0);
    const auto found = endJet<4>(poisoned.view(), CurveEnd::kStart, 0.0);
    EXPECT_EQ(found.c, expected.c);
    EXPECT_EQ(found.error, expected.error);
    EXPECT_EQ(found.size, expected.size);
  }
}

TEST(EndJet, OfAPolynomialVanishesExactlyAboveItsDegree) {
  Random random(115);
  const BezierCurve curve = randomBezier(random, 3, false);
  const auto jet = endJet<8>(curve.view(), CurveEnd::kEnd, 0.0);
  for (std::size_t k = 4; k <= 8; ++k) {
    EXPECT_EQ(jet.c[k], Vector3::Zero());
    EXPECT_EQ(jet.error[k], 0.0);
  }
}

TEST(EndJet, ATranslationChangesOnlyThePointAndTheErrors) {
  const BezierCurve curve(std::vector<Vector3>{{0, 0, 0}, {1, 2, 0}, {3, 1, 5}, {4, 4, 4}});
  const BezierCurve moved =
      curve.transformed(Eigen::Affine3d(Eigen::Translation3d(1024, -2048, 4096)));
  const auto jet = endJet<4>(curve.view(), CurveEnd::kStart, 0.0);
  const auto far = endJet<4>(moved.view(), CurveEnd::kStart, 0.0);
  EXPECT_EQ(far.c, jet.c);
  EXPECT_EQ(far.point, Vector3(1024, -2048, 4096));
  for (std::size_t k = 1; k <= 3; ++k)
    EXPECT_GT(far.error[k], 500.0 * jet.error[k]);
}

}  // namespace
}  // namespace osculate::test
