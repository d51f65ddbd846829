#include "osculate/occt/edge_graph.h"

#include <cmath>

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>

#include "occt/audit_shapes.h"
#include "support/errors.h"

namespace osculate::test {
namespace {

/// Two straight lines across each other, cut where they cross: four edges at one vertex.
TopoDS_Shape crossing() {
  const TopoDS_Vertex centre = vertexAt({0, 0, 0});
  const auto wire = [&](const Vector3& from, const Vector3& to) {
    return wireOf({lineBetween(vertexAt(from), centre), lineBetween(centre, vertexAt(to))});
  };
  return compoundOf(wire({-5, 0, 0}, {7, 0, 0}), wire({0, -5, 0}, {0, 7, 0}));
}

/// Lines one after the other along x, each with vertices of its own, `gap` mm apart.
std::vector<TopoDS_Edge> separateLines(int count, double gap) {
  std::vector<TopoDS_Edge> lines;
  for (int i = 0; i < count; ++i)
    lines.push_back(
        lineBetween(vertexAt({10.0 * i, 0, 0}), vertexAt({10.0 * i + 10.0 - gap, 0, 0})));
  return lines;
}

TopoDS_Compound separate(const std::vector<TopoDS_Edge>& edges) {
  TopoDS_Compound compound = compoundOf();
  for (const TopoDS_Edge& edge : edges)
    BRep_Builder().Add(compound, edge);
  return compound;
}

TEST(AuditPairs, OfACrossing) {
  using enum CurveEnd;
  const std::vector<Place> straightOn{{1, 2, kEnd, kStart}, {3, 4, kEnd, kStart}};
  EXPECT_EQ(auditOf(crossing(), JoinPairs::kAll).rows.size(), 6U);
  EXPECT_EQ(placesOf(auditOf(crossing(), JoinPairs::kWire), JoinKind::kVertex), straightOn);
  const AuditReport tangent = auditOf(crossing(), JoinPairs::kTangent);
  EXPECT_EQ(placesOf(tangent, JoinKind::kVertex), straightOn);
  EXPECT_EQ(tangent.corners, 4U);
}

TEST(AuditPairs, OfABoxAreTheSameInItsWires) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 2, 3).Shape();
  EXPECT_EQ(placesOf(auditOf(box, JoinPairs::kWire), JoinKind::kVertex),
            placesOf(auditOf(box, JoinPairs::kAll), JoinKind::kVertex));
  EXPECT_EQ(auditOf(box, JoinPairs::kTangent).corners, 24U);
}

TEST(AuditPairs, InAWireWhateverTheOrderAndTheDirectionsOfItsEdges) {
  const std::vector<TopoDS_Vertex> v{vertexAt({0, 0, 0}), vertexAt({1, 0, 0}), vertexAt({1, 1, 0}),
                                     vertexAt({0, 1, 0})};
  const TopoDS_Edge a = lineBetween(v[0], v[1]);
  const TopoDS_Edge b = TopoDS::Edge(lineBetween(v[2], v[1]).Reversed());
  const TopoDS_Edge c = lineBetween(v[2], v[3]);
  const TopoDS_Edge d = TopoDS::Edge(lineBetween(v[0], v[3]).Reversed());
  for (const auto& order : {std::vector{a, b, c, d}, std::vector{c, a, d, b}}) {
    for (const bool reversed : {false, true}) {
      TopoDS_Shape wire = wireOf(order);
      if (reversed) wire.Reverse();
      const AuditReport report = auditOf(wire, JoinPairs::kWire);
      const std::vector<Place> places = placesOf(report, JoinKind::kVertex);
      EXPECT_EQ(std::set<Place>(places.begin(), places.end()), placesByComparison(edgesOf(wire)));
      EXPECT_EQ(places.size(), 4U);
    }
  }
}

TEST(AuditPairs, OfEdgesInNoWireAreThoseWithEachOther) {
  const TopoDS_Vertex centre = vertexAt({0, 0, 0});
  const TopoDS_Edge a = lineBetween(vertexAt({-1, 0, 0}), centre);
  const TopoDS_Edge b = lineBetween(centre, vertexAt({1, 0, 0}));
  const TopoDS_Edge c = lineBetween(centre, vertexAt({0, 1, 0}));
  EXPECT_EQ(auditOf(compoundOf(a, b, c), JoinPairs::kWire).rows.size(), 3U);
  EXPECT_EQ(auditOf(compoundOf(wireOf({a, b}), c), JoinPairs::kWire).rows.size(), 1U);
}

TEST(AuditPairs, OfASeamInItsWire) {
  // each circle meets the seam at both of its ends, and itself
  const AuditReport report = auditOf(BRepPrimAPI_MakeCylinder(2, 5).Shape(), JoinPairs::kWire);
  EXPECT_EQ(placesOf(report, JoinKind::kVertex).size(), 4U);
  EXPECT_EQ(placesOf(report, JoinKind::kSeam).size(), 2U);
}

