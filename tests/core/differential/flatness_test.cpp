#include "osculate/differential/flatness.h"

#include <gtest/gtest.h>

#include "osculate/differential/point_geometry.h"
#include "support/random_curves.h"

namespace osculate::test {
namespace {

TEST(Flatness, IsAMillionthOfTheCurveOrWhatRoundingDoes) {
  const BSplineCurve line(BezierCurve(std::vector<Vector3>{{0, 0, 0}, {10, 0, 0}}));
  const Flatness flatness(line);
  EXPECT_NEAR(flatness.below({0, 0, 0}, 0.0), 1e-7, 1e-20);
  EXPECT_NEAR(flatness.below({5, 0, 0}, 0.0), 2e-7, 1e-20);
  EXPECT_EQ(flatness.below({5, 0, 0}, 1e-3), 1e-3);
}

TEST(Flatness, OfAFigureOfEightHasAScaleAtItsCrossing) {
  // a closed quintic whose middle lies where it begins and ends
  const BSplineCurve eight(BezierCurve(
      std::vector<Vector3>{{0, 0, 0}, {6, 6, 0}, {3, -9, 0}, {-3, 9, 0}, {-6, -6, 0}, {0, 0, 0}}));
  ASSERT_LE((eight.middlePoint() - eight.endPoint(CurveEnd::kStart)).norm(), 1e-14);
  const double below = Flatness(eight).below({0, 0, 0}, 0.0);
  EXPECT_GT(below, 1e-8);
  EXPECT_LT(below, 1e-5);
  EXPECT_TRUE(geometryAt(eight, 0.0).frame.normal);
}

}  // namespace
}  // namespace osculate::test
