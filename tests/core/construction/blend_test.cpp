#include "osculate/construction/blend.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>

#include "construction/blend_cases.h"
#include "osculate/construction/blend_curves.h"
#include "osculate/construction/contact_error.h"
#include "osculate/differential/arc_jet.h"

namespace osculate {
namespace {

using test::BlendCase;
using test::blendCases;
using test::distance;

constexpr std::array<Departure, 2> kEndToStart{Departure{.end = CurveEnd::kEnd},
                                               Departure{.end = CurveEnd::kStart}};

BlendOptions ofOrders(int first, int second) {
  BlendOptions options;
  options.order = {first, second};
  return options;
}

Blend blendOf(const BSplineCurve& first, const BSplineCurve& second, const BlendOptions& options) {
  return blend(contactJet(first, kEndToStart[0], options.order[0]),
               contactJet(second, kEndToStart[1], options.order[1]), options);
}

BSplineCurve line(const Vector3& from, const Vector3& to) {
  const std::vector<Vector3> poles{from, to};
  return BSplineCurve(BezierCurve(poles));
}

std::string orderName(int order) { return std::string("G").append(std::to_string(order)); }

TEST(Blend, MeetsTheOrdersAskedForOnEveryCase) {
  for (const BlendCase& task : blendCases()) {
    for (const auto& [first, second] : {std::pair{0, 1}, {1, 1}, {2, 2}, {3, 1}, {2, 3}, {3, 3}}) {
      const Construction result =
          blendCurves(task.first, task.second, kEndToStart, ofOrders(first, second));
      EXPECT_EQ(result.joins[0].report.order, first) << task.name;
      EXPECT_EQ(result.joins[1].report.order, second) << task.name;
    }
  }
}

/// Whether a warning names the end of this join.
bool hasWarning(const Construction& result, const CurveJoin& join) {
  const std::string end =
      &join == &result.joins[0] ? "rounding: at the first" : "rounding: at the second";
  return std::any_of(result.warnings.begin(), result.warnings.end(),
                     [&](const std::string& warning) { return warning.starts_with(end); });
}

TEST(Blend, SaysWhereRoundingKeepsItFromTheOrder) {
  for (const BlendCase& task : blendCases()) {
    const Construction result = blendCurves(task.first, task.second, kEndToStart, ofOrders(4, 4));
    for (const CurveJoin& join : result.joins) {
      // the fairest ends have short legs: order 4 within 1e-8 is beyond doubles there, but never
      // missed
      EXPECT_GE(join.report.order, 2) << task.name;
      for (std::size_t k = 0; k <= 4; ++k)
        EXPECT_NE(join.report.verdicts[k], Verdict::kFail) << task.name;
      EXPECT_EQ(join.report.order < 4, hasWarning(result, join)) << task.name;
    }
  }
}

TEST(Blend, IsAsFairAsTheBestKnown) {
  nlohmann::json best;
  std::ifstream(OSCULATE_TEST_DATA_DIR "/best_blends.json") >> best;
  for (const int order : {2, 3, 4}) {
    std::vector<double> ratios;  // of the energies: the objective is a logarithm
    for (const BlendCase& task : blendCases()) {
      const Blend result = blendOf(task.first, task.second, ofOrders(order, order));
      ratios.push_back(
          std::exp(*result.objective - best[orderName(order)][task.name].get<double>()));
      EXPECT_LE(ratios.back(), 1.10) << task.name << ", G" << order;
    }
    std::nth_element(ratios.begin(), ratios.begin() + 16, ratios.end());
    EXPECT_LE(ratios[16], 1.02) << orderName(order);
  }
}

TEST(Blend, ObjectiveIsThatOfTheCurveByAdaptiveQuadrature) {
  for (const BlendCase& task : blendCases()) {
    const Blend result = blendOf(task.first, task.second, ofOrders(3, 3));
    const double objective =
        energies(BSplineCurve(result.curve)).objective(Fairness::kMinimumVariation);
    EXPECT_NEAR(*result.objective, objective, 0.01) << task.name;
  }
}

TEST(Blend, OfAStraightGapIsTheStraightLine) {
  const BSplineCurve first = line({0, 0, 0}, {10, 0, 0});
  const BSplineCurve second = line({30, 0, 0}, {50, 0, 0});
  for (int order = 0; order <= 4; ++order) {
    const Blend result = blendOf(first, second, ofOrders(order, order));
    for (int i = 0; i <= 10; ++i)
      EXPECT_NEAR(result.curve.evaluate(0.1 * i).tail<2>().norm(), 0.0, 1e-9) << order;
    EXPECT_NEAR(result.curve.evaluate(0.5).x(), 20.0, 1e-3) << order;
  }
}

TEST(Blend, CompletesACircleToWithinItsDegree) {
  // two arcs of one circle, a quarter turn apart: degree 9 cannot be a circle, but nearly
  const double w = std::cos(std::numbers::pi / 8);
  const auto arc = [&](double from, double to) {
    const double mid = 0.5 * (from + to);
    const std::vector<Vector3> poles{{10 * std::cos(from), 10 * std::sin(from), 0},
                                     {10 / w * std::cos(mid), 10 / w * std::sin(mid), 0},
                                     {10 * std::cos(to), 10 * std::sin(to), 0}};
    const std::vector<double> weights{1.0, w, 1.0};
    return BSplineCurve(BezierCurve(poles, weights));
  };
  const double quarter = std::numbers::pi / 4;
  const Blend result = blendOf(arc(-quarter, 0.0), arc(2 * quarter, 3 * quarter), ofOrders(4, 4));
  for (int i = 0; i <= 32; ++i)
    EXPECT_NEAR(result.curve.evaluate(i / 32.0).norm(), 10.0, 5e-5);
}

// The optimum is found to rounding, so the curve itself can be compared, in chords.
constexpr double kSameCurve = 1e-5;

TEST(Blend, DoesNotChangeUnderScalingAndRigidMotion) {
  const Eigen::Affine3d motion = Eigen::Translation3d(3, -5, 7) *
                                 Eigen::AngleAxisd(0.7, Vector3(1, 2, 3).normalized()) *
                                 Eigen::Scaling(12.0);
  for (const BlendCase& task : blendCases()) {
    for (const int order : {2, 3, 4}) {
      const Blend own = blendOf(task.first, task.second, ofOrders(order, order));
      const Blend moved = blendOf(task.first.transformed(motion), task.second.transformed(motion),
                                  ofOrders(order, order));
      EXPECT_LE(distance(moved.curve, own.curve.transformed(motion)), kSameCurve * moved.chordMm)
          << task.name << ", G" << order;
    }
  }
}

TEST(Blend, DoesNotChangeWithTheDegreeOfItsCurves) {
  for (const BlendCase& task : blendCases()) {
    const Blend own = blendOf(task.first, task.second, ofOrders(3, 3));
    const Blend elevated = blendOf(task.first.elevated(2), task.second.elevated(1), ofOrders(3, 3));
    EXPECT_LE(distance(elevated.curve, own.curve), kSameCurve * own.chordMm) << task.name;
  }
}

TEST(Blend, ReversalOfTheTaskReversesTheCurve) {
  for (const BlendCase& task : blendCases()) {
    for (const int order : {2, 3, 4}) {
      const Blend own = blendOf(task.first, task.second, ofOrders(order, order));
      const Blend back =
          blendOf(task.second.reversed(), task.first.reversed(), ofOrders(order, order));
      EXPECT_LE(distance(back.curve.reversed(), own.curve), kSameCurve * own.chordMm)
          << task.name << ", G" << order;
    }
  }
}

TEST(Blend, KeepsGivenNumbersAndChoosesTheOthers) {
  const BlendCase task = blendCases()[1];
  BlendOptions options = ofOrders(3, 3);
  options.beta[0][0] = 0.9;
  options.beta[0][2] = -2.0;
  options.beta[1][1] = 0.5;
  const Blend result = blendOf(task.first, task.second, options);
  EXPECT_NEAR(result.beta[0][0], 0.9, 1e-12);
  EXPECT_NEAR(result.beta[0][2], -2.0, 1e-10);
  EXPECT_NEAR(result.beta[1][1], 0.5, 1e-11);
  const auto arc = arcJet(endJet<4>(result.curve.view(), CurveEnd::kStart, 0.0));
  EXPECT_NEAR(arc.arcLength[1] / result.chordMm, 0.9, 1e-12);
  EXPECT_NEAR(6.0 * arc.arcLength[3] / result.chordMm, -2.0, 1e-9);
}

TEST(Blend, WithoutFairnessHasUnitSpeedsAndNoFurtherNumbers) {
  const BlendCase task = blendCases()[1];
  BlendOptions options = ofOrders(3, 2);
  options.fairness.reset();
  const Blend result = blendOf(task.first, task.second, options);
  EXPECT_FALSE(result.objective);
  EXPECT_NEAR(result.beta[0][0], 1.0, 1e-12);
  EXPECT_NEAR(result.beta[1][0], 1.0, 1e-12);
  EXPECT_NEAR(result.beta[0][1], 0.0, 1e-10);
  EXPECT_NEAR(result.curve.derivatives(0.0, 1)[1].norm(), result.chordMm, 1e-9);
}

TEST(Blend, SymmetricNumbersAreEqual) {
  BlendOptions options = ofOrders(3, 3);
  options.symmetric = true;
  const BlendCase task = blendCases()[3];
  const Blend result = blendOf(task.first, task.second, options);
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(result.beta[0][k], result.beta[1][k], 1e-9) << k;
}

TEST(Blend, SymmetricNumbersGivenAtOneEndHoldAtTheOther) {
  BlendOptions options = ofOrders(3, 2);
  options.symmetric = true;
  options.beta[0] = {1.2, std::nullopt, -0.5};
  options.beta[1] = {std::nullopt, 0.3};
  const BlendCase task = blendCases()[3];
  const Blend result = blendOf(task.first, task.second, options);
  for (std::size_t end = 0; end < 2; ++end) {
    EXPECT_NEAR(result.beta[end][0], 1.2, 1e-12);
    EXPECT_NEAR(result.beta[end][1], 0.3, 1e-11);
  }
  EXPECT_NEAR(result.beta[0][2], -0.5, 1e-10) << "above the other end's order";
}

TEST(Blend, MoreDegreesAreNeverWorse) {
  for (const BlendCase& task : blendCases()) {
    const double least = *blendOf(task.first, task.second, ofOrders(2, 2)).objective;
    for (const int degree : {6, 8}) {
      BlendOptions options = ofOrders(2, 2);
      options.degree = degree;
      const Blend result = blendOf(task.first, task.second, options);
      EXPECT_EQ(result.curve.degree(), degree);
      EXPECT_LE(*result.objective, least + 1e-6) << task.name;
    }
  }
}

TEST(Blend, MovesLittleWhenTheTaskMovesLittle) {
  constexpr double kShift = 1e-6;    // in chords, as far as a hand can hold still
  constexpr double kLargest = 50.0;  // times the shift; 1.6 where no optimum is shallow
  for (const BlendCase& task : blendCases()) {
    for (const int order : {2, 3, 4}) {
      const Blend own = blendOf(task.first, task.second, ofOrders(order, order));
      for (int step = 1; step <= 3; ++step) {
        const double shift = step * kShift * own.chordMm;
        const Eigen::Affine3d motion(Eigen::Translation3d(shift, -shift, 0.5 * shift));
        const Blend moved =
            blendOf(task.first, task.second.transformed(motion), ofOrders(order, order));
        EXPECT_LE(distance(moved.curve, own.curve), kLargest * shift)
            << task.name << ", G" << order << ", step " << step;
      }
    }
  }
}

TEST(Blend, GivesTheSameCurveEveryTime) {
  const BlendCase task = blendCases()[25];
  const Blend once = blendOf(task.first, task.second, ofOrders(4, 3));
  const Blend again = blendOf(task.first, task.second, ofOrders(4, 3));
  EXPECT_EQ(distance(once.curve, again.curve), 0.0);
}

TEST(Blend, LeavesFromInsideAnEdge) {
  const BSplineCurve first = line({0, 0, 0}, {40, 0, 0});
  const BSplineCurve second = line({60, 20, 0}, {60, 60, 0});
  const std::array<Departure, 2> departures{
      Departure{.inside = true, .parameter = 0.5, .forward = true},
      Departure{.inside = true, .parameter = 0.25, .forward = false}};
  const Construction result = blendCurves(first, second, departures, ofOrders(3, 3));
  EXPECT_NEAR((result.curve.evaluate(0.0) - Vector3(20, 0, 0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((result.curve.evaluate(1.0) - Vector3(60, 30, 0)).norm(), 0.0, 1e-12);
  EXPECT_EQ(result.joins[0].report.order, 3);
  EXPECT_EQ(result.joins[1].report.order, 3);
}

TEST(Blend, RefusesWhatCannotBe) {
  const BSplineCurve first = line({0, 0, 0}, {10, 0, 0});
  const BSplineCurve second = line({10, 0, 0}, {10, 10, 0});
  EXPECT_THROW(blendOf(first, second, ofOrders(1, 1)), ContactError) << "coinciding ends";
  const BSplineCurve apart = line({30, 0, 0}, {30, 10, 0});
  BlendOptions low = ofOrders(3, 3);
  low.degree = 6;
  EXPECT_THROW(blendOf(first, apart, low), ContactError);
  BlendOptions stopped = ofOrders(1, 1);
  stopped.beta[0][0] = 0.0;
  EXPECT_THROW(blendOf(first, apart, stopped), std::invalid_argument);
  stopped.beta[0][0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(blendOf(first, apart, stopped), std::invalid_argument);
  EXPECT_THROW(blendOf(first, apart, ofOrders(9, 1)), std::invalid_argument);
  const std::vector<Vector3> cusp{{0, 0, 0}, {5, 0, 0}, {10, 3, 0}, {10, 0, 0}, {10, 0, 0}};
  EXPECT_THROW(blendOf(BSplineCurve(BezierCurve(cusp)), apart, ofOrders(3, 1)), ContactError)
      << "singular end";
}

}  // namespace
}  // namespace osculate
