#include "osculate/differential/frenet.h"

#include <vector>

#include "support/random_curves.h"

#include <gtest/gtest.h>

namespace osculate::test {
namespace {

using enum CurveEnd;
using Points = std::vector<Vector3>;

int legs(const Points& poles, CurveEnd end, double tolerance = 1e-12) {
  return legsOnTangent(BezierCurve(poles).view(), end, tolerance);
}

void expectRightHanded(const FrenetFrame& frame) {
  ASSERT_TRUE(frame.normal && frame.binormal);
  EXPECT_NEAR(frame.tangent.norm(), 1.0, 1e-14);
  EXPECT_NEAR(frame.normal->norm(), 1.0, 1e-14);
  EXPECT_NEAR(frame.tangent.dot(*frame.normal), 0.0, 1e-14);
  EXPECT_LE((frame.tangent.cross(*frame.normal) - *frame.binormal).norm(), 1e-14);
}

TEST(FrameKind, HasTheNamesOfTheContract) {
  EXPECT_EQ(name(FrameKind::kFrenet), "frenet");
  EXPECT_EQ(name(FrameKind::kFictitiousNormal), "fictitious-normal");
  EXPECT_EQ(name(FrameKind::kLine), "line");
  EXPECT_EQ(name(FrameKind::kFictitiousTangent), "fictitious-tangent");
}

TEST(LegsOnTangent, CountsFromTheEndAskedFor) {
  const Points poles{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 1, 0}, {5, 3, 2}};
  EXPECT_EQ(legs(poles, kStart), 3);
  EXPECT_EQ(legs(poles, kEnd), 1);
}

TEST(LegsOnTangent, OfAStraightSegmentAreAll) {
  EXPECT_EQ(legs({{1, 1, 1}, {2, 3, 4}}, kStart), 1);
  EXPECT_EQ(legs({{0, 0, 0}, {1, 2, 2}, {3, 6, 6}, {2, 4, 4}}, kEnd), 3)
      << "poles may go back along the line";
}

TEST(LegsOnTangent, CountsLegsOfNoLength) {
  EXPECT_EQ(legs({{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 1, 0}}, kStart), 3);
}

TEST(LegsOnTangent, ToleranceIsADistanceFromTheLine) {
  const Points poles{{0, 0, 0}, {1, 0, 0}, {2, 1e-5, 0}, {3, 1, 0}};
  EXPECT_EQ(legs(poles, kStart, 1e-7), 1);
  EXPECT_EQ(legs(poles, kStart, 1e-5), 2);
}

TEST(LineTolerance, IsRoundingOfTheSizeOrTheErrorOfThePoles) {
  EXPECT_EQ(lineTolerance(100.0, 0.0), 1600.0 * kUnitRoundoff);
  EXPECT_EQ(lineTolerance(100.0, 0.5), 1.0);
}

TEST(FictitiousFrame, TakesTheNormalFromTheFirstLegOffTheTangent) {
  const BezierCurve curve(Points{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, -2}, {4, 5, 0}});
  const EndFrame start = fictitiousFrame(curve.view(), kStart, Vector3::UnitX(), false);
  EXPECT_EQ(start.kind, FrameKind::kFictitiousNormal);
  EXPECT_EQ(*start.frame.normal, -Vector3::UnitZ());
  expectRightHanded(start.frame);
  const BezierCurve turned = curve.reversed();
  const EndFrame end = fictitiousFrame(turned.view(), kEnd, -Vector3::UnitX(), false);
  EXPECT_EQ(*end.frame.normal, -Vector3::UnitZ());
  EXPECT_EQ(end.frame.tangent, -Vector3::UnitX()) << "in the direction of travel";
  expectRightHanded(end.frame);
}

TEST(FictitiousFrame, OfALineHasItsNormalInTheXyPlane) {
  Random random(150);
  for (int round = 0; round < 20; ++round) {
    const Vector3 direction = random.direction();
    const Vector3 from = random.vector(10.0);
    const BezierCurve line(Points{from, from + 3.0 * direction});
    const EndFrame frame = fictitiousFrame(line.view(), kEnd, direction, false);
    EXPECT_EQ(frame.kind, FrameKind::kLine);
    EXPECT_EQ(frame.frame.normal->z(), 0.0);
    expectRightHanded(frame.frame);
  }
}

TEST(FictitiousFrame, OfALineAlongZHasTheNormalX) {
  const BezierCurve line(Points{{1, 2, 3}, {1, 2, 9}});
  const EndFrame frame = fictitiousFrame(line.view(), kStart, Vector3::UnitZ(), false);
  EXPECT_EQ(frame.kind, FrameKind::kLine);
  EXPECT_EQ(*frame.frame.normal, Vector3::UnitX());
  expectRightHanded(frame.frame);
}

TEST(FictitiousFrame, OfASingularEndWithoutTangentTakesTheFirstLegThatIsNotZero) {
  const BezierCurve curve(Points{{1, 1, 1}, {1, 1, 1}, {1, 3, 1}, {4, 3, 1}});
  const EndFrame start = fictitiousFrame(curve.view(), kStart, Vector3::Zero(), true);
  EXPECT_EQ(start.kind, FrameKind::kFictitiousTangent);
  EXPECT_EQ(start.frame.tangent, Vector3::UnitY());
  EXPECT_EQ(*start.frame.normal, Vector3::UnitX());
  expectRightHanded(start.frame);
  const BezierCurve turned = curve.reversed();
  const EndFrame end = fictitiousFrame(turned.view(), kEnd, Vector3::Zero(), true);
  EXPECT_EQ(end.frame.tangent, -Vector3::UnitY()) << "in the direction of travel";
  expectRightHanded(end.frame);
}

TEST(FictitiousFrame, OfOnePointIsStillAFrame) {
  const BezierCurve point(Points(4, Vector3(2, 2, 2)));
  const EndFrame frame = fictitiousFrame(point.view(), kStart, Vector3::Zero(), true);
  EXPECT_EQ(frame.kind, FrameKind::kFictitiousTangent);
  expectRightHanded(frame.frame);
}

}  // namespace
}  // namespace osculate::test
