// What the document objects of FreeCAD need of the compiled module.
#include "osculate/python/bindings.h"

namespace osculate::python {

namespace {

/// FreeCAD prints the traceback of an error that a recompute raises. One that is raised here has
/// none, as no frame of Python is left: the user reads a line.
void raiseReturned(const py::function& function, const py::args& arguments) {
  const py::object sentence = function(*arguments);
  if (sentence.is_none()) return;
  PyErr_SetObject(PyExc_RuntimeError, sentence.ptr());
  throw py::error_already_set();
}

}  // namespace

void bindFeature(py::module_& m) {
  m.def("raise_returned", &raiseReturned, py::arg("function"),
        "Calls function(*arguments) and raises RuntimeError with the text that it returns; None "
        "is no error. The error has no traceback.");
}

}  // namespace osculate::python