TEST(AuditPairs, ACornerWithAGapCounts) {
  const TopoDS_Vertex centre = vertexAt({0, 0, 0});
  const TopoDS_Edge a =
      edgeBetween(lineCurve({-5, 0, 0}, {-0.01, 0, 0}), vertexAt({-5, 0, 0}), centre);
  const TopoDS_Edge b = lineBetween(centre, vertexAt({0, 5, 0}));
  const AuditReport report = auditOf(compoundOf(a, b), JoinPairs::kTangent);
  ASSERT_EQ(report.rows.size(), 1U);
  EXPECT_EQ(report.rows[0].order, -1);
  EXPECT_EQ(report.corners, 0U);
}

TEST(AuditPairs, OfTheCornerAngleAskedFor) {
  AuditOptions options;
  options.pairs = JoinPairs::kTangent;
  const TopoDS_Vertex centre = vertexAt({0, 0, 0});
  const TopoDS_Shape bent = compoundOf(lineBetween(vertexAt({-1, 0, 0}), centre),
                                       lineBetween(centre, vertexAt({1, 0.5, 0})));  // 26.57 deg
  for (const double angle : {26.0, 27.0}) {
    options.cornerDegrees = angle;
    EXPECT_EQ(ShapeAudit(bent, options).report().rows.size(), angle > 26.57 ? 1U : 0U);
  }
}

TEST(AuditPairs, AStarThatNothingCanHoldIsRefused) {
  const TopoDS_Vertex centre = vertexAt({0, 0, 0});
  TopoDS_Compound star = compoundOf();
  for (int i = 0; i < 15000; ++i)
    BRep_Builder().Add(star, lineBetween(centre, vertexAt({std::cos(i), std::sin(i), 1})));
  EXPECT_ERROR(auditOf(star),
               "pairs: over 100 million pairs of edges meet at vertices (15000 edges");
}

TEST(AuditLoose, EdgesInNoWireMeetWhereTheirVerticesLie) {
  using enum CurveEnd;
  const std::vector<Place> along{{1, 2, kEnd, kStart}, {2, 3, kEnd, kStart}};
  for (const double gap : {0.0, 5e-4, 0.009}) {
    const AuditReport report = auditOf(separate(separateLines(3, gap)));
    EXPECT_EQ(placesOf(report, JoinKind::kVertex), along) << gap;
    EXPECT_EQ(report.rows[0].order, gap > 1e-3 ? -1 : 4);
    EXPECT_NEAR(report.rows[0].residuals[0], gap, 1e-14);
    EXPECT_EQ(
        placesOf(auditOf(separate(separateLines(3, gap)), JoinPairs::kWire), JoinKind::kVertex),
        along);
  }
  EXPECT_TRUE(auditOf(separate(separateLines(3, 0.011))).rows.empty());
}

TEST(AuditLoose, NotWhereOneIsInAWire) {
  const std::vector<TopoDS_Edge> lines = separateLines(3, 0.0);
  EXPECT_TRUE(auditOf(compoundOf(wireOf({lines[0]}), wireOf({lines[1], lines[2]}))).rows.empty());
  EXPECT_TRUE(auditOf(compoundOf(wireOf({lines[0]}), lines[1])).rows.empty());
}

TEST(AuditLoose, OnlyWhereItIsWanted) {
  AuditOptions options;
  options.touchMm = 0.0;
  EXPECT_TRUE(ShapeAudit(separate(separateLines(3, 0.0)), options).report().rows.empty());
  options.touchMm = 1.0;
  EXPECT_EQ(ShapeAudit(separate(separateLines(3, 0.9)), options).report().rows.size(), 2U);
}

TEST(AuditLoose, AnEndThatMeetsAnotherLooksNoFarther) {
  // a and b meet; c begins 0.005 mm away from them, and nothing is there for it
  const TopoDS_Edge a = lineBetween(vertexAt({-5, 0, 0}), vertexAt({0, 0, 0}));
  const TopoDS_Edge b = lineBetween(vertexAt({0, 0, 0}), vertexAt({5, 0, 0}));
  const TopoDS_Edge c = lineBetween(vertexAt({0, 0.005, 0}), vertexAt({0, 5, 0}));
  EXPECT_EQ(auditOf(compoundOf(a, b, c)).rows.size(), 1U);
}

TEST(AuditLoose, AShortEdgeJoinsItsNeighboursAndNotItself) {
  const std::vector<TopoDS_Edge> edges{lineBetween(vertexAt({-5, 0, 0}), vertexAt({0, 0, 0})),
                                       lineBetween(vertexAt({0, 0, 0}), vertexAt({0.005, 0, 0})),
                                       lineBetween(vertexAt({0.005, 0, 0}), vertexAt({5, 0, 0}))};
  const AuditReport report = auditOf(separate(edges));
  EXPECT_EQ(report.rows.size(), 2U);
  EXPECT_TRUE(placesOf(report, JoinKind::kSeam).empty());
}

TEST(AuditLoose, IsLinearInTheEdges) {
  const TopoDS_Compound shape = separate(separateLines(20000, 0.0));
  const AuditReport report = auditOf(shape);
  EXPECT_EQ(report.rows.size(), 19999U);
}

}  // namespace
}  // namespace osculate::test
