// osculate.Construction and the arguments that its makers share; private to this floor.
#pragma once

#include <memory>

#include <pybind11/stl.h>

#include "osculate/construction/construction.h"
#include "osculate/construction/fairness.h"
#include "osculate/python/arguments.h"

namespace osculate::python {

/// A construction with what Python may ask of it later.
struct ConstructionRecord : Construction {
  std::optional<Energies> knownEnergies;
};

using RecordPointer = std::shared_ptr<ConstructionRecord>;
using GivenNumbers = std::array<std::optional<double>, kMaxOrder>;

/// What a binding returns: call it with the GIL released.
inline RecordPointer recordOf(Construction construction) {
  return std::make_shared<ConstructionRecord>(ConstructionRecord{std::move(construction), {}});
}

// All of these raise TypeError for what is of the wrong kind and ValueError for a wrong value.

/// 0..kMaxOrder.
int orderFrom(const py::object& value);
/// "start", "end" or (t, "forward" or "backward").
Departure departureFrom(const py::object& value, const BSplineCurve& curve);
/// None for no numbers, or a tuple of at most `order` numbers, each None where it is chosen. Errors
/// name the argument.
GivenNumbers givenNumbersFrom(const py::object& value, int order, const char* argument = "beta",
                              const char* wanted = "None or a pair of tuples of numbers");
/// None for the least degree, which the core calls 0.
int degreeFrom(const py::object& value);
/// "mvc", "bending" or None.
std::optional<Fairness> fairnessFrom(const py::object& value);

}  // namespace osculate::python
