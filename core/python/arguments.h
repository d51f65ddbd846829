// From Python arguments to core values, with errors that name the argument; private to this floor.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <pybind11/numpy.h>

#include "osculate/continuity/curve_joins.h"
#include "osculate/python/bindings.h"

namespace osculate::python {

/// Contiguous float64.
using Array = py::array_t<double, py::array::c_style>;

// All of these raise TypeError for what is of the wrong kind and ValueError for a wrong shape or
// value.

/// TypeError: the argument must be what is `wanted`.
[[noreturn]] void failType(const std::string& argument, const std::string& wanted,
                           const py::handle& value);

/// An array of numbers; a copy only where the argument is no contiguous float64 array.
Array arrayFrom(const py::object& value, const char* argument);
/// Shape (m, 3).
Poles polesFrom(const py::object& value, const char* argument);
/// Shape (count,); None gives an empty vector.
std::vector<double> weightsFrom(const py::object& value, Eigen::Index count);
/// Shape (m,).
std::vector<double> numbersFrom(const py::object& value, const char* argument);
std::vector<int> integersFrom(const py::object& value, const char* argument);
double numberFrom(const py::object& value, const char* argument);
int integerFrom(const py::object& value, const char* argument);
bool boolFrom(const py::object& value, const char* argument);
/// A tuple or list of two values; `wanted` says of what.
py::sequence pairFrom(const py::object& value, const char* argument, const char* wanted);
/// "left" or "right".
Side sideFrom(const py::object& value);
/// "start" or "end". `argument` begins the error.
CurveEnd endFrom(const py::handle& value, const char* argument = "ends: each");
/// None, or a pair of "start" and "end".
std::optional<JoinEnds> endsFrom(const py::object& value);
/// None, a Tolerances, or the name of a preset.
Tolerances tolerancesFrom(const py::object& value);
AnalysisOptions optionsFrom(const py::object& order, const py::object& tolerances,
                            const py::object& scaleMm = py::none());
/// None or a callable. The result may be called without the GIL: it takes the GIL, lets Ctrl-C
/// through, calls, and goes on unless the callable returns something false other than None.
Progress progressFrom(const py::object& callback);

const char* name(CurveEnd end);

/// Throws std::invalid_argument unless t is within the curve's range.
void checkParameter(const BSplineCurve& curve, double t);
/// The segment over [0, 1]; nothing where it is a single point.
std::optional<BSplineCurve> asCurve(const BezierSegment& segment);

/// An array that owns a copy of `data`.
Array arrayOf(const double* data, std::vector<py::ssize_t> shape);

}  // namespace osculate::python
