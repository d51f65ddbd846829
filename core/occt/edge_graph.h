// The edges of a shape and which of their ends meet; private to this floor.
#pragma once

#include <cstdint>
#include <vector>

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Shape.hxx>

#include "osculate/continuity/audit_report.h"

namespace osculate {

/// One end of an edge as one number: edges from 0 in the order of TopExp::MapShapes, the end in its
/// lowest bit.
class EdgeEnd {
 public:
  EdgeEnd() = default;
  EdgeEnd(int edge, CurveEnd end) : code_(2U * static_cast<std::uint32_t>(edge) + bit(end)) {}
  int edge() const { return static_cast<int>(code_ / 2U); }
  CurveEnd end() const { return code_ % 2U == 0 ? CurveEnd::kStart : CurveEnd::kEnd; }
  auto operator<=>(const EdgeEnd&) const = default;

 private:
  static std::uint32_t bit(CurveEnd end) { return end == CurveEnd::kEnd ? 1U : 0U; }
  std::uint32_t code_ = 0;
};

/// Two ends at one vertex, of two edges; the lower edge first.
struct EndPair {
  EdgeEnd low;
  EdgeEnd high;
  auto operator<=>(const EndPair&) const = default;
};

/// Edges and vertices are told apart as TopoDS_Shape::IsSame does: by what they share and by their
/// placement. Directions are those of the edges as TopExp::MapShapes delivers them.
///
/// Edges in no wire, as wireframe models have them, meet also where vertices of theirs are in one
/// place within `gapMm`, and where two vertices that are alone there are within `touchMm`.
class EdgeGraph {
 public:
  /// Throws OcctError for what OpenCASCADE throws.
  EdgeGraph(const TopoDS_Shape& shape, double gapMm, double touchMm);

  int edgeCount() const { return edges_.Extent(); }
  const TopoDS_Edge& edge(int index) const;
  bool isDegenerated(int index) const;
  /// Both ends of the edge are at one vertex.
  bool isClosed(int index) const;
  /// Neither end is at a vertex.
  bool isBare(int index) const;
  /// The pairs of ends of different edges at a vertex, by the higher edge, then by the rest; each
  /// once. Degenerated edges have none. kTangent gives the pairs of kAll. Throws
  /// std::invalid_argument where they are over 100 million.
  std::vector<EndPair> pairs(JoinPairs which) const;

 private:
  /// An edge as a wire walks it.
  struct EdgeUse {
    EdgeEnd begin;
    EdgeEnd end;
  };

  void addVertices(int edge, TopTools_IndexedMapOfShape& vertices);
  void mergeLoose(const TopTools_IndexedMapOfShape& vertices, double gapMm, double touchMm);
  /// Of the vertices of edges that are in no wire, and of no other edge.
  std::vector<int> looseVertices() const;
  int vertexOf(EdgeEnd end) const;
  /// The vertex, or the one that stands for all in its place.
  int placeOf(EdgeEnd end) const;
  std::vector<EndPair> pairsAtVertices(const std::vector<bool>& excluded) const;
  std::vector<EndPair> pairsInWires() const;
  std::vector<EdgeUse> usesOf(const TopoDS_Shape& wire) const;
  void addPairsOf(const std::vector<EdgeUse>& uses, std::vector<EndPair>& pairs) const;

  TopoDS_Shape shape_;
  TopTools_IndexedMapOfShape edges_;
  std::vector<int> vertices_;  ///< of every end, numbered from 0; -1: none
  std::vector<int> places_;    ///< of every vertex
  std::vector<bool> degenerated_;
};

}  // namespace osculate
