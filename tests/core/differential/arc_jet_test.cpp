#include "osculate/differential/arc_jet.h"

#include "support/curve_ends.h"
#include "support/designed_curves.h"
#include "support/perturbation.h"

namespace osculate::test {
namespace {

constexpr int kOrder = 8;
constexpr auto kDegrees = {1, 2, 3, 4, 5, 7, 8, 12, 18};

ArcJet<kOrder> arcJetOf(const BezierCurve& curve, CurveEnd end, double poleError = 0.0) {
  return arcJet(endJet<kOrder>(curve.view(), end, poleError));
}

TEST(ArcJet, DerivativesAreTheExactOnesWithinTheirStatedErrors) {
  forEnds(120, kDegrees, [](Random&, const BezierCurve& curve, CurveEnd end) {
    const auto arc = arcJetOf(curve, end);
    const PointSeries expected = arcDerivatives(outwardTaylor(exact<Real>(curve), end, kOrder));
    for (std::size_t k = 1; k <= kOrder; ++k) {
      EXPECT_LE(distance(expected[k], arc.r[k]), arc.error[k]) << "order " << k;
      EXPECT_NEAR(arc.norm[k], arc.r[k].norm(), 1e-14 * arc.norm[k]) << "order " << k;
    }
  });
}

TEST(ArcJet, StatedErrorsBoundWhatHalfAUnitInTheLastPlaceOfPolesAndWeightsDoes) {
  BoundStatistics statistics;
  forEnds(121, kDegrees, [&](Random& random, const BezierCurve& curve, CurveEnd end) {
    const auto arc = arcJetOf(curve, end);
    std::array<double, kOrder + 1> largest{};
    for (int round = 0; round < 8; ++round) {
      const PointSeries moved =
          arcDerivatives(outwardTaylor(perturbed(curve, random), end, kOrder));
      for (std::size_t k = 1; k <= kOrder; ++k)
        largest[k] = std::max(largest[k], distance(moved[k], arc.r[k]));
    }
    for (std::size_t k = 1; k <= kOrder; ++k)
      statistics.add(arc.error[k], largest[k]);
  });
  EXPECT_GE(statistics.smallest(), 1.0);
  EXPECT_LE(statistics.median(), 1e4) << "a bound this loose says nothing";
}

TEST(ArcJet, StatedErrorsBoundWhatTheErrorOfThePolesDoes) {
  BoundStatistics statistics;
  forEnds(122, kDegrees, [&](Random& random, const BezierCurve& curve, CurveEnd end) {
    constexpr double kPoleError = 1e-7;
    const auto arc = arcJetOf(curve, end, kPoleError);
    std::array<double, kOrder + 1> largest{};
    for (int round = 0; round < 8; ++round) {
      const PointSeries moved =
          arcDerivatives(outwardTaylor(perturbed(curve, random, kPoleError), end, kOrder));
      for (std::size_t k = 1; k <= kOrder; ++k)
        largest[k] = std::max(largest[k], distance(moved[k], arc.r[k]));
    }
    for (std::size_t k = 1; k <= kOrder; ++k)
      statistics.add(arc.error[k], largest[k]);
  });
  EXPECT_GE(statistics.smallest(), 1.0);
  EXPECT_LE(statistics.median(), 1e4);
}

TEST(ArcJet, ErrorsAreInfiniteWhereTheFirstDerivativeIsHardlyToBeToldFromZero) {
  const BezierCurve curve(std::vector<Vector3>{{0, 0, 0}, {1e-3, 0, 0}, {1, 1, 0}, {2, 0, 0}});
  EXPECT_TRUE(std::isinf(arcJetOf(curve, CurveEnd::kStart, 1e-3).error[2]));
  EXPECT_TRUE(std::isfinite(arcJetOf(curve, CurveEnd::kStart, 1e-6).error[2]));
}

TEST(ArcJet, IsSingularWhereTheFirstLegIsNotToBeToldFromZero) {
  const auto jetWith = [](double leg, double poleError) {
    const BezierCurve curve(std::vector<Vector3>{{8, 0, 0}, {8 + leg, 0, 0}, {9, 1, 0}});
    return endJet<4>(curve.view(), CurveEnd::kStart, poleError);
  };
  EXPECT_TRUE(isSingular(jetWith(0.0, 0.0)));
  EXPECT_TRUE(isSingular(jetWith(0x1p-50, 0.0)));
  EXPECT_FALSE(isSingular(jetWith(1e-9, 0.0)));
  EXPECT_TRUE(isSingular(jetWith(1e-9, 1e-9)));
}

TEST(ArcJet, SeriesOfLengthAndParameterAreTheExactOnesAndInverseToEachOther) {
  forEnds(123, kDegrees, [](Random&, const BezierCurve& curve, CurveEnd end) {
    const auto arc = arcJetOf(curve, end);
    const PointSeries p = outwardTaylor(exact<Real>(curve), end, kOrder);
    const PointSeries velocity = derivative(p);
    const RealSeries speed = squareRoot(dot(velocity, velocity));
    RealSeries found{Real(0)};
    for (std::size_t k = 1; k <= kOrder; ++k) {
      const double expected = toDouble(Real(speed[k - 1] / Real(k)));
      EXPECT_NEAR(arc.arcLength[k], expected, 1e-10 * std::pow(arc.arcLength[1], k))
          << "s(t), order " << k;
      found.push_back(Real(arc.parameter[k]));
    }
    // s(t(sigma)) = sigma
    RealSeries power = found;
    RealSeries sum(kOrder + 1, Real(0));
    for (std::size_t j = 1; j <= kOrder; ++j) {
      for (std::size_t k = 0; k <= kOrder; ++k)
        sum[k] += Real(speed[j - 1] / Real(j)) * power[k];
      power = power * found;
    }
    for (std::size_t k = 1; k <= kOrder; ++k) {
      // by the parameter of unit speed, whose coefficients these bounds are about
      const double relative = arc.error[k] + 1e-10;
      EXPECT_NEAR(toDouble(sum[k]), k == 1 ? 1.0 : 0.0, relative) << "order " << k;
    }
  });
}

TEST(ArcJet, OfACircleHasCurvatureAloneInEveryOrder) {
  // a quarter circle of radius 5 around the origin, from (5, 0, 0)
  const double root = std::sqrt(0.5);
  const BezierCurve arc(std::vector<Vector3>{{5, 0, 0}, {5, 5, 0}, {0, 5, 0}},
                        std::vector<double>{1.0, root, 1.0});
  const auto jet = arcJetOf(arc, CurveEnd::kStart);
  // 5 cos(s/5), 5 sin(s/5)
  const Vector3 directions[4] = {{5, 0, 0}, {0, 5, 0}, {-5, 0, 0}, {0, -5, 0}};
  for (std::size_t k = 1; k <= kOrder; ++k) {
    EXPECT_LE((jet.r[k] - directions[k % 4] / std::pow(5.0, k)).norm(), jet.error[k])
        << "order " << k;
    EXPECT_LE(jet.error[k], 1e-10) << "order " << k;
  }
}

TEST(ArcJet, OfAnEllipseHasTheCurvatureOfItsVertex) {
  // semi-axes a = 3 and b = 2; at the vertex (a, 0): kappa = a / b^2, kappa' = 0,
  // kappa'' = 3 a (b^2 - a^2) / b^6 (kappa = a b / (a^2 sin^2 + b^2 cos^2)^(3/2), ds = b du there)
  const double root = std::sqrt(0.5);
  const BezierCurve arc(std::vector<Vector3>{{3, 0, 0}, {3, 2, 0}, {0, 2, 0}},
                        std::vector<double>{1.0, root, 1.0});
  const auto jet = arcJetOf(arc, CurveEnd::kStart);
  EXPECT_LE((jet.r[2] - Vector3(-0.75, 0, 0)).norm(), jet.error[2]);
  const double second = 3.0 * 3.0 * (4.0 - 9.0) / 64.0;
  EXPECT_LE((jet.r[3] - Vector3(0, -0.75 * 0.75, 0)).norm(),
            jet.error[3]);  // -kappa^2 t + kappa' n
  EXPECT_LE((jet.r[4] - Vector3(-(second - std::pow(0.75, 3)), 0, 0)).norm(),
            jet.error[4]);  // (kappa'' - kappa^3) n
}

TEST(ArcJet, RecoversTheDesignedDerivativesWhateverTheParametrisation) {
  Random random(124);
  const PointSeries helix = frenetCurve({Real(0.25)}, {Real(-0.125)}, kOrder);
  const PointSeries clothoid = frenetCurve({Real(0.1), Real(0.05)}, {Real(0)}, kOrder);
  const PointSeries general = frenetCurve({Real(0.2), Real(0.1), Real(-0.05), Real(0.01)},
                                          {Real(0.3), Real(-0.1), Real(0.02)}, kOrder);
  for (const PointSeries& arc : {helix, clothoid, general}) {
    for (int round = 0; round < 5; ++round) {
      RealSeries sigma{Real(0), Real(random.uniform(1.0, 3.0))};
      while (sigma.size() <= 10)
        sigma.push_back(Real(random.uniform(-1.0, 1.0)));
      const auto found = arcJetOf(startingWith(arc, sigma), CurveEnd::kStart);
      for (std::size_t k = 1; k <= kOrder; ++k) {
        EXPECT_LE(distance(arc[k], found.r[k]), found.error[k]) << "order " << k;
      }
      const auto arriving = arcJetOf(endingWith(arc, sigma), CurveEnd::kEnd);
      for (std::size_t k = 1; k <= kOrder; ++k) {
        const Vector3 forward = k % 2 == 1 ? Vector3(-arriving.r[k]) : arriving.r[k];
        EXPECT_LE(distance(arc[k], forward), arriving.error[k]) << "arriving, order " << k;
      }
    }
  }
}

TEST(ArcJet, OfAStraightLineOfUnevenSpeedIsTheTangentAlone) {
  const BezierCurve line(std::vector<Vector3>{{0, 0, 0}, {1, 2, 2}, {3, 6, 6}, {4, 8, 8}});
  const auto jet = arcJetOf(line, CurveEnd::kStart);
  EXPECT_LE((jet.r[1] - Vector3(1, 2, 2) / 3.0).norm(), 1e-15);
  for (std::size_t k = 2; k <= kOrder; ++k)
    EXPECT_LE(jet.norm[k], jet.error[k]) << "order " << k;
}

}  // namespace
}  // namespace osculate::test
