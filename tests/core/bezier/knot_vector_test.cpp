#include "osculate/bezier/knot_vector.h"

#include <limits>

#include "support/errors.h"

namespace osculate::test {
namespace {

using Flat = std::vector<double>;

TEST(Flatten, RepeatsEveryKnotByItsMultiplicity) {
  EXPECT_EQ(flatten({{0.0, 0.5, 2.0}, {3, 1, 2}}), (Flat{0.0, 0.0, 0.0, 0.5, 2.0, 2.0}));
}

TEST(Compress, IsTheInverseOfFlatten) {
  const KnotVector knots{{-1.0, 0.0, 1e-6, 7.0}, {4, 1, 3, 4}};
  const KnotVector back = compress(flatten(knots));
  EXPECT_EQ(back.knots, knots.knots);
  EXPECT_EQ(back.multiplicities, knots.multiplicities);
  EXPECT_TRUE(compress(Flat{}).knots.empty());
}

TEST(CheckKnots, AcceptsClampedUnclampedAndPeriodicKnots) {
  EXPECT_NO_THROW(checkKnots({{0, 1, 2}, {4, 4, 4}}, 3, 8, false));
  EXPECT_NO_THROW(checkKnots({{0, 1, 2, 3, 4, 5, 6, 7}, {1, 1, 1, 1, 1, 1, 1, 1}}, 3, 4, false));
  EXPECT_NO_THROW(checkKnots({{0, 1, 2, 3}, {2, 1, 3, 2}}, 3, 6, true));
}

TEST(CheckKnots, NamesTheDegreeOutOfRange) {
  EXPECT_ERROR(checkKnots({{0, 1}, {1, 1}}, 0, 1, false), "degree: must be from 1 to 25, got 0");
  EXPECT_ERROR(checkKnots({{0, 1}, {27, 27}}, 26, 27, false),
               "degree: must be from 1 to 25, got 26");
}

TEST(CheckKnots, NamesTooFewKnotsAndMissingMultiplicities) {
  EXPECT_ERROR(checkKnots({{0}, {4}}, 3, 4, false), "at least 2 knots");
  EXPECT_ERROR(checkKnots({{0, 1}, {4}}, 3, 4, false), "multiplicities: one for each");
}

TEST(CheckKnots, NamesKnotsThatDoNotIncreaseOrAreNotFinite) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_ERROR(checkKnots({{0, 2, 1}, {2, 1, 2}}, 1, 3, false), "knots: must increase strictly");
  EXPECT_ERROR(checkKnots({{0, 1, 1}, {2, 1, 2}}, 1, 3, false), "knots: must increase strictly");
  EXPECT_ERROR(checkKnots({{0, kNaN, 1}, {2, 1, 2}}, 1, 3, false),
               "knots: every knot must be finite");
  EXPECT_ERROR(checkKnots({{0, kInfinity}, {2, 2}}, 1, 2, false),
               "knots: every knot must be finite");
}

TEST(CheckKnots, NamesMultiplicitiesOutOfRange) {
  EXPECT_ERROR(checkKnots({{0, 1, 2}, {4, 0, 4}}, 3, 4, false),
               "multiplicities: each must be from 1 to 4, got 0");
  EXPECT_ERROR(checkKnots({{0, 1, 2}, {4, 5, 4}}, 3, 9, false),
               "multiplicities: each must be from 1 to 4, got 5");
  EXPECT_ERROR(checkKnots({{0, 1, 2}, {4, 1, 4}}, 3, 5, true),
               "multiplicities: each must be from 1 to 3, got 4");
}

TEST(CheckKnots, NamesSumsThatDoNotFitThePoles) {
  EXPECT_ERROR(checkKnots({{0, 1}, {4, 4}}, 3, 5, false),
               "their sum must be 9 (poles + degree + 1), got 8");
  EXPECT_ERROR(checkKnots({{0, 1, 2}, {1, 1, 1}}, 3, 3, true),
               "their sum must be 4 (poles plus the last");
}

TEST(CheckKnots, NamesTooFewPoles) {
  EXPECT_ERROR(checkKnots({{0, 1}, {3, 3}}, 3, 2, false),
               "poles: a curve of degree 3 needs at least 4 poles, got 2");
}

TEST(CheckKnots, NamesUnequalEndMultiplicitiesOfAPeriodicCurve) {
  EXPECT_ERROR(checkKnots({{0, 1, 2}, {1, 1, 2}}, 3, 2, true),
               "the first and the last must be equal");
}

}  // namespace
}  // namespace osculate::test
