#include "osculate/differential/arc_invariants.h"

#include "support/designed_curves.h"
#include "support/perturbation.h"

namespace osculate::test {
namespace {

TravelJet<double> travelJetOf(const BezierCurve& curve, CurveEnd end) {
  const auto arc = arcJet(endJet<4>(curve.view(), end, 0.0));
  return inTravel(arc.r, end == CurveEnd::kEnd ? -1.0 : 1.0);
}

void expectRelative(double found, const Real& expected, double size, double tolerance,
                    const char* name) {
  EXPECT_LE(std::abs(toDouble(Real(Real(found) - expected))),
            tolerance * std::max(size, std::abs(toDouble(expected))))
      << name;
}

TEST(ArcNumbers, AreThoseOfTheCrossProductFormulasInTheDirectionOfTravel) {
  Random random(130);
  for (int round = 0; round < 60; ++round) {
    const BezierCurve curve = randomBezier(random, 3 + round % 6, round % 2 == 0);
    for (const CurveEnd end : {CurveEnd::kStart, CurveEnd::kEnd}) {
      const ArcNumbers<double> found = arcNumbers(travelJetOf(curve, end));
      const Real t(end == CurveEnd::kStart ? 0 : 1);
      const ExactInvariants expected = invariants(taylor(exact<Real>(curve), t, 5));
      // relative to the size that the lengths of the curve (about 10 mm) and its curvature give
      const double unit = std::max(0.1, found.curvature) / std::min(1.0, found.curvature);
      expectRelative(found.curvature, expected.curvature, 0.1, 1e-11, "curvature");
      expectRelative(found.torsion, expected.torsion, unit, 1e-11, "torsion");
      expectRelative(found.curvatureRate, expected.curvatureRate, unit * unit, 1e-11,
                     "curvature rate");
      expectRelative(found.curvatureRate2, expected.curvatureRate2, unit * unit * unit, 1e-11,
                     "curvature rate 2");
      expectRelative(found.torsionRate, expected.torsionRate, unit * unit * unit, 1e-11,
                     "torsion rate");
    }
  }
}

TEST(ArcNumbers, FrameIsOrthonormalAndRightHanded) {
  Random random(131);
  for (int round = 0; round < 20; ++round) {
    const ArcNumbers<double> n =
        arcNumbers(travelJetOf(randomBezier(random, 4, false), CurveEnd::kEnd));
    EXPECT_NEAR(n.tangent.dot(n.normal), 0.0, 1e-12);
    EXPECT_NEAR(n.tangent.cross(n.normal).dot(n.binormal), 1.0, 1e-12);
  }
}

TEST(ArcNumbers, OfAHelixAreConstantWithSignedTorsion) {
  for (const double torsion : {0.375, -0.375}) {
    RealSeries sigma{Real(0), Real(2), Real(1), Real(-1), Real(1), Real(0), Real(1)};
    const PointSeries helix = frenetCurve({Real(0.5)}, {Real(torsion)}, 6);
    for (const bool arrives : {false, true}) {
      const BezierCurve curve = arrives ? endingWith(helix, sigma) : startingWith(helix, sigma);
      const auto n = arcNumbers(travelJetOf(curve, arrives ? CurveEnd::kEnd : CurveEnd::kStart));
      EXPECT_NEAR(n.curvature, 0.5, 1e-13);
      EXPECT_NEAR(n.torsion, torsion, 1e-12);
      EXPECT_NEAR(n.curvatureRate, 0.0, 1e-12);
      EXPECT_NEAR(n.curvatureRate2, 0.0, 1e-11);
      EXPECT_NEAR(n.torsionRate, 0.0, 1e-11);
    }
  }
}

TEST(ArcNumbers, OfAClothoidHaveTheRateOfItsCurvature) {
  const PointSeries clothoid = frenetCurve({Real(0.25), Real(0.125)}, {Real(0)}, 6);
  const RealSeries sigma{Real(0), Real(2), Real(1), Real(-1), Real(1), Real(0), Real(1)};
  const auto n = arcNumbers(travelJetOf(endingWith(clothoid, sigma), CurveEnd::kEnd));
  EXPECT_NEAR(n.curvature, 0.25, 1e-13);
  EXPECT_NEAR(n.curvatureRate, 0.125, 1e-12);
  EXPECT_NEAR(n.curvatureRate2, 0.0, 1e-11);
  EXPECT_EQ(n.torsion, 0.0);
  EXPECT_EQ(n.torsionRate, 0.0);
}

/// What is stored of a curve that has everything.
std::pair<FrenetFrame, Invariants> stored(int available, double flatBelow) {
  Random random(132);
  const auto numbers = arcNumbers(travelJetOf(randomBezier(random, 5, false), CurveEnd::kStart));
  std::pair<FrenetFrame, Invariants> result;
  storeNumbers(numbers, 0, available, flatBelow, result.first, result.second);
  return result;
}

TEST(StoreNumbers, KeepsOnlyWhatTheAvailableDerivativesGive) {
  EXPECT_TRUE(stored(0, 0.0).first.tangent.isZero(0.0));
  EXPECT_NEAR(stored(1, 0.0).first.tangent.norm(), 1.0, 1e-15);
  EXPECT_FALSE(stored(1, 0.0).second.curvature);
  EXPECT_TRUE(stored(2, 0.0).second.curvature && stored(2, 0.0).first.normal &&
              stored(2, 0.0).first.binormal);
  EXPECT_FALSE(stored(2, 0.0).second.torsion);
  EXPECT_TRUE(stored(3, 0.0).second.torsion && stored(3, 0.0).second.curvatureRate);
  EXPECT_FALSE(stored(3, 0.0).second.curvatureRate2 || stored(3, 0.0).second.torsionRate);
  EXPECT_TRUE(stored(4, 0.0).second.curvatureRate2 && stored(4, 0.0).second.torsionRate);
}

TEST(StoreNumbers, WhereFlatGivesTheCurvatureButNoNumberThatNeedsANormal) {
  const auto [frame, numbers] = stored(4, 1e9);
  EXPECT_TRUE(numbers.curvature);
  EXPECT_FALSE(frame.normal || frame.binormal);
  EXPECT_FALSE(numbers.torsion || numbers.curvatureRate || numbers.curvatureRate2 ||
               numbers.torsionRate);
}

}  // namespace
}  // namespace osculate::test
