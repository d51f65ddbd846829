// The compiled half of the Python package `osculate`.
#include "osculate/python/bindings.h"

PYBIND11_MODULE(_core, m) {
  namespace python = osculate::python;
  // Docstrings begin with their own signature ("name(...)\n--\n\n"), which inspect reads.
  pybind11::options options;
  options.disable_function_signatures();
  m.doc() = "The compiled core of osculate; use the package `osculate`.";
  m.attr("__version__") = OSCULATE_VERSION;
  python::bindBezier(m);
  python::bindDifferential(m);
  python::bindTolerances(m);
  python::bindSide(m);
  python::bindReport(m);
  python::bindContinuity(m);
  python::bindBatch(m);
  python::bindOcct(m);
}
