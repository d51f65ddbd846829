#include "osculate/construction/curve_chain.h"

#include <gtest/gtest.h>

#include <limits>

#include "construction/join_checks.h"
#include "support/errors.h"

namespace osculate {
namespace {

using namespace test;

const Vector3 kA(0, 0, 0);
const Vector3 kB(4, 0, 0);
const Vector3 kC(4, 4, 1);
const Vector3 kD(0, 4, 0);
const Vector3 kE(-4, 2, 0);

/// "0 1' 2": the indices in the order of travel, with ' where one is reversed; "closed" at the end.
std::string told(const CurveChain& chain) {
  std::string text;
  for (const ChainLink& link : chain.links)
    text += std::to_string(link.index) + (link.reversed ? "' " : " ");
  return text + (chain.closed ? "closed" : "") + (chain.sorted ? "sorted" : "");
}

std::string chainOf(const std::vector<BSplineCurve>& curves, double toleranceMm = 0.0) {
  return told(orderChain(curves, toleranceMm));
}

TEST(CurveChain, TurnsCurvesAsTheirEndsMeet) {
  EXPECT_EQ(chainOf({segment(kA, kB), segment(kB, kC)}), "0 1 ");
  EXPECT_EQ(chainOf({segment(kB, kA), segment(kC, kB), segment(kC, kD)}), "0' 1' 2 ");
  EXPECT_EQ(chainOf({segment(kB, kA), segment(kB, kC)}), "0' 1 ");
  EXPECT_EQ(chainOf({segment(kA, kB)}), "0 ");
}

TEST(CurveChain, GoesWithTheListWhereThatIsAChain) {
  EXPECT_EQ(chainOf({segment(kC, kB), segment(kB, kA)}), "0 1 ");
  // through A twice
  EXPECT_EQ(chainOf({segment(kE, kA), segment(kA, kB), segment(kB, kC), segment(kA, kC),
                     segment(kA, kD)}),
            "0 1 2 3' 4 ");
}

TEST(CurveChain, ClosesWhereTheLastMeetsTheFirst) {
  EXPECT_EQ(chainOf({segment(kA, kB), segment(kB, kC), segment(kA, kC)}), "0 1 2' closed");
  EXPECT_EQ(chainOf({segment(kA, kB), segment(kB, kC), segment(kC, kD)}), "0 1 2 ");
  Random random(240);
  const auto arcs = BSplineCurve(randomBezier(random, 3, false)).split(0.5);
  const Vector3 begin = arcs.first.endPoint(CurveEnd::kStart);
  const Vector3 end = arcs.second.endPoint(CurveEnd::kEnd);
  EXPECT_EQ(chainOf({segment(end, begin), arcs.first, arcs.second}), "0 1 2 closed");
}

TEST(CurveChain, OfTwoThatMeetTwiceBeginsWithTheFirst) {
  const std::vector<Vector3> poles{kA, kD, kB};
  const BSplineCurve arch{BezierCurve(poles)};
  EXPECT_EQ(chainOf({segment(kA, kB), arch}), "0 1' closed");
  EXPECT_EQ(chainOf({segment(kB, kA), arch}), "0 1 closed");
  EXPECT_EQ(chainOf({arch, segment(kA, kB)}), "0 1' closed");
}

TEST(CurveChain, SortsWhatIsNoChainInTheOrderGiven) {
  EXPECT_EQ(chainOf({segment(kC, kD), segment(kA, kB), segment(kC, kB)}), "1 2' 0 sorted");
  EXPECT_EQ(chainOf({segment(kD, kC), segment(kA, kB), segment(kC, kB)}), "0 2 1' sorted");
  EXPECT_EQ(chainOf({segment(kB, kC), segment(kD, kE), segment(kA, kB), segment(kC, kD),
                     segment(kE, kA)}),
            "0 3 1 4 2 closedsorted");
}

TEST(CurveChain, SortsAThousandShuffledCurves) {
  Random random(241);
  std::vector<BSplineCurve> curves;
  for (int i = 0; i < 1000; ++i) {
    const BSplineCurve next = segment({0, 0.0 + i, 0}, {0, i + 1.0, 0});
    curves.push_back(random.coin() ? next : next.reversed());
  }
  for (int i = 999; i > 0; --i)
    std::swap(curves[static_cast<std::size_t>(i)],
              curves[static_cast<std::size_t>(random.integer(0, i))]);
  const CurveChain chain = orderChain(curves, 0.0);
  ASSERT_EQ(chain.links.size(), 1000U);
  for (std::size_t i = 0; i < 1000; ++i) {
    const BSplineCurve& curve = curves[chain.links[i].index];
    const double low = std::min(curve.evaluate(0).y(), curve.evaluate(1).y());
    const double expected = curves[0].evaluate(1).y() > curves[0].evaluate(0).y()
                                ? static_cast<double>(i)
                                : 999.0 - static_cast<double>(i);
    EXPECT_EQ(low, expected);
  }
}

TEST(CurveChain, TakesTheNearestOfEndsWithinAWideTolerance) {
  const Vector3 nearB = kB + Vector3(0.3, 0, 0);  // a curve shorter than the tolerance
  EXPECT_EQ(chainOf({segment(nearB, kC), segment(kA, kB), segment(kB, nearB)}, 1.0),
            "1 2 0 sorted");
}

TEST(CurveChain, NamesTheGap) {
  const Vector3 off = kB + Vector3(0, 0, 0.25);
  const std::vector<BSplineCurve> curves{segment(kA, kB), segment(off, kC), segment(kC, kD)};
  EXPECT_THROW(orderChain(curves, 0.0), ContactError);
  EXPECT_ERROR(orderChain(curves, 0.0),
               "curves: curves[0] and curves[1] are no chain: their nearest free ends are 0.25 mm "
               "apart, beyond rounding; a tolerance of at least 0.125 mm");
  EXPECT_ERROR(orderChain(curves, 0.1), "beyond rounding and twice the tolerance of 0.1 mm");
  EXPECT_EQ(chainOf(curves, 0.125), "0 1 2 ");
  EXPECT_ERROR(chainOf({segment(kA, kB), segment(kC, kD), segment(kC, kE)}),
               "curves[0] and curves[1] are no chain: their nearest free ends are 4 mm");
  const std::vector<BSplineCurve> apart{segment(kA, kB), segment(kB, kC), segment(kC, kA),
                                        segment(kD, kE)};
  EXPECT_ERROR(orderChain(apart, 0.0), "are no chain");
}

TEST(CurveChain, TakesRoundingOfCoordinatesForNoGap) {
  const Vector3 far(1e6, 0, 0);
  const Vector3 next(std::nextafter(1e6, 2e6), 0, 1e-8);
  EXPECT_EQ(chainOf({segment(kA, far), segment(next, kC)}), "0 1 ");
  EXPECT_THROW(chainOf({segment(kA, kB), segment(kB + Vector3(0, 0, 1e-8), kC)}), ContactError);
  const BSplineCurve approximate = segment(kB + Vector3(0, 0, 1e-8), kC).withPoleError(2e-8);
  EXPECT_EQ(chainOf({segment(kA, kB), approximate}), "0 1 ");
}

TEST(CurveChain, NamesABranch) {
  const std::vector<BSplineCurve> curves{segment(kA, kB), segment(kB, kC), segment(kD, kB)};
  EXPECT_THROW(orderChain(curves, 0.0), ContactError);
  EXPECT_ERROR(orderChain(curves, 0.0),
               "curves: the chain branches where ends of curves[0], curves[1] and curves[2] meet");
  EXPECT_ERROR(chainOf({segment(kB, kA), segment(kC, kB), segment(kB, kD), segment(kB, kE)}),
               "the chain branches");
}

TEST(CurveChain, NamesACurveThatIsThereTwice) {
  Random random(242);
  const BSplineCurve curve(randomBezier(random, 4, true));
  const BSplineCurve other = segment(curve.evaluate(1), kA);
  EXPECT_ERROR(chainOf({curve, curve}), "curves: curves[0] and curves[1] are the same curve");
  EXPECT_ERROR(chainOf({curve, other, curve.reversed()}),
               "curves: curves[0] and curves[2] are the same curve");
  EXPECT_ERROR(chainOf({other, curve, curve.reparametrised(3, 8)}),
               "curves: curves[1] and curves[2] are the same curve");
}

TEST(CurveChain, NamesBadArguments) {
  EXPECT_ERROR(chainOf({}), "curves: at least one is needed");
  for (const double bad :
       {-1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    EXPECT_ERROR(chainOf({segment(kA, kB)}, bad), "tolerance: must be finite and >= 0");
  }
}

}  // namespace
}  // namespace osculate
