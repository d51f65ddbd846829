#include "osculate/occt/audit.h"

#include <iterator>
#include <numbers>

#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <Geom_Circle.hxx>

#include "occt/audit_shapes.h"

namespace osculate::test {
namespace {

const gp_Ax2 kAxes(gp_Pnt(1, 2, 3), gp_Dir(0, 0, 1));

TopoDS_Shape moved(const TopoDS_Shape& shape, double x) {
  gp_Trsf translation;
  translation.SetTranslation(gp_Vec(x, 0, 0));
  return shape.Moved(TopLoc_Location(translation));
}

struct Sample {
  const char* name;
  TopoDS_Shape shape;
};

std::vector<Sample> samples() {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 2, 3).Shape();
  const TopoDS_Edge circle = BRepBuilderAPI_MakeEdge(gp_Circ(kAxes, 5)).Edge();
  return {{"box", box},
          {"box turned inside out", box.Reversed()},
          {"cylinder", BRepPrimAPI_MakeCylinder(2, 5).Shape()},
          {"half cylinder", BRepPrimAPI_MakeCylinder(2, 5, 3).Shape()},
          {"sphere", BRepPrimAPI_MakeSphere(3).Shape()},
          {"cone", BRepPrimAPI_MakeCone(2, 0, 5).Shape()},
          {"torus", BRepPrimAPI_MakeTorus(5, 1).Shape()},
          {"assembly", compoundOf(box, moved(box, 5), moved(moved(box, 5), -5))},
          {"chain", chainOf(50)},
          {"circle", circle},
          {"line", BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 0), gp_Pnt(1, 2, 3)).Edge()},
          {"nothing", compoundOf()}};
}

void expectSameRow(const AuditRow& row, const JoinReport& report) {
  EXPECT_EQ(row.order, report.order);
  EXPECT_EQ(row.parametricOrder, report.parametricOrder);
  EXPECT_EQ(row.verdicts, report.verdicts);
  EXPECT_EQ(row.residuals, report.residuals);
  EXPECT_EQ(row.warnings.list(), report.warnings.list());
  EXPECT_EQ(row.point[2], report.sides[0].point.z());
  const Deviation deviation = row.deviation();
  EXPECT_EQ(deviation.gapMm, report.deviation.gapMm);
  EXPECT_EQ(deviation.tangentAngleDegrees, report.deviation.tangentAngleDegrees);
  EXPECT_EQ(deviation.osculatingPlaneAngleDegrees, report.deviation.osculatingPlaneAngleDegrees);
  EXPECT_EQ(deviation.curvatureRate2PerMm3, report.deviation.curvatureRate2PerMm3);
}

TEST(Audit, PairsEveryTwoEndsThatAreOneVertex) {
  for (const auto& [name, shape] : samples()) {
    SCOPED_TRACE(name);
    const std::vector<TopoDS_Edge> edges = edgesOf(shape);
    const AuditReport report = auditOf(shape);
    EXPECT_EQ(report.edgeCount, static_cast<int>(edges.size()));
    const std::vector<Place> places = placesOf(report, JoinKind::kVertex);
    EXPECT_EQ(std::set<Place>(places.begin(), places.end()), placesByComparison(edges));
    EXPECT_EQ(places.size(), placesByComparison(edges).size()) << "a pair comes twice";
    EXPECT_TRUE(report.complete);
  }
}

TEST(Audit, RowsAreTheReportsOfTheCurves) {
  for (const auto& [name, shape] : samples()) {
    SCOPED_TRACE(name);
    const ShapeAudit audit(shape);
    const std::vector<TopoDS_Edge> edges = edgesOf(shape);
    const auto curve = [&](int number) {
      return curveFromEdge(edges[static_cast<std::size_t>(number) - 1]).curve;
    };
    for (const AuditRow& row : audit.report().rows) {
      expectSameRow(row, audit.join(row).report);
      if (row.kind == JoinKind::kVertex)
        expectSameRow(row,
                      analyzeCurves(curve(row.edges[0]), curve(row.edges[1]), {}, row.ends).report);
    }
  }
}

