#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <unordered_map>

#include "osculate/bezier/vector3.h"
#include "osculate/solid/mesh.h"

namespace osculate {

namespace {

using Edge = std::uint64_t;

Edge edgeOf(int a, int b) {
  const auto [low, high] = std::minmax(a, b);
  return static_cast<Edge>(low) << 32U | static_cast<Edge>(static_cast<std::uint32_t>(high));
}

/// Distance of a point from a triangle (Ericson, Real-Time Collision Detection, 2005, sec. 5.1.5).
double distanceToTriangle(const Vector3& p, const Vector3& a, const Vector3& b, const Vector3& c) {
  const Vector3 ab = b - a;
  const Vector3 ac = c - a;
  const Vector3 normal = ab.cross(ac);
  const auto distanceToSegment = [&](const Vector3& from, const Vector3& along) {
    const double length2 = along.squaredNorm();
    const double t = length2 > 0.0 ? std::clamp((p - from).dot(along) / length2, 0.0, 1.0) : 0.0;
    return (p - from - t * along).norm();
  };
  const double area2 = normal.squaredNorm();
  if (area2 > 0.0) {
    const double v = normal.dot((p - a).cross(ac)) / area2;
    const double w = normal.dot(ab.cross(p - a)) / area2;
    if (v >= 0.0 && w >= 0.0 && v + w <= 1.0) return std::abs(normal.dot(p - a)) / std::sqrt(area2);
  }
  return std::min(
      {distanceToSegment(a, ab), distanceToSegment(a, ac), distanceToSegment(b, c - b)});
}

struct Element {
  std::array<int, 4> vertices;
  /// The face of the solid that the side opposite to each vertex lies on, or -1.
  std::array<int, 4> faces;
};

class Mesher {
 public:
  Mesher(const BezierTetrahedron& solid, double chordalMm, int maxTetrahedra)
      : solid_(solid), chordalMm_(chordalMm), maxTetrahedra_(maxTetrahedra) {
    for (int corner = 0; corner < 4; ++corner) {
      faceNets_.push_back(faceNet<4>(solid.homogeneousWithWeights(), solid.degree(), corner));
      addVertex(Barycentric<4>::Unit(corner));
    }
    addElement({{0, 1, 2, 3}, {0, 1, 2, 3}});
  }

  SolidMesh run() {
    for (std::size_t i = 0; i < elements_.size(); ++i) {
      while (isTooCoarse(elements_[i])) {
        refineAlongPath(i);
        checkSize();
      }
    }
    // halving a neighbour can change elements already looked at only to finer ones, whose parts of
    // a face lie in the hull of the old part but not always as near to their own triangles
    for (bool changed = true; changed;) {
      changed = false;
      for (std::size_t i = 0; i < elements_.size(); ++i) {
        if (!isTooCoarse(elements_[i])) continue;
        refineAlongPath(i);
        checkSize();
        changed = true;
      }
    }
    return result();
  }

 private:
  int addVertex(const Barycentric<4>& u) {
    coordinates_.push_back(u);
    const SpacePoint point = solid_.evaluate(u);
    if (!point.allFinite())
      throw std::invalid_argument("mesh: the solid has no point at a corner (weight 0)");
    points_.emplace_back(point);
    return static_cast<int>(points_.size()) - 1;
  }

  void addElement(const Element& element) {
    elements_.push_back(element);
    link(elements_.size() - 1);
  }
  template <class F>
  static void forEdges(const Element& element, F f) {
    for (std::size_t a = 0; a < 4; ++a) {
      for (std::size_t b = a + 1; b < 4; ++b)
        f(edgeOf(element.vertices[a], element.vertices[b]));
    }
  }
  void link(std::size_t i) {
    forEdges(elements_[i], [&](Edge edge) { around_[edge].push_back(i); });
  }
  void unlink(std::size_t i) {
    forEdges(elements_[i], [&](Edge edge) { std::erase(around_[edge], i); });
  }

  /// Vertices by number, a total order of the edges: no two elements see a shared edge differently.
  bool isLonger(Edge a, Edge b) const {
    const double la = squaredLength(a);
    const double lb = squaredLength(b);
    return la != lb ? la > lb : a > b;
  }
  double squaredLength(Edge edge) const {
    const auto a = static_cast<std::size_t>(edge >> 32U);
    const auto b = static_cast<std::size_t>(edge & 0xffffffffU);
    // in the domain, so that a collapsed edge of the solid is halved too
    return (coordinates_[a] - coordinates_[b]).squaredNorm();
  }
  Edge longestEdge(const Element& element) const {
    Edge longest = edgeOf(element.vertices[0], element.vertices[1]);
    forEdges(element, [&](Edge edge) {
      if (isLonger(edge, longest)) longest = edge;
    });
    return longest;
  }

