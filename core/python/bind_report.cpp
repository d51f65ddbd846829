// osculate.JoinReport: the numbers of a join as lazy, read-only attributes.
#include <algorithm>
#include <cmath>
#include <string>

#include <pybind11/stl.h>
#include <nlohmann/json.hpp>

#include "osculate/continuity/report_json.h"
#include "osculate/continuity/report_text.h"
#include "osculate/python/arguments.h"
#include "osculate/python/join_side.h"
#include "osculate/python/report_values.h"

namespace osculate::python {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kReportDoc = R"(What an analysis says of one join: read-only.

Both sides are taken in the direction of travel: the first curve arrives at the join, the second
leaves it; signs and rates follow. What does not exist is None, never a made-up number. str() is the
table that a person reads; to_dict() and to_json() give the same data, schema osculate.join/1.)";

constexpr const char* kWarningDoc =
    R"(What a report warns of: `code` for programs, `sentence` for people.

A JoinWarning equals its code: `"cusp" in report.warnings`.)";

constexpr const char* kDetailDoc = R"(One meaning of G2 or G3, evaluated at a join.)";

constexpr const char* kToDictDoc = R"(to_dict(self)
--

The report as dict, list, str, float, int and None: schema osculate.join/1.)";

constexpr const char* kToJsonDoc = R"(to_json(self, indent=None)
--

The report as JSON text, schema osculate.join/1; `indent` spaces a level, None for one line.)";

struct DefinitionDetail {
  const DefinitionInfo* info;
  DefinitionResult result;
};

template <class Map>
auto property(Map map) {
  return [map](const CurveJoin& self) { return map(self.report); };
}

/// The numbers of the orders asked for.
template <auto member>
py::tuple perOrder(const CurveJoin& self) {
  return upTo(self.report.requestedOrder, self.report.*member);
}

py::tuple parametricResiduals(const JoinReport& report) {
  return upTo(std::min(report.parametricOrder + 1, report.requestedOrder),
              report.parametricResiduals);
}

py::tuple verdicts(const JoinReport& report) {
  py::tuple result(report.requestedOrder + 1);
  for (std::size_t k = 0; k < result.size(); ++k)
    result[k] = name(report.verdicts[k]);
  return result;
}

py::tuple betas(const JoinReport& report) {
  py::tuple result(report.requestedOrder);
  for (std::size_t k = 0; k < result.size(); ++k) {
    const bool exists = static_cast<int>(k) < report.betaCount;
    result[k] = exists ? finite(report.beta[k]) : py::none();
  }
  return result;
}

py::dict deviation(const JoinReport& report) { return deviationDict(report.deviation); }

py::object verdictText(const DefinitionResult& result) {
  return result.verdict ? py::object(py::cast(name(*result.verdict))) : py::none();
}

/// `map` of each definition, by name.
template <class Map>
py::dict byDefinition(const JoinReport& report, Map map) {
  py::dict all;
  for (int i = 0; i < kDefinitionCount; ++i) {
    const DefinitionInfo& about = info(static_cast<Definition>(i));
    all[py::cast(about.name)] = map(about, report.definitions[static_cast<std::size_t>(i)]);
  }
  return all;
}

py::dict definitions(const JoinReport& report) {
  return byDefinition(report, [](const DefinitionInfo&, const DefinitionResult& result) {
    return verdictText(result);
  });
}

py::dict definitionDetails(const JoinReport& report) {
  return byDefinition(report, [](const DefinitionInfo& about, const DefinitionResult& result) {
    return DefinitionDetail{&about, result};
  });
}

py::tuple warnings(const JoinReport& report) { return py::tuple(py::cast(report.warnings.list())); }

py::object toPython(const Json& value) {
  switch (value.type()) {
    case Json::value_t::object: {
      py::dict result;
      for (const auto& [key, element] : value.items())
        result[py::cast(key)] = toPython(element);
      return result;
    }
    case Json::value_t::array: {
      py::list result;
      for (const Json& element : value)
        result.append(toPython(element));
      return result;
    }
    case Json::value_t::string:
      return py::cast(value.get_ref<const std::string&>());
    case Json::value_t::boolean:
      return py::bool_(value.get<bool>());
    case Json::value_t::number_integer:
    case Json::value_t::number_unsigned:
      return py::int_(value.get<std::int64_t>());
    case Json::value_t::number_float:
      return py::float_(value.get<double>());
    default:
      return py::none();
  }
}

std::string toJsonText(const CurveJoin& self, const py::object& indent) {
  return toJson(self).dump(indent.is_none() ? -1 : integerFrom(indent, "indent"));
}

std::string repr(const CurveJoin& self) {
  return "<osculate.JoinReport: " + headline(self.report) + ">";
}

void bindWarning(py::module_& m) {
  py::class_<Warning>(m, "JoinWarning", kWarningDoc)
      .def_property_readonly(
          "code", [](Warning self) { return code(self); }, "Short text, e.g. 'cusp'.")
      .def_property_readonly(
          "sentence", [](Warning self) { return sentence(self); }, "For a person.")
      .def(
          "__eq__", [](Warning self, Warning other) { return self == other; }, py::is_operator())
      .def(
          "__eq__", [](Warning self, const std::string& other) { return code(self) == other; },
          py::is_operator())
      .def("__hash__", [](Warning self) { return py::hash(py::cast(code(self))); })
      .def(
          "__str__",
          [](Warning self) { return std::string(code(self)) + ": " + std::string(sentence(self)); })
      .def("__repr__",
           [](Warning self) { return "<osculate.JoinWarning " + std::string(code(self)) + ">"; });
}