TEST(Audit, HasTheInnerKnotsAndTheClosingOfEachEdge) {
  for (const auto& [name, shape] : samples()) {
    SCOPED_TRACE(name);
    const AuditReport report = auditOf(shape);
    const std::vector<TopoDS_Edge> edges = edgesOf(shape);
    std::vector<AuditRow> inner;
    std::copy_if(report.rows.begin(), report.rows.end(), std::back_inserter(inner),
                 [](const AuditRow& row) { return row.kind != JoinKind::kVertex; });
    auto row = inner.begin();
    for (std::size_t i = 0; i < edges.size(); ++i) {
      if (BRep_Tool::Degenerated(edges[i])) continue;
      for (const CurveJoin& join : analyzeInnerJoins(curveFromEdge(edges[i]).curve)) {
        ASSERT_NE(row, inner.end());
        EXPECT_EQ(row->edges, (std::array{static_cast<int>(i) + 1, static_cast<int>(i) + 1}));
        EXPECT_EQ(row->kind, join.parameter ? JoinKind::kKnot : JoinKind::kSeam);
        if (join.parameter) {
          EXPECT_EQ(row->parameter, *join.parameter);
        }
        expectSameRow(*row++, join.report);
      }
    }
    EXPECT_EQ(row, inner.end());
  }
}

TEST(Audit, CountsOfKnownShapes) {
  const auto counts = [](const TopoDS_Shape& shape) {
    const AuditSummary summary = summarize(auditOf(shape).rows);
    return std::array{summary.kinds[0], summary.kinds[1], summary.kinds[2]};
  };
  EXPECT_EQ(counts(BRepPrimAPI_MakeBox(1, 2, 3).Shape()), (std::array<std::size_t, 3>{24, 0, 0}));
  // two circles of 4 quarters each, closed; the seam meets both ends of each
  EXPECT_EQ(counts(BRepPrimAPI_MakeCylinder(2, 5).Shape()), (std::array<std::size_t, 3>{4, 6, 2}));
  // a half circle of 2 quarters; both of its ends are poles, at which nothing else has a curve
  EXPECT_EQ(counts(BRepPrimAPI_MakeSphere(3).Shape()), (std::array<std::size_t, 3>{0, 1, 0}));
  EXPECT_EQ(counts(chainOf(50)), (std::array<std::size_t, 3>{49, 50, 0}));
}

TEST(Audit, RowsComeByTheHigherEdge) {
  const AuditReport report =
      auditOf(compoundOf(chainOf(20), BRepPrimAPI_MakeCylinder(2, 5).Shape()));
  for (std::size_t i = 1; i < report.rows.size(); ++i) {
    const AuditRow& before = report.rows[i - 1];
    const AuditRow& row = report.rows[i];
    EXPECT_LE(before.edges[1], row.edges[1]);
    EXPECT_LE(row.edges[0], row.edges[1]);
    if (before.edges[1] != row.edges[1]) continue;
    const auto rank = [](const AuditRow& r) { return (static_cast<int>(r.kind) + 2) % 3; };
    EXPECT_LE(rank(before), rank(row)) << "knots, then the seam, then vertices";
  }
}

TEST(Audit, MeasuresGapsOnTheCurves) {
  const TopoDS_Vertex shared = vertexAt({0, 0, 0});
  const TopoDS_Edge a =
      edgeBetween(lineCurve({-5, 0, 0}, {-3e-4, 0, 0}), vertexAt({-5, 0, 0}), shared);
  const TopoDS_Edge b =
      edgeBetween(lineCurve({2e-4, 0, 0}, {5, 0, 0}), shared, vertexAt({5, 0, 0}));
  const AuditReport report = auditOf(compoundOf(a, b));
  ASSERT_EQ(report.rows.size(), 1U);
  EXPECT_NEAR(report.rows[0].residuals[0], 5e-4, 1e-12);
  AuditOptions strict;
  strict.analysis.tolerances.gapMm = 4e-4;
  EXPECT_EQ(ShapeAudit(compoundOf(a, b), strict).report().rows[0].order, -1);
}

TEST(Audit, FollowsPlacements) {
  const TopoDS_Shape chain = chainOf(3);
  gp_Trsf placement;
  placement.SetRotation(gp_Ax1(gp_Pnt(1, 2, 3), gp_Dir(1, 1, 1)), 0.7);
  const AuditReport here = auditOf(chain);
  const AuditReport there = auditOf(chain.Moved(TopLoc_Location(placement)));
  ASSERT_EQ(there.rows.size(), here.rows.size());
  for (std::size_t i = 0; i < here.rows.size(); ++i) {
    const auto& [x, y, z] = here.rows[i].point;
    const gp_Pnt expected = gp_Pnt(x, y, z).Transformed(placement);
    EXPECT_NEAR(there.rows[i].point[0], expected.X(), 1e-12);
    EXPECT_EQ(there.rows[i].order, here.rows[i].order);
    EXPECT_NEAR(there.rows[i].residuals[2], here.rows[i].residuals[2], 1e-10);
  }
}

