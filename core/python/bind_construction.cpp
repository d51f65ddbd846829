// osculate.Construction and the constructions that make it. The package `osculate` puts its public
// functions in front of these.
#include <memory>
#include <sstream>
#include <string>

#include <pybind11/stl.h>

#include "osculate/construction/construction.h"
#include "osculate/construction/contact_error.h"
#include "osculate/python/arguments.h"

namespace osculate::python {

namespace {

constexpr const char* kConstructionDoc =
    R"(A constructed curve with the proof of what it meets: read-only.

Made by osculate.blend. The reports analyse the finished poles, not what was asked for.)";

constexpr const char* kEnergyDoc =
    R"(How fair the curve is, as a dict; computed when first asked for.

Over the curve of length L, its parameter t taken as [0, 1]: 'bending' = L int kappa^2 ds, 'mvc' =
L^3 int |d(kappa vector)/ds|^2 ds (Moreton and Sequin 1992), 'speed' = int ln^2(|Q'|/L) dt, and
'objective', what was minimised, by its quadrature, or None: all without dimension. 'length_mm' is L.)";

/// A construction with what Python may ask of it later.
struct ConstructionRecord : Construction {
  std::optional<Energies> knownEnergies;
};

using RecordPointer = std::shared_ptr<ConstructionRecord>;
using GivenNumbers = std::array<std::optional<double>, kMaxOrder>;

/// An integer for both ends, or a pair.
std::array<int, 2> ordersFrom(const py::object& value) {
  const bool isPair = py::isinstance<py::tuple>(value) || py::isinstance<py::list>(value);
  const py::sequence both = isPair ? value : py::make_tuple(value, value);
  const py::sequence pair = pairFrom(both, "order", "an integer or a pair of them");
  const std::array<int, 2> orders{integerFrom(pair[0], "order"), integerFrom(pair[1], "order")};
  for (const int order : orders) {
    if (order < 0 || order > kMaxOrder) {
      throw std::invalid_argument("order: must be from 0 to " + std::to_string(kMaxOrder) +
                                  " at each end, got " + std::to_string(order));
    }
  }
  return orders;
}

/// "forward" or "backward".
bool isForward(const py::object& value) {
  const std::string text = py::str(value);
  if (text == "forward") return true;
  if (text == "backward") return false;
  throw std::invalid_argument("ends: the direction must be 'forward' or 'backward', got " +
                              std::string(py::repr(value)));
}

/// "start", "end" or (t, direction).
Departure departureFrom(const py::object& value, const BSplineCurve& curve) {
  if (py::isinstance<py::str>(value)) return {.end = endFrom(value)};
  const py::sequence pair = pairFrom(value, "ends", "'start', 'end' or (t, direction) for each");
  const double t = numberFrom(pair[0], "ends: t");
  const bool forward = isForward(pair[1]);
  const bool isPartLeft =
      forward ? curve.first() < t && t <= curve.last() : curve.first() <= t && t < curve.last();
  if (!isPartLeft) {
    std::ostringstream text;
    text << "ends: t must be within the curve's range " << (forward ? '(' : '[') << curve.first()
         << ", " << curve.last() << (forward ? ']' : ')') << " where the blend leaves "
         << (forward ? "forward" : "backward") << ", got " << t;
    throw std::invalid_argument(text.str());
  }
  return {.inside = true, .parameter = t, .forward = forward};
}

std::array<Departure, 2> departuresFrom(const py::object& value, const BSplineCurve& first,
                                        const BSplineCurve& second) {
  if (value.is_none()) return nearestDepartures(first, second);
  const py::sequence pair = pairFrom(value, "ends", "None or a pair, one for each curve");
  return {departureFrom(pair[0], first), departureFrom(pair[1], second)};
}

/// None for no numbers, or a tuple of at most `order` numbers, each None where it is chosen.
GivenNumbers givenFrom(const py::object& value, int order) {
  GivenNumbers numbers;
  if (value.is_none()) return numbers;
  if (!py::isinstance<py::tuple>(value) && !py::isinstance<py::list>(value)) {
    failType("beta", "None or a pair of tuples of numbers", value);
  }
  const py::sequence given = value;
  if (given.size() > static_cast<std::size_t>(order)) {
    throw std::invalid_argument("beta: an end of order " + std::to_string(order) + " has " +
                                std::to_string(order) + " numbers, got " +
                                std::to_string(given.size()));
  }
  for (std::size_t k = 0; k < given.size(); ++k) {
    const py::object number = given[k];
    if (!number.is_none()) numbers[k] = numberFrom(number, "beta");
  }
  return numbers;
}

std::array<GivenNumbers, 2> betaFrom(const py::object& value, const std::array<int, 2>& orders) {
  if (value.is_none()) return {};
  const py::sequence pair = pairFrom(value, "beta", "None or a pair of tuples of numbers");
  return {givenFrom(pair[0], orders[0]), givenFrom(pair[1], orders[1])};
}

/// None for the least degree, which the core calls 0.
int degreeFrom(const py::object& value) {
  if (value.is_none()) return 0;
  const int degree = integerFrom(value, "degree");
  if (degree < 1) {
    throw std::invalid_argument(
        "degree: must be at least 1, or None for the least that the orders "
        "need, got " +
        std::to_string(degree));
  }
  return degree;
}

std::optional<Fairness> fairnessFrom(const py::object& value) {
  if (value.is_none()) return {};
  const std::string text = py::str(value);
  if (text == "mvc") return Fairness::kMinimumVariation;
  if (text == "bending") return Fairness::kBending;
  throw std::invalid_argument("fairness: must be 'mvc', 'bending' or None, got " +
                              std::string(py::repr(value)));
}

RecordPointer makeBlend(const BSplineCurve& first, const BSplineCurve& second,
                        const py::object& order, const py::object& ends, const py::object& beta,
                        const py::object& degree, const py::object& fairness,
                        const py::object& symmetric) {
  BlendOptions options;
  options.order = ordersFrom(order);
  options.degree = degreeFrom(degree);
  options.beta = betaFrom(beta, options.order);
  options.symmetric = boolFrom(symmetric, "symmetric");
  options.fairness = fairnessFrom(fairness);
  const std::array<Departure, 2> departures = departuresFrom(ends, first, second);
  const py::gil_scoped_release release;
  return std::make_shared<ConstructionRecord>(
      ConstructionRecord{blendCurves(first, second, departures, options), {}});
}

/// Each keeps the construction alive instead of a copy of itself.
py::tuple reports(const RecordPointer& self) {
  py::tuple result(self->joins.size());
  for (std::size_t i = 0; i < self->joins.size(); ++i) {
    result[i] = std::shared_ptr<CurveJoin>(self, &self->joins[i]);
  }
  return result;
}

py::tuple beta(const ConstructionRecord& self) {
  return py::make_tuple(py::tuple(py::cast(self.beta[0])), py::tuple(py::cast(self.beta[1])));
}

py::dict energy(ConstructionRecord& self) {
  if (!self.knownEnergies) self.knownEnergies = energies(self.curve);
  const Energies& known = *self.knownEnergies;
  py::dict result;
  result["bending"] = known.bending;
  result["mvc"] = known.variation;
  result["speed"] = known.speed;
  result["objective"] = self.objective;
  result["length_mm"] = known.lengthMm;
  return result;
}

std::string repr(const ConstructionRecord& self) {
  std::string text = "<osculate.Construction: degree " + std::to_string(self.curve.degree());
  for (const CurveJoin& join : self.joins) {
    const int order = join.report.order;
    text += order < 0 ? ", a gap" : ", G" + std::to_string(order);
  }
  if (!self.warnings.empty()) text += ", warnings: " + std::to_string(self.warnings.size());
  return text + ">";
}

void bindRecord(py::module_& m) {
  using Record = ConstructionRecord;
  py::class_<Record, RecordPointer>(m, "Construction", kConstructionDoc)
      .def_property_readonly(
          "curve", [](const Record& self) { return self.curve; }, "The Curve.")
      .def_property_readonly(
          "edge", [](const Record& self) { return py::cast(self.curve).attr("to_edge")(); },
          "The curve as a new Part.Edge (in FreeCAD; ImportError elsewhere).")
      .def_property_readonly("reports", &reports,
                             "A JoinReport for each join that was made, by the preset `exact`, the "
                             "first curve's before the second's.")
      .def_property_readonly(
          "beta", &beta,
          "The free numbers ((beta_1, ...), (beta_1, ...)) at the first and the second end, "
          "without "
          "dimension: beta_k = (d^k s/dt^k) / chord, s and t measured from the end into the curve.")
      .def_property_readonly("energy", &energy, kEnergyDoc)
      .def_property_readonly(
          "warnings", [](const Record& self) { return py::tuple(py::cast(self.warnings)); },
          "A tuple of sentences: what is cramped, and where rounding keeps a join from its order.")
      .def_property_readonly(
          "max_displacement_mm", [](const Record&) { return py::none(); },
          "The largest distance by which a curve was changed; None where none was, as by a blend.")
      .def("__repr__", &repr);
}

/// osculate.ContactError is a class of Python, so that it exists where this module does not load.
void translateContactError(std::exception_ptr error) {
  try {
    if (error) std::rethrow_exception(error);
  } catch (const ContactError& contact) {
    const py::object type = py::module_::import("osculate.errors").attr("ContactError");
    PyErr_SetString(type.ptr(), contact.what());
  }
}

}  // namespace

void bindConstruction(py::module_& m) {
  py::register_local_exception_translator(&translateContactError);
  bindRecord(m);
  m.def("blend", &makeBlend, py::arg("first"), py::arg("second"), py::arg("order"), py::arg("ends"),
        py::arg("beta"), py::arg("degree"), py::arg("fairness"), py::arg("symmetric"));
}

}  // namespace osculate::python
