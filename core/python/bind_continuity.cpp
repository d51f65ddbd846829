// The analyses of whole curves. The package `osculate` puts its public functions in front of these.
#include <memory>

#include <pybind11/stl.h>

#include "osculate/python/arguments.h"

namespace osculate::python {

namespace {

std::shared_ptr<CurveJoin> analyzePair(const BSplineCurve& first, const BSplineCurve& second,
                                       const py::object& order, const py::object& ends,
                                       const py::object& tolerances, const py::object& scaleMm) {
  return std::make_shared<CurveJoin>(
      analyzeCurves(first, second, optionsFrom(order, tolerances, scaleMm), endsFrom(ends)));
}

std::vector<std::shared_ptr<CurveJoin>> analyzeInner(const BSplineCurve& curve,
                                                     const py::object& order,
                                                     const py::object& tolerances,
                                                     const py::object& callback) {
  const AnalysisOptions options = optionsFrom(order, tolerances);
  const Progress progress = progressFrom(callback);
  std::vector<std::shared_ptr<CurveJoin>> result;
  const py::gil_scoped_release release;
  for (CurveJoin& join : analyzeInnerJoins(curve, options, progress)) {
    result.push_back(std::make_shared<CurveJoin>(std::move(join)));
  }
  return result;
}

bool isClosed(const BSplineCurve& curve, const py::object& tolerances) {
  return curve.isClosed(tolerancesFrom(tolerances).gapMm);
}

}  // namespace

void bindContinuity(py::module_& m) {
  m.attr("MAX_ORDER") = kMaxOrder;
  m.def("analyze_pair", &analyzePair, py::arg("first"), py::arg("second"), py::arg("order"),
        py::arg("ends"), py::arg("tolerances"), py::arg("scale_mm"));
  m.def("analyze_inner", &analyzeInner, py::arg("curve"), py::arg("order"), py::arg("tolerances"),
        py::arg("progress"));
  m.def("is_closed", &isClosed, py::arg("curve"), py::arg("tolerances"));
}

}  // namespace osculate::python
