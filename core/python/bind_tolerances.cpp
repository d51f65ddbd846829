// osculate.Tolerances and its presets.
#include <optional>
#include <sstream>

#include <pybind11/stl.h>

#include "osculate/python/arguments.h"

namespace osculate::python {

namespace {

constexpr const char* kTolerancesDoc =
    R"(The largest residual of each order that still passes: an immutable value.

Equal if the numbers and `metric` are.)";

constexpr const char* kInitDoc =
    R"(__init__(self, *, gap_mm=None, angle_deg=None, curvature=None, third=None, fourth=None)
--

gap_mm: order 0, mm. angle_deg: order 1, degrees. curvature, third, fourth: orders 2, 3 and from 4
on, dimensionless. What is not given is that of the preset `osculate`: 1e-3 mm, 0.1 degrees, 0.01,
0.02, 0.05. Raises ValueError unless each is finite and > 0.)";

constexpr const char* kPresetDoc = R"(preset(name)
--

The tolerances of a preset, which `presets()` lists. Raises ValueError for any other name.)";

constexpr const char* kPresetsDoc = R"(presets()
--

A TolerancePreset for each preset: `name`, `source` (where its numbers are from) and `borrowed`
(which of them are those of `osculate`, because the system has none).)";

constexpr const char* kOfOrderDoc = R"(of_order(self, order)
--

The tolerance of one order, 0 to 8: mm, degrees, then dimensionless.)";

const char* name(CurvatureMetric metric) {
  switch (metric) {
    case CurvatureMetric::kVector:
      return "vector";
    case CurvatureMetric::kMaximum:
      return "maximum";
    case CurvatureMetric::kOpenNurbs:
      return "opennurbs";
    case CurvatureMetric::kSum:
      return "sum";
    case CurvatureMetric::kMean:
      return "mean";
    case CurvatureMetric::kGeometricMean:
      return "geometric-mean";
  }
  return "";
}

void take(double& value, const py::object& argument, const char* argumentName,
          Tolerances& tolerances) {
  if (argument.is_none()) return;
  value = numberFrom(argument, argumentName);
  tolerances.name = "custom";
}

Tolerances makeTolerances(const py::object& gapMm, const py::object& angleDegrees,
                          const py::object& curvature, const py::object& third,
                          const py::object& fourth) {
  Tolerances result;
  take(result.gapMm, gapMm, "gap_mm", result);
  take(result.angleDegrees, angleDegrees, "angle_deg", result);
  take(result.curvature, curvature, "curvature", result);
  take(result.third, third, "third", result);
  take(result.fourth, fourth, "fourth", result);
  result.check();
  return result;
}

py::tuple identity(const Tolerances& self) {
  return py::make_tuple(self.gapMm, self.angleDegrees, self.curvature, self.third, self.fourth,
                        name(self.metric));
}

std::string repr(const Tolerances& self) {
  std::ostringstream text;
  text << "<osculate.Tolerances " << self.name << ": " << self.gapMm << " mm, " << self.angleDegrees
       << " deg, " << self.curvature << ", " << self.third << ", " << self.fourth << ">";
  return text.str();
}

double ofOrder(const Tolerances& self, const py::object& order) {
  const int number = integerFrom(order, "order");
  if (number < 0 || number > kMaxOrder) {
    throw std::invalid_argument("order: must be from 0 to " + std::to_string(kMaxOrder));
  }
  return self.ofOrder(number);
}

void bindPreset(py::module_& m) {
  py::class_<TolerancePreset>(m, "TolerancePreset", "What is known of a preset of tolerances.")
      .def_readonly("name", &TolerancePreset::name, "What Tolerances.preset takes.")
      .def_readonly("source", &TolerancePreset::source, "Where its numbers are from.")
      .def_readonly("borrowed", &TolerancePreset::borrowed,
                    "Which of its numbers are those of `osculate`, or an empty text.")
      .def("__repr__", [](const TolerancePreset& self) {
        return "<osculate.TolerancePreset " + std::string(self.name) + ": " +
               std::string(self.source) + ">";
      });
}

std::vector<TolerancePreset> presets() {
  const auto all = tolerancePresets();
  return {all.begin(), all.end()};
}

}  // namespace

void bindTolerances(py::module_& m) {
  bindPreset(m);
  const py::none none;
  py::class_<Tolerances>(m, "Tolerances", kTolerancesDoc)
      .def(py::init(&makeTolerances), py::kw_only(), py::arg("gap_mm") = none,
           py::arg("angle_deg") = none, py::arg("curvature") = none, py::arg("third") = none,
           py::arg("fourth") = none, kInitDoc)
      .def_static("preset", &Tolerances::preset, py::arg("name"), kPresetDoc)
      .def_static("presets", &presets, kPresetsDoc)
      .def_readonly("gap_mm", &Tolerances::gapMm, "Order 0: distance of the ends, mm.")
      .def_readonly("angle_deg", &Tolerances::angleDegrees,
                    "Order 1: angle between the tangents, degrees.")
      .def_readonly("curvature", &Tolerances::curvature, "Order 2, dimensionless.")
      .def_readonly("third", &Tolerances::third, "Order 3, dimensionless.")
      .def_readonly("fourth", &Tolerances::fourth, "Order 4 and above, dimensionless.")
      .def_readonly("name", &Tolerances::name, "Name of the preset, or 'custom'.")
      .def_property_readonly(
          "metric", [](const Tolerances& self) { return name(self.metric); },
          "How this preset's system measures a G2 deviation: 'vector', 'maximum', 'opennurbs', "
          "'sum', "
          "'mean' or 'geometric-mean'. The verdict itself is always the vector one.")
      .def("of_order", &ofOrder, py::arg("order"), kOfOrderDoc)
      .def(
          "__eq__",
          [](const Tolerances& self, const Tolerances& other) {
            return identity(self).equal(identity(other));
          },
          py::is_operator())
      .def("__hash__", [](const Tolerances& self) { return py::hash(identity(self)); })
      .def("__repr__", &repr);
}

}  // namespace osculate::python
