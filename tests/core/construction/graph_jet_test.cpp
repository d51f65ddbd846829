// A curve as a graph over its tangent, against the Frenet formulas and against its inverse.
#include "osculate/construction/graph_jet.h"

#include <gtest/gtest.h>

#include "construction/extend_curves.h"
#include "osculate/differential/arc_jet.h"
#include "osculate/differential/point_geometry.h"

namespace osculate {
namespace {

std::size_t index(int k) { return static_cast<std::size_t>(k); }

TEST(GraphJet, HasTheDerivativesOfFrenetsFormulas) {
  for (const auto& [name, curve] : {test::NamedCurve{"quintic", test::twistedQuintic()},
                                    {"rational", test::rationalQuartic()}}) {
    const PointGeometry geometry = geometryAt(curve, curve.last(), Side::kLeft);
    const GraphJet graph = graphJet(contactJet(curve, {}, 4));
    const auto& r = graph.overTangent.r;
    const Invariants& i = geometry.invariants;
    const double kappa = *i.curvature;
    const double tau = *i.torsion;
    const Vector3 n = *geometry.frame.normal;
    const Vector3 b = *geometry.frame.binormal;
    EXPECT_NEAR(r[2].dot(n), kappa, 1e-13) << name;
    EXPECT_NEAR(r[2].dot(b), 0.0, 1e-13) << name;
    EXPECT_NEAR(r[3].dot(n), *i.curvatureRate, 1e-13) << name;
    EXPECT_NEAR(r[3].dot(b), kappa * tau, 1e-13) << name;
    EXPECT_NEAR(r[4].dot(n), *i.curvatureRate2 + 3.0 * std::pow(kappa, 3) - kappa * tau * tau,
                1e-13)
        << name;
    EXPECT_NEAR(r[4].dot(b), 2.0 * *i.curvatureRate * tau + kappa * *i.torsionRate, 1e-13) << name;
    for (std::size_t k = 2; k <= 4; ++k)
      EXPECT_NEAR(r[k].dot(r[1]), 0.0, 1e-15) << name << k;
  }
}

TEST(GraphJet, OfACircleIsItsSeries) {
  // y = R - sqrt(R^2 - u^2) = u^2/2R + u^4/8R^3 + u^6/16R^5 + 5 u^8/128R^7; s = R asin(u/R)
  const GraphJet graph = graphJet(contactJet(test::quarterCircle(), {}, 8));
  const Vector3 inward(0, -1, 0);
  const std::array<double, 9> expected{0, 0, 0.05, 0, 1 / 8e3, 0, 1 / 16e5, 0, 5 / 128e7};
  const std::array<double, 9> lengths{0, 1, 0, 1 / 6e2, 0, 3 / 40e4, 0, 5 / 112e6, 0};
  for (std::size_t k = 2; k <= 8; ++k) {
    const double taylor = graph.overTangent.r[k].dot(inward) / detail::kFactorials[k];
    EXPECT_NEAR(taylor, expected[k], 1e-12 * std::pow(0.1, static_cast<double>(k))) << k;
  }
  for (std::size_t k = 1; k <= 8; ++k)
    EXPECT_NEAR(graph.arcLength[k], lengths[k], 1e-12 * std::pow(0.1, static_cast<double>(k))) << k;
}

TEST(GraphJet, ArcLengthAndTangentialCoordinateAreInverse) {
  const ContactJet contact = contactJet(test::twistedQuintic(), {}, 8);
  const ArcLengthSeries sigma{20.0, 4.0, -3.0, 2.0, 1.0, -1.0, 0.5, 0.25};
  const ArcLengthSeries back = arcLengthOf(graphJet(contact), tangentialOf(contact, sigma));
  for (std::size_t k = 0; k < kMaxOrder; ++k)
    EXPECT_NEAR(back[k], sigma[k], 1e-9) << k;
}

TEST(GraphJet, AttachesTheSameCurveAsArcLength) {
  const ContactJet contact = contactJet(test::rationalQuartic(), {}, 6);
  const ArcLengthSeries sigma{20.0, 4.0, -3.0, 2.0, 1.0, -1.0};
  const BoundedPoles byLength = attach(contact, sigma, 8);
  const BoundedPoles byTangent =
      attach(graphJet(contact).overTangent, tangentialOf(contact, sigma), 8);
  EXPECT_LE((byLength - byTangent).norm(), 1e-11);
}

TEST(GraphJet, DerivativesOfArcLengthAgreeWithDifferences) {
  const GraphJet graph = graphJet(contactJet(test::twistedQuintic(), {}, 6));
  const ArcLengthSeries u{20.0, 4.0, -3.0, 2.0, 1.0, -1.0};
  const SeriesDerivatives derivative = arcLengthDerivatives(graph, u);
  for (std::size_t l = 0; l < 6; ++l) {
    constexpr double kStep = 1e-5;
    ArcLengthSeries above = u;
    ArcLengthSeries below = u;
    above[l] += kStep;
    below[l] -= kStep;
    const ArcLengthSeries high = arcLengthOf(graph, above);
    const ArcLengthSeries low = arcLengthOf(graph, below);
    for (std::size_t k = 0; k < 6; ++k) {
      const double difference = (high[k] - low[k]) / (2.0 * kStep);
      EXPECT_NEAR(difference, derivative[l][k], 1e-6 * (1.0 + std::abs(difference))) << l << k;
    }
  }
  EXPECT_EQ(derivative[index(2)][index(1)], 0.0);  // s_2 does not depend on u_3
}

}  // namespace
}  // namespace osculate
