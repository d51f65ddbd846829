#include "osculate/python/solid_arguments.h"

#include <cmath>
#include <fstream>
#include <stdexcept>

namespace osculate::python {

namespace {

constexpr double kSumTolerance = 1e-9;

void checkSums(const Array& rows, const char* argument) {
  const py::ssize_t columns = rows.shape(rows.ndim() - 1);
  for (py::ssize_t i = 0; i < rows.size(); i += columns) {
    double sum = 0.0;
    for (py::ssize_t c = 0; c < columns; ++c)
      sum += rows.data()[i + c];
    if (!(std::abs(sum - 1.0) <= kSumTolerance)) {
      throw std::invalid_argument(std::string(argument) +
                                  ": barycentric coordinates must have the sum 1, got " +
                                  std::to_string(sum));
    }
  }
}

}  // namespace

Array rowsFrom(const py::object& value, const char* argument, py::ssize_t columns) {
  const Array array = arrayFrom(value, argument);
  if (array.ndim() < 1 || array.shape(array.ndim() - 1) != columns) {
    throw std::invalid_argument(std::string(argument) + ": must have the shape (.., " +
                                std::to_string(columns) + "), got " +
                                std::string(py::str(array.attr("shape"))));
  }
  for (py::ssize_t i = 0; i < array.size(); ++i) {
    if (!std::isfinite(array.data()[i])) {
      throw std::invalid_argument(std::string(argument) +
                                  ": must be finite (found NaN or infinity)");
    }
  }
  return array;
}

template <int Corners>
Array coordinatesFrom(const py::object& value, const char* argument) {
  const Array rows = rowsFrom(value, argument, Corners);
  checkSums(rows, argument);
  return rows;
}
template Array coordinatesFrom<3>(const py::object&, const char*);
template Array coordinatesFrom<4>(const py::object&, const char*);

Eigen::VectorXd vectorFrom(const py::object& value, const char* argument, int dimension) {
  const Array row = rowsFrom(value, argument, dimension);
  if (row.ndim() != 1) {
    throw std::invalid_argument(std::string(argument) + ": must have the shape (" +
                                std::to_string(dimension) + ",)");
  }
  return Eigen::Map<const Eigen::VectorXd>(row.data(), dimension);
}

template <int Corners>
Barycentric<Corners> coordinateFrom(const py::object& value, const char* argument) {
  const Barycentric<Corners> result = vectorFrom(value, argument, Corners);
  coordinatesFrom<Corners>(value, argument);  // checks the sum
  return result;
}
template Barycentric<3> coordinateFrom<3>(const py::object&, const char*);
template Barycentric<4> coordinateFrom<4>(const py::object&, const char*);

MultiIndex<4> permutationFrom(const py::object& value, const char* argument) {
  const std::vector<int> numbers = integersFrom(value, argument);
  if (numbers.size() != 4) {
    throw std::invalid_argument(std::string(argument) + ": must be four numbers, got " +
                                std::to_string(numbers.size()));
  }
  return {numbers[0], numbers[1], numbers[2], numbers[3]};
}

Array rowsOf(const std::vector<double>& numbers, py::ssize_t columns) {
  return arrayOf(numbers.data(), {static_cast<py::ssize_t>(numbers.size()) / columns, columns});
}

py::array_t<int> rowsOf(const std::vector<int>& numbers, py::ssize_t columns) {
  return py::array_t<int>({static_cast<py::ssize_t>(numbers.size()) / columns, columns},
                          numbers.data());
}

void writeFile(const std::string& path, const std::function<void(std::ostream&)>& write) {
  std::ofstream stream(path, std::ios::binary);
  if (!stream) throw std::invalid_argument("path: cannot write " + path);
  write(stream);
  stream.close();
  if (!stream) throw std::invalid_argument("path: writing " + path + " failed");
}

}  // namespace osculate::python
