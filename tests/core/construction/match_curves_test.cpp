// What a match meets, what it leaves alone, and that it does not depend on how curves are written.
#include "osculate/construction/match_curves.h"

#include <cmath>
#include <numbers>

#include "construction/match_samples.h"
#include "osculate/construction/contact_error.h"
#include "support/errors.h"

namespace osculate::test {
namespace {

/// Every order up to that asked for passes, or is beyond what doubles carry; the order is that
/// asked for, or a warning says so.
void expectMet(const Construction& result, int order, const std::string& name, int surely = 3) {
  ASSERT_EQ(result.joins.size(), 1U);
  const JoinReport& report = result.joins[0].report;
  for (int k = 0; k <= order; ++k) {
    const auto i = static_cast<std::size_t>(k);
    EXPECT_LE(report.residuals[i], std::max(1e-9, report.uncertainties[i])) << name << ", k " << k;
  }
  const bool warned = !result.warnings.empty() && result.warnings.back().starts_with("rounding");
  EXPECT_EQ(report.order < order, warned) << name;
  if (order <= surely) {
    EXPECT_EQ(report.order, order) << name;
  }
}

TEST(MatchCurves, MeetsEveryOrderForAnyDegreeAndNumberOfSpans) {
  Random random(300);
  for (const int degree : {1, 2, 3, 5, 9}) {
    for (const int spans : {1, 2, 3, 12}) {
      for (const bool rational : {false, true}) {
        const BSplineCurve a = arrival(random, rational);
        const BSplineCurve b = wave(random, degree, spans, rational);
        for (int order = 0; order <= kMaxOrder; ++order) {
          const std::string name = "degree " + std::to_string(degree) + ", spans " +
                                   std::to_string(spans) + ", order " + std::to_string(order) +
                                   (rational ? ", rational" : "");
          expectMet(matched(a, b, ofOrder(order)), order, name);
        }
      }
    }
  }
}

TEST(MatchCurves, MeetsAtEitherEndAndLeavesFromInside) {
  Random random(301);
  const BSplineCurve a = arrival(random);
  const BSplineCurve b = wave(random, 4, 6);
  expectMet(matchCurves(a, {.end = CurveEnd::kEnd}, b.reversed(), CurveEnd::kEnd, ofOrder(3)), 3,
            "the end of b");
  expectMet(matchCurves(a.reversed(), {.end = CurveEnd::kStart}, b, CurveEnd::kStart, ofOrder(3)),
            3, "the start of a");
  const Construction inside = matchCurves(a, {.inside = true, .parameter = 0.9, .forward = true}, b,
                                          CurveEnd::kStart, ofOrder(3));
  expectMet(inside, 3, "inside a");
  EXPECT_LE((inside.curve.endPoint(CurveEnd::kStart) - a.evaluate(0.9)).norm(), 1e-12);
}

TEST(MatchCurves, LeavesFarPolesWeightsAndKnotsBitForBit) {
  Random random(302);
  for (const bool rational : {false, true}) {
    for (const int degree : {2, 3, 5}) {
      const BSplineCurve a = arrival(random);
      const BSplineCurve b = wave(random, degree, 60, rational);
      for (int order = 0; order <= degree; ++order) {
        for (const CurveEnd end : {CurveEnd::kStart, CurveEnd::kEnd}) {
          const Construction result =
              matchCurves(a, {.end = CurveEnd::kEnd}, b, end, ofOrder(order));
          const CurveChange& change = *result.change;
          const BSplineData& before = b.data();
          const BSplineData& after = result.curve.data();
          EXPECT_EQ(change.raised, 0);
          EXPECT_EQ(after.degree, degree);
          EXPECT_EQ(after.knots.knots, before.knots.knots);
          EXPECT_EQ(after.knots.multiplicities, before.knots.multiplicities);
          EXPECT_EQ(after.weights, before.weights);
          const Eigen::Index still = before.poles.cols() - change.poles;
          EXPECT_GT(still, before.poles.cols() / 2);
          EXPECT_FALSE(change.kept.has_value());
          const bool atStart = end == CurveEnd::kStart;
          EXPECT_EQ(atStart ? after.poles.rightCols(still) : after.poles.leftCols(still),
                    atStart ? before.poles.rightCols(still) : before.poles.leftCols(still));
          const double beyond = atStart ? change.last : change.first;
          const double far = atStart ? b.last() : b.first();
          for (const double share : {0.0, 0.01, 0.5, 1.0}) {
            const double t = std::lerp(beyond, far, share);
            const auto side = atStart ? Side::kRight : Side::kLeft;
            EXPECT_EQ(result.curve.derivatives(t, 3, side), b.derivatives(t, 3, side));
          }
        }
      }
    }
  }
}

TEST(MatchCurves, KeepsTheContactOfTheFarEnd) {
  Random random(303);
  for (const bool rational : {false, true}) {
    for (const int degree : {3, 5, 8}) {
      // the partner is the other half of one curve: every order holds there
      const auto [b, partner] = wave(random, degree, 1, rational).split(0.6);
      const BSplineCurve a = arrival(random);
      for (const int order : {0, 2, 4}) {
        for (const int keep : {0, 1, 4, 6}) {
          const Construction result = matched(a, b, {.order = order, .keep = keep});
          const AnalysisOptions exact{.order = kMaxOrder,
                                      .tolerances = Tolerances::preset("exact")};
          const JoinReport report = analyzeCurves(result.curve, partner, exact, JoinEnds{}).report;
          for (int k = 0; k <= keep; ++k)
            EXPECT_NE(report.verdicts[static_cast<std::size_t>(k)], Verdict::kFail)
                << "degree " << degree << ", order " << order << ", keep " << keep << ", k " << k;
          EXPECT_GE(result.change->kept.value_or(kMaxOrder), std::min(keep, degree));
          EXPECT_LE((result.curve.endPoint(CurveEnd::kEnd) - b.endPoint(CurveEnd::kEnd)).norm(),
                    1e-12);
        }
      }
    }
  }
}

TEST(MatchCurves, RaisesTheDegreeNoMoreThanIsNeeded) {
  Random random(304);
  const BSplineCurve a = arrival(random);
  const auto degreeOf = [&](int degree, int spans, int order, int keep) {
    const Construction result =
        matched(a, wave(random, degree, spans), {.order = order, .keep = keep});
    EXPECT_EQ(result.change->raised, result.curve.degree() - degree);
    return result.curve.degree();
  };
  // a Bézier curve needs order+1 poles at the join and keep+1 at the far end
  EXPECT_EQ(degreeOf(3, 1, 2, 4), 7);
  EXPECT_EQ(degreeOf(3, 1, 2, 2), 5);
  EXPECT_EQ(degreeOf(9, 1, 4, 4), 9);
  EXPECT_EQ(degreeOf(10, 1, 4, 4), 10);
  EXPECT_EQ(degreeOf(1, 1, 0, 0), 1);
  // of many spans only the order counts
  EXPECT_EQ(degreeOf(3, 20, 3, 8), 3);
  EXPECT_EQ(degreeOf(3, 20, 4, 8), 4);
}

TEST(MatchCurves, RaisedSplinesStayTheSameCurveFarAway) {
  Random random(305);
  const BSplineCurve a = arrival(random);
  const BSplineCurve b = wave(random, 3, 40);
  const Construction result = matched(a, b, ofOrder(5));
  EXPECT_EQ(result.curve.degree(), 5);
  for (double t = result.change->last; t <= b.last(); t += 0.37)
    EXPECT_LE((result.curve.evaluate(t) - b.evaluate(t)).norm(), 1e-11) << t;
  // and as smooth at the knots as the cubic
  for (const CurveJoin& join : analyzeInnerJoins(result.curve, {.order = 2, .tolerances = {}}))
    EXPECT_EQ(join.report.order, 2) << *join.parameter;
}

TEST(MatchCurves, TakesConicsAndKeepsTheirWeights) {
  const double w = std::cos(std::numbers::pi / 4);
  const std::vector<Vector3> poles{{0, 0, 0}, {10, 0, 0}, {10, 10, 0}};
  const std::vector<double> weights{1, w, 1};
  const BSplineCurve arc(BezierCurve(poles, weights));
  Random random(306);
  for (const int order : {1, 2, 4}) {
    const Construction result = matched(arrival(random), arc, {.order = order, .keep = 2});
    EXPECT_EQ(result.joins[0].report.order, order);
    EXPECT_EQ(result.curve.degree(), order + 3);
    EXPECT_EQ(result.curve.data().weights, arc.elevated(order + 1).data().weights);
    // the far end still has the circle's curvature
    const BezierCurve segment = result.curve.segment(0).curve;
    const auto d = segment.derivatives(1.0, 2);
    EXPECT_NEAR(d[1].cross(d[2]).norm() / std::pow(d[1].norm(), 3), 0.1, 1e-12);
  }
}

TEST(MatchCurves, ReturnsACurveThatMeetsAlreadyAsItIs) {
  Random random(307);
  for (const bool rational : {false, true}) {
    const auto [a, b] = wave(random, 5, 4, rational).split(1.7);
    for (int order = 0; order <= 4; ++order) {
      const Construction result = matched(a, b, ofOrder(order));
      EXPECT_EQ(&result.curve.data(), &b.data());
      EXPECT_EQ(result.maxDisplacementMm, 0.0);
      EXPECT_EQ(result.change->poles, 0);
      EXPECT_EQ(result.change->spans, 0);
      for (int k = 0; k <= order; ++k)
        EXPECT_NE(result.joins[0].report.verdicts[static_cast<std::size_t>(k)], Verdict::kFail);
      EXPECT_EQ(result.beta[0].size(), static_cast<std::size_t>(order));
    }
  }
}

TEST(MatchCurves, FindsACurveThatMeetsAlreadyWhereADegreeIsAskedFor) {
  Random random(308);
  const auto [a, b] = wave(random, 5, 1).split(0.4);
  for (const int order : {2, 4}) {
    const Construction result = matched(a, b, {.order = order, .degree = 10});
    EXPECT_EQ(result.curve.degree(), 10);
    EXPECT_LE(*result.maxDisplacementMm, 1e-10);
    EXPECT_EQ(result.joins[0].report.order, order);
  }
}

TEST(MatchCurves, BoundsTheDisplacement) {
  Random random(309);
  for (const bool rational : {false, true}) {
    for (const int spans : {1, 3, 30}) {
      const BSplineCurve b = wave(random, 5, spans, rational);
      for (const int order : {0, 2, 4}) {
        const Construction result = matched(arrival(random), b, ofOrder(order));
        const double sampled = sampledDistance(b, result.curve);
        const CurveChange& change = *result.change;
        EXPECT_GE(*result.maxDisplacementMm, sampled * (1.0 - 1e-9));
        EXPECT_LE(*result.maxDisplacementMm, sampled * 1.005);
        EXPECT_LE((b.evaluate(change.parameter) - change.point).norm(), 1e-9);
        EXPECT_LE((result.curve.evaluate(change.parameter) - change.moved).norm(), 1e-9);
        EXPECT_GE((change.moved - change.point).norm(), 0.998 * *result.maxDisplacementMm);
      }
    }
  }
}

/// A chain of Bézier curves in one B-spline, each knot of full multiplicity; the middle joint is
/// G2 but not C1 and the others are C2.
BSplineCurve chain(Random& random) {
  const auto [first, rest] = wave(random, 5, 1).split(0.3);
  const auto [second, third] = rest.split(0.6);
  BSplineData data{.poles = Poles(3, 16),
                   .weights = {},
                   .knots = {{0, 1, 2.5, 4}, {6, 5, 5, 6}},
                   .degree = 5,
                   .periodic = false,
                   .poleError = 0.0};
  data.poles << first.data().poles, second.data().poles.rightCols(5),
      third.data().poles.rightCols(5);
  return BSplineCurve(std::move(data));
}

TEST(MatchCurves, KeepsTheContactAtInnerKnots) {
  Random random(310);
  for (int trial = 0; trial < 5; ++trial) {
    const BSplineCurve b = chain(random);
    for (const auto& join : analyzeInnerJoins(b, {.order = 4, .tolerances = {}})) {
      ASSERT_EQ(join.report.order, 4);
      ASSERT_EQ(join.report.parametricOrder, 0);  // the knots are not those of one polynomial
    }
    for (const int order : {0, 1, 2, 3}) {
      const Construction result = matched(arrival(random), b, {.order = order, .keep = 2});
      EXPECT_EQ(result.joins[0].report.order, order);
      EXPECT_EQ(result.curve.degree(), 5) << order;
      EXPECT_GT(result.change->spans, 1);
      for (const auto& join :
           analyzeInnerJoins(result.curve, {.order = 4, .tolerances = Tolerances::preset("exact")}))
        EXPECT_EQ(join.report.order, 4) << "order " << order << " at " << *join.parameter;
    }
  }
}

TEST(MatchCurves, LeavesCornersWhereTheyAre) {
  // a polygon: its knots are corners, and stay corners of the same places
  Random random(311);
  const BSplineCurve b = wave(random, 1, 8);
  const Construction result = matched(arrival(random), b, ofOrder(2));
  EXPECT_EQ(result.joins[0].report.order, 2);
  EXPECT_EQ(result.curve.degree(), 2);
  for (double t = result.change->last; t <= b.last(); t += 0.25)
    EXPECT_LE((result.curve.evaluate(t) - b.evaluate(t)).norm(), 1e-12);
}

TEST(MatchCurves, ClosesACurveSmoothly) {
  Random random(312);
  BSplineData data = wave(random, 5, 12).data();
  for (Eigen::Index i = 0; i < data.poles.cols(); ++i) {
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) /
                         static_cast<double>(data.poles.cols() - 1);
    data.poles.col(i) = Vector3(50.0 * std::cos(angle), 30.0 * std::sin(angle), 0.0);
  }
  data.poles.col(data.poles.cols() - 1) = data.poles.col(0);
  const BSplineCurve drop(data);
  ASSERT_LT(analyzeClosing(drop).report.order, 2);
  for (const CurveEnd changed : {CurveEnd::kStart, CurveEnd::kEnd}) {
    const Construction result = matchClosing(drop, changed, {.order = 3, .keep = 0});
    EXPECT_EQ(result.joins[0].report.order, 3);
    EXPECT_EQ(analyzeClosing(result.curve).report.order, 3);
    EXPECT_EQ(result.change->end, changed);
    EXPECT_EQ(result.curve.endPoint(opposite(changed)), drop.endPoint(opposite(changed)));
  }
}

TEST(MatchCurves, OpensPeriodicAndClampsUnclampedCurves) {
  Random random(313);
  const BSplineCurve a = arrival(random);
  const BSplineCurve ring(
      randomSplineData(random, 3, {{0, 1, 2, 3, 4, 5, 6}, {1, 1, 1, 1, 1, 1, 1}}, true, true));
  const Construction opened = matched(a, ring, ofOrder(2));
  EXPECT_EQ(opened.joins[0].report.order, 2);
  EXPECT_FALSE(opened.curve.isPeriodic());
  EXPECT_TRUE(opened.warnings.at(0).starts_with("opened:"));
  for (double t = opened.change->last; t <= ring.last(); t += 0.25)
    EXPECT_LE((opened.curve.evaluate(t) - ring.evaluate(t)).norm(), 1e-12) << t;

  KnotVector knots;
  for (int i = 0; i < 24; ++i) {
    knots.knots.push_back(i);
    knots.multiplicities.push_back(1);
  }
  const BSplineCurve b = waveFrom(random, 3, knots, false);
  ASSERT_GT(b.first(), 0.0);
  const Construction clamped = matched(a, b, ofOrder(2));
  EXPECT_EQ(clamped.joins[0].report.order, 2);
  EXPECT_EQ(clamped.curve.first(), b.first());
  EXPECT_EQ(clamped.curve.last(), b.last());
  for (double t = clamped.change->last; t <= b.last(); t += 0.25)
    EXPECT_LE((clamped.curve.evaluate(t) - b.evaluate(t)).norm(), 1e-12) << t;
}

TEST(MatchCurves, MakesASingularEndRegular) {
  Random random(314);
  const BSplineCurve a = arrival(random);
  const std::vector<Vector3> poles{{0, 0, 0},  {0, 0, 0},  {10, 1, 0}, {20, 5, 0},
                                   {30, 5, 2}, {40, 0, 0}, {50, 0, 1}};
  const BSplineCurve cusp{BezierCurve(poles)};
  const Construction result = matched(a, cusp, {.order = 2, .keep = 2});
  EXPECT_EQ(result.joins[0].report.order, 2);
  EXPECT_EQ(result.joins[0].report.sides[1].multiplicity, 1);

  // a whole span at one point
  BSplineData data = wave(random, 3, 10).data();
  data.poles.leftCols(4).colwise() = Vector3(data.poles.col(0));
  const Construction fromPoint = matched(a, BSplineCurve(data), ofOrder(2));
  EXPECT_EQ(fromPoint.joins[0].report.order, 2);
}

TEST(MatchCurves, RefusesWhatCannotBe) {
  Random random(315);
  const BSplineCurve a = arrival(random);
  const BSplineCurve b = wave(random, 5, 20);
  const auto run = [&](const MatchOptions& options) { return matched(a, b, options); };
  EXPECT_ERROR(run({.order = 9}), "order: must be from 0 to 8, got 9");
  EXPECT_ERROR(run({.order = -1}), "order: must be from 0 to 8, got -1");
  EXPECT_ERROR(run({.keep = 9}), "keep: must be from 0 to 8, got 9");
  EXPECT_ERROR(run({.spans = -1}), "spans: must be at least 1");
  EXPECT_THROW(run({.degree = 4}), ContactError);
  EXPECT_ERROR(run({.degree = 4}), "b has degree 5");
  EXPECT_ERROR(run({.order = 7, .degree = 6}), "order 7 needs one from 7 to 25, got 6");
  EXPECT_ERROR(run({.degree = 26}), "from 5 to 25, got 26");
  // a change within one span of simple knots has a single freedom, and G2 needs three
  EXPECT_ERROR(run({.order = 2, .spans = 1}), "order 2 needs at least 3");
  EXPECT_NO_THROW(run({.order = 2, .spans = 3}));
  MatchOptions stopped = ofOrder(2);
  stopped.beta[0] = 0.0;
  EXPECT_ERROR(run(stopped), "beta: beta_1 must be finite and > 0");
  stopped.beta = {1.0, std::nan("")};
  EXPECT_ERROR(run(stopped), "beta: every number must be finite");
  const BSplineCurve arc = wave(random, 3, 1);
  EXPECT_THROW(matched(a, arc, {.order = 4, .degree = 8}), ContactError);
  EXPECT_ERROR(matched(a, arc, {.order = 4, .degree = 8}), "need at least 9, got 8");
  EXPECT_ERROR(matched(a, arc, {.order = 8, .degree = 8, .keep = 8}), "need at least 17, got 8");
  const std::vector<Vector3> tip{{-20, 5, 0}, {-10, 0, 0}, {0, 0, 0}, {0, 0, 0}};
  EXPECT_THROW(matched(BSplineCurve(BezierCurve(tip)), b, ofOrder(4)), ContactError);
}

}  // namespace
}  // namespace osculate::test
