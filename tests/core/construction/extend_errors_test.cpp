// What an extension refuses, with the argument, the rule and what can be.
#include <gtest/gtest.h>

#include <limits>

#include "construction/extend_curves.h"
#include "osculate/construction/contact_error.h"
#include "osculate/construction/extend.h"
#include "support/errors.h"

namespace osculate {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
const double kNan = std::nan("");

/// The error of an extension of a cubic whose options the function sets.
template <class Setter>
auto with(const Setter& set) {
  return [set] {
    ExtendOptions options;
    set(options);
    extend(test::twistedCubic(), options);
  };
}

#define EXPECT_REFUSED(text, ...) EXPECT_ERROR(with([](ExtendOptions& o) { __VA_ARGS__; })(), text)
#define EXPECT_CONTACT_ERROR(text, ...) \
  EXPECT_REFUSED(text, __VA_ARGS__);    \
  EXPECT_THROW(with([](ExtendOptions& o) { __VA_ARGS__; })(), ContactError)

TEST(ExtendErrors, NumbersOutsideTheirRange) {
  EXPECT_REFUSED("order: must be from 0 to 8", o.order = -1);
  EXPECT_REFUSED("order: must be from 0 to 8", o.order = 9);
  EXPECT_REFUSED("degree: must be from 1 to 25", o.degree = -2);
  EXPECT_REFUSED("degree: must be from 1 to 25", o.degree = 26);
  EXPECT_REFUSED("beta: beta_1 must be > 0", o.beta[0] = 0.0);
  EXPECT_REFUSED("beta: every number must be finite", o.beta[2] = kInfinite);
  EXPECT_REFUSED("beta: contact of order 4 has 4 numbers", o.beta[4] = 1.0);
  EXPECT_REFUSED("tangential: that of C_1 must be > 0", o.tangential[0] = -1.0);
  EXPECT_REFUSED("tangential: every number must be finite", o.tangential[1] = kNan);
  EXPECT_REFUSED("tangential: contact of order 1 has 1 numbers", o.order = 1; o.tangential[1] = 2);
  EXPECT_REFUSED("length: must be finite and > 0", o.targets.lengthMm = 0.0);
  EXPECT_REFUSED("length: must be finite and > 0", o.targets.lengthMm = kNan);
  EXPECT_REFUSED("to_point: must be finite", o.targets.point = Vector3(0, kInfinite, 0));
  EXPECT_REFUSED("to_direction: must be finite and not zero",
                 o.targets.direction = Vector3(0, 0, 0));
  EXPECT_REFUSED("to_direction: must be finite", o.targets.direction = Vector3(kNan, 0, 1));
  EXPECT_REFUSED("to_curvature: must be finite", o.targets.curvatureVector = Vector3(kNan, 0, 1));
  EXPECT_REFUSED("to_curvature: a number must be finite and >= 0", o.targets.curvature = -0.1);
  EXPECT_REFUSED("parameter: must be finite and > 0", o.parameter = 0.0);
}

TEST(ExtendErrors, RequestsThatContradictEachOther) {
  EXPECT_CONTACT_ERROR("beta and tangential are the same", o.beta[0] = 1.0; o.tangential[1] = 5.0);
  EXPECT_CONTACT_ERROR("fixes the numbers", o.parametric = true; o.beta[0] = 1.0);
  EXPECT_CONTACT_ERROR("fixes the numbers", o.parameter = 0.5; o.tangential[0] = 1.0);
  EXPECT_CONTACT_ERROR("parameter shortens", o.parametric = true; o.parameter = 0.5);
  EXPECT_REFUSED("give a vector or a number", o.targets.curvature = 0.1;
                 o.targets.curvatureVector = Vector3(0, 0, 1));
  EXPECT_CONTACT_ERROR("at right angles", o.targets.direction = Vector3(1, 0, 0);
                       o.targets.curvatureVector = Vector3(0.1, 0, 0.1));
  EXPECT_CONTACT_ERROR("to_point: it is the end itself", o.targets.point = Vector3(20, 20, 10));
  EXPECT_CONTACT_ERROR("longer than its chord", o.targets.point = Vector3(20, 40, 10);
                       o.targets.lengthMm = 20.0);
}

TEST(ExtendErrors, OverdeterminedWithCounts) {
  EXPECT_CONTACT_ERROR(
      "over-determined: degree 4 has 4 free numbers for 5 conditions: "
      "to_point (3), to_direction (2), and no curve of that degree was found; "
      "degree 5 can",
      o.degree = 4;
      o.targets.point = Vector3(30, 40, 20); o.targets.direction = Vector3(0, 1, 0));
  EXPECT_CONTACT_ERROR(
      "over-determined: degree 2 has 2 free numbers for 3 conditions: beta (2), "
      "length (1)",
      o.order = o.degree = 2;
      o.beta[0] = 1.0; o.beta[1] = 0.1; o.targets.lengthMm = 20.0);
  EXPECT_CONTACT_ERROR(
      "over-determined: degree 1 has 1 free numbers for 2 conditions: contact "
      "above the degree (2)",
      o.order = 2;
      o.degree = 1);
  EXPECT_CONTACT_ERROR("over-determined: degree 3 has 0 free numbers for 1 conditions: length (1)",
                       o.order = o.degree = 3;
                       o.tangential = {5.0, 10.0, 15.0}; o.targets.lengthMm = 20.0);
}

TEST(ExtendErrors, UnderdeterminedWithoutFairness) {
  EXPECT_CONTACT_ERROR("under-determined: 3 numbers are left free", o.fairness.reset());
  EXPECT_CONTACT_ERROR("under-determined: 2 numbers", o.fairness.reset(); o.beta[0] = 1.0);
  ExtendOptions fixed;
  fixed.order = 1;
  fixed.fairness.reset();
  EXPECT_EQ(extend(test::twistedCubic(), fixed).freeNumbers, 0);
}

TEST(ExtendErrors, AChordThatDoesNotExist) {
  // a quarter circle's chord is shorter than its arc: speed 1.5 all along is no chord
  ExtendOptions options;
  options.order = options.degree = 1;
  options.beta[0] = 1.5;
  EXPECT_ERROR(extend(test::quarterCircle(), options), "they fix the chord");
}

TEST(ExtendErrors, ASingularEndWithoutTheDerivatives) {
  const BSplineCurve cusp = test::bezier({{-20, 5, 0}, {-10, 0, 0}, {0, 0, 0}, {0, 0, 0}});
  EXPECT_ERROR(extend(cusp, {.order = 4}), "order: the curve's end is singular");
  EXPECT_ERROR(extend(test::doublePole(), {.order = 2, .parametric = true}),
               "parametric: the curve stops at its end");
}

}  // namespace
}  // namespace osculate
