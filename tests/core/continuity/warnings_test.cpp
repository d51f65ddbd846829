#include "osculate/continuity/warnings.h"

#include <set>

#include "support/joins.h"

namespace osculate::test {
namespace {

TEST(WarningSet, HoldsWhatWasAddedInTheOrderOfTheList) {
  WarningSet set;
  EXPECT_TRUE(set.empty());
  set.add(Warning::kApproximated);
  set.add(Warning::kCusp);
  set.add(Warning::kCusp);
  EXPECT_FALSE(set.empty());
  EXPECT_TRUE(set.has(Warning::kCusp));
  EXPECT_FALSE(set.has(Warning::kUndecided));
  EXPECT_EQ(set.list(), (std::vector{Warning::kCusp, Warning::kApproximated}));
}

TEST(Warnings, HaveCodesOfTheirOwnAndASentence) {
  std::set<std::string_view> codes;
  for (unsigned i = 0; i < static_cast<unsigned>(Warning::kCount); ++i) {
    const auto warning = static_cast<Warning>(i);
    codes.insert(code(warning));
    EXPECT_TRUE(sentence(warning).ends_with('.')) << code(warning);
  }
  EXPECT_EQ(codes.size(), static_cast<std::size_t>(Warning::kCount));
  EXPECT_TRUE(codes.contains("cusp") && codes.contains("degenerate-tangent") &&
              codes.contains("near-flat") && codes.contains("far-from-origin") &&
              codes.contains("touches-at-both-ends") && codes.contains("undecided"));
}

TEST(Warnings, AJoinWithoutPeculiarityHasNone) {
  Random random(260);
  for (int round = 0; round < 20; ++round) {
    const auto [first, second] = randomJoin(random, round % 5, 5);
    EXPECT_TRUE(join(first, second).warnings.empty());
  }
}

TEST(Warnings, OfFlatnessIsForCurvesNotForLines) {
  const BezierCurve line = bezier({{-2, 0, 0}, {0, 0, 0}});
  EXPECT_TRUE(join(line, line.segment(1, 2)).warnings.empty());
  const BezierCurve inflected = bezier({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 1, 0}});
  EXPECT_EQ(join(line, inflected).warnings.list(), std::vector{Warning::kNearFlat});
}

TEST(Warnings, OfTheOriginIsAMillionTimesTheSize) {
  const BezierCurve line = bezier({{-2, 0, 0}, {0, 0, 0}});
  const auto movedBy = [&](double distance) {
    const Eigen::Affine3d map(Eigen::Translation3d(0, distance, 0));
    return join(line.transformed(map), line.segment(1, 2).transformed(map))
        .warnings.has(Warning::kFarFromOrigin);
  };
  EXPECT_FALSE(movedBy(1e6));
  EXPECT_TRUE(movedBy(4e6));
}

}  // namespace
}  // namespace osculate::test
