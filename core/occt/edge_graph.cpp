#include "osculate/occt/edge_graph.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>

#include "osculate/occt/near_points.h"
#include "osculate/occt/occt_error.h"

namespace osculate {

namespace {

/// Adds a pair of ends of different edges with the lower edge first.
void addPair(EdgeEnd a, EdgeEnd b, std::vector<EndPair>& pairs) {
  if (a.edge() != b.edge()) pairs.push_back(a < b ? EndPair{a, b} : EndPair{b, a});
}

/// A star of very many edges has more pairs than anything can hold. `counts[v + 1]` ends are at
/// the vertex v.
void checkPairCount(const std::vector<std::size_t>& counts) {
  constexpr std::size_t kMost = 100'000'000;
  std::size_t sum = 0;
  for (const std::size_t count : counts) {
    sum += count == 0 ? 0 : count * (count - 1) / 2;
    if (sum <= kMost) continue;
    throw std::invalid_argument("pairs: over 100 million pairs of edges meet at vertices (" +
                                std::to_string(count) +
                                " edges at one); ask for those in wires alone (pairs = wire)");
  }
}

}  // namespace

EdgeGraph::EdgeGraph(const TopoDS_Shape& shape, double gapMm, double touchMm) : shape_(shape) {
  translateFailures([&] {
    TopExp::MapShapes(shape, TopAbs_EDGE, edges_);
    const auto count = static_cast<std::size_t>(edges_.Extent());
    vertices_.assign(2 * count, -1);
    degenerated_.assign(count, false);
    TopTools_IndexedMapOfShape vertices;
    vertices.ReSize(edges_.Extent());
    for (int i = 0; i < edges_.Extent(); ++i) {
      degenerated_[static_cast<std::size_t>(i)] = BRep_Tool::Degenerated(edge(i));
      addVertices(i, vertices);
    }
    places_.resize(static_cast<std::size_t>(vertices.Extent()));
    std::iota(places_.begin(), places_.end(), 0);
    if (touchMm > 0.0) mergeLoose(vertices, gapMm, touchMm);
  });
}

const TopoDS_Edge& EdgeGraph::edge(int index) const { return TopoDS::Edge(edges_(index + 1)); }

bool EdgeGraph::isDegenerated(int index) const {
  return degenerated_[static_cast<std::size_t>(index)];
}

int EdgeGraph::vertexOf(EdgeEnd end) const {
  const std::size_t start = 2 * static_cast<std::size_t>(end.edge());
  return vertices_[start + (end.end() == CurveEnd::kEnd ? 1 : 0)];
}

int EdgeGraph::placeOf(EdgeEnd end) const {
  const int vertex = vertexOf(end);
  return vertex < 0 ? vertex : places_[static_cast<std::size_t>(vertex)];
}

bool EdgeGraph::isClosed(int index) const {
  const int start = vertexOf({index, CurveEnd::kStart});
  return start >= 0 && start == vertexOf({index, CurveEnd::kEnd});
}

bool EdgeGraph::isBare(int index) const {
  return vertexOf({index, CurveEnd::kStart}) < 0 && vertexOf({index, CurveEnd::kEnd}) < 0;
}

void EdgeGraph::addVertices(int index, TopTools_IndexedMapOfShape& vertices) {
  const TopoDS_Edge& edge = this->edge(index);
  const bool reversed = edge.Orientation() == TopAbs_REVERSED;
  // orientations as stored in the edge: composed with an internal edge's they would all be internal
  for (TopoDS_Iterator it(edge, Standard_False); it.More(); it.Next()) {
    const TopAbs_Orientation orientation = it.Value().Orientation();
    if (orientation != TopAbs_FORWARD && orientation != TopAbs_REVERSED) continue;
    const bool isStart = (orientation == TopAbs_FORWARD) != reversed;
    int& vertex = vertices_[2 * static_cast<std::size_t>(index) + (isStart ? 0 : 1)];
    if (vertex < 0) vertex = vertices.Add(it.Value()) - 1;
  }
}

std::vector<int> EdgeGraph::looseVertices() const {
  std::vector<bool> isLooseEdge(static_cast<std::size_t>(edgeCount()), false);
  for (TopExp_Explorer it(shape_, TopAbs_EDGE, TopAbs_WIRE); it.More(); it.Next())
    isLooseEdge[static_cast<std::size_t>(edges_.FindIndex(it.Current()) - 1)] = true;
  std::vector<bool> isLoose(places_.size(), true);
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    if (vertices_[i] >= 0 && !isLooseEdge[i / 2])
      isLoose[static_cast<std::size_t>(vertices_[i])] = false;
  }
  std::vector<int> loose;
  for (std::size_t vertex = 0; vertex < isLoose.size(); ++vertex) {
    if (isLoose[vertex]) loose.push_back(static_cast<int>(vertex));
  }
  return loose;
}

