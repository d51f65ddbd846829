#include "osculate/continuity/join_analysis.h"

#include <limits>

#include "support/joins.h"

namespace osculate::test {
namespace {

TEST(AnalyzeJoin, FindsTheOrderOfRandomJoinsOfEveryOrder) {
  Random random(200);
  for (int order = -1; order <= kMaxOrder; ++order) {
    for (int round = 0; round < 12; ++round) {
      const JoinedPair pair = randomJoin(random, order, 8);
      const JoinReport report = join(pair.first, pair.second, withPreset("osculate", kMaxOrder));
      EXPECT_EQ(report.order, order) << "order " << order << " round " << round;
      EXPECT_EQ(join(pair.first, pair.second).order, std::min(order, 4));
    }
  }
}

TEST(AnalyzeJoin, ResidualsAreThoseOfTheContractToTheirUncertainty) {
  Random random(201);
  for (int order = -1; order <= 4; ++order) {
    for (int round = 0; round < 8; ++round) {
      const JoinedPair pair = randomJoin(random, order, 5);
      const JoinReport report = join(pair.first, pair.second, withPreset("exact", kMaxOrder));
      const auto expected =
          residuals(arrivingDerivatives(exact<Real>(pair.first), kMaxOrder),
                    leavingDerivatives(exact<Real>(pair.second), kMaxOrder), report.scaleMm);
      for (std::size_t k = 0; k <= kMaxOrder; ++k) {
        EXPECT_NEAR(report.residuals[k], expected[k], report.uncertainties[k] + 1e-14 * expected[k])
            << "order " << k;
      }
    }
  }
}

TEST(AnalyzeJoin, JudgesEachOrderByItself) {
  // parallel curves with a gap: order 0 fails, all others pass
  const BezierCurve first = bezier({{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {3, 3, 0}});
  const auto [left, right] = first.split(0.5);
  const JoinReport report =
      join(left, right.transformed(Eigen::Affine3d(Eigen::Translation3d(0, 0, 0.5))));
  EXPECT_EQ(report.order, -1);
  EXPECT_EQ(report.parametricOrder, -1);
  EXPECT_EQ(report.verdicts[0], Verdict::kFail);
  for (std::size_t k = 1; k <= 4; ++k)
    EXPECT_EQ(report.verdicts[k], Verdict::kPass) << "order " << k;
  EXPECT_DOUBLE_EQ(report.residuals[0], 0.5);
  EXPECT_DOUBLE_EQ(report.deviation.gapMm, 0.5);
}

TEST(AnalyzeJoin, ReportsOnlyTheOrdersAskedFor) {
  const BezierCurve line = bezier({{0, 0, 0}, {1, 0, 0}});
  for (int order = 0; order <= kMaxOrder; ++order) {
    const JoinReport report = join(line, line.segment(1.0, 2.0), withPreset("osculate", order));
    EXPECT_EQ(report.requestedOrder, order);
    EXPECT_EQ(report.order, order);
  }
}

TEST(AnalyzeJoin, TolerancesAreThoseOfTheOptionsAndOrdersAboveFourUseTheFourth) {
  AnalysisOptions options = withPreset("osculate", kMaxOrder);
  options.tolerances = {.gapMm = 1, .angleDegrees = 2, .curvature = 3, .third = 4, .fourth = 5};
  const BezierCurve line = bezier({{0, 0, 0}, {1, 0, 0}});
  const JoinReport report = join(line, line.segment(1.0, 2.0), options);
  EXPECT_EQ(report.tolerances, (PerOrder{1, 2, 3, 4, 5, 5, 5, 5, 5}));
}

TEST(AnalyzeJoin, EitherEndOfEitherSegmentMayLieAtTheJoin) {
  Random random(202);
  const JoinedPair pair = randomJoin(random, 2, 5);
  const JoinReport plain = join(pair.first, pair.second);
  const BezierCurve first = pair.first.reversed();
  const BezierCurve second = pair.second.reversed();
  const JoinReport turned = analyzeJoin(arriving(first, CurveEnd::kStart),
                                        leaving(second, CurveEnd::kEnd), AnalysisOptions{});
  EXPECT_EQ(turned.order, plain.order);
  for (std::size_t k = 0; k <= 4; ++k)
    EXPECT_NEAR(turned.residuals[k], plain.residuals[k], plain.uncertainties[k]);
  EXPECT_EQ(turned.sides[0].end, CurveEnd::kStart);
  EXPECT_EQ(turned.sides[1].end, CurveEnd::kEnd);
  EXPECT_LE((turned.sides[0].frame.tangent - plain.sides[0].frame.tangent).norm(), 1e-14)
      << "direction of travel";
}

TEST(AnalyzeJoin, ScaleIsTheSmallerReachAndMayBeOverridden) {
  const BezierCurve first = bezier({{-8, 0, 0}, {0, 0, 0}});
  const BezierCurve second = bezier({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}});
  EXPECT_EQ(join(first, second).scaleMm, 3.0);
  JoinSide side = leaving(second);
  side.reach = 5.0;
  EXPECT_EQ(analyzeJoin(arriving(first), side).scaleMm, 5.0);
  AnalysisOptions options;
  options.scaleMm = 0.25;
  EXPECT_EQ(join(first, second, options).scaleMm, 0.25);
}

TEST(ReachOf, IsTheDistanceToTheOtherEndOrTheMiddleWhicheverIsFarther) {
  const BezierCurve chord = bezier({{0, 0, 0}, {1, 1, 0}, {4, 0, 0}});
  EXPECT_EQ(reachOf(chord.view(), CurveEnd::kStart), 4.0);
  EXPECT_EQ(reachOf(chord.view(), CurveEnd::kEnd), 4.0);
  const BezierCurve loop = bezier({{0, 0, 0}, {4, 8, 0}, {-4, 8, 0}, {0, 0, 0}});
  EXPECT_EQ(reachOf(loop.view(), CurveEnd::kStart), 6.0) << "closed: the middle (0, 6)";
  const BezierCurve weighted = bezier({{0, 0, 0}, {0, 9, 0}, {0, 0, 0}}, {1.0, 4.0, 1.0});
  EXPECT_NEAR(reachOf(weighted.view(), CurveEnd::kEnd), 9.0 * 8.0 / 10.0, 1e-14);
}

TEST(ReachOf, OfACurveThatIsBackAtTheJoinAtItsMiddleIsStillItsSize) {
  // a figure of eight: ends and middle are the crossing
  const BezierCurve eight =
      bezier({{0, 0, 0}, {8, 8, 0}, {-4, -8, 0}, {4, 8, 0}, {-8, -8, 0}, {0, 0, 0}});
  ASSERT_EQ(eight.evaluate(0.5), Vector3::Zero());
  EXPECT_GT(reachOf(eight.view(), CurveEnd::kStart), 1.0);
}

TEST(AnalyzeJoin, DeviationsArePhysicalAndEmptyWhereASideHasNoSuchNumber) {
  const double root = std::sqrt(0.5);
  const BezierCurve line = bezier({{0, -5, 0}, {0, 0, 0}});
  const BezierCurve arc = bezier({{0, 0, 0}, {0, 10, 0}, {-10, 10, 0}}, {1.0, root, 1.0});
  const Deviation toArc = join(line, arc).deviation;
  EXPECT_EQ(toArc.tangentAngleDegrees, 0.0);
  EXPECT_NEAR(toArc.curvatureVectorPerMm.value(), 0.1, 1e-15);
  EXPECT_NEAR(toArc.curvatureRelative.value(), 1.0, 1e-15);
  EXPECT_FALSE(toArc.osculatingPlaneAngleDegrees || toArc.torsionPerMm ||
               toArc.curvatureRatePerMm2 || toArc.torsionRatePerMm2 || toArc.curvatureRate2PerMm3);
  const Deviation between =
      join(arc.reversed().segment(0, 0.5), arc.reversed().segment(0.5, 1)).deviation;
  EXPECT_NEAR(between.osculatingPlaneAngleDegrees.value(), 0.0, 1e-10);
  EXPECT_NEAR(between.torsionPerMm.value(), 0.0, 1e-14);
  EXPECT_NEAR(between.curvatureRate2PerMm3.value(), 0.0, 1e-13);
}

TEST(AnalyzeJoin, SidesCarryPointFrameAndNumbersInTheDirectionOfTravel) {
  Random random(203);
  const JoinedPair pair = randomJoin(random, 3, 6);
  const JoinReport report = join(pair.first, pair.second);
  const ExactInvariants first = invariants(taylor(exact<Real>(pair.first), Real(1), 5));
  EXPECT_NEAR(*report.sides[0].invariants.curvatureRate, toDouble(first.curvatureRate), 1e-12);
  EXPECT_NEAR(*report.sides[0].invariants.torsion, toDouble(first.torsion), 1e-12);
  EXPECT_EQ(report.sides[0].point, Vector3(pair.first.pole(6)));
  EXPECT_LE((report.sides[0].frame.tangent - Vector3::UnitX()).norm(), 1e-13);
  EXPECT_LE((*report.sides[1].frame.normal - Vector3::UnitY()).norm(), 1e-12);
  EXPECT_EQ(report.sides[0].linearity, 1);
  EXPECT_EQ(report.sides[0].multiplicity, 1);
  EXPECT_EQ(report.sides[0].smoothness, kMaxOrder);
  EXPECT_EQ(report.frameKind, FrameKind::kFrenet);
}

TEST(AnalyzeJoin, FrameIsThatOfTheFirstCurveByTheThesissSpecialCases) {
  const BezierCurve line = bezier({{0, 0, 0}, {0, 5, 0}});
  const BezierCurve next = bezier({{0, 5, 0}, {0, 8, 0}, {1, 9, 0}, {2, 9, 0}});
  EXPECT_EQ(join(line, next).frameKind, FrameKind::kLine);
  const BezierCurve inflected = bezier({{3, 4, 0}, {0, 3, 0}, {0, 4, 0}, {0, 5, 0}});
  const JoinReport report = join(inflected, next);
  EXPECT_EQ(report.frameKind, FrameKind::kFictitiousNormal);
  EXPECT_EQ(report.frame.tangent, Vector3::UnitY());
  EXPECT_EQ(*report.frame.normal, Vector3::UnitX()) << "of the first leg off the tangent";
  EXPECT_EQ(*report.frame.binormal, -Vector3::UnitZ());
  EXPECT_FALSE(report.sides[0].frame.normal) << "the side itself has none";
}

TEST(AnalyzeJoin, DerivativesInTheFrameAreThoseOfTheSegmentsInTheDirectionOfTravel) {
  Random random(204);
  const BezierCurve first = randomBezier(random, 5, true);
  const BezierCurve second = randomBezier(random, 4, false);
  const JoinReport report = join(first, second);
  const std::vector<Vector3> expected[2] = {first.derivatives(1.0, 4), second.derivatives(0.0, 4)};
  Eigen::Matrix3d axes;
  axes << report.frame.tangent, *report.frame.normal, *report.frame.binormal;
  for (std::size_t i = 0; i < 2; ++i) {
    for (int k = 0; k <= 4; ++k) {
      Vector3 derivative = expected[i][static_cast<std::size_t>(k)];
      if (k == 0) derivative -= first.pole(5);
      const Vector3 found = axes * report.derivativesInFrame[i].row(k).transpose();
      EXPECT_LE((found - derivative).norm(), 1e-11 * (1.0 + derivative.norm()))
          << "side " << i << " order " << k;
    }
  }
}

TEST(AnalyzeJoin, ParametricOrderComparesDerivativesByTheCurvesOwnParameters) {
  const BezierCurve quintic =
      bezier({{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {3, 3, 1}, {4, 2, 3}, {6, 2, 4}});
  const auto [left, right] = quintic.split(0.25);
  JoinSide before = arriving(left);
  JoinSide after = leaving(right);
  EXPECT_EQ(analyzeJoin(before, after, withPreset("exact")).parametricOrder, 0)
      << "both over [0, 1]: speeds differ";
  before.span = 0.25;
  after.span = 0.75;
  const JoinReport report = analyzeJoin(before, after, withPreset("exact", kMaxOrder));
  EXPECT_EQ(report.parametricOrder, kMaxOrder);
  after.span = 0.75 * 1.0001;
  EXPECT_EQ(analyzeJoin(before, after).parametricOrder, 4)
      << "within the tolerances of the default preset";
}

TEST(AnalyzeJoin, ParametricOrderEndsWhereAHigherDerivativeDiffers) {
  Random random(205);
  for (int order = 0; order <= 3; ++order) {
    std::vector<Vector3> coefficients(6, Vector3::Zero());
    for (std::size_t k = 1; k <= 5; ++k)
      coefficients[k] = random.vector(3.0);
    PointSeries forward;
    for (const Vector3& c : coefficients)
      forward.push_back(exact<Real>(c));
    PointSeries changed = forward;
    changed[static_cast<std::size_t>(order) + 1] += Point<Real>(1, 2, -2);
    const BezierCurve first = roundedCurve(bezierNet(backwards(forward))).reversed();
    const JoinReport report = join(first, roundedCurve(bezierNet(changed)), withPreset("exact"));
    EXPECT_EQ(report.parametricOrder, order);
  }
}

TEST(DecideJoin, IsTheDecisionOfTheFullReport) {
  Random random(206);
  for (int round = 0; round < 40; ++round) {
    const JoinedPair pair = randomJoin(random, round % 6 - 1, 5);
    for (const int order : {0, 2, 4, 7}) {
      const AnalysisOptions options = withPreset("osculate", order);
      const JoinReport report = join(pair.first, pair.second, options);
      const JoinDecision decision = decideJoin(arriving(pair.first), leaving(pair.second), options);
      EXPECT_EQ(decision.order, report.order);
      EXPECT_EQ(decision.parametricOrder, report.parametricOrder);
      for (std::size_t k = 0; k <= static_cast<std::size_t>(order); ++k) {
        EXPECT_EQ(decision.verdicts[k], report.verdicts[k]);
        EXPECT_EQ(decision.residuals[k], report.residuals[k]);
        EXPECT_EQ(decision.uncertainties[k], report.uncertainties[k]);
      }
    }
  }
}

TEST(AnalyzeJoin, OfCurvesThatAreOnePointSaysThatThereIsNoTangent) {
  const BezierCurve point = bezier({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}});
  const BezierCurve line = bezier({{1, 1, 1}, {2, 1, 1}});
  const JoinReport report = join(point, line);
  EXPECT_EQ(report.order, 0);
  EXPECT_TRUE(std::isinf(report.residuals[1]));
  EXPECT_EQ(report.verdicts[1], Verdict::kFail);
  EXPECT_FALSE(report.deviation.tangentAngleDegrees);
  EXPECT_TRUE(report.warnings.has(Warning::kDegenerateTangent));
}

}  // namespace
}  // namespace osculate::test
