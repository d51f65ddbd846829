#include "osculate/python/arguments.h"

#include <cmath>
#include <limits>
#include <stdexcept>

namespace osculate::python {

namespace {

std::string shapeText(const py::array& array) { return py::str(array.attr("shape")); }

[[noreturn]] void failShape(const std::string& argument, const std::string& wanted,
                            const py::array& array) {
  throw std::invalid_argument(argument + ": must have the shape " + wanted + ", got " +
                              shapeText(array));
}

Array vectorFrom(const py::object& value, const char* argument) {
  Array array = arrayFrom(value, argument);
  if (array.ndim() != 1) failShape(argument, "(n,)", array);
  return array;
}

}  // namespace

void failType(const std::string& argument, const std::string& wanted, const py::handle& value) {
  throw py::type_error(argument + ": must be " + wanted + ", got " +
                       std::string(py::str(py::type::of(value).attr("__name__"))));
}

Array arrayFrom(const py::object& value, const char* argument) {
  const py::array array = py::array::ensure(value);
  if (!array) failType(argument, "an array of numbers (rows of equal length)", value);
  const char kind = array.dtype().kind();
  const bool isNumeric = kind == 'f' || kind == 'i' || kind == 'u';
  if (!isNumeric) failType(argument, "an array of real numbers", value);
  return Array::ensure(array);
}

Poles polesFrom(const py::object& value, const char* argument) {
  const Array array = arrayFrom(value, argument);
  if (array.ndim() != 2 || array.shape(1) != 3) failShape(argument, "(n+1, 3)", array);
  return Eigen::Map<const Poles>(array.data(), 3, array.shape(0));
}

std::vector<double> weightsFrom(const py::object& value, Eigen::Index count) {
  if (value.is_none()) return {};
  std::vector<double> weights = numbersFrom(value, "weights");
  if (static_cast<Eigen::Index>(weights.size()) != count) {
    throw std::invalid_argument("weights: one for each pole is needed, got " +
                                std::to_string(weights.size()) + " for " + std::to_string(count) +
                                " poles");
  }
  return weights;
}

std::vector<double> numbersFrom(const py::object& value, const char* argument) {
  const Array array = vectorFrom(value, argument);
  return {array.data(), array.data() + array.size()};
}

std::vector<int> integersFrom(const py::object& value, const char* argument) {
  std::vector<int> result;
  for (const double number : numbersFrom(value, argument)) {
    const bool isInt =
        number == std::floor(number) && std::abs(number) <= std::numeric_limits<int>::max();
    if (!isInt) throw std::invalid_argument(std::string(argument) + ": must be whole numbers");
    result.push_back(static_cast<int>(number));
  }
  return result;
}

double numberFrom(const py::object& value, const char* argument) {
  const double number = PyFloat_AsDouble(value.ptr());
  if (number == -1.0 && PyErr_Occurred() != nullptr) {
    PyErr_Clear();
    failType(argument, "a number", value);
  }
  return number;
}

int integerFrom(const py::object& value, const char* argument) {
  const auto index = py::reinterpret_steal<py::object>(PyNumber_Index(value.ptr()));
  if (!index) {
    PyErr_Clear();
    failType(argument, "an integer", value);
  }
  int overflow = 0;
  const long number = PyLong_AsLongAndOverflow(index.ptr(), &overflow);
  if (overflow != 0 || std::abs(number) > std::numeric_limits<int>::max()) {
    throw std::invalid_argument(std::string(argument) + ": " + std::string(py::str(index)) +
                                " is out of range");
  }
  return static_cast<int>(number);
}

bool boolFrom(const py::object& value, const char* argument) {
  if (!PyBool_Check(value.ptr())) failType(argument, "True or False", value);
  return value.is(py::bool_(true));
}

py::sequence pairFrom(const py::object& value, const char* argument, const char* wanted) {
  if (!py::isinstance<py::tuple>(value) && !py::isinstance<py::list>(value)) {
    failType(argument, wanted, value);
  }
  const py::sequence pair = value;
  if (pair.size() != 2) {
    throw std::invalid_argument(std::string(argument) + ": must be a pair, got " +
                                std::to_string(pair.size()) + " values");
  }
  return pair;
}

Side sideFrom(const py::object& value) {
  const std::string text = py::str(value);
  if (text == "left") return Side::kLeft;
  if (text == "right") return Side::kRight;
  throw std::invalid_argument("side: must be 'left' or 'right', got " +
                              std::string(py::repr(value)));
}

const char* name(CurveEnd end) { return end == CurveEnd::kStart ? "start" : "end"; }

CurveEnd endFrom(const py::handle& value, const char* argument) {
  const std::string text = py::str(value);
  if (text == "start") return CurveEnd::kStart;
  if (text == "end") return CurveEnd::kEnd;
  throw std::invalid_argument(std::string(argument) + " must be 'start' or 'end', got " +
                              std::string(py::repr(value)));
}

std::optional<JoinEnds> endsFrom(const py::object& value) {
  if (value.is_none()) return {};
  const py::sequence pair = pairFrom(value, "ends", "None or a pair of 'start' and 'end'");
  return JoinEnds{endFrom(pair[0]), endFrom(pair[1])};
}

Tolerances tolerancesFrom(const py::object& value) {
  if (value.is_none()) return {};
  if (py::isinstance<Tolerances>(value)) return value.cast<Tolerances>();
  if (py::isinstance<py::str>(value)) return Tolerances::preset(value.cast<std::string>());
  failType("tolerances", "None, a Tolerances or the name of a preset", value);
}

AnalysisOptions optionsFrom(const py::object& order, const py::object& tolerances,
                            const py::object& scaleMm) {
  AnalysisOptions options;
  options.order = integerFrom(order, "order");
  options.tolerances = tolerancesFrom(tolerances);
  if (!scaleMm.is_none()) {
    options.scaleMm = numberFrom(scaleMm, "scale_mm");
    if (!(std::isfinite(options.scaleMm) && options.scaleMm > 0.0)) {
      throw std::invalid_argument("scale_mm: must be finite and > 0");
    }
  }
  checkOptions(options);
  return options;
}

Progress progressFrom(const py::object& callback) {
  if (!callback.is_none() && PyCallable_Check(callback.ptr()) == 0) {
    failType("progress", "None or a callable", callback);
  }
  return [callback = callback.ptr()](double share) {
    const py::gil_scoped_acquire gil;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    if (callback == Py_None) return true;
    const py::object answer = py::handle(callback)(share);
    const int isTrue = PyObject_IsTrue(answer.ptr());
    if (isTrue < 0) throw py::error_already_set();
    return answer.is_none() || isTrue == 1;
  };
}

Array arrayOf(const double* data, std::vector<py::ssize_t> shape) {
  return Array(std::move(shape), data);  // without a base object NumPy copies
}

}  // namespace osculate::python
