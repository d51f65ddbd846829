// Interpolation. The package `osculate` puts its public function in front of it.
#include <string>

#include "osculate/construction/nu_spline.h"
#include "osculate/python/arguments.h"

namespace osculate::python {

namespace {

/// A number for all points, or one for each.
std::vector<double> tensionFrom(const py::object& value) {
  if (arrayFrom(value, "tension").ndim() == 0) return {numberFrom(value, "tension")};
  return numbersFrom(value, "tension");
}

Spacing spacingFrom(const py::object& value) {
  const std::string text = py::str(value);
  if (text == "centripetal") return Spacing::kCentripetal;
  if (text == "chordal") return Spacing::kChordal;
  if (text == "uniform") return Spacing::kUniform;
  throw std::invalid_argument(
      "parameters: must be 'centripetal', 'chordal', 'uniform', None or numbers, got " +
      std::string(py::repr(value)));
}

/// "natural", "bessel" or a tangent of three numbers.
NuSplineEnd nuSplineEndFrom(const py::object& value) {
  using Kind = NuSplineEnd::Kind;
  if (py::isinstance<py::str>(value)) {
    const std::string text = py::str(value);
    if (text == "natural") return {Kind::kNatural};
    if (text == "bessel") return {Kind::kBessel};
    throw std::invalid_argument("ends: each must be 'natural', 'bessel' or a tangent, got " +
                                std::string(py::repr(value)));
  }
  const std::vector<double> numbers = numbersFrom(value, "ends");
  if (numbers.size() != 3) {
    throw std::invalid_argument("ends: a tangent has three numbers, got " +
                                std::to_string(numbers.size()));
  }
  return {Kind::kTangent, Vector3(numbers[0], numbers[1], numbers[2])};
}

std::array<NuSplineEnd, 2> nuSplineEndsFrom(const py::object& value, bool closed) {
  std::array<NuSplineEnd, 2> ends;
  if (py::isinstance<py::str>(value)) {
    ends[0] = ends[1] = nuSplineEndFrom(value);
  } else {
    const py::sequence pair =
        pairFrom(value, "ends", "'natural', 'bessel' or a pair of these and tangents");
    ends = {nuSplineEndFrom(pair[0]), nuSplineEndFrom(pair[1])};
  }
  for (const NuSplineEnd& end : ends) {
    if (closed && end.kind != NuSplineEnd::Kind::kNatural)
      throw std::invalid_argument("ends: a closed curve has none; leave them 'natural'");
  }
  return ends;
}

BSplineCurve makeNuSpline(const py::object& points, const py::object& tension,
                          const py::object& parameters, const py::object& ends,
                          const py::object& closed) {
  const Poles poles = polesFrom(points, "points");
  NuSplineOptions options;
  options.tension = tensionFrom(tension);
  options.closed = boolFrom(closed, "closed");
  options.ends = nuSplineEndsFrom(ends, options.closed);
  if (py::isinstance<py::str>(parameters)) {
    options.spacing = spacingFrom(parameters);
  } else if (!parameters.is_none()) {
    options.parameters = numbersFrom(parameters, "parameters");
    if (options.parameters.empty())
      throw std::invalid_argument("parameters: there are none; None chooses them");
  }
  const py::gil_scoped_release release;
  return nuSpline(poles, options);
}

}  // namespace

void bindNuSpline(py::module_& m) {
  m.def("nu_spline", &makeNuSpline, py::arg("points"), py::arg("tension"), py::arg("parameters"),
        py::arg("ends"), py::arg("closed"));
}

}  // namespace osculate::python
