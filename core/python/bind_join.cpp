// The join. The package `osculate` puts its public function in front of it.
#include "osculate/construction/join.h"
#include "osculate/python/construction_record.h"

namespace osculate::python {

namespace {

RecordPointer makeJoin(const std::vector<BSplineCurve>& curves, const py::object& tolerance) {
  const double toleranceMm = numberFrom(tolerance, "tolerance");
  const py::gil_scoped_release release;
  return recordOf(joinCurves(curves, toleranceMm));
}

}  // namespace

void bindJoin(py::module_& m) { m.def("join", &makeJoin, py::arg("curves"), py::arg("tolerance")); }

}  // namespace osculate::python
