// The compiled half of the Python package `osculate`.
#include "osculate/python/bindings.h"

namespace {

/// Help, errors and pickles name the classes by the package that offers them.
void showAsPublic(const pybind11::module_& m) {
  for (const auto& [name, value] : pybind11::dict(m.attr("__dict__"))) {
    if (PyType_Check(value.ptr()) != 0) value.attr("__module__") = "osculate";
  }
}

}  // namespace

PYBIND11_MODULE(_core, m) {
  namespace python = osculate::python;
  // Docstrings begin with their own signature ("name(...)\n--\n\n"), which inspect reads.
  pybind11::options options;
  options.disable_function_signatures();
  m.doc() = "The compiled core of osculate; use the package `osculate`.";
  m.attr("__version__") = OSCULATE_VERSION;
  python::bindBezier(m);
  python::bindDifferential(m);
  python::bindComb(m);
  python::bindTolerances(m);
  python::bindSide(m);
  python::bindReport(m);
  python::bindContinuity(m);
  python::bindBatch(m);
  python::bindAudit(m);
  python::bindConstruction(m);
  python::bindBlend(m);
  python::bindExtend(m);
  python::bindJoin(m);
  python::bindNuSpline(m);
  python::bindMatch(m);
  python::bindFeature(m);
  python::bindOcct(m);
  python::bindSolid(m);
  python::bindSolidAnalysis(m);
  python::bindSolidOutput(m);
  python::bindSolidPrimitives(m);
  showAsPublic(m);
}
