// Shapes from FreeCAD's Part.__toPythonOCC__, which wraps a TopoDS_Shape as SWIG's Python runtime
// does; private to this floor, and compiled only where SWIG was found.
#pragma once

#include <TopoDS_Shape.hxx>

#include "osculate/python/bindings.h"

namespace osculate::python {

/// Makes the type "TopoDS_Shape *" known to SWIG's runtime, which all SWIG modules of a process
/// share (pivy is one), unless another module did. Part.__toPythonOCC__ refuses as long as nobody
/// did. Must be called with the GIL; again does nothing.
void registerShapeType();

/// The shape out of a proxy; the proxy is empty afterwards. Raises TypeError for anything else.
TopoDS_Shape takeShape(const py::object& proxy);

}  // namespace osculate::python
