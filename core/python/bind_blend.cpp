// The blend. The package `osculate` puts its public function in front of it.
#include <string>

#include "osculate/construction/blend_curves.h"
#include "osculate/python/construction_record.h"

namespace osculate::python {

namespace {

/// An integer for both ends, or a pair.
std::array<int, 2> ordersFrom(const py::object& value) {
  const bool isPair = py::isinstance<py::tuple>(value) || py::isinstance<py::list>(value);
  const py::sequence both = isPair ? value : py::make_tuple(value, value);
  const py::sequence pair = pairFrom(both, "order", "an integer or a pair of them");
  return {orderFrom(pair[0]), orderFrom(pair[1])};
}

std::array<Departure, 2> departuresFrom(const py::object& value, const BSplineCurve& first,
                                        const BSplineCurve& second) {
  if (value.is_none()) return nearestDepartures(first, second);
  const py::sequence pair = pairFrom(value, "ends", "None or a pair, one for each curve");
  return {departureFrom(pair[0], first), departureFrom(pair[1], second)};
}

std::array<GivenNumbers, 2> betaFrom(const py::object& value, const std::array<int, 2>& orders) {
  if (value.is_none()) return {};
  const py::sequence pair = pairFrom(value, "beta", "None or a pair of tuples of numbers");
  return {givenNumbersFrom(pair[0], orders[0]), givenNumbersFrom(pair[1], orders[1])};
}

RecordPointer makeBlend(const BSplineCurve& first, const BSplineCurve& second,
                        const py::object& order, const py::object& ends, const py::object& beta,
                        const py::object& degree, const py::object& fairness,
                        const py::object& symmetric) {
  BlendOptions options;
  options.order = ordersFrom(order);
  options.degree = degreeFrom(degree);
  options.beta = betaFrom(beta, options.order);
  options.symmetric = boolFrom(symmetric, "symmetric");
  options.fairness = fairnessFrom(fairness);
  const std::array<Departure, 2> departures = departuresFrom(ends, first, second);
  const py::gil_scoped_release release;
  return recordOf(blendCurves(first, second, departures, options));
}

}  // namespace

void bindBlend(py::module_& m) {
  m.def("blend", &makeBlend, py::arg("first"), py::arg("second"), py::arg("order"), py::arg("ends"),
        py::arg("beta"), py::arg("degree"), py::arg("fairness"), py::arg("symmetric"));
}

}  // namespace osculate::python
