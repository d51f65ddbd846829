#include "osculate/solid/vtu.h"

#include <array>
#include <charconv>
#include <stdexcept>
#include <string>

namespace osculate {

namespace {

constexpr int kVtkBezierTetrahedron = 78;  // vtkCellType.h

/// VTK counts barycentric coordinates (r, s, t, rest) with corner 0 at rest = 1: ours are (rest, r,
/// s, t).
int netPosition(const std::array<int, 4>& vtk) {
  return netIndex<4>({vtk[3], vtk[0], vtk[1], vtk[2]});
}

// The tables of vtkHigherOrderTetra: corners by the coordinate that is largest there, edges by
// their corners, faces by the coordinates that vary in them and the one that is least.
constexpr std::array<std::size_t, 4> kCornerCoordinate{3, 0, 1, 2};
constexpr std::array<std::array<std::size_t, 2>, 6> kEdgeCorners{
    {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};
constexpr std::array<std::array<std::size_t, 3>, 4> kFaceCoordinates{
    {{0, 2, 3}, {2, 0, 1}, {2, 1, 3}, {1, 0, 3}}};
constexpr std::array<std::size_t, 4> kFaceLeast{1, 3, 0, 2};

/// The points of a triangle of this degree in the order of vtkHigherOrderTriangle, least coordinate
/// `least` and largest `least + degree`.
void addTriangle(int degree, int least, std::vector<std::array<int, 3>>& points) {
  if (degree < 0) return;
  if (degree == 0) {
    points.push_back({least, least, least});
    return;
  }
  for (std::size_t corner = 0; corner < 3; ++corner) {
    std::array<int, 3> point{least, least, least};
    point[(corner + 2) % 3] = least + degree;
    points.push_back(point);
  }
  for (std::size_t edge = 0; edge < 3; ++edge) {
    for (int i = 1; i < degree; ++i) {
      std::array<int, 3> point{least, least, least};
      point[(edge + 2) % 3] = least + degree - i;
      point[edge] = least + i;
      points.push_back(point);
    }
  }
  addTriangle(degree - 3, least + 1, points);
}

void addTetrahedron(int degree, int least, std::vector<int>& order) {
  if (degree < 0) return;
  const auto start = std::array<int, 4>{least, least, least, least};
  if (degree == 0) {
    order.push_back(netPosition(start));
    return;
  }
  for (const std::size_t coordinate : kCornerCoordinate) {
    auto point = start;
    point[coordinate] += degree;
    order.push_back(netPosition(point));
  }
  for (const auto& corners : kEdgeCorners) {
    for (int i = 1; i < degree; ++i) {
      auto point = start;
      point[kCornerCoordinate[corners[0]]] += degree - i;
      point[kCornerCoordinate[corners[1]]] += i;
      order.push_back(netPosition(point));
    }
  }
  std::vector<std::array<int, 3>> inner;
  addTriangle(degree - 3, 1, inner);
  for (std::size_t face = 0; face < 4; ++face) {
    for (const std::array<int, 3>& place : inner) {
      auto point = start;
      for (std::size_t k = 0; k < 3; ++k)
        point[kFaceCoordinates[face][k]] += place[k];
      point[kFaceLeast[face]] = least;
      order.push_back(netPosition(point));
    }
  }
  addTetrahedron(degree - 4, least + 1, order);
}

/// The shortest text that reads back as the same double.
std::string text(double value) {
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  return {buffer.data(), end};
}

void check(std::span<const BezierTetrahedron> solids) {
  if (solids.empty()) throw std::invalid_argument("vtu: at least one solid is needed");
  for (const BezierTetrahedron& solid : solids) {
    if (solid.dimension() != 3)
      throw std::invalid_argument("vtu: of a solid in E3; project it from E4 first");
    for (const double weight : solid.weights()) {
      if (weight == 0.0) {
        throw std::invalid_argument(
            "vtu: VTK divides by the weights, and one is 0; raise the degree first");
      }
    }
  }
}

template <class Write>
void writeArray(std::ostream& stream, const char* attributes, Write write) {
  stream << "<DataArray " << attributes << " format=\"ascii\">\n";
  write();
  stream << "</DataArray>\n";
}

template <class Write>
void forPoints(std::span<const BezierTetrahedron> solids, Write write) {
  for (const BezierTetrahedron& solid : solids) {
    for (const int position : vtkOrder(solid.degree()))
      write(solid, position);
  }
}

void writeCells(std::ostream& stream, std::span<const BezierTetrahedron> solids, int count) {
  stream << "<Cells>\n";
  writeArray(stream, "type=\"Int64\" Name=\"connectivity\"", [&] {
    for (int i = 0; i < count; ++i)
      stream << i << "\n";
  });
  writeArray(stream, "type=\"Int64\" Name=\"offsets\"", [&] {
    int end = 0;
    for (const BezierTetrahedron& solid : solids)
      stream << (end += solid.size()) << "\n";
  });
  writeArray(stream, "type=\"UInt8\" Name=\"types\"", [&] {
    for (std::size_t i = 0; i < solids.size(); ++i)
      stream << kVtkBezierTetrahedron << "\n";
  });
  stream << "</Cells>\n";
}

}  // namespace

std::vector<int> vtkOrder(int degree) {
  std::vector<int> order;
  addTetrahedron(degree, 0, order);
  return order;
}

void writeVtu(std::ostream& stream, std::span<const BezierTetrahedron> solids) {
  check(solids);
  int count = 0;
  for (const BezierTetrahedron& solid : solids)
    count += solid.size();
  stream << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" "
            "version=\"2.1\">\n<UnstructuredGrid>\n"
         << "<Piece NumberOfPoints=\"" << count << "\" NumberOfCells=\"" << solids.size() << "\">\n"
         << "<PointData RationalWeights=\"RationalWeights\">\n";
  writeArray(stream, "type=\"Float64\" Name=\"RationalWeights\"", [&] {
    forPoints(solids, [&](const BezierTetrahedron& solid, int i) {
      stream << text(solid.weight(i)) << "\n";
    });
  });
  stream << "</PointData>\n<CellData HigherOrderDegrees=\"HigherOrderDegrees\">\n";
  writeArray(stream, "type=\"Float64\" Name=\"HigherOrderDegrees\" NumberOfComponents=\"3\"", [&] {
    for (const BezierTetrahedron& solid : solids)
      stream << solid.degree() << " " << solid.degree() << " " << solid.degree() << "\n";
  });
  stream << "</CellData>\n<Points>\n";
  writeArray(stream, "type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\"", [&] {
    forPoints(solids, [&](const BezierTetrahedron& solid, int i) {
      const auto p = solid.points().col(i);
      stream << text(p[0]) << " " << text(p[1]) << " " << text(p[2]) << "\n";
    });
  });
  stream << "</Points>\n";
  writeCells(stream, solids, count);
  stream << "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

}  // namespace osculate
