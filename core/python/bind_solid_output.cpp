// Bézier solids for display and for other programs: meshes, sections, projections, files.
#include <sstream>

#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include "osculate/occt/binary_shape.h"
#include "osculate/occt/solid_shape.h"
#include "osculate/python/solid_arguments.h"
#include "osculate/solid/mesh.h"
#include "osculate/solid/slice.h"
#include "osculate/solid/space4.h"
#include "osculate/solid/vtu.h"

namespace osculate::python {

namespace {

constexpr const char* kMeshDoc = R"(mesh(self, n=None, *, chordal_mm=None)
--

The solid as linear tetrahedra and boundary triangles, a SolidMesh: n^3 tetrahedra between the points
at (i, j, k, l)/n, 1 <= n <= 200, or, with chordal_mm, as many as keep every point of a face within
this distance of its triangles (fine where the faces bend, coarse inside). Give one of both.)";

constexpr const char* kTessellateDoc = R"(tessellate(self, chordal_mm)
--

The four faces for display, a list of FaceMesh: triangles within chordal_mm of the face (by bounds of
the second derivatives, not by samples; at most a million for a face) with outward unit normals.)";

constexpr const char* kSliceDoc = R"(slice(self, origin, normal, n=24)
--

The section with the plane through origin, a SectionMesh of triangles that turn left seen against the
normal. Marches through the n^3 tetrahedra of the domain; vertices lie on the plane and in the solid to
rounding, between them the section is a chord.)";

constexpr const char* kProjectDoc = R"(project(self, direction=None, centre=None)
--

From E4 to E3, in an orthonormal basis of the hyperplane through the origin across `direction` (by
default the fourth axis, whose hyperplane has the first three axes as its basis): orthogonally, or from
the point `centre`, which makes the result rational.)";

constexpr const char* kEmbeddedDoc = R"(embedded(self, direction=(0, 0, 0, 1))
--

From E3 into the hyperplane of E4 through the origin across `direction`; `project` with the same
direction takes it back.)";

constexpr const char* kToSolidDoc = R"(to_solid(self)
--

A Part.Solid with the exact faces (in FreeCAD): planes, ruled patches, and tensor-product patches with
one edge collapsed to a corner. Raises ValueError for a solid without volume, in E4 or with a corner of
weight 0, OcctError (a RuntimeError) where OpenCASCADE finds no valid solid between the faces. It does
not look for faces that pass through each other: ask `validity` about that first.)";

constexpr const char* kVtuDoc = R"(write_vtu(self, path)
--

Writes the solid for ParaView: a Bézier tetrahedron of VTK 9 with its rational weights. See
osculate.solids.write_vtu for several in one file.)";

template <class Owner, class Number>
void bindRows(py::class_<Owner>& type, const char* name, std::vector<Number> Owner::*member,
              py::ssize_t columns, const char* doc) {
  type.def_property_readonly(
      name, [member, columns](const Owner& self) { return rowsOf(self.*member, columns); }, doc);
}

void bindMeshes(py::module_& m) {
  py::class_<SolidMesh> solid(m, "SolidMesh",
                              "A solid as linear tetrahedra and boundary triangles.");
  bindRows(solid, "points", &SolidMesh::points, 3, "(N, 3) vertices in mm.");
  bindRows(solid, "coordinates", &SolidMesh::coordinates, 4,
           "(N, 4) barycentric coordinates of the vertices.");
  bindRows(solid, "tetrahedra", &SolidMesh::tetrahedra, 4,
           "(T, 4) vertices, oriented as the domain.");
  bindRows(solid, "triangles", &SolidMesh::triangles, 3,
           "(F, 3) vertices, turning left seen from outside.");
  solid.def_property_readonly(
      "triangle_faces",
      [](const SolidMesh& self) {
        return py::array_t<int>(static_cast<py::ssize_t>(self.triangleFaces.size()),
                                self.triangleFaces.data());
      },
      "(F,) the face of the solid that each triangle belongs to.");
  py::class_<FaceMesh> face(m, "FaceMesh", "One face of a solid for display.");
  bindRows(face, "points", &FaceMesh::points, 3, "(N, 3) vertices in mm.");
  bindRows(face, "normals", &FaceMesh::normals, 3, "(N, 3) outward unit normals.");
  bindRows(face, "triangles", &FaceMesh::triangles, 3,
           "(F, 3) vertices, turning left seen from outside.");
  py::class_<SolidSlice> section(m, "SectionMesh", "The section of a solid with a plane.");
  bindRows(section, "points", &SolidSlice::points, 3, "(N, 3) vertices in mm, on the plane.");
  bindRows(section, "coordinates", &SolidSlice::coordinates, 4,
           "(N, 4) barycentric coordinates of the vertices.");
  bindRows(section, "triangles", &SolidSlice::triangles, 3, "(F, 3) vertices.");
}

