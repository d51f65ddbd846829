// osculate.Construction, its error, and the arguments that its makers share.
#include <algorithm>
#include <sstream>
#include <string>

#include "osculate/construction/contact_error.h"
#include "osculate/python/construction_record.h"

namespace osculate::python {

namespace {

constexpr const char* kConstructionDoc =
    R"(A constructed curve with the proof of what it meets: read-only.

Made by osculate.blend and its sisters. The reports analyse the finished poles, not what was asked for.)";

constexpr const char* kEnergyDoc =
    R"(How fair the curve is, as a dict; computed when first asked for.

Over the curve of length L, its parameter t taken as [0, 1]: 'bending' = L int kappa^2 ds, 'mvc' =
L^3 int |d(kappa vector)/ds|^2 ds (Moreton and Sequin 1992), 'speed' = int ln^2(|Q'|/L) dt, and
'objective', what was minimised, by its quadrature, None where nothing was free: all without
dimension. 'length_mm' is L.)";

constexpr const char* kChangeDoc =
    R"(What of a curve a match changed, as a dict; None where none was.

'end' ("start" or "end") meets the other curve now. From there 'spans' spans and 'poles' poles
differ, over the parameters 'range'; all others are as they were, bit for bit if 'raised', by how
much the degree was raised, is 0. 'kept' is the highest derivative at the far end that stays, None
where all do. 'rms_mm' is the root mean square of the displacement over the arc length of those
spans. The largest displacement is at 'parameter', from 'point' to 'moved'.)";

/// Each keeps the construction alive instead of a copy of itself.
template <std::vector<CurveJoin> Construction::*kJoins>
py::tuple reports(const RecordPointer& self) {
  std::vector<CurveJoin>& joins = (*self).*kJoins;
  py::tuple result(joins.size());
  for (std::size_t i = 0; i < joins.size(); ++i)
    result[i] = std::shared_ptr<CurveJoin>(self, &joins[i]);
  return result;
}

py::tuple beta(const ConstructionRecord& self) {
  return py::make_tuple(py::tuple(py::cast(self.beta[0])), py::tuple(py::cast(self.beta[1])));
}

/// Those without dimension.
py::dict dictOf(const Energies& known) {
  py::dict result;
  result["bending"] = known.bending;
  result["mvc"] = known.variation;
  result["speed"] = known.speed;
  return result;
}

py::dict energy(ConstructionRecord& self) {
  if (!self.knownEnergies) self.knownEnergies = energies(self.curve);
  py::dict result = dictOf(*self.knownEnergies);
  result["objective"] = self.objective;
  result["length_mm"] = self.knownEnergies->lengthMm;
  return result;
}

py::dict energiesOf(const BSplineCurve& curve) {
  const auto known = [&] {
    const py::gil_scoped_release release;
    return energies(curve);
  }();
  py::dict result = dictOf(known);
  result["length_mm"] = known.lengthMm;
  return result;
}

/// None, or a dict of what a match changed.
py::object change(const ConstructionRecord& self) {
  if (!self.change) return py::none();
  const CurveChange& change = *self.change;
  py::dict result;
  result["end"] = name(change.end);
  result["poles"] = change.poles;
  result["spans"] = change.spans;
  result["range"] = py::make_tuple(change.first, change.last);
  result["raised"] = change.raised;
  result["kept"] = change.kept;
  result["rms_mm"] = change.rootMeanSquareMm;
  result["parameter"] = change.parameter;
  result["point"] = arrayOf(change.point.data(), {3});
  result["moved"] = arrayOf(change.moved.data(), {3});
  return result;
}

std::string repr(const ConstructionRecord& self) {
  constexpr std::size_t kMostJoinsTold = 4;
  std::string text = "<osculate.Construction: degree " + std::to_string(self.curve.degree());
  int lowest = kMaxOrder;
  for (const CurveJoin& join : self.joins) {
    const int order = join.report.order;
    lowest = std::min(lowest, order);
    if (self.joins.size() <= kMostJoinsTold)
      text += order < 0 ? ", a gap" : ", G" + std::to_string(order);
  }
  if (self.joins.size() > kMostJoinsTold) {
    text += ", " + std::to_string(self.joins.size()) + " joins, the lowest " +
            (lowest < 0 ? "a gap" : "G" + std::to_string(lowest));
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
      .def_property_readonly("reports", &reports<&Construction::joins>,
                             "A JoinReport for each join that was made, by the preset `exact`, in "
                             "the order of travel.")
      .def_property_readonly("input_reports", &reports<&Construction::inputJoins>,
                             "Of osculate.join, the same joins as the curves were given; else an "
                             "empty tuple.")
      .def_property_readonly(
          "beta", &beta,
          "The free numbers ((beta_1, ...), (beta_1, ...)) at the first and the second end, "
          "without "
          "dimension: beta_k = (d^k s/dt^k) / chord, s and t measured from the end into the curve.")
      .def_property_readonly("energy", &energy, kEnergyDoc)
      .def_property_readonly(
          "warnings", [](const Record& self) { return py::tuple(py::cast(self.warnings)); },
          "A tuple of sentences, each begun by a word for its kind, e.g. 'cramped' or 'corner'.")
      .def_property_readonly(
          "max_displacement_mm", [](const Record& self) { return self.maxDisplacementMm; },
          "The largest distance by which a curve was changed; None where none was, as by a blend.")
      .def_property_readonly(
          "free_numbers", [](const Record& self) { return self.freeNumbers; },
          "How many numbers an extension's request left free, so that fairness chose them; else "
          "None.")
      .def_property_readonly("change", &change, kChangeDoc)
      .def("__repr__", &repr);
}

/// "forward" or "backward".
bool isForward(const py::object& value) {
  const std::string text = py::str(value);
  if (text == "forward") return true;
  if (text == "backward") return false;
  throw std::invalid_argument("ends: the direction must be 'forward' or 'backward', got " +
                              std::string(py::repr(value)));
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

int orderFrom(const py::object& value) {
  const int order = integerFrom(value, "order");
  if (order < 0 || order > kMaxOrder) {
    throw std::invalid_argument("order: must be from 0 to " + std::to_string(kMaxOrder) +
                                " at each end, got " + std::to_string(order));
  }
  return order;
}

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
         << ", " << curve.last() << (forward ? ']' : ')') << " where the new curve leaves "
         << (forward ? "forward" : "backward") << ", got " << t;
    throw std::invalid_argument(text.str());
  }
  return {.inside = true, .parameter = t, .forward = forward};
}

GivenNumbers givenNumbersFrom(const py::object& value, int order, const char* argument,
                              const char* wanted) {
  GivenNumbers numbers;
  if (value.is_none()) return numbers;
  if (!py::isinstance<py::tuple>(value) && !py::isinstance<py::list>(value))
    failType(argument, wanted, value);
  const py::sequence given = value;
  if (given.size() > static_cast<std::size_t>(order)) {
    throw std::invalid_argument(std::string(argument) + ": an end of order " +
                                std::to_string(order) + " has " + std::to_string(order) +
                                " numbers, got " + std::to_string(given.size()));
  }
  for (std::size_t k = 0; k < given.size(); ++k) {
    const py::object number = given[k];
    if (!number.is_none()) numbers[k] = numberFrom(number, argument);
  }
  return numbers;
}

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

void bindConstruction(py::module_& m) {
  py::register_local_exception_translator(&translateContactError);
  bindRecord(m);
  m.def("energies", &energiesOf, py::arg("curve"));
}

}  // namespace osculate::python
