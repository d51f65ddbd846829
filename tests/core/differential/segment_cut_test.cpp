#include "osculate/differential/segment_cut.h"

#include "support/exact.h"
#include "support/random_curves.h"

namespace osculate::test {
namespace {

BezierSegment segmentOf(const BezierCurve& curve) { return {curve, 0.0, 1.0, 0.0}; }

TEST(SegmentCutter, GivesTheLongerPartOutwardWithinItsStatedError) {
  Random random(200);
  for (const int degree : {1, 2, 5, 25}) {
    for (const bool rational : {false, true}) {
      const BezierCurve curve = randomBezier(random, degree, rational);
      const SegmentCutter cutter(segmentOf(curve));
      const auto reference = exact<Real>(curve);
      for (const double t : {0.1, 0.4999, 0.5, 0.9}) {
        SCOPED_TRACE(std::to_string(degree) + " at " + std::to_string(t));
        const CutSegment cut = cutter.at(t);
        EXPECT_EQ(cut.end, t < 0.5 ? CurveEnd::kStart : CurveEnd::kEnd);
        EXPECT_EQ(cut.sign(), t < 0.5 ? 1.0 : -1.0);
        EXPECT_EQ(cut.length, std::max(t, 1.0 - t));
        for (const double u : {0.0, 0.3, 1.0}) {
          const Real own = t < 0.5 ? Real(Real(t) + Real(u) * (1 - Real(t))) : Real(u) * Real(t);
          EXPECT_LE(distance(evaluate(reference, own),
                             evaluate(exact<Real>(cut.curve), Real(u))
                                 .unaryExpr([](const Real& x) { return toDouble(x); })
                                 .eval()),
                    cut.poleError + 1e-15 * size(curve));
        }
      }
    }
  }
}

TEST(SegmentCutter, AtTheEndsIsTheSegmentItself) {
  Random random(201);
  const BezierCurve curve = randomBezier(random, 4, true);
  const SegmentCutter cutter({curve, 2.0, 3.0, 1e-9});
  for (const double t : {0.0, 1.0}) {
    const CutSegment cut = cutter.at(t);
    EXPECT_TRUE(identical(cut.curve, curve));
    EXPECT_EQ(cut.end, t == 0.0 ? CurveEnd::kStart : CurveEnd::kEnd);
    EXPECT_EQ(cut.length, 1.0);
    EXPECT_EQ(cut.poleError, 1e-9);
  }
  EXPECT_GT(cutter.at(0.3).poleError, 1e-9);
}

}  // namespace
}  // namespace osculate::test
