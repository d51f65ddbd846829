// Edges in: what osculate.shapes hands over. No class of OpenCASCADE is registered with pybind11,
// so that this module lives beside others that do.
#include <fstream>

#include "osculate/occt/binary_shape.h"
#include "osculate/occt/edge_curve.h"
#include "osculate/occt/occt_error.h"
#include "osculate/python/bindings.h"
#ifdef OSCULATE_HAS_SHAPE_PROXY
#include "osculate/python/shape_proxy.h"
#endif

namespace osculate::python {

namespace {

constexpr const char* kFromEdgeDoc = R"(from_edge(edge)
--

The edge's own part of its curve, oriented as the edge: Part.Edge of any curve type, trimmed, reversed,
placed, rational or periodic. See osculate.shapes.curve_from_edge.)";

constexpr const char* kToEdgeDoc = R"(to_edge(self)
--

A Part.Edge over the whole curve with the same numbers, bit for bit. See
osculate.shapes.edge_from_curve.)";

constexpr const char* kFromBinaryDoc = R"(curve_from_binary(path)
--

The curve of the edge in a file that Part.Edge.exportBinary wrote.)";

BSplineCurve curveFromBinary(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw std::invalid_argument("path: cannot read " + path);
  return curveFromEdge(readBinaryShape(stream)).curve;
}

/// Part is imported by osculate.shapes only, where a shape is at hand.
py::object shapesFunction(const char* name) {
  return py::module_::import("osculate.shapes").attr(name);
}

#ifdef OSCULATE_HAS_SHAPE_PROXY
constexpr const char* kRegisterDoc = R"(register_shape_type()
--

Lets Part.__toPythonOCC__ make proxies; once in a process is enough.)";

constexpr const char* kFromProxyDoc = R"(curve_from_proxy(proxy)
--

The curve of the edge in what Part.__toPythonOCC__ returned; the proxy is used up.)";

void bindShapeProxy(py::module_& m) {
  m.def("register_shape_type", &registerShapeType, kRegisterDoc);
  m.def(
      "curve_from_proxy",
      // with the GIL: it keeps other threads of Python from the edge meanwhile
      [](const py::object& proxy) { return curveFromEdge(takeShape(proxy)).curve; },
      py::arg("proxy"), kFromProxyDoc);
}
#else
void bindShapeProxy(py::module_&) {}
#endif

}  // namespace

void bindOcct(py::module_& m) {
  py::register_exception<OcctError>(m, "OcctError", PyExc_RuntimeError);
  m.def("curve_from_binary", &curveFromBinary, py::arg("path"), kFromBinaryDoc);
  bindShapeProxy(m);
  static_cast<py::class_<BSplineCurve>>(m.attr("Curve"))
      .def_static(
          "from_edge",
          [](const py::object& edge) { return shapesFunction("curve_from_edge")(edge); },
          py::arg("edge"), kFromEdgeDoc)
      .def(
          "to_edge", [](const py::object& self) { return shapesFunction("edge_from_curve")(self); },
          kToEdgeDoc);
}

}  // namespace osculate::python
