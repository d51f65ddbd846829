// From Python arguments to what Bézier solids need; private to this floor.
#pragma once

#include <functional>
#include <ostream>

#include "osculate/bezier/bezier_tetrahedron.h"
#include "osculate/python/arguments.h"

namespace osculate::python {

/// An array of shape (.., columns) of finite numbers.
Array rowsFrom(const py::object& value, const char* argument, py::ssize_t columns);
/// Shape (.., Corners) with the sum 1 in each row.
template <int Corners>
Array coordinatesFrom(const py::object& value, const char* argument);
/// Shape (Corners,), sum 1.
template <int Corners>
Barycentric<Corners> coordinateFrom(const py::object& value, const char* argument);
/// Shape (dimension,).
Eigen::VectorXd vectorFrom(const py::object& value, const char* argument, int dimension);
/// Four numbers; whether they are a permutation is for the core to say.
MultiIndex<4> permutationFrom(const py::object& value, const char* argument);

/// A copy of shape (numbers.size()/columns, columns).
Array rowsOf(const std::vector<double>& numbers, py::ssize_t columns);
py::array_t<int> rowsOf(const std::vector<int>& numbers, py::ssize_t columns);

/// Opens the file, lets `write` fill it and closes it; std::invalid_argument where one of that
/// fails.
void writeFile(const std::string& path, const std::function<void(std::ostream&)>& write);

}  // namespace osculate::python
