// That the change is the least one, by other methods, and that it does not depend on how the curves
// are written down.
#include "osculate/construction/match.h"

#include <gtest/gtest.h>

#include <cmath>

#include "construction/match_samples.h"
#include "osculate/continuity/join_analysis.h"
#include "osculate/differential/arc_length.h"
#include "support/sanitized.h"

namespace osculate::test {
namespace {

Match solved(const BSplineCurve& a, const BSplineCurve& b, const MatchOptions& options) {
  return match(contactJet(a, {.end = CurveEnd::kEnd}, options.order), b, CurveEnd::kStart, options);
}

/// int |displacement|^2 ds as the match itself states it.
double statedIntegral(const Match& result, const BSplineCurve& b) {
  const double last = b.segment(result.change.spans - 1).last;
  const double lengthMm = length(b, b.first(), last);
  return std::pow(result.change.rootMeanSquareMm, 2) * lengthMm;
}

struct MatchTask {
  std::string name;
  BSplineCurve a;
  BSplineCurve b;
  MatchOptions options;
};

std::vector<MatchTask> matchTasks() {
  Random random(320);
  std::vector<MatchTask> result;
  for (const bool rational : {false, true}) {
    for (const int spans : {1, 4, 20}) {
      for (const int order : {0, 1, 2, 3, 4}) {
        const std::string name = std::to_string(spans) + " spans, order " + std::to_string(order) +
                                 (rational ? ", rational" : "");
        result.push_back({name,
                          arrival(random, rational),
                          wave(random, 5, spans, rational),
                          {.order = order, .degree = spans == 1 ? 11 : 0, .keep = 3}});
      }
    }
  }
  return result;
}

TEST(Match, StatesTheIntegralOfTheSquaredDisplacement) {
  for (const MatchTask& task : matchTasks()) {
    const Match result = solved(task.a, task.b, task.options);
    const double integral = integralOfSquares(task.b, result.curve);
    EXPECT_NEAR(statedIntegral(result, task.b), integral, 1e-6 * integral) << task.name;
  }
}

BSplineCurve withPole(const BSplineCurve& curve, Eigen::Index i, const Vector3& pole) {
  BSplineData data = curve.data();
  data.poles.col(i) = pole;
  return BSplineCurve(std::move(data));
}

TEST(Match, NoFreePoleCanLowerIt) {
  // a free pole moves the curve by its own basis function: the integral is a parabola in each
  // direction, whose vertex is where the pole is
  for (const MatchTask& task : matchTasks()) {
    const Match result = solved(task.a, task.b, task.options);
    const BSplineCurve before = task.b.elevated(result.change.raised);
    for (int i = task.options.order + 1; i < result.change.poles; ++i) {
      for (int axis = 0; axis < 3; ++axis) {
        constexpr double kStep = 0.1;
        const auto integral = [&](double step) {
          Vector3 pole = result.curve.data().poles.col(i);
          pole[axis] += step;
          return integralOfSquares(before, withPole(result.curve, i, pole), 2);
        };
        const double above = integral(kStep);
        const double below = integral(-kStep);
        const double bend = above + below - 2.0 * integral(0.0);
        const double vertex = 0.5 * kStep * (below - above) / bend;
        EXPECT_NEAR(vertex, 0.0, 1e-5) << task.name << ", pole " << i;
      }
    }
  }
}

/// What is left when the numbers are given and only poles are chosen: by the public way alone.
double costAt(const MatchTask& task, const std::vector<double>& beta) {
  MatchOptions options = task.options;
  for (std::size_t k = 0; k < beta.size(); ++k)
    options.beta[k] = beta[k];
  return std::pow(solved(task.a, task.b, options).change.rootMeanSquareMm, 2);
}

bool isHeld(const Match& result) {
  return std::any_of(result.warnings.begin(), result.warnings.end(),
                     [](const std::string& warning) { return warning.starts_with("held"); });
}

TEST(Match, NoFreeNumberCanLowerIt) {
  for (const MatchTask& task : matchTasks()) {
    const Match result = solved(task.a, task.b, task.options);
    const double least = std::pow(result.change.rootMeanSquareMm, 2);
    EXPECT_NEAR(costAt(task, result.beta), least, 1e-12 * least) << task.name;
    for (std::size_t k = 0; k < result.beta.size(); ++k) {
      for (const double step : {-0.3, -1e-3, 1e-3, 0.3}) {
        std::vector<double> beside = result.beta;
        beside[k] += step * (1.0 + std::abs(beside[k]));
        if (k == 0 && step < 0.0 && isHeld(result)) continue;
        EXPECT_GE(costAt(task, beside), least) << task.name << ", beta_" << k + 1;
      }
    }
  }
}

TEST(Match, NoFarStartLeadsToLess) {
  // a search that knows nothing of the problem: random numbers, each then improved one at a time
  constexpr int kTrials = kIsSanitized ? 1 : 3;
  Random random(321);
  for (const MatchTask& task : matchTasks()) {
    if (task.options.order == 0) continue;
    const Match result = solved(task.a, task.b, task.options);
    if (isHeld(result)) continue;
    const double least = std::pow(result.change.rootMeanSquareMm, 2);
    for (int trial = 0; trial < kTrials; ++trial) {
      std::vector<double> beta;
      for (int k = 0; k < task.options.order; ++k)
        beta.push_back(k == 0 ? random.uniform(0.1, 4.0) : random.uniform(-10.0, 10.0));
      double cost = costAt(task, beta);
      double step = 1.0;
      for (int round = 0; round < 40; ++round) {
        bool better = false;
        for (std::size_t k = 0; k < beta.size(); ++k) {
          for (const double direction : {-step, step}) {
            std::vector<double> beside = beta;
            beside[k] += direction;
            if (beside[0] <= 0.0) continue;
            const double other = costAt(task, beside);
            if (other >= cost) continue;
            cost = other;
            beta = beside;
            better = true;
          }
        }
        if (!better) step *= 0.5;
      }
      EXPECT_GE(cost, least * (1.0 - 1e-9)) << task.name;
    }
  }
}

TEST(Match, OfMoreSpansWouldBeHardlyLess) {
  // the spans that are left out of the search
  Random random(322);
  for (const int degree : {1, 2, 3, 5, 9, 15}) {
    for (const int order : {0, 1, 2}) {
      if (order > degree) continue;
      const BSplineCurve a = arrival(random);
      const BSplineCurve b = wave(random, degree, 100);
      const Match result = solved(a, b, ofOrder(order));
      MatchOptions fewer = ofOrder(order);
      fewer.spans = result.change.spans - degree;
      const Match limited = solved(a, b, fewer);
      EXPECT_EQ(limited.change.spans, fewer.spans);
      const double gain = statedIntegral(limited, b) / statedIntegral(result, b) - 1.0;
      // with `degree` spans less it is at most a hundredth more
      EXPECT_LE(gain, 0.01) << "degree " << degree << ", order " << order;
      EXPECT_GE(gain, -1e-9);
    }
  }
}

TEST(Match, TakesGivenNumbersAndChoosesTheOthers) {
  Random random(323);
  const BSplineCurve a = arrival(random);
  const BSplineCurve b = wave(random, 5, 10);
  const Match chosen = solved(a, b, ofOrder(3));
  MatchOptions options = ofOrder(3);
  options.beta = {1.3, std::nullopt, -2.0};
  const Match given = solved(a, b, options);
  EXPECT_EQ(given.beta[0], 1.3);
  EXPECT_EQ(given.beta[2], -2.0);
  EXPECT_GT(given.change.rootMeanSquareMm, chosen.change.rootMeanSquareMm);
  options.beta = {chosen.beta[0], std::nullopt, std::nullopt};
  const Match same = solved(a, b, options);
  EXPECT_NEAR(same.beta[1], chosen.beta[1], 1e-6 * std::abs(chosen.beta[1]));
  // beta_1: the speed in the first span by its reach
  const BezierCurve segment = given.curve.segment(0).curve;
  const double reach = reachOf(b.segment(0).curve.view(), CurveEnd::kStart);
  EXPECT_NEAR(segment.derivatives(0.0, 1)[1].norm(), 1.3 * reach, 1e-12 * reach);
}

TEST(Match, HoldsTheSpeedAtHalfOfWhatItWas) {
  // the curve points the other way: turning it round would take a speed below zero
  Random random(324);
  const BSplineCurve b = wave(random, 5, 10)
                             .reversed()
                             .transformed(Eigen::Affine3d(Eigen::Translation3d(-60.0, 0.0, 0.0)));
  const BSplineCurve a = arrival(random);
  const Match result = solved(a, b, ofOrder(1));
  const BezierCurve before = b.segment(0).curve;
  const double own =
      std::min(before.derivatives(0.0, 1)[1].norm(), reachOf(before.view(), CurveEnd::kStart));
  EXPECT_NEAR(result.curve.segment(0).curve.derivatives(0.0, 1)[1].norm(), 0.5 * own, 1e-9 * own);
  ASSERT_EQ(result.warnings.size(), 1U);
  EXPECT_TRUE(result.warnings[0].starts_with("held:"));
  // numbers that are given are taken
  MatchOptions slow = ofOrder(1);
  slow.beta[0] = 0.1;
  EXPECT_TRUE(solved(a, b, slow).warnings.empty());
  EXPECT_LT(solved(a, b, slow).change.rootMeanSquareMm, result.change.rootMeanSquareMm);
}

/// The poles that a match gives, moved back, do not depend on the transformation.
void expectSamePoles(const Poles& own, const Poles& other, double size, const std::string& name) {
  ASSERT_EQ(own.cols(), other.cols());
  EXPECT_LE((own - other).colwise().norm().maxCoeff(), 1e-7 * size) << name;
}

TEST(Match, DoesNotDependOnPlaceSizeOrMirroring) {
  Eigen::Affine3d turn(Eigen::AngleAxisd(0.7, Vector3(1, 2, -1).normalized()));
  turn.pretranslate(Vector3(30, -50, 70));
  Eigen::Affine3d mirror(Eigen::Scaling(1.0, 1.0, -1.0));
  for (const MatchTask& task : matchTasks()) {
    const Poles own = solved(task.a, task.b, task.options).curve.data().poles;
    const Eigen::Affine3d large(Eigen::Scaling(1e3));
    const Eigen::Affine3d small(Eigen::Scaling(1e-3));
    for (const Eigen::Affine3d& map : {turn, mirror, large, small}) {
      const Match moved = solved(task.a.transformed(map), task.b.transformed(map), task.options);
      expectSamePoles(own, map.inverse() * moved.curve.data().poles, 60.0, task.name);
    }
  }
}

TEST(Match, DoesNotDependOnHowTheCurvesAreWritten) {
  for (const MatchTask& task : matchTasks()) {
    const Match own = solved(task.a, task.b, task.options);
    const Poles& poles = own.curve.data().poles;
    expectSamePoles(poles, solved(task.a.elevated(2), task.b, task.options).curve.data().poles,
                    60.0, task.name + ", a raised");
    const Match backward =
        match(contactJet(task.a.reversed(), {.end = CurveEnd::kStart}, task.options.order),
              task.b.reversed(), CurveEnd::kEnd, task.options);
    expectSamePoles(poles, backward.curve.reversed().data().poles, 60.0, task.name + ", reversed");
    const Match mapped = solved(task.a, task.b.reparametrised(-3.0, 11.0), task.options);
    expectSamePoles(poles, mapped.curve.data().poles, 60.0, task.name + ", other knots");
    for (std::size_t k = 0; k < own.beta.size(); ++k) {
      const double tolerance = 1e-5 * (1.0 + std::abs(own.beta[k]));
      EXPECT_NEAR(mapped.beta[k], own.beta[k], tolerance);
      EXPECT_NEAR(backward.beta[k], own.beta[k], tolerance);
    }
  }
}

TEST(Match, GivesTheSameCurveForTheSameInput) {
  for (const MatchTask& task : matchTasks()) {
    const Match first = solved(task.a, task.b, task.options);
    const Match second = solved(task.a, task.b, task.options);
    EXPECT_EQ(first.curve.data().poles, second.curve.data().poles) << task.name;
  }
}

TEST(Match, MovesLittleWhereTheTaskMovesLittle) {
  Random random(325);
  const BSplineCurve a = arrival(random);
  const BSplineCurve b = wave(random, 5, 12);
  Poles last = solved(a, b, ofOrder(3)).curve.data().poles;
  for (int i = 1; i <= 100; ++i) {
    const Eigen::Affine3d step(Eigen::Translation3d(0.0, 0.05 * i, 0.02 * i));
    const Poles next = solved(a.transformed(step), b, ofOrder(3)).curve.data().poles;
    EXPECT_LE((next - last).colwise().norm().maxCoeff(), 1.0) << i;
    last = next;
  }
}

}  // namespace
}  // namespace osculate::test