  /// Halves the longest edge of the element, and before it the longer edges of those around it.
  void refineAlongPath(std::size_t i) {
    std::vector<Edge> path{longestEdge(elements_[i])};
    while (!path.empty()) {
      const Edge edge = path.back();
      const auto& ring = around_[edge];
      const auto longer = std::find_if(ring.begin(), ring.end(), [&](std::size_t e) {
        return longestEdge(elements_[e]) != edge;
      });
      if (longer == ring.end()) {
        halve(edge);
        path.pop_back();
      } else {
        path.push_back(longestEdge(elements_[*longer]));
      }
    }
  }

  void halve(Edge edge) {
    const std::vector<std::size_t> ring = around_[edge];
    if (ring.empty()) return;  // was halved on the way
    const auto a = static_cast<int>(edge >> 32U);
    const auto b = static_cast<int>(edge & 0xffffffffU);
    const int middle = addVertex(0.5 * (coordinates_[static_cast<std::size_t>(a)] +
                                        coordinates_[static_cast<std::size_t>(b)]));
    for (const std::size_t i : ring) {
      unlink(i);
      Element first = elements_[i];
      Element second = first;
      replace(first, b, a, middle);
      replace(second, a, b, middle);
      elements_[i] = first;
      link(i);
      addElement(second);
    }
  }

  /// The side opposite to the vertex that stays is the cut, which is no face of the solid.
  static void replace(Element& element, int from, int kept, int to) {
    for (std::size_t c = 0; c < 4; ++c) {
      if (element.vertices[c] == kept) element.faces[c] = -1;
    }
    for (int& vertex : element.vertices) {
      if (vertex == from) vertex = to;
    }
  }

  bool isTooCoarse(const Element& element) const {
    for (std::size_t c = 0; c < 4; ++c) {
      if (element.faces[c] >= 0 && faceDeviation(element, c) > chordalMm_) return true;
    }
    return false;
  }

  /// The largest distance of a control point of the part of the face from its triangle.
  double faceDeviation(const Element& element, std::size_t opposite) const {
    const int solidFace = element.faces[opposite];
    PartCornersOf<3> corners;
    std::array<const Vector3*, 3> triangle{};
    std::size_t next = 0;
    for (std::size_t c = 0; c < 4; ++c) {
      if (c == opposite) continue;
      const auto vertex = static_cast<std::size_t>(element.vertices[c]);
      for (int k = 0, to = 0; k < 4; ++k) {
        if (k != solidFace) corners[next][to++] = coordinates_[vertex][k];
      }
      triangle[next++] = &points_[vertex];
    }
    const SimplexNet part =
        partNet<3, 3>(faceNets_[static_cast<std::size_t>(solidFace)], solid_.degree(), corners);
    double deviation = 0.0;
    for (Eigen::Index i = 0; i < part.cols(); ++i) {
      if (!(part(3, i) > 0.0)) continue;
      const Vector3 point = part.col(i).head<3>() / part(3, i);
      deviation =
          std::max(deviation, distanceToTriangle(point, *triangle[0], *triangle[1], *triangle[2]));
    }
    return deviation;
  }

  void checkSize() const {
    if (static_cast<int>(elements_.size()) > maxTetrahedra_) {
      throw std::runtime_error("mesh: needs more than " + std::to_string(maxTetrahedra_) +
                               " tetrahedra; allow a larger chordal deviation");
    }
  }

  SolidMesh result() const {
    SolidMesh mesh;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      mesh.points.insert(mesh.points.end(), points_[i].data(), points_[i].data() + 3);
      mesh.coordinates.insert(mesh.coordinates.end(), coordinates_[i].data(),
                              coordinates_[i].data() + 4);
    }
    for (const Element& element : elements_) {
      mesh.tetrahedra.insert(mesh.tetrahedra.end(), element.vertices.begin(),
                             element.vertices.end());
      for (std::size_t c = 0; c < 4; ++c) {
        if (element.faces[c] < 0) continue;
        // the side opposite to vertex c turns left seen from outside in this order
        static constexpr std::array<std::array<std::size_t, 3>, 4> kSides{
            {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};
        for (const std::size_t k : kSides[c])
          mesh.triangles.push_back(element.vertices[k]);
        mesh.triangleFaces.push_back(element.faces[c]);
      }
    }
    return mesh;
  }

  const BezierTetrahedron& solid_;
  double chordalMm_;
  int maxTetrahedra_;
  std::vector<SimplexNet> faceNets_;
  std::vector<Barycentric<4>> coordinates_;
  std::vector<Vector3> points_;
  std::vector<Element> elements_;
  std::unordered_map<Edge, std::vector<std::size_t>> around_;
};

}  // namespace

SolidMesh adaptiveMesh(const BezierTetrahedron& solid, double chordalMm, int maxTetrahedra) {
  if (!(std::isfinite(chordalMm) && chordalMm > 0.0)) {
    throw std::invalid_argument("chordal_mm: must be finite and > 0, got " +
                                std::to_string(chordalMm));
  }
  if (solid.dimension() != 3)
    throw std::invalid_argument("mesh: of a solid in E3; project it from E4 first");
  return Mesher(solid, chordalMm, maxTetrahedra).run();
}

}  // namespace osculate
