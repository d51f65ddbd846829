// The freedoms of an extension: given, solved from targets, or chosen by fairness.
#include "osculate/construction/extend.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "construction/blend_cases.h"
#include "construction/extend_curves.h"
#include "osculate/construction/contact_error.h"
#include "osculate/construction/extend_curve.h"
#include "osculate/differential/arc_length.h"
#include "osculate/differential/point_geometry.h"
#include "support/errors.h"

namespace osculate {
namespace {

using test::distance;
using test::NamedCurve;

double lengthOf(const Extension& extension) { return length(BSplineCurve(extension.curve)); }

Vector3 endOf(const BezierCurve& curve) { return curve.pole(curve.degree()); }

Vector3 curvatureVectorAtEnd(const BezierCurve& curve) {
  const PointGeometry geometry = geometryAt(BSplineCurve(curve), 1.0, Side::kLeft);
  if (!geometry.frame.normal) return Vector3::Zero();
  return *geometry.invariants.curvature * *geometry.frame.normal;
}

Vector3 directionAtEnd(const BezierCurve& curve) {
  return curve.derivatives(1.0, 1)[1].normalized();
}

GivenNumbers given(std::initializer_list<double> numbers) {
  GivenNumbers result;
  std::copy(numbers.begin(), numbers.end(), result.begin());
  return result;
}

ExtendOptions ofOrder(int order, int degree = 0) {
  ExtendOptions options;
  options.order = order;
  options.degree = degree;
  return options;
}

TEST(Extend, HasTheReachOfTheCurveAsLength) {
  for (const auto& [name, curve] : test::curvesToExtend()) {
    for (const CurveEnd end : {CurveEnd::kStart, CurveEnd::kEnd}) {
      for (const int order : {0, 1, 4}) {
        ExtendOptions options = ofOrder(order);
        options.end = end;
        const double reach = reachFrom(curve, end);
        EXPECT_NEAR(lengthOf(extend(curve, options)), reach, 1e-9 * reach) << name << order;
      }
    }
  }
}

TEST(Extend, MeetsALength) {
  for (const auto& [name, curve] : test::curvesToExtend()) {
    for (const double lengthMm : {0.5, 12.0, 45.0}) {
      for (const int degree : {4, 6}) {
        ExtendOptions options = ofOrder(4, degree);
        options.targets.lengthMm = lengthMm;
        const Extension result = extend(curve, options);
        EXPECT_NEAR(lengthOf(result), lengthMm, 1e-9 * lengthMm) << name;
        EXPECT_EQ(result.freeNumbers, degree == 4 ? 3 : 9) << name;
      }
    }
  }
}

TEST(Extend, MeetsTargetsAtTheLowestDegreeThatCan) {
  ExtendOptions options = ofOrder(4);
  options.targets.point = Vector3(30, 40, 20);
  Extension result = extend(test::twistedCubic(), options);
  EXPECT_LE((endOf(result.curve) - *options.targets.point).norm(), 1e-9);
  EXPECT_EQ(result.curve.degree(), 4);
  EXPECT_EQ(result.freeNumbers, 1);

  options.targets.direction = Vector3(0, 2, 0);
  result = extend(test::twistedCubic(), options);
  EXPECT_EQ(result.curve.degree(), 5);  // 5 conditions, and degree 4 has 4 numbers
  EXPECT_LE((endOf(result.curve) - *options.targets.point).norm(), 1e-9);
  EXPECT_LE((directionAtEnd(result.curve) - Vector3(0, 1, 0)).norm(), 1e-9);

  options.targets.curvatureVector = Vector3(0.01, 0, 0.02);
  options.targets.lengthMm = 27.0;
  options.degree = 7;
  result = extend(test::twistedCubic(), options);
  EXPECT_LE((endOf(result.curve) - *options.targets.point).norm(), 1e-9);
  EXPECT_LE((directionAtEnd(result.curve) - Vector3(0, 1, 0)).norm(), 1e-9);
  EXPECT_LE((curvatureVectorAtEnd(result.curve) - *options.targets.curvatureVector).norm(), 1e-9);
  EXPECT_NEAR(lengthOf(result), 27.0, 1e-9);
  EXPECT_EQ(result.freeNumbers, 4 + 9 - 8);
}

TEST(Extend, MeetsEachTargetAlone) {
  for (const auto& [name, curve] : test::curvesToExtend()) {
    const double reach = reachFrom(curve, CurveEnd::kEnd);
    ExtendOptions options = ofOrder(2, 6);
    options.targets.direction = Vector3(1, 2, -1);
    Extension result = extend(curve, options);
    EXPECT_LE((directionAtEnd(result.curve) - Vector3(1, 2, -1).normalized()).norm(), 1e-9) << name;
    EXPECT_NEAR(lengthOf(result), reach, 1e-9 * reach) << name;

    for (const double curvature : {0.0, 1.0 / reach}) {
      options = ofOrder(3, 5);
      options.targets.curvature = curvature;
      result = extend(curve, options);
      EXPECT_NEAR(curvatureVectorAtEnd(result.curve).norm() * reach, curvature * reach, 1e-9)
          << name;
    }
    options = ofOrder(1, 6);
    options.targets.curvatureVector = Vector3(0, -0.5, 0.5) / reach;
    result = extend(curve, options);
    EXPECT_LE(
        (curvatureVectorAtEnd(result.curve) - *options.targets.curvatureVector).norm() * reach,
        1e-9)
        << name;
  }
}

TEST(Extend, APointInThePlaneOfAPlanarCurveKeepsThePlane) {
  ExtendOptions options = ofOrder(2);
  options.targets.point = Vector3(30, 20, 0);
  const Extension result = extend(test::planarCubic(), options);
  EXPECT_EQ(result.curve.degree(), 2);  // two numbers, and two conditions in the plane
  EXPECT_EQ(result.freeNumbers, 0);
  EXPECT_LE((endOf(result.curve) - *options.targets.point).norm(), 1e-9);
  for (int i = 0; i <= 2; ++i)
    EXPECT_NEAR(result.curve.pole(i).z(), 0.0, 1e-12);
}

TEST(Extend, KeepsGivenTangentialCoordinates) {
  ExtendOptions options = ofOrder(4);
  options.tangential = given({5.0, 9.0, 14.0, 20.0});
  Extension result = extend(test::twistedQuintic(), options);
  const BSplineCurve curve = test::twistedQuintic();
  const Vector3 tangent = curve.derivatives(1.0, 1)[1].normalized();
  const std::array<double, 5> expected{0.0, 5.0, 9.0, 14.0, 20.0};
  for (int i = 0; i <= 4; ++i) {
    EXPECT_NEAR((result.curve.pole(i) - endOf(curve.segment(0).curve)).dot(tangent),
                expected[static_cast<std::size_t>(i)], 1e-12);
  }
  EXPECT_EQ(result.freeNumbers, 0);
  EXPECT_FALSE(result.objective);

  options.tangential = {5.0, std::nullopt, 14.0};
  result = extend(curve, options);
  EXPECT_NEAR((result.curve.pole(3) - result.curve.pole(0)).dot(tangent), 14.0, 1e-12);
  EXPECT_NEAR(lengthOf(result), 14.0 * 4 / 3, 1e-9);  // the size that the numbers say
}

TEST(Extend, KeepsGivenBeta) {
  for (const int degree : {4, 5, 7}) {
    ExtendOptions options = ofOrder(4, degree);
    options.beta = {0.9, std::nullopt, -0.5};
    const Extension result = extend(test::twistedCubic(), options);
    EXPECT_NEAR(result.beta[0], 0.9, 1e-10);
    EXPECT_NEAR(result.beta[2], -0.5, 1e-9);
    EXPECT_NEAR(lengthOf(result), 30.0, 1e-8);
    EXPECT_EQ(result.freeNumbers, degree == 4 ? 1 : 1 + 3 * (degree - 4));
  }
}

TEST(Extend, BetaInFullFixesTheChord) {
  // round trip: the numbers of a curve give the curve, whatever its size was chosen by
  for (const auto& [name, curve] : test::curvesToExtend()) {
    if (name == "line") continue;
    const Extension known = extend(curve, ofOrder(4));
    ExtendOptions options = ofOrder(4, 4);
    std::copy(known.beta.begin(), known.beta.end(), options.beta.begin());
    const Extension result = extend(curve, options);
    EXPECT_LE(distance(result.curve, known.curve), 1e-6) << name;
    EXPECT_EQ(result.freeNumbers, 0);
  }
}

TEST(Extend, BetaInFullWithMorePolesLeavesTheRestToTheLength) {
  ExtendOptions options = ofOrder(2, 4);
  options.beta = given({1.1, -0.2});
  options.targets.lengthMm = 25.0;
  const Extension result = extend(test::twistedCubic(), options);
  EXPECT_NEAR(result.beta[0], 1.1, 1e-10);
  EXPECT_NEAR(result.beta[1], -0.2, 1e-10);
  EXPECT_NEAR(lengthOf(result), 25.0, 1e-9);
  EXPECT_EQ(result.freeNumbers, 8 - 3);
}

TEST(Extend, BetaOnALineMustAddUp) {
  ExtendOptions options = ofOrder(2, 2);
  options.beta = given({1.5, -1.0});  // 1.5 - 1/2 = 1
  options.targets.lengthMm = 8.0;
  EXPECT_NEAR(lengthOf(extend(test::line(), options)), 8.0, 1e-9);
  options.beta = given({1.5, 0.0});
  EXPECT_ERROR(extend(test::line(), options), "they fix the chord");
}

TEST(Extend, FairnessFindsNoWorseThanOtherNumbers) {
  // the lowest degree against a search over its numbers: none of 200 is better
  test::Random random(5);
  for (const auto& [name, curve] : test::curvesToExtend()) {
    const Extension best = extend(curve, ofOrder(3));
    for (int trial = 0; trial < 30; ++trial) {
      ExtendOptions options = ofOrder(3);
      options.targets.lengthMm = reachFrom(curve, CurveEnd::kEnd);
      options.beta = {random.uniform(0.36, 2.0), random.uniform(-2.0, 2.0)};
      try {
        const Extension other = extend(curve, options);
        if (other.curve.degree() == 3) {
          EXPECT_GE(*other.objective, *best.objective - 1e-6) << name;
        }
      } catch (const ContactError&) {  // no such curve
      }
    }
  }
}

TEST(Extend, MorePolesAreNeverWorse) {
  for (const auto& [name, curve] : test::curvesToExtend()) {
    const double least = *extend(curve, ofOrder(2)).objective;
    for (const int degree : {3, 4, 6, 9}) {
      const double value = *extend(curve, ofOrder(2, degree)).objective;
      EXPECT_LE(value, least + 1e-6) << name << degree;
    }
  }
}

TEST(Extend, ObjectiveIsTheEnergyOfTheCurve) {
  for (const Fairness fairness : {Fairness::kMinimumVariation, Fairness::kBending}) {
    for (const auto& [name, curve] : test::curvesToExtend()) {
      ExtendOptions options = ofOrder(4);
      options.fairness = fairness;
      const Extension result = extend(curve, options);
      EXPECT_NEAR(*result.objective, energies(BSplineCurve(result.curve)).objective(fairness), 1e-3)
          << name;
    }
  }
}

TEST(Extend, OfACircleStaysNearIt) {
  // a fair continuation does not turn the other way, and does not tighten
  const Extension result = extend(test::quarterCircle(), ofOrder(4));
  for (int i = 0; i <= 50; ++i) {
    const PointGeometry geometry = geometryAt(BSplineCurve(result.curve), i / 50.0);
    EXPECT_LE(*geometry.invariants.curvature, 0.105);
    EXPECT_GE(*geometry.invariants.curvature, 0.03);
  }
}

TEST(Extend, InvariantUnderScalingAndRigidMotion) {
  const Eigen::Affine3d motion =
      Eigen::Translation3d(3, -2, 5) * Eigen::AngleAxisd(0.7, Vector3(1, 2, 3).normalized());
  for (const auto& [name, curve] : test::curvesToExtend()) {
    for (const int degree : {0, 6}) {
      const BezierCurve own = extend(curve, ofOrder(3, degree)).curve;
      const double size = reachFrom(curve, CurveEnd::kEnd);
      for (const double scale : {1e-3, 1.0, 1e3}) {
        const Eigen::Affine3d map = Eigen::Scaling(scale) * motion;
        const BezierCurve moved = extend(curve.transformed(map), ofOrder(3, degree)).curve;
        EXPECT_LE(distance(moved, own.transformed(map)), 1e-5 * size * scale) << name << degree;
      }
    }
  }
}

TEST(Extend, InvariantUnderReversalElevationAndSplitting) {
  for (const auto& [name, curve] : test::curvesToExtend()) {
    const BezierCurve own = extend(curve, ofOrder(4)).curve;
    const double size = reachFrom(curve, CurveEnd::kEnd);
    ExtendOptions fromStart = ofOrder(4);
    fromStart.end = CurveEnd::kStart;
    EXPECT_LE(distance(extend(curve.reversed(), fromStart).curve, own), 1e-6 * size) << name;
    EXPECT_LE(distance(extend(curve.elevated(2), ofOrder(4)).curve, own), 1e-5 * size) << name;
    ExtendOptions sized = ofOrder(4);
    sized.targets.lengthMm = size;
    const BSplineCurve part = curve.split(std::lerp(curve.first(), curve.last(), 0.45)).second;
    EXPECT_LE(distance(extend(part, sized).curve, own), 1e-4 * size) << name;
  }
}

TEST(Extend, FollowsATargetThatMovesALittle) {
  // no jumps of the optimum for small moves
  ExtendOptions options = ofOrder(3, 6);
  std::optional<BezierCurve> before;
  for (int i = 0; i <= 60; ++i) {
    options.targets.point = Vector3(32.0 + 0.1 * i, 40.0 - 0.2 * i, 15.0);
    const BezierCurve now = extend(test::twistedCubic(), options).curve;
    if (before) {
      EXPECT_LE(distance(now, *before), 2.0) << i;
    }
    before = now;
  }
}

TEST(Extend, SameInputSameCurve) {
  ExtendOptions options = ofOrder(4, 3);
  const BezierCurve first = extend(test::twistedQuintic(), options).curve;
  EXPECT_TRUE(test::identical(extend(test::twistedQuintic(), options).curve, first));
}

TEST(Extend, WarnsOfCrampedAndSharpCurves) {
  ExtendOptions options = ofOrder(2);
  options.beta = {0.05};
  EXPECT_EQ(extend(test::twistedCubic(), options).warnings.at(0).substr(0, 8), "cramped:");
  options = ofOrder(4);
  options.targets.point = Vector3(30, 40, 20);
  options.targets.direction = Vector3(0, 1, 0);
  EXPECT_EQ(extend(test::twistedCubic(), options).warnings.at(0).substr(0, 6), "sharp:");
  options.degree = 7;
  EXPECT_TRUE(extend(test::twistedCubic(), options).warnings.empty());
}

TEST(Extend, FairOverTheCasesOfBlends) {
  // every arm of the blend cases is continued within the exact preset, without a warning
  for (const test::BlendCase& task : test::blendCases()) {
    for (const BSplineCurve& curve : {task.first, task.second.reversed()}) {
      const Construction result = extendCurve(curve, ofOrder(4));
      EXPECT_EQ(result.joins[0].report.order, 4) << task.name;
      EXPECT_TRUE(result.warnings.empty()) << task.name;
    }
  }
}

}  // namespace
}  // namespace osculate