SolidMesh meshOf(const BezierTetrahedron& self, const py::object& n, const py::object& chordalMm) {
  if (n.is_none() == chordalMm.is_none()) {
    throw std::invalid_argument("mesh: give either n, the number of divisions, or chordal_mm");
  }
  if (!n.is_none()) {
    const int divisions = integerFrom(n, "n");
    const py::gil_scoped_release release;
    return uniformMesh(self, divisions);
  }
  const double chordal = numberFrom(chordalMm, "chordal_mm");
  const py::gil_scoped_release release;
  return adaptiveMesh(self, chordal);
}

std::vector<FaceMesh> tessellated(const BezierTetrahedron& self, double chordalMm) {
  const py::gil_scoped_release release;
  const int m = divisionsFor(self, chordalMm);
  std::vector<FaceMesh> faces;
  for (int corner = 0; corner < 4; ++corner)
    faces.push_back(faceMesh(self, corner, m));
  return faces;
}

py::list tessellate(const BezierTetrahedron& self, const py::object& chordalMm) {
  py::list result;
  for (FaceMesh& mesh : tessellated(self, numberFrom(chordalMm, "chordal_mm")))
    result.append(std::move(mesh));
  return result;
}

SolidSlice sliceOf(const BezierTetrahedron& self, const py::object& origin,
                   const py::object& normal, const py::object& n) {
  const Vector3 from = vectorFrom(origin, "origin", 3);
  const Vector3 across = vectorFrom(normal, "normal", 3);
  const int divisions = integerFrom(n, "n");
  const py::gil_scoped_release release;
  return slice(self, from, across, divisions);
}

BezierTetrahedron project(const BezierTetrahedron& self, const py::object& direction,
                          const py::object& centre) {
  Eigen::Vector4d across = Eigen::Vector4d::UnitW();
  if (!direction.is_none()) across = vectorFrom(direction, "direction", 4);
  if (centre.is_none()) return parallelProjection(self, across);
  return perspectiveProjection(self, vectorFrom(centre, "centre", 4), across);
}

void writeSolids(const std::vector<const BezierTetrahedron*>& solids, const std::string& path) {
  std::vector<BezierTetrahedron> values;
  for (const BezierTetrahedron* solid : solids)
    values.push_back(*solid);
  std::ostringstream text;  // an error leaves the file as it was
  writeVtu(text, values);
  writeFile(path, [&](std::ostream& stream) { stream << text.str(); });
}

void writeBinary(const BezierTetrahedron& self, const std::string& path) {
  const TopoDS_Solid solid = solidFromTetrahedron(self);
  writeFile(path, [&](std::ostream& stream) { writeBinaryShape(stream, solid); });
}

}  // namespace

void bindSolidOutput(py::module_& m) {
  bindMeshes(m);
  static_cast<py::class_<BezierTetrahedron>>(m.attr("BezierTetrahedron"))
      .def("mesh", &meshOf, py::arg("n") = py::none(), py::kw_only(),
           py::arg("chordal_mm") = py::none(), kMeshDoc)
      .def("tessellate", &tessellate, py::arg("chordal_mm"), kTessellateDoc)
      .def("slice", &sliceOf, py::arg("origin"), py::arg("normal"), py::arg("n") = 24, kSliceDoc)
      .def("project", &project, py::arg("direction") = py::none(), py::arg("centre") = py::none(),
           kProjectDoc)
      .def(
          "embedded",
          [](const BezierTetrahedron& self, const py::object& direction) {
            return embedded(self, vectorFrom(direction, "direction", 4));
          },
          py::arg("direction") = py::make_tuple(0, 0, 0, 1), kEmbeddedDoc)
      .def(
          "to_solid",
          [](const py::object& self) {
            return py::module_::import("osculate.shapes").attr("solid_from_tetrahedron")(self);
          },
          kToSolidDoc)
      .def(
          "write_vtu",
          [](const BezierTetrahedron& self, const py::object& path) {
            writeSolids({&self},
                        py::module_::import("os").attr("fspath")(path).cast<std::string>());
          },
          py::arg("path"), kVtuDoc);
  m.def("write_solids_vtu", &writeSolids, py::arg("solids"), py::arg("path"));
  m.def("solid_to_binary", &writeBinary, py::arg("solid"), py::arg("path"));
}

}  // namespace osculate::python
