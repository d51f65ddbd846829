#include "osculate/construction/join.h"

#include <gtest/gtest.h>

#include <cmath>

#include "construction/join_checks.h"
#include "support/errors.h"
#include "support/spline_samples.h"

namespace osculate {
namespace {

using namespace test;

std::string told(int degree, bool rational) {
  return "degree " + std::to_string(degree) + (rational ? ", rational" : "");
}

TEST(Join, ReturnsTheSplineThatWasCut) {
  Random random(200);
  for (const bool rational : {false, true}) {
    for (int degree = 2; degree <= 9; ++degree) {
      SCOPED_TRACE(told(degree, rational));
      const BSplineCurve whole = randomSpline(random, degree, degree - 1, rational);
      const auto parts = disguised(random, pieces(whole, {0.3, 0.8, 1.1, 2.5, 3.1}), {});
      const Construction result = joinCurves(parts);
      expectSameCurve(result.curve, whole, 1e-10 * size(whole));
      expectTraces(result, parts, 1e-13);
    }
  }
}

TEST(Join, RaisesToTheHighestDegree) {
  Random random(201);
  for (const bool rational : {false, true}) {
    for (const int degree : {2, 3, 5}) {
      SCOPED_TRACE(told(degree, rational));
      const BSplineCurve whole = randomSpline(random, degree, degree - 1, rational);
      const auto parts =
          disguised(random, pieces(whole, {0.3, 0.8, 1.1, 2.5, 3.1}), {.elevate = 3});
      const Construction result = joinCurves(parts);
      expectSameCurve(result.curve, whole.elevated(3), 1e-9 * size(whole));
      expectTraces(result, parts, 1e-13);
    }
  }
}

TEST(Join, KeepsTheBitsOfPolesFarFromTheJoins) {
  Random random(202);
  const BSplineCurve whole(
      randomSplineData(random, 3, {{0, 1, 2, 3, 4, 5, 6, 7}, {4, 1, 1, 1, 1, 1, 1, 4}}, false));
  const auto parts = pieces(whole, {3.5});
  const Construction result = joinCurves(parts);
  expectSameCurve(result.curve, whole, 1e-12 * size(whole));
  const Poles& poles = result.curve.data().poles;
  EXPECT_EQ(poles.leftCols(4), parts[0].data().poles.leftCols(4));
  EXPECT_EQ(poles.rightCols(4), parts[1].data().poles.rightCols(4));
}

TEST(Join, OfDegree25IsExactToRounding) {
  Random random(203);
  for (const bool rational : {false, true}) {
    const BSplineCurve whole(randomBezier(random, 25, rational));
    const auto parts = disguised(random, pieces(whole, {0.4, 0.7}), {});
    const Construction result = joinCurves(parts);
    EXPECT_EQ(result.curve.spanCount(), 1) << rational;
    expectTraces(result, parts, 1e-13);
  }
}

TEST(Join, MixesDegreesUpTo25AndKinds) {
  Random random(204);
  std::vector<BSplineCurve> parts;
  Vector3 end = Vector3::Zero();
  for (int degree = 1; degree <= 25; ++degree) {
    std::vector<Vector3> poles = randomPoles(random, degree + 1);
    const Vector3 shift = end - poles.front();
    for (Vector3& pole : poles)
      pole += shift;
    poles.front() = end;
    end = poles.back();
    const auto weights =
        degree % 3 == 0 ? randomWeights(random, degree + 1) : std::vector<double>{};
    parts.emplace_back(BezierCurve(poles, weights));
  }
  const Construction result = joinCurves(parts);
  EXPECT_EQ(result.curve.degree(), 25);
  EXPECT_TRUE(result.curve.isRational());
  for (const BSplineCurve::InnerKnot& knot : result.curve.innerKnots())
    EXPECT_EQ(knot.multiplicity, 25);
  expectTraces(result, parts, 1e-13);
  ASSERT_EQ(result.warnings.size(), 1U);
  EXPECT_TRUE(result.warnings[0].starts_with("corner: G0 only at 24 joins (the sharpest, "));
}

TEST(Join, LowersKnotsThatTheInputsDoNotNeed) {
  Random random(205);
  const BSplineCurve whole = randomSpline(random, 4, 2, false);
  SplineNet net = clampedNet(whole);
  net = inserted(inserted(net, 1.5, 2), 2.0, 1);
  const std::vector<BSplineCurve> one{curveOf(net)};
  expectSameCurve(joinCurves(one).curve, whole, 1e-11 * size(whole));
  EXPECT_TRUE(joinCurves(one).joins.empty());
  expectSameCurve(joinCurves(pieces(one[0], {1.7})).curve, whole, 1e-11 * size(whole));
}

TEST(Join, OfOneCurveIsItself) {
  Random random(206);
  for (const bool rational : {false, true}) {
    const std::vector<BSplineCurve> one{randomSpline(random, 3, 3, rational)};
    const Construction result = joinCurves(one);
    expectSameCurve(result.curve, one[0], rational ? 1e-14 : 0.0);
    EXPECT_EQ(*result.maxDisplacementMm, *joinCurves(one).maxDisplacementMm);
    EXPECT_LE(*result.maxDisplacementMm, 1e-14 * size(one[0]));
  }
}

TEST(Join, OfCollinearSegmentsIsOneSegment) {
  const std::vector<BSplineCurve> parts{segment({0, 0, 0}, {1, 2, 0}),
                                        segment({3, 6, 0}, {1, 2, 0}),
                                        segment({3, 6, 0}, {3.5, 7, 0})};
  const Construction result = joinCurves(parts);
  EXPECT_EQ(result.curve.data().poles.cols(), 2);
  EXPECT_EQ(result.curve.data().knots.knots, (std::vector<double>{0.0, 3.5}));
  EXPECT_TRUE(result.warnings.empty());
  for (const CurveJoin& join : result.joins)
    EXPECT_EQ(join.report.order, 4);
}

TEST(Join, KeepsCornersAndMeanSpeeds) {
  const std::vector<BSplineCurve> parts{segment({0, 0, 0}, {2, 0, 0}),
                                        segment({2, 0, 0}, {2, 6, 0})};
  const Construction result = joinCurves(parts);
  EXPECT_EQ(result.curve.data().knots.knots, (std::vector<double>{0.0, 1.0, 4.0}));
  EXPECT_EQ(result.curve.data().knots.multiplicities, (std::vector<int>{2, 1, 2}));
  ASSERT_EQ(result.joins.size(), 1U);
  EXPECT_EQ(result.joins[0].report.order, 0);
  EXPECT_EQ(result.joins[0].parameter, 1.0);
  EXPECT_EQ(result.warnings, (std::vector<std::string>{"corner: G0 only at 1 join (90 degrees, "
                                                       "between curves[0] and curves[1])"}));
}

TEST(Join, OfArcsKeepsTheKnotsThatHomogeneousFormNeeds) {
  const std::vector<BSplineCurve> parts{arc(0, 90), arc(90, 130).reversed(), arc(130, 200)};
  const Construction result = joinCurves(parts);
  EXPECT_EQ(result.curve.data().knots.multiplicities, (std::vector<int>{3, 2, 2, 3}));
  for (const CurveJoin& join : result.joins) {
    EXPECT_EQ(join.report.order, 4);
    EXPECT_GE(join.report.parametricOrder, 1);  // the parameter runs through at one speed
  }
  EXPECT_TRUE(result.warnings.empty());
  expectTraces(result, parts, 1e-14);
}

TEST(Join, JudgesRationalCurvesWithTheirWeights) {
  // a quarter of a circle cut by de Casteljau: the weights of its halves run on
  const auto [first, second] = arc(0, 90).split(0.4);
  Random random(207);
  const auto parts = disguised(random, {first, second}, {});
  expectSameCurve(joinCurves(parts).curve, arc(0, 90), 1e-13);
}

TEST(Join, ReportsTheJoinsOfTheResultAndOfTheInputs) {
  Random random(208);
  const BSplineCurve whole(
      randomSplineData(random, 5, {{0, 1, 2, 3}, {6, 3, 2, 6}}, false));  // C2 at 1, C3 at 2
  const auto parts = disguised(random, pieces(whole, {0.5, 1, 2}), {});
  const Construction result = joinCurves(parts);
  ASSERT_EQ(result.joins.size(), 3U);
  ASSERT_EQ(result.inputJoins.size(), 3U);
  const int orders[] = {4, 2, 3};
  const double knots[] = {0.5, 1.0, 2.0};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(result.joins[i].report.order, orders[i]) << i;
    EXPECT_EQ(result.joins[i].report.parametricOrder, orders[i]) << i;
    EXPECT_EQ(result.inputJoins[i].report.order, orders[i]) << i;
    EXPECT_EQ(result.inputJoins[i].report.parametricOrder, 0) << i;
    EXPECT_NEAR(*result.joins[i].parameter, knots[i], 1e-12);
  }
}

TEST(Join, MatchesTheFirstDerivativesThatAreNotZero) {
  // t^2 before and after the join: no speed there, but one second derivative
  const std::vector<Vector3> poles{{-4, -2, 0}, {0, 0, 0}, {0, 0, 0}};
  const std::vector<Vector3> later{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {3, 1.5, 0}};
  const std::vector<Vector3> same{{0, 0, 0}, {0, 0, 0}, {-1, -0.5, 0}};
  const BSplineCurve first{BezierCurve(poles)};
  const Construction back =
      joinCurves(std::vector{first, BSplineCurve(BezierCurve(same), 0.0, 5.0)});
  EXPECT_EQ(back.curve.spanCount(), 1);  // one parabola of t, there and back
  EXPECT_NEAR(back.curve.last(), 1.5, 1e-14);
  const Construction on = joinCurves(std::vector{first, BSplineCurve(BezierCurve(later))});
  EXPECT_EQ(on.curve.data().knots.multiplicities[1], 2);  // C1: the second derivatives differ
}

TEST(Join, GivesTheParameterOfTheFirstCurve) {
  Random random(209);
  const BSplineCurve whole = randomSpline(random, 3, 2, false);
  for (const double factor : {1.0, 1e-3, 1e6}) {
    auto parts = pieces(whole, {1.5});
    parts[0] = parts[0].reparametrised(7.0, 7.0 + 1.5 * factor);
    const Construction result = joinCurves(parts);
    EXPECT_EQ(result.curve.first(), 7.0);
    EXPECT_NEAR(result.curve.last(), 7.0 + 4.0 * factor, 1e-11 * factor);
    EXPECT_EQ(result.curve.spanCount(), whole.spanCount());
  }
}

TEST(Join, FollowsRigidMotionAndScaling) {
  Random random(210);
  const BSplineCurve whole = randomSpline(random, 4, 3, true);
  const auto parts = disguised(random, pieces(whole, {0.8, 1.1, 2.5}), {.elevate = 1});
  const BSplineCurve still = joinCurves(parts).curve;
  for (const double scale : {1.0, 1e-4, 1e5}) {
    Eigen::Affine3d map(Eigen::AngleAxisd(0.7, random.direction()));
    map = Eigen::Translation3d(scale * random.vector(20)) * map * Eigen::Scaling(scale);
    std::vector<BSplineCurve> moved;
    for (const BSplineCurve& part : parts)
      moved.push_back(part.transformed(map));
    expectSameCurve(joinCurves(moved).curve, still.transformed(map), 1e-9 * std::max(1.0, scale));
  }
}

TEST(Join, OfTheListBackwardsIsTheCurveBackwards) {
  Random random(211);
  const BSplineCurve whole = randomSpline(random, 3, 2, true);
  auto parts = disguised(random, pieces(whole, {0.8, 1.1, 2.5}), {});
  const BSplineCurve ahead = joinCurves(parts).curve;
  std::reverse(parts.begin(), parts.end());
  const BSplineCurve back = joinCurves(parts).curve.reversed();
  const double scale = back.data().weights.front() / ahead.data().weights.front();
  expectSameCurve(withWeightsScaled(back, 1.0 / scale).reparametrised(ahead.first(), ahead.last()),
                  ahead, 1e-11 * size(whole));
}

TEST(Join, CutsCurvesThatAreTornWhereTheyMeet) {
  Random random(212);
  BSplineData data = randomSplineData(random, 2, {{0, 1, 2}, {3, 3, 3}}, false);
  EXPECT_THROW(joinCurves(std::vector{BSplineCurve(data)}), ContactError);
  EXPECT_ERROR(joinCurves(std::vector{BSplineCurve(data)}), "curves[0] is torn by");
  data.poles.col(3) = data.poles.col(2);
  const Construction result = joinCurves(std::vector{BSplineCurve(data)});
  EXPECT_EQ(result.curve.data().knots.multiplicities, (std::vector<int>{3, 2, 3}));
  EXPECT_TRUE(result.joins.empty());
  data.poles.col(3) += Vector3(0, 0, 1e-3);
  EXPECT_NEAR(*joinCurves(std::vector{BSplineCurve(data)}, 1e-3).maxDisplacementMm, 5e-4, 1e-6);
}

TEST(Join, TakesUnclampedAndPeriodicCurves) {
  for (const SplineSample& sample : splineSamples(216)) {
    if (sample.isTorn()) continue;
    SCOPED_TRACE(sample.name);
    const std::vector<BSplineCurve> one{BSplineCurve(sample.data)};
    const Construction result = joinCurves(one);
    EXPECT_LE(result.curve.data().poles.cols(), clampedNet(one[0]).poleCount());
    EXPECT_EQ(result.curve.first(), one[0].first());
    EXPECT_EQ(result.curve.last(), one[0].last());
    expectTraces(result, one, 1e-13);
    EXPECT_EQ(result.joins.size(), sample.data.periodic ? 1U : 0U);
  }
}

TEST(Join, RaisesLongSplinesToHighDegreesSoon) {
  Random random(217);
  KnotVector knots{{0}, {4}};
  for (int i = 1; i < 1000; ++i) {
    knots.knots.push_back(i);
    knots.multiplicities.push_back(1);
  }
  knots.knots.push_back(1000);
  knots.multiplicities.push_back(4);
  const BSplineCurve spline(randomSplineData(random, 3, knots, false));
  std::vector<Vector3> poles = randomPoles(random, 26);
  for (std::size_t i = poles.size(); i-- > 0;)
    poles[i] += spline.endPoint(CurveEnd::kEnd) - poles[0];
  const std::vector<BSplineCurve> parts{spline, BSplineCurve(BezierCurve(poles))};
  const Construction result = joinCurves(parts);
  EXPECT_EQ(result.curve.degree(), 25);
  EXPECT_EQ(result.curve.data().knots.multiplicities[500], 23);
  expectTraces(result, parts, 1e-13);
}

TEST(Join, OfAThousandCurvesIsOneCurve) {
  Random random(213);
  KnotVector knots{{0}, {6}};
  std::vector<double> cuts;
  for (int i = 1; i < 1000; ++i) {
    knots.knots.push_back(i + random.uniform(-0.3, 0.3));
    knots.multiplicities.push_back(random.integer(1, 4));
    if (i % 7 != 0) cuts.push_back(knots.knots.back());
    if (i % 7 == 0) cuts.push_back(i + 0.5);
  }
  knots.knots.push_back(1000);
  knots.multiplicities.push_back(6);
  const BSplineCurve whole(randomSplineData(random, 5, knots, false));
  const auto parts = disguised(random, pieces(whole, cuts), {});
  ASSERT_EQ(parts.size(), 1000U);
  const Construction result = joinCurves(parts);
  EXPECT_EQ(result.curve.data().knots.multiplicities, knots.multiplicities);
  expectTraces(result, parts, 1e-12);
}

std::vector<BSplineCurve> thousandPieces(const BSplineCurve& whole) {
  std::vector<double> cuts;
  for (int i = 1; i < 1000; ++i)
    cuts.push_back(i / 1000.0);
  return pieces(whole, cuts);
}

TEST(Join, OfAThousandPiecesOfOneSegmentIsTheSegment) {
  Random random(214);
  for (const bool rational : {false, true}) {
    for (const int degree : {1, 3, 5, 9}) {
      SCOPED_TRACE(told(degree, rational));
      const BSplineCurve whole(randomBezier(random, degree, rational));
      const auto parts = thousandPieces(whole);
      const Construction result = joinCurves(parts);
      EXPECT_EQ(result.curve.spanCount(), 1);
      expectTraces(result, parts, 1e-13);
    }
  }
}

TEST(Join, OfAThousandPiecesOfDegree25IsExact) {
  Random random(215);
  const auto parts = thousandPieces(BSplineCurve(randomBezier(random, 25, false)));
  const Construction result = joinCurves(parts);
  expectTraces(result, parts, 2e-13);
  // high derivatives of pieces so short are rounding: some knots stay, with few copies
  EXPECT_LT(result.curve.data().poles.cols(), 5000);
}

TEST(Join, BreaksALinkBeforeItsKnotsCrowd) {
  // each curve ends twice as fast as it begins: matched speeds would shrink intervals by 2^-200
  std::vector<BSplineCurve> parts;
  for (int i = 0; i < 200; ++i) {
    const double x = i;
    const std::vector<Vector3> poles{{x, 0, 0}, {x + 1 / 3.0, 0, 0}, {x + 1, 0, 0}};
    parts.emplace_back(BezierCurve(poles));
  }
  const Construction result = joinCurves(parts);
  expectTraces(result, parts, 2e-12);
  ASSERT_FALSE(result.warnings.empty());
  EXPECT_TRUE(result.warnings[0].starts_with("speed: smooth but at two speeds"));
}

TEST(Join, NamesWeightsAndKnotsThatLeaveTheRange) {
  std::vector<BSplineCurve> parts;
  for (int i = 0; i < 120; ++i) {
    const std::vector<Vector3> poles{{0.0 + i, 0, 0}, {i + 0.5, 1, 0}, {i + 1.0, 0, 0}};
    const std::vector<double> weights{1, 3, 10};
    parts.emplace_back(BezierCurve(poles, weights));
  }
  EXPECT_THROW(joinCurves(parts), ContactError);
  EXPECT_ERROR(joinCurves(parts), "curves: the weights, made to agree at every join");
  parts.erase(parts.begin() + 90, parts.end());
  expectTraces(joinCurves(parts), parts, 1e-13);

  const KnotVector fine{{0, 1e-17, 1}, {2, 1, 2}};
  const BSplineCurve crowded(BSplineData{.poles = columns({{1, 0, 0}, {1, 1, 0}, {2, 0, 0}}),
                                         .weights = {},
                                         .knots = fine,
                                         .degree = 1});
  EXPECT_ERROR(joinCurves(std::vector{segment({0, 0, 0}, {1, 0, 0}), crowded}),
               "knots of curves[1] cannot be told apart");
}

}  // namespace
}  // namespace osculate
