// Many joins of Bézier segments in arrays.
#include <stdexcept>

#include "osculate/continuity/batch.h"
#include "osculate/python/arguments.h"

namespace osculate::python {

namespace {

/// Poles and weights of one side of all joins; the arrays stay alive with it.
struct BatchSide {
  Array poles;
  std::optional<Array> weights;

  std::size_t count() const { return static_cast<std::size_t>(poles.shape(0)); }
  int degree() const { return static_cast<int>(poles.shape(1)) - 1; }
  const double* weightData() const { return weights ? weights->data() : nullptr; }
};

Eigen::Map<const Eigen::ArrayXd> valuesOf(const Array& array) {
  return {array.data(), array.size()};
}

/// 0 times infinity or NaN is NaN; as a sum it is several times as fast as one test for each
/// number.
bool allFinite(const Array& array) { return (0.0 * valuesOf(array)).sum() == 0.0; }

void checkPoles(const Array& poles, const std::string& argument) {
  if (poles.ndim() != 3 || poles.shape(2) != 3) {
    throw std::invalid_argument(argument + ": must have the shape (N, n+1, 3)");
  }
  if (poles.shape(1) < 2 || poles.shape(1) > kMaxDegree + 1) {
    throw std::invalid_argument(argument + ": 2 to " + std::to_string(kMaxDegree + 1) +
                                " poles for each segment are needed, got " +
                                std::to_string(poles.shape(1)));
  }
  if (!allFinite(poles)) {
    throw std::invalid_argument(argument + ": every coordinate must be finite");
  }
}

void checkWeights(const Array& weights, const Array& poles, const std::string& argument) {
  if (weights.ndim() != 2 || weights.shape(0) != poles.shape(0) ||
      weights.shape(1) != poles.shape(1)) {
    throw std::invalid_argument(argument + ": must have the shape (N, n+1), one for each pole");
  }
  const bool isPositive = weights.size() == 0 || valuesOf(weights).minCoeff() > 0.0;
  if (!(isPositive && allFinite(weights))) {
    throw std::invalid_argument(argument + ": every weight must be finite and > 0");
  }
}

BatchSide sideFrom(const py::object& poles, const py::object& weights, const std::string& name) {
  const std::string polesName = name + "_poles";
  const std::string weightsName = name + "_weights";
  BatchSide side{arrayFrom(poles, polesName.c_str()), {}};
  checkPoles(side.poles, polesName);
  if (!weights.is_none()) {
    side.weights = arrayFrom(weights, weightsName.c_str());
    checkWeights(*side.weights, side.poles, weightsName);
  }
  return side;
}

/// Result arrays of `count` rows.
struct BatchArrays {
  py::array_t<std::int8_t> order;
  py::array_t<std::int8_t> parametricOrder;
  py::array_t<std::uint8_t> verdicts;
  py::array_t<double> residuals;
  py::array_t<double> uncertainties;

  BatchArrays(std::size_t count, std::size_t columns)
      : order(count),
        parametricOrder(count),
        verdicts({count, columns}),
        residuals({count, columns}),
        uncertainties({count, columns}) {}

  BatchOutput output() {
    return {order.mutable_data(), parametricOrder.mutable_data(), verdicts.mutable_data(),
            residuals.mutable_data(), uncertainties.mutable_data()};
  }

  /// The first `count` rows.
  py::tuple rows(std::size_t count) const {
    if (static_cast<std::size_t>(order.shape(0)) == count) {
      return py::make_tuple(order, parametricOrder, verdicts, residuals, uncertainties);
    }
    const py::slice done(0, static_cast<py::ssize_t>(count), 1);
    const auto cut = [&](const py::array& array) { return array[done].attr("copy")(); };
    return py::make_tuple(cut(order), cut(parametricOrder), cut(verdicts), cut(residuals),
                          cut(uncertainties));
  }
};

py::tuple analyzeArrays(const py::object& firstPoles, const py::object& secondPoles,
                        const py::object& firstWeights, const py::object& secondWeights,
                        const py::object& order, const py::object& tolerances,
                        const py::object& callback) {
  const AnalysisOptions options = optionsFrom(order, tolerances);
  const Progress progress = progressFrom(callback);
  const BatchSide first = sideFrom(firstPoles, firstWeights, "first");
  const BatchSide second = sideFrom(secondPoles, secondWeights, "second");
  if (first.count() != second.count()) {
    throw std::invalid_argument("second_poles: as many segments as first_poles are needed, got " +
                                std::to_string(second.count()) + " for " +
                                std::to_string(first.count()));
  }
  const BatchInput input{first.count(),      first.poles.data(),  second.poles.data(),
                         first.weightData(), second.weightData(), first.degree(),
                         second.degree()};
  BatchArrays arrays(first.count(), static_cast<std::size_t>(options.order) + 1);
  const BatchOutput output = arrays.output();
  const std::size_t done = [&] {
    const py::gil_scoped_release release;
    return analyzeBatch(input, output, options, progress);
  }();
  return arrays.rows(done);
}

}  // namespace

void bindBatch(py::module_& m) {
  m.def("analyze_arrays", &analyzeArrays, py::arg("first_poles"), py::arg("second_poles"),
        py::arg("first_weights"), py::arg("second_weights"), py::arg("order"),
        py::arg("tolerances"), py::arg("progress"));
}

}  // namespace osculate::python