void EdgeGraph::mergeLoose(const TopTools_IndexedMapOfShape& vertices, double gapMm,
                           double touchMm) {
  const auto pointsOf = [&](const std::vector<int>& chosen) {
    std::vector<Vector3> points;
    for (const int vertex : chosen) {
      const gp_Pnt point = BRep_Tool::Pnt(TopoDS::Vertex(vertices(vertex + 1)));
      points.emplace_back(point.X(), point.Y(), point.Z());
    }
    return points;
  };
  const std::vector<int> loose = looseVertices();
  const std::vector<int> first = mergePoints(pointsOf(loose), gapMm);
  for (std::size_t i = 0; i < loose.size(); ++i) {
    places_[static_cast<std::size_t>(loose[i])] = loose[static_cast<std::size_t>(first[i])];
  }
  // a place with one end looks farther
  std::vector<int> ends(places_.size(), 0);
  for (const int vertex : vertices_) {
    if (vertex >= 0) ++ends[static_cast<std::size_t>(places_[static_cast<std::size_t>(vertex)])];
  }
  std::vector<int> lonely;
  std::copy_if(loose.begin(), loose.end(), std::back_inserter(lonely),
               [&](int vertex) { return ends[static_cast<std::size_t>(vertex)] == 1; });
  for (const auto& [a, b] : matchPoints(pointsOf(lonely), touchMm))
    places_[static_cast<std::size_t>(lonely[static_cast<std::size_t>(b)])] =
        lonely[static_cast<std::size_t>(a)];
}

std::vector<EndPair> EdgeGraph::pairs(JoinPairs which) const {
  if (which == JoinPairs::kWire) return translateFailures([&] { return pairsInWires(); });
  return pairsAtVertices(degenerated_);
}

std::vector<EndPair> EdgeGraph::pairsAtVertices(const std::vector<bool>& excluded) const {
  const auto forEachEnd = [&](auto&& visit) {
    for (int edge = 0; edge < edgeCount(); ++edge) {
      if (excluded[static_cast<std::size_t>(edge)]) continue;
      for (const CurveEnd side : {CurveEnd::kStart, CurveEnd::kEnd}) {
        const int place = placeOf({edge, side});
        if (place >= 0) visit(static_cast<std::size_t>(place), EdgeEnd(edge, side));
      }
    }
  };
  // the ends in each place, in the order of the edges: counted, then filed
  std::vector<std::size_t> first(places_.size() + 1, 0);
  forEachEnd([&](std::size_t place, EdgeEnd) { ++first[place + 1]; });
  checkPairCount(first);
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<EdgeEnd> ends(first.back());
  std::vector<std::size_t> filed(first.begin(), first.end());
  std::vector<EndPair> pairs;
  // every end pairs with those filed in its place before it, of lower edges
  forEachEnd([&](std::size_t place, EdgeEnd high) {
    for (std::size_t i = first[place]; i < filed[place]; ++i)
      addPair(ends[i], high, pairs);
    ends[filed[place]++] = high;
  });
  return pairs;
}

std::vector<EdgeGraph::EdgeUse> EdgeGraph::usesOf(const TopoDS_Shape& wire) const {
  std::vector<EdgeUse> uses;
  for (TopoDS_Iterator it(wire, Standard_False); it.More(); it.Next()) {
    const int index = edges_.FindIndex(it.Value()) - 1;
    if (index < 0 || isDegenerated(index)) continue;
    const bool along = it.Value().Orientation() == edge(index).Orientation();
    uses.push_back({{index, along ? CurveEnd::kStart : CurveEnd::kEnd},
                    {index, along ? CurveEnd::kEnd : CurveEnd::kStart}});
  }
  return uses;
}

void EdgeGraph::addPairsOf(const std::vector<EdgeUse>& uses, std::vector<EndPair>& pairs) const {
  std::vector<std::pair<int, EdgeEnd>> begins;  // with their vertex
  for (const EdgeUse& use : uses)
    begins.emplace_back(vertexOf(use.begin), use.begin);
  std::sort(begins.begin(), begins.end());
  for (std::size_t k = 0; k < uses.size(); ++k) {
    const EdgeEnd arriving = uses[k].end;
    const int vertex = vertexOf(arriving);
    if (vertex < 0) continue;
    // where the wire's list is in order the next edge follows; elsewhere every one that can
    const EdgeEnd next = uses[(k + 1) % uses.size()].begin;
    if (vertexOf(next) == vertex && next != arriving) {
      addPair(arriving, next, pairs);
      continue;
    }
    auto it = std::lower_bound(begins.begin(), begins.end(), std::pair(vertex, EdgeEnd()));
    for (; it != begins.end() && it->first == vertex; ++it)
      addPair(arriving, it->second, pairs);
  }
}

std::vector<EndPair> EdgeGraph::pairsInWires() const {
  TopTools_IndexedMapOfShape wires;
  TopExp::MapShapes(shape_, TopAbs_WIRE, wires);
  std::vector<bool> inWire = degenerated_;
  std::vector<EndPair> pairs;
  for (int i = 1; i <= wires.Extent(); ++i) {
    const std::vector<EdgeUse> uses = usesOf(wires(i));
    for (const EdgeUse& use : uses)
      inWire[static_cast<std::size_t>(use.begin.edge())] = true;
    addPairsOf(uses, pairs);
  }
  const std::vector<EndPair> loose = pairsAtVertices(inWire);
  pairs.insert(pairs.end(), loose.begin(), loose.end());
  std::sort(pairs.begin(), pairs.end(), [](const EndPair& a, const EndPair& b) {
    return a.high != b.high ? a.high < b.high : a.low < b.low;
  });
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

}  // namespace osculate
