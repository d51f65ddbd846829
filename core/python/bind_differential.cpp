// Differential geometry of osculate.Curve: the geometry at a point and arc length.
#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include "osculate/differential/arc_length.h"
#include "osculate/differential/point_geometry.h"
#include "osculate/python/arguments.h"

namespace osculate::python {

namespace {

constexpr const char* kFrameDoc =
    "Three orthonormal vectors, right-handed; normal and binormal are None where there are none.";

constexpr const char* kPointGeometryDoc = R"(The differential geometry of a curve at one parameter.

What does not exist there (the normal and the torsion where curvature is zero) is None.)";

constexpr const char* kGeometryDoc = R"(geometry(self, t, side='right')
--

Frenet frame, curvature, torsion and their rates by arc length at t, as a PointGeometry.

t: within `parameter_range`. side: 'left' or 'right', the side from which a knot is approached. The
tangent points in the direction of the parameter. Raises ValueError outside the range.)";

constexpr const char* kLengthDoc = R"(length(self)
--

The arc length in mm, to a relative error of about 1e-12.)";

constexpr const char* kParameterDoc = R"(parameter_at_length(self, s)
--

The parameter where the arc length from the start is s mm. Raises ValueError for s outside
[0, length()].)";

template <auto member>
void bindInvariant(py::class_<PointGeometry>& geometry, const char* name, const char* doc) {
  geometry.def_property_readonly(
      name, [](const PointGeometry& self) { return self.invariants.*member; }, doc);
}

void bindPointGeometry(py::module_& m) {
  py::class_<PointGeometry> geometry(m, "PointGeometry", kPointGeometryDoc);
  geometry
      .def_property_readonly(
          "point", [](const PointGeometry& self) { return self.point; }, "(3,), mm.")
      .def_property_readonly(
          "tangent", [](const PointGeometry& self) { return self.frame.tangent; },
          "(3,), unit vector in the direction of the parameter.")
      .def_property_readonly(
          "normal", [](const PointGeometry& self) { return self.frame.normal; },
          "(3,), unit vector towards the centre of curvature, or None.")
      .def_property_readonly(
          "binormal", [](const PointGeometry& self) { return self.frame.binormal; },
          "(3,), tangent x normal, or None.")
      .def_property_readonly(
          "frame_kind", [](const PointGeometry& self) { return std::string(name(self.kind)); },
          "'frenet', 'fictitious-normal', 'line' or 'fictitious-tangent'.")
      .def_readonly("smoothness", &PointGeometry::smoothness,
                    "How many arc-length derivatives exist there, at most 4.");
  bindInvariant<&Invariants::curvature>(geometry, "curvature", "kappa >= 0, 1/mm, or None.");
  bindInvariant<&Invariants::torsion>(geometry, "torsion", "tau, signed, 1/mm, or None.");
  bindInvariant<&Invariants::curvatureRate>(geometry, "curvature_rate",
                                            "d kappa/ds, 1/mm^2, or None.");
  bindInvariant<&Invariants::curvatureRate2>(geometry, "curvature_rate2",
                                             "d^2 kappa/ds^2, 1/mm^3, or None.");
  bindInvariant<&Invariants::torsionRate>(geometry, "torsion_rate", "d tau/ds, 1/mm^2, or None.");
}

PointGeometry geometry(const BSplineCurve& curve, const py::object& t, const py::object& side) {
  const double parameter = numberFrom(t, "t");
  checkParameter(curve, parameter);
  return geometryAt(curve, parameter, sideFrom(side));
}

double parameterAt(const BSplineCurve& curve, const py::object& s) {
  const double length = numberFrom(s, "s");
  const py::gil_scoped_release release;
  return parameterAtLength(curve, length);
}

}  // namespace

void bindDifferential(py::module_& m) {
  py::class_<FrenetFrame>(m, "FrenetFrame", kFrameDoc)
      .def_property_readonly(
          "tangent", [](const FrenetFrame& self) { return self.tangent; }, "(3,), unit vector.")
      .def_property_readonly(
          "normal", [](const FrenetFrame& self) { return self.normal; },
          "(3,), unit vector, or None.")
      .def_property_readonly(
          "binormal", [](const FrenetFrame& self) { return self.binormal; },
          "(3,), tangent x normal, or None.");
  bindPointGeometry(m);
  py::class_<BSplineCurve>(m.attr("Curve"))
      .def("geometry", &geometry, py::arg("t"), py::arg("side") = "right", kGeometryDoc)
      .def(
          "length", [](const BSplineCurve& self) { return length(self); },
          py::call_guard<py::gil_scoped_release>(), kLengthDoc)
      .def("parameter_at_length", &parameterAt, py::arg("s"), kParameterDoc);
}

}  // namespace osculate::python
