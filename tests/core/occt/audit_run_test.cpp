#include "osculate/occt/audit_run.h"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <thread>

#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>

#include "occt/audit_shapes.h"
#include "support/errors.h"

namespace osculate::test {
namespace {

/// The same numbers, whatever lies between them in memory.
bool identicalRows(const AuditRow& a, const AuditRow& b) {
  return placeOf(a) == placeOf(b) && a.kind == b.kind && a.order == b.order &&
         a.verdicts == b.verdicts && a.residuals == b.residuals && a.point == b.point &&
         a.parameter == b.parameter && a.physical == b.physical && a.hasPhysical == b.hasPhysical &&
         a.parametricOrder == b.parametricOrder;
}

TEST(Audit, DoesNotDependOnTheNumberOfThreads) {
  const TopoDS_Shape shape = compoundOf(chainOf(9000), BRepPrimAPI_MakeTorus(5, 1).Shape());
  for (const JoinPairs pairs : {JoinPairs::kAll, JoinPairs::kWire, JoinPairs::kTangent}) {
    const AuditReport one = auditOf(shape, pairs, 1);
    ASSERT_GT(one.rows.size(), 17990U);
    for (const int threads : {0, 2, 7}) {
      const AuditReport many = auditOf(shape, pairs, threads);
      ASSERT_EQ(many.rows.size(), one.rows.size());
      EXPECT_TRUE(std::equal(one.rows.begin(), one.rows.end(), many.rows.begin(), identicalRows));
    }
  }
}

TEST(AuditSkips, WhatHasNoCurve) {
  TopoDS_Edge empty;
  BRep_Builder().MakeEdge(empty);
  const TopoDS_Vertex middle = vertexAt({0, 0, 0});
  BRep_Builder().Add(empty, middle.Oriented(TopAbs_FORWARD));
  const TopoDS_Edge infinite =
      BRepBuilderAPI_MakeEdge(gp_Lin(gp_Pnt(0, 0, 0), gp_Dir(1, 0, 0))).Edge();
  const TopoDS_Edge a = lineBetween(vertexAt({-5, 0, 0}), middle);
  const TopoDS_Edge b = lineBetween(middle, vertexAt({5, 0, 0}));
  const AuditReport report = auditOf(compoundOf(a, empty, infinite, b));
  ASSERT_EQ(report.skipped.size(), 2U);
  EXPECT_EQ(report.skipped[0].edge, 2);
  EXPECT_EQ(report.skipped[0].reason, "has no geometry (neither a curve nor a curve on a surface)");
  EXPECT_FALSE(report.skipped[0].degenerated);
  EXPECT_EQ(report.skipped[1].edge, 3);
  EXPECT_EQ(report.skipped[1].reason, "is infinite; trim it to a finite range");
  const std::vector<Place> expected{{1, 4, CurveEnd::kEnd, CurveEnd::kStart}};
  EXPECT_EQ(placesOf(report, JoinKind::kVertex), expected);
}

TEST(AuditSkips, DegeneratedEdges) {
  const AuditReport report = auditOf(BRepPrimAPI_MakeSphere(3).Shape());
  ASSERT_EQ(report.skipped.size(), 2U);
  EXPECT_TRUE(report.skipped[0].degenerated && report.skipped[1].degenerated);
}

TEST(AuditProgress, RisesToOneInThisThread) {
  std::vector<double> shares;
  const auto caller = std::this_thread::get_id();
  AuditOptions options;
  options.threads = 3;
  const ShapeAudit audit(chainOf(20000), options, [&](double share) {
    EXPECT_EQ(std::this_thread::get_id(), caller);
    shares.push_back(share);
    return true;
  });
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_EQ(shares.front(), 0.0);
  EXPECT_EQ(shares.back(), 1.0);
}

TEST(AuditProgress, StopsWithTheRowsOfAFirstPart) {
  const TopoDS_Shape chain = chainOf(60000);
  const AuditReport whole = auditOf(chain);
  for (const double limit : {-1.0, 0.0, 0.5}) {
    const AuditReport part = [&] {
      ShapeAudit audit(chain, {}, [&](double share) { return share <= limit; });
      return audit.takeReport();
    }();
    EXPECT_FALSE(part.complete);
    EXPECT_LT(part.rows.size(), whole.rows.size());
    EXPECT_TRUE(std::equal(part.rows.begin(), part.rows.end(), whole.rows.begin(), identicalRows));
    EXPECT_TRUE(limit >= 0.0 || part.rows.empty());
  }
}

TEST(AuditProgress, AnExceptionEndsIt) {
  const TopoDS_Shape chain = chainOf(20000);
  for (const double limit : {-1.0, 0.0}) {
    const auto fail = [&](double share) -> bool {
      if (share > limit) throw std::out_of_range("from the callback");
      return true;
    };
    EXPECT_THROW(ShapeAudit(chain, {}, fail), std::out_of_range);
  }
}

TEST(AuditProgress, OneEdgeOfManyKnotsCanBeStopped) {
  BSplineData data;
  data.degree = 3;
  constexpr int kSpans = 200000;
  data.poles.resize(3, kSpans + 3);
  for (int i = 0; i < kSpans + 3; ++i)
    data.poles.col(i) << i, i % 3, i % 2;
  for (int i = 0; i <= kSpans; ++i) {
    data.knots.knots.push_back(i);
    data.knots.multiplicities.push_back(i == 0 || i == kSpans ? 4 : 1);
  }
  const TopoDS_Edge edge = edgeOf(geomFrom(data));
  int calls = 0;
  const ShapeAudit audit(edge, {}, [&](double) { return ++calls < 3; });
  EXPECT_FALSE(audit.report().complete);
  EXPECT_EQ(calls, 3) << "asked while the edge was analysed";
  EXPECT_EQ(auditOf(edge).rows.size(), static_cast<std::size_t>(kSpans) - 1);
}

TEST(AuditErrors, NameTheArgument) {
  EXPECT_ERROR(ShapeAudit{TopoDS_Shape()}, "shape: is null");
  AuditOptions options;
  options.threads = -1;
  EXPECT_ERROR(ShapeAudit(chainOf(2), options), "threads: must be 0");
  options = {};
  options.cornerDegrees = std::numeric_limits<double>::quiet_NaN();
  EXPECT_ERROR(ShapeAudit(chainOf(2), options), "corner_deg: must be from 0 to 180");
  options = {};
  options.touchMm = -1.0;
  EXPECT_ERROR(ShapeAudit(chainOf(2), options), "touch_mm: must be finite and 0 or more");
  options = {};
  options.analysis.order = 9;
  EXPECT_ERROR(ShapeAudit(chainOf(2), options), "order: must be from 0 to 8");
}

}  // namespace
}  // namespace osculate::test
