// One function for each part of the module; private to this floor.
#pragma once

#include <pybind11/pybind11.h>

namespace osculate::python {

namespace py = pybind11;

void bindBezier(py::module_& m);
void bindDifferential(py::module_& m);
void bindComb(py::module_& m);
void bindTolerances(py::module_& m);
void bindSide(py::module_& m);
void bindReport(py::module_& m);
void bindContinuity(py::module_& m);
void bindBatch(py::module_& m);
void bindAudit(py::module_& m);
void bindConstruction(py::module_& m);
void bindBlend(py::module_& m);
void bindExtend(py::module_& m);
void bindJoin(py::module_& m);
void bindNuSpline(py::module_& m);
void bindMatch(py::module_& m);
void bindFeature(py::module_& m);
void bindOcct(py::module_& m);
void bindSolid(py::module_& m);
void bindSolidAnalysis(py::module_& m);
void bindSolidOutput(py::module_& m);
void bindSolidPrimitives(py::module_& m);

}  // namespace osculate::python