void bindDetail(py::module_& m) {
  using Detail = DefinitionDetail;
  const auto number = [](double DefinitionResult::*member) {
    return [member](const Detail& self) {
      return self.result.verdict ? finite(self.result.*member) : py::none();
    };
  };
  py::class_<Detail>(m, "DefinitionDetail", kDetailDoc)
      .def_property_readonly(
          "verdict", [](const Detail& self) { return verdictText(self.result); },
          "'pass', 'fail', 'undecided', or None where the definition says nothing.")
      .def_property_readonly("value", number(&DefinitionResult::value),
                             "What is compared, in `unit`.")
      .def_property_readonly("tolerance", number(&DefinitionResult::tolerance),
                             "The largest value that passes.")
      .def_property_readonly(
          "unit", [](const Detail& self) { return self.info->unit; },
          "Unit of value and tolerance, empty if dimensionless.")
      .def_property_readonly(
          "who", [](const Detail& self) { return self.info->who; }, "The systems that mean this.")
      .def_property_readonly(
          "meaning", [](const Detail& self) { return self.info->meaning; },
          "The condition in words.");
}

using ReportClass = py::class_<CurveJoin, JoinPointer>;

void bindVerdicts(ReportClass& report) {
  report
      .def_property_readonly(
          "order", property([](const JoinReport& r) { return r.order; }),
          "The highest m up to `requested_order` for which the orders 0..m all pass (G^m); "
          "-1 at a gap. Where order m+1 is undecided, a warning `undecided` says so.")
      .def_property_readonly("parametric_order",
                             property([](const JoinReport& r) { return r.parametricOrder; }),
                             "The same for C^m, in the curves' own parameters.")
      .def_property_readonly("requested_order",
                             property([](const JoinReport& r) { return r.requestedOrder; }),
                             "The order asked for, 0 to 8.")
      .def_property_readonly("preset", property([](const JoinReport& r) { return r.preset; }),
                             "Name of the tolerances, or 'custom'.")
      .def_property_readonly(
          "verdicts", property(&verdicts),
          "For each order from 0, judged by itself: 'pass', 'fail' or 'undecided' (the "
          "tolerance lies within residual +- uncertainty).")
      .def_property_readonly(
          "residuals", &perOrder<&JoinReport::residuals>,
          "For each order from 0: mm, degrees (0 to 180), then dimensionless; None where "
          "a side has no such derivative.")
      .def_property_readonly("tolerances", &perOrder<&JoinReport::tolerances>,
                             "For each order from 0, in the unit of its residual.")
      .def_property_readonly(
          "uncertainties", &perOrder<&JoinReport::uncertainties>,
          "For each order from 0: bound of the error of the residual that double "
          "coordinates (and a converted curve) carry; None where there is no bound.")
      .def_property_readonly(
          "parametric_residuals", property(&parametricResiduals),
          "The residuals of C^m from order 0 up to the first that fails: mm, then "
          "dimensionless (order 1 to be compared with the angle in radians).")
      .def_property_readonly(
          "beta", property(&betas),
          "(beta_1, beta_2, ...) that carry the first curve's derivatives into the "
          "second's, by the parameters of the two segments; None from the first order "
          "that fails.")
      .def_property_readonly("scale_mm", property([](const JoinReport& r) { return r.scaleMm; }),
                             "L, the length that residuals from order 2 on refer to, mm.");
}

py::tuple sides(const JoinPointer& self) {
  return py::make_tuple(JoinSideView{self, 0}, JoinSideView{self, 1});
}

py::tuple ends(const JoinReport& report) {
  return py::make_tuple(name(report.sides[0].end), name(report.sides[1].end));
}

void bindDescription(ReportClass& report) {
  report
      .def_property_readonly(
          "deviation", property(&deviation),
          "Physical deviations between the sides, by name with unit; None where a side "
          "has no such number.")
      .def_property_readonly("sides", &sides, "Two JoinSide: the arriving and the leaving curve.")
      .def_property_readonly("ends", property(&ends), "Which ends meet, e.g. ('end', 'start').")
      .def_property_readonly(
          "parameter", [](const CurveJoin& self) { return self.parameter; },
          "The parameter of an inner knot, or None.")
      .def_property_readonly("frame", property([](const JoinReport& r) { return r.frame; }),
                             "FrenetFrame of the first curve at the join, always complete.")
      .def_property_readonly("frame_kind",
                             property([](const JoinReport& r) { return name(r.frameKind); }),
                             "'frenet', 'fictitious-normal', 'line' or 'fictitious-tangent'.")
      .def_property_readonly(
          "definitions", property(&definitions),
          "Verdict of each meaning of G2 and G3, by name; None where it says nothing.")
      .def_property_readonly("definition_details", property(&definitionDetails),
                             "DefinitionDetail of each meaning of G2 and G3, by name.")
      .def_property_readonly("disagreement", property(&disagreement),
                             "Why the definitions disagree, in a sentence; empty where they agree.")
      .def_property_readonly("warnings", property(&warnings), "A tuple of JoinWarning.")
      .def_property_readonly("headline", property(&headline), "The verdict in one line.")
      .def(
          "to_dict", [](const CurveJoin& self) { return toPython(toJson(self)); }, kToDictDoc)
      .def("to_json", &toJsonText, py::arg("indent") = py::none(), kToJsonDoc)
      .def("__str__", property(&reportTable))
      .def("__repr__", &repr);
}

}  // namespace

void bindReport(py::module_& m) {
  bindWarning(m);
  bindDetail(m);
  ReportClass report(m, "JoinReport", kReportDoc);
  bindVerdicts(report);
  bindDescription(report);
}

}  // namespace osculate::python
