// The extension. The package `osculate` puts its public function in front of it.
#include "osculate/construction/contact_error.h"
#include "osculate/construction/extend_curve.h"
#include "osculate/python/construction_record.h"

namespace osculate::python {

namespace {

std::optional<double> optionalFrom(const py::object& value, const char* argument) {
  if (value.is_none()) return {};
  return numberFrom(value, argument);
}

/// None or three numbers.
std::optional<Vector3> vectorFrom(const py::object& value, const char* argument) {
  if (value.is_none()) return {};
  const std::vector<double> numbers = numbersFrom(value, argument);
  if (numbers.size() != 3) {
    throw std::invalid_argument(std::string(argument) + ": must be three numbers, got " +
                                std::to_string(numbers.size()));
  }
  return Vector3(numbers[0], numbers[1], numbers[2]);
}

/// A number is the magnitude, three are the vector.
void setCurvature(const py::object& value, ExtendTargets& targets) {
  if (py::isinstance<py::float_>(value) || py::isinstance<py::int_>(value)) {
    targets.curvature = numberFrom(value, "to_curvature");
  } else {
    targets.curvatureVector = vectorFrom(value, "to_curvature");
  }
}

ExtendOptions optionsFrom(const py::kwargs& given) {
  constexpr const char* kNumbers = "None or a tuple of numbers";
  ExtendOptions options;
  options.end = endFrom(given["end"], "end:");
  options.order = orderFrom(given["order"]);
  options.degree = degreeFrom(given["degree"]);
  options.beta = givenNumbersFrom(given["beta"], options.order, "beta", kNumbers);
  options.tangential = givenNumbersFrom(given["tangential"], options.order, "tangential", kNumbers);
  options.targets.lengthMm = optionalFrom(given["length"], "length");
  options.targets.point = vectorFrom(given["to_point"], "to_point");
  options.targets.direction = vectorFrom(given["to_direction"], "to_direction");
  setCurvature(given["to_curvature"], options.targets);
  options.parametric = boolFrom(given["parametric"], "parametric");
  options.parameter = optionalFrom(given["parameter"], "parameter");
  options.fairness = fairnessFrom(given["fairness"]);
  return options;
}

/// A curve's own continuation has no other freedom than its length.
void checkNatural(const py::kwargs& given, const ExtendOptions& options) {
  std::string names;
  for (const char* name :
       {"degree", "beta", "tangential", "to_point", "to_direction", "to_curvature", "parameter"}) {
    if (!given[name].is_none()) names += (names.empty() ? "" : ", ") + std::string(name);
  }
  if (options.parametric) names += (names.empty() ? "" : ", ") + std::string("parametric");
  if (!names.empty()) {
    throw ContactError(
        "natural: the curve's own continuation leaves nothing but its length to choose; got " +
        names);
  }
}

/// `given` has every argument of the package's function.
RecordPointer makeExtension(const BSplineCurve& curve, const py::kwargs& given) {
  const ExtendOptions options = optionsFrom(given);
  const bool natural = boolFrom(given["natural"], "natural");
  if (natural) checkNatural(given, options);
  const py::gil_scoped_release release;
  return recordOf(natural
                      ? extendNaturally(curve, options.end, options.order, options.targets.lengthMm)
                      : extendCurve(curve, options));
}

}  // namespace

void bindExtend(py::module_& m) { m.def("extend", &makeExtension, py::arg("curve")); }

}  // namespace osculate::python
