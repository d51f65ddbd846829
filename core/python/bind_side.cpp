// osculate.JoinSide: the numbers of one side of a join.
#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include "osculate/python/arguments.h"
#include "osculate/python/join_side.h"

namespace osculate::python {

namespace {

template <auto member>
void bindInvariant(py::class_<JoinSideView>& side, const char* name, const char* doc) {
  side.def_property_readonly(
      name, [](const JoinSideView& self) { return self.report().invariants.*member; }, doc);
}

void bindInvariants(py::class_<JoinSideView>& side) {
  bindInvariant<&Invariants::curvature>(side, "curvature", "kappa >= 0, 1/mm, or None.");
  bindInvariant<&Invariants::torsion>(side, "torsion", "tau, signed, 1/mm, or None.");
  bindInvariant<&Invariants::curvatureRate>(side, "curvature_rate", "d kappa/ds, 1/mm^2, or None.");
  bindInvariant<&Invariants::curvatureRate2>(side, "curvature_rate2",
                                             "d^2 kappa/ds^2, 1/mm^3, or None.");
  bindInvariant<&Invariants::torsionRate>(side, "torsion_rate", "d tau/ds, 1/mm^2, or None.");
}

std::optional<Vector3> tangentOf(const JoinSideView& self) {
  if (self.report().smoothness < 1) return {};
  return self.report().frame.tangent;
}

}  // namespace

void bindSide(py::module_& m) {
  using Side = JoinSideView;
  py::class_<Side> side(m, "JoinSide",
                        "One of the two curves at a join, in the direction of travel.");
  side.def_property_readonly(
          "end", [](const Side& self) { return name(self.report().end); },
          "Which end of the curve lies at the join: 'start' or 'end'.")
      .def_property_readonly(
          "point", [](const Side& self) { return self.report().point; }, "(3,), mm.")
      .def_property_readonly("tangent", &tangentOf,
                             "(3,), unit vector in the direction of travel, or None.")
      .def_property_readonly(
          "normal", [](const Side& self) { return self.report().frame.normal; },
          "(3,), unit vector towards the centre of curvature, or None.")
      .def_property_readonly(
          "binormal", [](const Side& self) { return self.report().frame.binormal; },
          "(3,), tangent x normal, or None.")
      .def_property_readonly(
          "linearity", [](const Side& self) { return self.report().linearity; },
          "Legs of the control polygon, from the join, that lie on the tangent.")
      .def_property_readonly(
          "multiplicity", [](const Side& self) { return self.report().multiplicity; },
          "1 at a regular end; m where the first m-1 derivatives are zero.")
      .def_property_readonly(
          "smoothness", [](const Side& self) { return self.report().smoothness; },
          "How many arc-length derivatives exist, at most 8.")
      .def_property_readonly(
          "segment", [](const Side& self) { return asCurve(self.segment()); },
          "The Bézier Curve at the join, over [0, 1] in its curve's own direction; None "
          "if it is a single point.")
      .def_property_readonly(
          "derivatives_in_frame",
          [](const Side& self) { return self.join->report.derivativesInFrame[self.index]; },
          "(5, 3): derivatives 0 to 4 by the segment's parameter in the direction of travel, as "
          "(tangent, "
          "normal, binormal) components in the report's frame; row 0 is the position from the "
          "first "
          "curve's end.");
  bindInvariants(side);
}

}  // namespace osculate::python
