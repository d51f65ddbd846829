// The betas of a join: the re-parametrisation that carries the first curve into the second.
#include "support/joins.h"

namespace osculate::test {
namespace {

/// Forward derivatives by the parameter, 0..count, at the join.
PointSeries derivativesAtEnd(const BezierCurve& curve, int count) {
  PointSeries d = taylor(exact<Real>(curve), Real(1), count);
  for (int k = 0; k <= count; ++k)
    d[static_cast<std::size_t>(k)] *= factorial<Real>(k);
  return d;
}
PointSeries derivativesAtStart(const BezierCurve& curve, int count) {
  PointSeries d = taylor(exact<Real>(curve), Real(0), count);
  for (int k = 0; k <= count; ++k)
    d[static_cast<std::size_t>(k)] *= factorial<Real>(k);
  return d;
}

RealSeries betasOf(const JoinReport& report) {
  RealSeries beta{Real(0)};
  for (int k = 0; k < report.betaCount; ++k)
    beta.push_back(Real(report.beta[static_cast<std::size_t>(k)]));
  return beta;
}

/// P^(k) with beta by Faa di Bruno must be Q^(k), k = 1..count, in mm of the curve's derivatives.
void expectCarried(const BezierCurve& first, const BezierCurve& second, const JoinReport& report,
                   int count) {
  ASSERT_GE(report.betaCount, count);
  const PointSeries carried =
      composed(derivativesAtEnd(first, count), betasOf(report), static_cast<std::size_t>(count));
  const PointSeries expected = derivativesAtStart(second, count);
  for (int k = 1; k <= count; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const Vector3 derivative = toDouble(Point<Real>(factorial<Real>(k) * carried[i]));
    const double size =
        toDouble(Real(expected[i].norm())) + std::pow(toDouble(Real(expected[1].norm())), k);
    EXPECT_LE(distance(expected[i], derivative), 1e-9 * size) << "order " << k;
  }
}

TEST(Beta, CarriesTheFirstCurvesDerivativesIntoTheSeconds) {
  Random random(230);
  for (int order = 1; order <= 6; ++order) {
    for (int round = 0; round < 10; ++round) {
      const auto [first, second] = randomJoin(random, order, 7);
      const JoinReport report = join(first, second, withPreset("osculate", 7));
      ASSERT_EQ(report.order, order);
      EXPECT_EQ(report.betaCount, order) << "none from the first order that fails";
      expectCarried(first, second, report, order);
    }
  }
}

TEST(Beta, OfTwoDesignedParametrisationsAreTheirSeries) {
  Random random(231);
  const PointSeries arc = randomArc(random, 6);
  // the second curve is R(s(t)), the first R(t) itself near its end: beta is s
  const RealSeries sigma{Real(0), Real(3), Real("0.5"), Real(-1), Real(2), Real(0), Real(0)};
  RealSeries unit(7, Real(0));
  unit[1] = Real(1);
  const JoinReport report =
      join(endingWith(arc, unit), startingWith(arc, sigma), withPreset("osculate"));
  ASSERT_EQ(report.betaCount, 4);
  for (std::size_t k = 1; k <= 4; ++k)
    EXPECT_NEAR(report.beta[k - 1], toDouble(sigma[k]), 1e-9) << "beta " << k;
}

TEST(Beta, OfACurveCutAtTheMiddleAreOneAndZeros) {
  Random random(232);
  const auto [left, right] = randomBezier(random, 6, false).split(0.5);
  const JoinReport report = join(left, right);
  ASSERT_EQ(report.betaCount, 4);
  EXPECT_NEAR(report.beta[0], 1.0, 1e-12);
  for (std::size_t k = 1; k < 4; ++k)
    EXPECT_NEAR(report.beta[k], 0.0, 1e-9) << "beta " << k + 1;
}

TEST(Beta, OfAMoebiusMapAreItsDerivatives) {
  // weights rho^i: u = rho t / (1 + (rho - 1) t), u^(k)(0) = k! rho (1 - rho)^(k-1)
  Random random(233);
  const auto [left, right] = randomBezier(random, 5, false).split(0.5);
  for (const double rho : {0.5, 2.0}) {
    const JoinReport report = join(left, moebius(right, rho));
    ASSERT_EQ(report.betaCount, 4);
    double expected = rho;
    for (std::size_t k = 1; k <= 4; ++k) {
      EXPECT_NEAR(report.beta[k - 1], expected, 1e-8) << "beta " << k;
      expected *= static_cast<double>(k + 1) * (1.0 - rho);
    }
  }
}

/// f(g(t)) for derivatives f_k and g_k at 0, f_0 = g_0 = 0: the chain rule.
RealSeries chained(const RealSeries& f, const RealSeries& g) {
  PointSeries outer;
  for (const Real& value : f)
    outer.push_back(Point<Real>(value, 0, 0));
  const PointSeries product = composed(outer, g, g.size() - 1);
  RealSeries result;
  for (const auto& value : product)
    result.push_back(factorial<Real>(static_cast<int>(result.size())) * value.x());
  return result;
}

/// A curve that arrives with the length s(t) forward of the join, where endingWith counts
/// backwards.
BezierCurve arrivingAlong(const PointSeries& arc, RealSeries s) {
  for (std::size_t k = 2; k < s.size(); k += 2)
    s[k] = -s[k];
  return endingWith(arc, s);
}

TEST(Beta, OfJoinsInARowComposeByTheChainRule) {
  Random random(234);
  for (int round = 0; round < 20; ++round) {
    // three parametrisations of one trace, the middle one on both sides of the point
    const PointSeries arc = randomArc(random, 7);
    const RealSeries a = randomSigma(random, 7);
    const RealSeries b = randomSigma(random, 7);
    const RealSeries c = randomSigma(random, 7);
    const RealSeries ab = betasOf(join(arrivingAlong(arc, a), startingWith(arc, b)));
    const RealSeries bc = betasOf(join(arrivingAlong(arc, b), startingWith(arc, c)));
    const RealSeries ac = betasOf(join(arrivingAlong(arc, a), startingWith(arc, c)));
    ASSERT_TRUE(ab.size() == 5 && bc.size() == 5 && ac.size() == 5);
    const RealSeries composedBeta = chained(ab, bc);
    for (std::size_t k = 1; k <= 4; ++k) {
      EXPECT_NEAR(toDouble(composedBeta[k]), toDouble(ac[k]),
                  1e-9 * (1.0 + std::abs(toDouble(ac[k]))))
          << "beta " << k;
    }
  }
}

TEST(Beta, AreNoneAcrossAGapOrACorner) {
  EXPECT_EQ(join(bezier({{0, 0, 0}, {1, 0, 0}}), bezier({{1, 1, 0}, {2, 1, 0}})).betaCount, 0);
  EXPECT_EQ(join(bezier({{0, 0, 0}, {1, 0, 0}}), bezier({{1, 0, 0}, {1, 1, 0}})).betaCount, 0);
}

}  // namespace
}  // namespace osculate::test
