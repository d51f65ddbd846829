#include "osculate/occt/near_points.h"

#include <gtest/gtest.h>

#include <limits>

#include "support/random_curves.h"

namespace osculate::test {
namespace {

std::vector<Vector3> clusteredPoints(int count) {
  Random random(11);
  std::vector<Vector3> points;
  for (int i = 0; i < count; ++i) {
    const bool isNear = i > 0 && random.coin();
    const Vector3 centre =
        isNear ? points[static_cast<std::size_t>(random.integer(0, i - 1))] : random.vector(3.0);
    points.emplace_back(centre + random.vector(isNear ? 0.1 : 0.0));
  }
  return points;
}

TEST(MergePoints, IsWhatComparisonOfAllGives) {
  const std::vector<Vector3> points = clusteredPoints(300);
  for (const double tolerance : {0.01, 0.1, 0.5, 2.0}) {
    std::vector<int> expected;
    for (std::size_t i = 0; i < points.size(); ++i) {
      expected.push_back(static_cast<int>(i));
      for (std::size_t j = 0; j < i && expected[i] == static_cast<int>(i); ++j) {
        const bool standsForItself = expected[j] == static_cast<int>(j);
        if (standsForItself && (points[i] - points[j]).norm() <= tolerance)
          expected[i] = static_cast<int>(j);
      }
    }
    EXPECT_EQ(mergePoints(points, tolerance), expected);
  }
}

TEST(MergePoints, OfNothingAndOfNumbersThatAreNone) {
  EXPECT_TRUE(mergePoints({}, 1.0).empty());
  const double none = std::numeric_limits<double>::quiet_NaN();
  const double endless = std::numeric_limits<double>::infinity();
  const std::vector<Vector3> points{
      {none, 0, 0}, {none, 0, 0}, {endless, 0, 0}, {1, 0, 0}, {1, 0, 0}};
  EXPECT_EQ(mergePoints(points, 0.1), (std::vector<int>{0, 1, 2, 3, 3}));
}

TEST(MergePoints, FarFromTheOrigin) {
  const std::vector<Vector3> points{{1e200, 0, 0}, {1e200, 0, 0}, {-1e200, 0, 0}, {2e200, 0, 0}};
  EXPECT_EQ(mergePoints(points, 1e-3), (std::vector<int>{0, 0, 2, 3}));
}

TEST(MatchPoints, TakesEachPointOnceAndTheNearestFirst) {
  using Pairs = std::vector<std::pair<int, int>>;
  const std::vector<Vector3> points{{0, 0, 0}, {0.3, 0, 0}, {0.5, 0, 0},
                                    {5, 0, 0}, {5, 0.9, 0}, {9, 0, 0}};
  EXPECT_EQ(matchPoints(points, 1.0), (Pairs{{1, 2}, {3, 4}}));
  EXPECT_EQ(matchPoints(points, 0.3), (Pairs{{1, 2}}));
  EXPECT_EQ(matchPoints(points, 0.1), Pairs{});
}

TEST(MatchPoints, AcrossCells) {
  for (const double x : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
    const std::vector<Vector3> points{{x - 0.4, x, -x}, {x + 0.4, x, -x}};
    EXPECT_EQ(matchPoints(points, 1.0).size(), 1U) << x;
  }
}

}  // namespace
}  // namespace osculate::test
