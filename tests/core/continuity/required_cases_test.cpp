// Joins that an analysis must get right, one test each.
#include <tuple>

#include "osculate/continuity/curve_joins.h"
#include "support/joins.h"

namespace osculate::test {
namespace {

using Points = std::vector<Vector3>;

BezierCurve arc(const Points& poles) {
  return BezierCurve(poles, std::vector<double>{1.0, std::sqrt(0.5), 1.0});
}

Verdict verdictOf(const JoinReport& report, Definition definition) {
  return report.definitions[static_cast<std::size_t>(definition)].verdict.value();
}

/// A parametrisation of degree 7 that is not by arc length; the curve is about 4 mm long.
const RealSeries kSigma{Real(0), Real(4), Real(1), Real(-2), Real(1), Real(0), Real(0), Real(0)};
const RealSeries kOtherSigma{Real(0), Real(3), Real(-1), Real(1),
                             Real(2), Real(0), Real(0),  Real(0)};

TEST(RequiredCases, Gap) {
  const JoinReport report =
      join(bezier({{0, 0, 0}, {1, 0, 0}}), bezier({{1, 0.25, 0}, {2, 0.25, 0}}));
  EXPECT_EQ(report.order, -1);
  EXPECT_EQ(report.residuals[0], 0.25);
}

/// A line and one that starts at its end at the angle.
JoinReport cornerOf(double degrees) {
  const double angle = degrees * std::numbers::pi / 180.0;
  return join(bezier({{-3, 0, 0}, {0, 0, 0}}),
              bezier({{0, 0, 0}, {2 * std::cos(angle), 2 * std::sin(angle), 0}}));
}

TEST(RequiredCases, TouchingAtNinetyDegreesIsG0) {
  const JoinReport report = cornerOf(90.0);
  EXPECT_EQ(report.order, 0);
  EXPECT_NEAR(report.residuals[1], 90.0, 1e-12);
  EXPECT_FALSE(report.warnings.has(Warning::kCusp));
}

TEST(RequiredCases, TouchingAtAlmostOppositeTangentsIsG0) {
  const JoinReport report = cornerOf(179.999);
  EXPECT_EQ(report.order, 0);
  EXPECT_NEAR(report.residuals[1], 179.999, 1e-11) << "not folded into 0 to 90 degrees";
  EXPECT_TRUE(report.warnings.has(Warning::kCusp));
}

TEST(RequiredCases, CuspOfOppositeTangentsIsG0) {
  const JoinReport report = join(bezier({{-3, 0, 0}, {0, 0, 0}}), bezier({{0, 0, 0}, {-2, 0, 0}}));
  EXPECT_EQ(report.order, 0);
  EXPECT_EQ(report.residuals[1], 180.0);
  EXPECT_EQ(report.verdicts[1], Verdict::kFail);
  EXPECT_TRUE(report.warnings.has(Warning::kCusp));
}

TEST(RequiredCases, EqualCirclesSJoinedAreG1) {
  const JoinReport report =
      join(arc({{-10, 10, 0}, {-10, 0, 0}, {0, 0, 0}}), arc({{0, 0, 0}, {10, 0, 0}, {10, -10, 0}}));
  EXPECT_EQ(report.order, 1);
  EXPECT_NEAR(report.residuals[2], 2.0, 1e-14) << "the curvature vectors are opposite";
  EXPECT_NEAR(report.deviation.osculatingPlaneAngleDegrees.value(), 180.0, 1e-6);
  EXPECT_EQ(verdictOf(report, Definition::kG2Maximum), Verdict::kPass) << "by number";
}

TEST(RequiredCases, OsculatingPlanesApartByNinetyDegreesWithEqualCurvatureAreG1) {
  const JoinReport report =
      join(arc({{-10, 10, 0}, {-10, 0, 0}, {0, 0, 0}}), arc({{0, 0, 0}, {10, 0, 0}, {10, 0, 10}}));
  EXPECT_EQ(report.order, 1);
  EXPECT_NEAR(report.residuals[2], std::sqrt(2.0), 1e-14);
  EXPECT_NEAR(report.deviation.osculatingPlaneAngleDegrees.value(), 90.0, 1e-10);
  EXPECT_NEAR(report.deviation.curvatureRelative.value(), 0.0, 1e-14);
}

TEST(RequiredCases, CollinearLinesPassAllOrders) {
  const JoinReport report = join(bezier({{0, 0, 0}, {3, 6, 6}}),
                                 bezier({{3, 6, 6}, {4, 8, 8}, {9, 18, 18}}), withPreset("exact"));
  EXPECT_EQ(report.order, 4);
  const JoinReport eight = join(bezier({{0, 0, 0}, {3, 6, 6}}), bezier({{3, 6, 6}, {4, 8, 8}}),
                                withPreset("exact", kMaxOrder));
  EXPECT_EQ(eight.order, kMaxOrder);
  EXPECT_FALSE(eight.sides[0].invariants.torsion) << "no made-up numbers on a line";
  EXPECT_EQ(eight.frameKind, FrameKind::kLine);
}

TEST(RequiredCases, LineToArcIsG1) {
  const JoinReport report =
      join(bezier({{-5, 0, 0}, {0, 0, 0}}), arc({{0, 0, 0}, {10, 0, 0}, {10, 10, 0}}));
  EXPECT_EQ(report.order, 1);
  EXPECT_NEAR(report.residuals[2], 0.5, 1e-14) << "0.1 / mm over the line's length of 5 mm";
  EXPECT_EQ(join(arc({{10, 10, 0}, {10, 0, 0}, {0, 0, 0}}), bezier({{0, 0, 0}, {-5, 0, 0}})).order,
            1);
}

TEST(RequiredCases, LineToACurveWithStraightLegsHasTheOrderOfItsLinearity) {
  const BezierCurve line = bezier({{-5, 0, 0}, {0, 0, 0}});
  for (int legs = 1; legs <= 7; ++legs) {
    Points poles;
    for (int i = 0; i <= legs; ++i)
      poles.emplace_back(i, 0, 0);
    poles.emplace_back(legs + 1, 1, 0);
    poles.emplace_back(legs + 2, 1, 2);
    const JoinReport report = join(line, BezierCurve(poles), withPreset("osculate", kMaxOrder));
    EXPECT_EQ(report.order, legs);
    EXPECT_EQ(report.sides[1].linearity, legs);
  }
}

TEST(RequiredCases, InflectionsOnBothSidesMatchOrderByOrder) {
  Random random(210);
  for (int order = 2; order <= 5; ++order) {
    // curvature and torsion vanish at s = 0 and grow from there
    const PointSeries inflection =
        frenetCurve({Real(0), Real(0.25), Real(0.05), Real(-0.02)}, {Real(0), Real(0.1)}, 7);
    const PointSeries other = changedAt(inflection, static_cast<std::size_t>(order) + 1, random);
    const JoinReport report = join(endingWith(inflection, kSigma), startingWith(other, kOtherSigma),
                                   withPreset("exact", 6));
    EXPECT_EQ(report.order, order);
    EXPECT_FALSE(report.sides[0].invariants.torsion || report.sides[1].invariants.torsion);
    EXPECT_TRUE(report.warnings.has(Warning::kNearFlat));
  }
}

TEST(RequiredCases, ZeroCurvatureOnOneSideOnlyIsG1) {
  const PointSeries inflection = frenetCurve({Real(0), Real(0.25)}, {Real(0)}, 7);
  const PointSeries bent = frenetCurve({Real(0.25), Real(0.25)}, {Real(0)}, 7);
  const JoinReport report = join(endingWith(inflection, kSigma), startingWith(bent, kOtherSigma));
  EXPECT_EQ(report.order, 1);
  EXPECT_NEAR(report.residuals[2], 0.25 * report.scaleMm, 1e-12);
  EXPECT_FALSE(report.sides[0].frame.normal);
  EXPECT_TRUE(report.sides[1].frame.normal);
  EXPECT_FALSE(report.deviation.osculatingPlaneAngleDegrees);
}

TEST(RequiredCases, CircleToHelixOfEqualCurvatureIsG3ByScalarRateOnly) {
  const PointSeries circle = frenetCurve({Real(0.25)}, {Real(0)}, 7);
  const PointSeries helix = frenetCurve({Real(0.25)}, {Real(0.25)}, 7);
  const JoinReport report = join(endingWith(circle, kSigma), startingWith(helix, kOtherSigma));
  EXPECT_EQ(report.order, 2);
  EXPECT_EQ(verdictOf(report, Definition::kG3Vector), Verdict::kFail);
  EXPECT_EQ(verdictOf(report, Definition::kG3ScalarRate), Verdict::kPass);
  EXPECT_EQ(verdictOf(report, Definition::kG3Torsion), Verdict::kFail);
  EXPECT_NEAR(report.deviation.torsionPerMm.value(), 0.25, 1e-10);
}

TEST(RequiredCases, PlanarArcToClothoidLikeQuinticIsG3ByFrameAndTorsionOnly) {
  const RealSeries quintic{Real(0), Real(4), Real(1), Real(-2), Real(1), Real(0)};
  const PointSeries circle = frenetCurve({Real(0.25)}, {Real(0)}, 5);
  const PointSeries clothoid = frenetCurve({Real(0.25), Real(0.125)}, {Real(0)}, 5);
  const JoinReport report = join(endingWith(circle, quintic), startingWith(clothoid, quintic));
  EXPECT_EQ(report.order, 2);
  EXPECT_EQ(verdictOf(report, Definition::kG3Vector), Verdict::kFail);
  EXPECT_EQ(verdictOf(report, Definition::kG3FrenetFrame), Verdict::kPass);
  EXPECT_EQ(verdictOf(report, Definition::kG3Torsion), Verdict::kPass);
  EXPECT_EQ(verdictOf(report, Definition::kG3ScalarRate), Verdict::kFail);
  EXPECT_NEAR(report.deviation.curvatureRatePerMm2.value(), 0.125, 1e-11);
}

TEST(RequiredCases,
     OneCurveCutAndOneHalfMoebiusReparametrisedPassesAllOrdersButIsParametricallyC0OrC1) {
  const BezierCurve curve =
      bezier({{0, 0, 0}, {2, 3, 0}, {5, 3, 2}, {7, 0, 4}, {8, -3, 3}, {9, -3, 0}});
  const auto [left, right] = curve.split(0.5);
  const JoinReport slower = join(left, moebius(right, 2.0), withPreset("exact", kMaxOrder));
  EXPECT_GE(slower.order, 6) << "above that doubles do not carry 1e-8";
  for (const Verdict verdict : slower.verdicts)
    EXPECT_NE(verdict, Verdict::kFail);
  EXPECT_EQ(slower.parametricOrder, 0);
  // the halves over spans that make up for the speed at the join: C^1, not C^2
  JoinSide after;
  const BezierCurve mapped = moebius(right, 2.0);
  after = leaving(mapped);
  after.span = 2.0;
  EXPECT_EQ(analyzeJoin(arriving(left), after, withPreset("exact")).parametricOrder, 1);
  EXPECT_EQ(analyzeJoin(arriving(left), after, withPreset("exact")).order, 4);
}

/// P(t^m) for a polynomial curve.
BezierCurve slowed(const BezierCurve& curve, int m) {
  const PointSeries own = taylor(exact<Real>(curve), Real(0), curve.degree());
  PointSeries coefficients(static_cast<std::size_t>(m * curve.degree()) + 1,
                           Point<Real>::Constant(Real(0)));
  for (std::size_t k = 0; k < own.size(); ++k)
    coefficients[static_cast<std::size_t>(m) * k] = own[k];
  return roundedCurve(bezierNet(coefficients));
}

TEST(RequiredCases, DoubleAndTripleEndPolesWithARegularTraceHaveFullOrder) {
  const BezierCurve curve =
      bezier({{0, 0, 0}, {2, 3, 0}, {5, 3, 2}, {7, 0, 4}, {8, -3, 3}, {9, -3, 0}});
  const auto [left, right] = curve.split(0.5);
  for (const int m : {2, 3}) {
    const BezierCurve slow = slowed(right, m);
    const JoinReport report = join(left, slow, withPreset("osculate"));
    EXPECT_EQ(report.order, 4) << m << "-fold pole";
    EXPECT_EQ(report.sides[1].multiplicity, m);
    EXPECT_TRUE(report.warnings.has(Warning::kDegenerateTangent));
    EXPECT_FALSE(report.warnings.has(Warning::kFractionalSmoothness));
    EXPECT_EQ(report.betaCount, 0) << "no regular re-parametrisation";
    const JoinReport both =
        join(slowed(left.reversed(), m).reversed(), slow, withPreset("osculate"));
    EXPECT_EQ(both.order, 4) << m << "-fold poles on both sides";
    EXPECT_EQ(both.frameKind, FrameKind::kFictitiousTangent);
  }
}

TEST(RequiredCases, DoubleAndTripleEndPolesWithACuspHaveTheOrderOfTheirSmoothness) {
  const BezierCurve line = bezier({{-3, 0, 0}, {0, 0, 0}});
  const std::vector<std::tuple<Points, int, int>> cusps{
      {{{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {3, 1, 0}}, 2, 1},  // (3t^2 + .., t^3): s^(3/2)
      {{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {4, 1, 0}}, 3, 1}};  // (4t^3, t^4): s^(4/3)
  for (const auto& [poles, multiplicity, order] : cusps) {
    const JoinReport report = join(line, BezierCurve(poles));
    EXPECT_EQ(report.order, order);
    EXPECT_EQ(report.sides[1].multiplicity, multiplicity);
    EXPECT_TRUE(std::isinf(report.residuals[2])) << "no second derivative by arc length";
    EXPECT_TRUE(report.warnings.has(Warning::kFractionalSmoothness));
    EXPECT_FALSE(report.sides[1].invariants.curvature);
  }
}

TEST(RequiredCases, AClosedEdgeAgainstItself) {
  const double root = std::sqrt(0.5);
  const BSplineCurve circle(BSplineData{.poles = columns({{5, 0, 0},
                                                          {5, 5, 0},
                                                          {0, 5, 0},
                                                          {-5, 5, 0},
                                                          {-5, 0, 0},
                                                          {-5, -5, 0},
                                                          {0, -5, 0},
                                                          {5, -5, 0},
                                                          {5, 0, 0}}),
                                        .weights = {1, root, 1, root, 1, root, 1, root, 1},
                                        .knots = {{0, 1, 2, 3, 4}, {3, 2, 2, 2, 3}},
                                        .degree = 2,
                                        .periodic = false,
                                        .poleError = 0.0});
  EXPECT_EQ(analyzeClosing(circle, withPreset("exact")).report.order, 4);
  const BSplineCurve drop(bezier({{0, 0, 0}, {4, 6, 0}, {-4, 6, 0}, {0, 0, 0}}));
  const JoinReport corner = analyzeClosing(drop).report;
  EXPECT_EQ(corner.order, 0);
  EXPECT_NEAR(corner.residuals[1], 180.0 - 2.0 * std::atan2(4.0, 6.0) * 180.0 / std::numbers::pi,
              1e-10);
}

TEST(RequiredCases, TwoEdgesThatTouchAtBothEndsTakeEndToStartAndSayIt) {
  const BSplineCurve upper(arc({{5, 0, 0}, {5, 5, 0}, {0, 5, 0}}));
  const BSplineCurve back(arc({{0, 5, 0}, {0, 0, 0}, {5, 0, 0}}));
  const JoinReport report = analyzeCurves(upper, back).report;
  EXPECT_TRUE(report.warnings.has(Warning::kTouchesAtBothEnds));
  EXPECT_EQ(report.sides[0].end, CurveEnd::kEnd);
  EXPECT_EQ(report.sides[1].end, CurveEnd::kStart);
  EXPECT_EQ(report.order, 0);
}

/// One quintic cut in the middle, scaled and moved.
JoinReport cutQuintic(double scale, const Vector3& offset, const AnalysisOptions& options) {
  const BezierCurve curve =
      bezier({{0, 0, 0}, {2, 3, 0}, {5, 3, 2}, {7, 0, 4}, {8, -3, 3}, {9, -3, 0}});
  const Eigen::Affine3d map = Eigen::Translation3d(offset) * Eigen::Scaling(scale / 10.0);
  const auto [left, right] = curve.split(0.5);
  return join(left.transformed(map), right.transformed(map), options);
}

TEST(RequiredCases, AMicroscopicEdgeIsDecidedAtTheOriginAndUndecidedFarFromIt) {
  const JoinReport near = cutQuintic(1e-3, Vector3::Zero(), withPreset("exact"));
  EXPECT_EQ(near.order, 4) << "doubles are relative: nothing is lost";
  const JoinReport far = cutQuintic(1e-3, Vector3(1e5, -5e4, 2e4), withPreset("exact"));
  EXPECT_EQ(far.verdicts[0], Verdict::kPass);
  for (std::size_t k = 1; k <= 4; ++k) {
    EXPECT_EQ(far.verdicts[k], Verdict::kUndecided) << "order " << k;
    EXPECT_GT(far.uncertainties[k], far.tolerances[k]);
  }
  EXPECT_EQ(far.order, 0);
  EXPECT_TRUE(far.warnings.has(Warning::kUndecided));
  EXPECT_TRUE(far.warnings.has(Warning::kFarFromOrigin));
  EXPECT_GE(cutQuintic(1e-3, Vector3(1e5, -5e4, 2e4), withPreset("osculate")).order, 1)
      << "0.1 degrees it carries";
}

TEST(RequiredCases, AnEdgeAHundredMetresFromTheOriginIsUndecidedInHighOrdersUnderExactOnly) {
  const JoinReport far = cutQuintic(10.0, Vector3(1e5, 0, 0), withPreset("exact"));
  EXPECT_EQ(far.verdicts[0], Verdict::kPass);
  EXPECT_EQ(far.verdicts[1], Verdict::kPass);
  EXPECT_EQ(far.verdicts[4], Verdict::kUndecided);
  for (const Verdict verdict : far.verdicts)
    EXPECT_NE(verdict, Verdict::kFail);
  EXPECT_EQ(cutQuintic(10.0, Vector3(1e5, 0, 0), withPreset("osculate")).order, 4);
}

TEST(RequiredCases, Degree1AgainstDegree25) {
  Points straight;
  for (int i = 0; i <= kMaxDegree; ++i)
    straight.emplace_back(i, 0, 0);
  const BezierCurve line = bezier({{-5, 0, 0}, {0, 0, 0}});
  EXPECT_EQ(join(line, BezierCurve(straight), withPreset("exact")).order, 4);
  Points bent = straight;
  for (std::size_t i = 3; i < bent.size(); ++i)
    bent[i] += Vector3(0, static_cast<double>(i - 2), 0.5);
  const JoinReport report = join(line, BezierCurve(bent));
  EXPECT_EQ(report.order, 2);
  EXPECT_EQ(report.sides[1].linearity, 2);
}

TEST(RequiredCases, AFigureOfEightDoesNotPassForLackOfALength) {
  // two lobes of different roundness that cross at the join and at the middle of the range
  const BSplineCurve eight(BSplineData{.poles = columns({{0, 0, 0},
                                                         {3, 3, 0},
                                                         {6, 0, 0},
                                                         {3, -3, 0},
                                                         {0, 0, 0},
                                                         {-1, 1, 0},
                                                         {-9, 1, 0},
                                                         {-1, -1, 0},
                                                         {0, 0, 0}}),
                                       .weights = {},
                                       .knots = {{0, 1, 2}, {5, 4, 5}},
                                       .degree = 4,
                                       .periodic = false,
                                       .poleError = 0.0});
  const JoinReport closing = analyzeClosing(eight).report;
  EXPECT_GT(closing.scaleMm, 1.0);
  EXPECT_EQ(closing.order, 1) << "equal tangents, different curvatures";
  const std::vector<CurveJoin> joins = analyzeInnerJoins(eight);
  ASSERT_EQ(joins.size(), 2U);
  EXPECT_GT(joins[0].report.scaleMm, 1.0);
  EXPECT_EQ(joins[0].report.order, 1) << "at the middle likewise";
}

}  // namespace
}  // namespace osculate::test
