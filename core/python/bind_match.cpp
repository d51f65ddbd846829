// The match. The package `osculate` puts its public function in front of it.
#include <string>

#include "osculate/construction/blend_curves.h"
#include "osculate/construction/match_curves.h"
#include "osculate/python/construction_record.h"

namespace osculate::python {

namespace {

/// None for as many as are useful, which the core calls 0.
int spansFrom(const py::object& value) {
  if (value.is_none()) return 0;
  const int spans = integerFrom(value, "spans");
  if (spans < 1) {
    throw std::invalid_argument(
        "spans: must be at least 1, or None for as many as are useful, got " +
        std::to_string(spans));
  }
  return spans;
}

MatchOptions optionsFrom(const py::object& order, const py::object& keep, const py::object& spans,
                         const py::object& degree, const py::object& beta) {
  MatchOptions options;
  options.order = orderFrom(order);
  options.keep = integerFrom(keep, "keep");
  options.spans = spansFrom(spans);
  options.degree = degreeFrom(degree);
  options.beta = givenNumbersFrom(beta, options.order, "beta", "None or a tuple of numbers");
  return options;
}

RecordPointer makeMatch(const BSplineCurve& first, const BSplineCurve& second,
                        const py::object& order, const py::object& ends, const py::object& keep,
                        const py::object& spans, const py::object& degree, const py::object& beta) {
  const MatchOptions options = optionsFrom(order, keep, spans, degree, beta);
  std::array<Departure, 2> departures;
  if (ends.is_none()) {
    departures = nearestDepartures(first, second);
  } else {
    const py::sequence pair = pairFrom(ends, "ends", "None or a pair, one for each curve");
    departures = {departureFrom(pair[0], first), Departure{.end = endFrom(pair[1])}};
  }
  const py::gil_scoped_release release;
  return recordOf(matchCurves(first, departures[0], second, departures[1].end, options));
}

/// `changed` is "start" or "end".
RecordPointer makeClosing(const BSplineCurve& curve, const py::object& changed,
                          const py::object& order, const py::object& keep, const py::object& spans,
                          const py::object& degree, const py::object& beta) {
  const MatchOptions options = optionsFrom(order, keep, spans, degree, beta);
  const CurveEnd end = endFrom(changed);
  const py::gil_scoped_release release;
  return recordOf(matchClosing(curve, end, options));
}

}  // namespace

void bindMatch(py::module_& m) {
  m.def("match", &makeMatch, py::arg("first"), py::arg("second"), py::arg("order"), py::arg("ends"),
        py::arg("keep"), py::arg("spans"), py::arg("degree"), py::arg("beta"));
  m.def("match_closing", &makeClosing, py::arg("curve"), py::arg("changed"), py::arg("order"),
        py::arg("keep"), py::arg("spans"), py::arg("degree"), py::arg("beta"));
}

}  // namespace osculate::python
