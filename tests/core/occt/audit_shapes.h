// Shapes to audit, and the joins they have by a second, slow method.
#pragma once

#include <algorithm>
#include <set>
#include <tuple>
#include <vector>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>

#include "occt/edge_samples.h"
#include "osculate/occt/audit.h"

namespace osculate::test {

inline TopoDS_Vertex vertexAt(const Vector3& point) {
  TopoDS_Vertex vertex;
  BRep_Builder().MakeVertex(vertex, gp_Pnt(point.x(), point.y(), point.z()), 1e-7);
  return vertex;
}

/// An edge of the curve between vertices, wherever they are: nothing is checked.
inline TopoDS_Edge edgeBetween(const BSplineCurve& curve, const TopoDS_Vertex& start,
                               const TopoDS_Vertex& end) {
  TopoDS_Edge edge = edgeOf(geomFrom(curve.data()), curve.first(), curve.last());
  BRep_Builder builder;
  builder.Add(edge, start.Oriented(TopAbs_FORWARD));
  builder.Add(edge, end.Oriented(TopAbs_REVERSED));
  return edge;
}

inline BSplineCurve lineCurve(const Vector3& a, const Vector3& b) {
  return BSplineCurve(BezierCurve(std::vector<Vector3>{a, b}));
}

inline TopoDS_Edge lineBetween(const TopoDS_Vertex& start, const TopoDS_Vertex& end) {
  return edgeBetween(
      lineCurve(toVector(BRep_Tool::Pnt(start).XYZ()), toVector(BRep_Tool::Pnt(end).XYZ())), start,
      end);
}

template <class... Shapes>
TopoDS_Compound compoundOf(const Shapes&... shapes) {
  TopoDS_Compound compound;
  BRep_Builder builder;
  builder.MakeCompound(compound);
  (builder.Add(compound, shapes), ...);
  return compound;
}

inline TopoDS_Wire wireOf(const std::vector<TopoDS_Edge>& edges) {
  TopoDS_Wire wire;
  BRep_Builder builder;
  builder.MakeWire(wire);
  for (const TopoDS_Edge& edge : edges)
    builder.Add(wire, edge);
  return wire;
}

/// Cubic edges one after the other, each with an inner knot, in one wire; G1 at the vertices.
inline TopoDS_Wire chainOf(int count) {
  std::vector<TopoDS_Edge> edges;
  TopoDS_Vertex start = vertexAt({0, 0, 0});
  for (int i = 0; i < count; ++i) {
    const double x = 10.0 * i;
    const double up = i % 2 == 0 ? 1.0 : -1.0;
    const TopoDS_Vertex end = vertexAt({x + 10, 0, 0});
    const BSplineData data{
        .poles = columns(
            {{x, 0, 0}, {x + 2, up, 0}, {x + 5, 3 * up, 1}, {x + 8, up, 0}, {x + 10, 0, 0}}),
        .weights = {},
        .knots = {{0, 1, 3}, {4, 1, 4}},
        .degree = 3,
        .periodic = false,
        .poleError = 0.0};
    edges.push_back(edgeBetween(BSplineCurve(data), start, end));
    start = end;
  }
  return wireOf(edges);
}

inline std::vector<TopoDS_Edge> edgesOf(const TopoDS_Shape& shape) {
  TopTools_IndexedMapOfShape map;
  TopExp::MapShapes(shape, TopAbs_EDGE, map);
  std::vector<TopoDS_Edge> edges;
  for (int i = 1; i <= map.Extent(); ++i)
    edges.push_back(TopoDS::Edge(map(i)));
  return edges;
}

/// Two edge numbers and the ends that meet.
using Place = std::tuple<int, int, CurveEnd, CurveEnd>;

inline Place placeOf(const AuditRow& row) {
  return {row.edges[0], row.edges[1], row.ends.first, row.ends.second};
}

inline std::vector<Place> placesOf(const AuditReport& report, JoinKind kind) {
  std::vector<Place> places;
  for (const AuditRow& row : report.rows) {
    if (row.kind == kind) places.push_back(placeOf(row));
  }
  return places;
}

/// Every two ends of different edges that are one vertex, by comparing each with each.
inline std::set<Place> placesByComparison(const std::vector<TopoDS_Edge>& edges) {
  const auto vertexOf = [](const TopoDS_Edge& edge, CurveEnd end) {
    return end == CurveEnd::kStart ? TopExp::FirstVertex(edge, Standard_True)
                                   : TopExp::LastVertex(edge, Standard_True);
  };
  std::set<Place> places;
  for (std::size_t a = 0; a < edges.size(); ++a) {
    for (std::size_t b = a + 1; b < edges.size(); ++b) {
      if (BRep_Tool::Degenerated(edges[a]) || BRep_Tool::Degenerated(edges[b])) continue;
      for (const CurveEnd first : {CurveEnd::kStart, CurveEnd::kEnd}) {
        for (const CurveEnd second : {CurveEnd::kStart, CurveEnd::kEnd}) {
          const TopoDS_Vertex vertex = vertexOf(edges[a], first);
          if (vertex.IsNull() || !vertex.IsSame(vertexOf(edges[b], second))) continue;
          places.emplace(static_cast<int>(a) + 1, static_cast<int>(b) + 1, first, second);
        }
      }
    }
  }
  return places;
}

inline AuditReport auditOf(const TopoDS_Shape& shape, JoinPairs pairs = JoinPairs::kAll,
                           int threads = 2) {
  AuditOptions options;
  options.pairs = pairs;
  options.threads = threads;
  return ShapeAudit(shape, options).takeReport();
}

}  // namespace osculate::test
