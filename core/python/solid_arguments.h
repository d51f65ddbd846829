// From Python arguments to what Bézier solids need; private to this floor.
#pragma once

#include <functional>
#include <ostream>

#include "osculate/bezier/bezier_tetrahedron.h"
#include "osculate/python/arguments.h"

namespace osculate::python {

/// An array of shape (.., columns) of finite numbers; `wanted` names that shape in errors.
Array rowsFrom(const py::object& value, const char* argument, py::ssize_t columns);
/// Shape (.., Corners) with the sum 1 in each row.
template <int Corners>
Array coordinatesFrom(const py::object& value, const char* argument);
/// Shape (Corners,), sum 1.
template <int Corners>
Barycentric<Corners> coordinateFrom(const py::object& value, const char* argument);
/// Shape (3,) or (4,).
Eigen::VectorXd vectorFrom(const py::object& value, const char* argument, int dimension);
MultiIndex<4> permutationFrom(const py::object& value, const char* argument);

/// (points.size()/columns, columns), a copy.
Array rowsOf(const std::vector<double>& numbers, py::ssize_t columns);
py::array_t<int> rowsOf(const std::vector<int>& numbers, py::ssize_t columns);

/// What a person calls the file's error; opens it for writing.
void writeFile(const std::string& path, const std::function<void(std::ostream&)>& write);

}  // namespace osculate::python