TEST(Audit, OneShapeInTwoPlacesHasTheEdgesOfBoth) {
  const TopoDS_Shape chain = chainOf(3);
  const AuditReport report = auditOf(compoundOf(chain, moved(chain, 100)));
  EXPECT_EQ(report.edgeCount, 6);
  EXPECT_EQ(report.rows.size(), 2 * auditOf(chain).rows.size());
}

TEST(Audit, TakesInternalAndExternalEdges) {
  const TopoDS_Vertex middle = vertexAt({0, 0, 0});
  for (const TopAbs_Orientation orientation : {TopAbs_INTERNAL, TopAbs_EXTERNAL}) {
    const TopoDS_Edge a = lineBetween(vertexAt({-5, 0, 0}), middle);
    const TopoDS_Shape b = lineBetween(middle, vertexAt({5, 0, 0})).Oriented(orientation);
    const std::vector<Place> expected{{1, 2, CurveEnd::kEnd, CurveEnd::kStart}};
    EXPECT_EQ(placesOf(auditOf(compoundOf(a, b)), JoinKind::kVertex), expected);
  }
}

TEST(Audit, TakesNoNoticeOfVerticesInsideAnEdge) {
  const TopoDS_Vertex inside = vertexAt({0, 0, 0});
  TopoDS_Edge a = lineBetween(vertexAt({-5, 0, 0}), vertexAt({5, 0, 0}));
  BRep_Builder().Add(a, inside.Oriented(TopAbs_INTERNAL));
  EXPECT_TRUE(auditOf(compoundOf(a, lineBetween(inside, vertexAt({0, 5, 0})))).rows.empty());
}

TEST(AuditSeam, OfClosedEdges) {
  const Handle(Geom_Circle) circle = new Geom_Circle(kAxes, 5);
  const double turn = 2.0 * std::numbers::pi;
  const TopoDS_Vertex vertex = vertexAt({6, 2, 3});
  TopoDS_Edge withVertex = edgeOf(circle, 0, turn);
  BRep_Builder().Add(withVertex, vertex.Oriented(TopAbs_FORWARD));
  BRep_Builder().Add(withVertex, vertex.Oriented(TopAbs_REVERSED));
  const TopoDS_Edge bare = edgeOf(circle, 0, turn);
  for (const TopoDS_Edge& edge : {withVertex, bare}) {
    const AuditReport report = auditOf(edge);
    ASSERT_EQ(report.rows.size(), 4U);
    EXPECT_EQ(report.rows[3].kind, JoinKind::kSeam);
    EXPECT_EQ(report.rows[3].ends, JoinEnds{});
    EXPECT_EQ(report.rows[3].order, 4);
  }
}

TEST(AuditSeam, WithAGap) {
  const TopoDS_Vertex vertex = vertexAt({0, 0, 0});
  const BSplineCurve almost(
      BezierCurve(std::vector<Vector3>{{0, 0, 0}, {9, 0, 0}, {0, 9, 0}, {0, 0.5, 0}}));
  const AuditReport report = auditOf(edgeBetween(almost, vertex, vertex));
  ASSERT_EQ(report.rows.size(), 1U);
  EXPECT_EQ(report.rows[0].kind, JoinKind::kSeam);
  EXPECT_EQ(report.rows[0].order, -1);
  EXPECT_NEAR(report.rows[0].residuals[0], 0.5, 1e-15);
}

TEST(AuditSeam, NotOfAnEdgeShorterThanTheTolerance) {
  EXPECT_TRUE(auditOf(lineBetween(vertexAt({0, 0, 0}), vertexAt({1e-4, 0, 0}))).rows.empty());
}

TEST(Audit, HasTheOrdersAskedFor) {
  for (const int order : {0, 2, 8}) {
    AuditOptions options;
    options.analysis.order = order;
    const ShapeAudit audit(chainOf(5), options);
    for (const AuditRow& row : audit.report().rows)
      EXPECT_LE(row.order, order);
  }
}

}  // namespace
}  // namespace osculate::test
