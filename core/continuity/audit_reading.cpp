#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "osculate/continuity/audit_document.h"
#include "osculate/continuity/deviation_fields.h"

namespace osculate {

namespace {

using Parsed = nlohmann::json;

[[noreturn]] void fail(const std::string& what) {
  throw std::invalid_argument("no audit report (schema osculate.audit/1): " + what);
}

/// The value of an enum whose name this is.
template <class Enum>
Enum named(const Parsed& value, int count, const char* what) {
  const std::string& text = value.get_ref<const std::string&>();
  for (int i = 0; i < count; ++i) {
    if (name(static_cast<Enum>(i)) == text) return static_cast<Enum>(i);
  }
  fail(std::string(what) + " '" + text + "' is unknown");
}

CurveEnd endFrom(const Parsed& value) {
  const std::string& text = value.get_ref<const std::string&>();
  if (text != "start" && text != "end") fail("end '" + text + "' is unknown");
  return text == "start" ? CurveEnd::kStart : CurveEnd::kEnd;
}

double numberOr(const Parsed& value, double missing) {
  return value.is_null() ? missing : value.get<double>();
}

std::string textFrom(const Parsed& value) {
  return value.is_null() ? std::string() : value.get<std::string>();
}

std::int8_t orderFrom(const Parsed& value) {
  const int order = value.get<int>();
  if (order < -1 || order > kMaxOrder) fail("order " + std::to_string(order) + " is impossible");
  return static_cast<std::int8_t>(order);
}

WarningSet warningsFrom(const Parsed& list) {
  WarningSet set;
  for (const Parsed& entry : list) {
    const std::string& text = entry.get_ref<const std::string&>();
    for (unsigned i = 0; i < static_cast<unsigned>(Warning::kCount); ++i) {
      if (code(static_cast<Warning>(i)) == text) set.add(static_cast<Warning>(i));
    }
  }
  return set;
}

AuditRow rowFrom(const Parsed& json) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  AuditRow row;
  row.edges = json.at("edges").get<std::array<int, 2>>();
  row.kind = named<JoinKind>(json.at("kind"), kJoinKindCount, "kind");
  if (row.kind == JoinKind::kKnot) {
    row.parameter = json.at("parameter").get<double>();
  } else {
    row.ends = {endFrom(json.at("ends").at(0)), endFrom(json.at("ends").at(1))};
  }
  row.point = json.at("point").get<std::array<double, 3>>();
  row.order = orderFrom(json.at("order"));
  row.parametricOrder = orderFrom(json.at("parametric_order"));
  const Parsed& verdicts = json.at("verdicts");
  const Parsed& residuals = json.at("residuals");
  if (verdicts.empty() || verdicts.size() > row.verdicts.size() ||
      residuals.size() != verdicts.size())
    fail("a row has a wrong number of orders");
  for (std::size_t k = 0; k < verdicts.size(); ++k) {
    row.verdicts[k] = named<Verdict>(verdicts[k], 3, "verdict");
    row.residuals[k] = numberOr(residuals[k], kInfinity);
  }
  Deviation deviation;
  for (const auto& [name, member] : kDeviationFields) {
    const Parsed& value = json.at("deviation").at(std::string(name));
    if (!value.is_null()) deviation.*member = value.get<double>();
  }
  row.residuals[1] = deviation.tangentAngleDegrees.value_or(kInfinity);
  row.setDeviation(deviation);
  row.warnings = warningsFrom(json.at("warnings"));
  return row;
}

/// A preset keeps its name and metric only where the numbers are its own.
Tolerances tolerancesFrom(const Parsed& options) {
  const Parsed& json = options.at("tolerances");
  const std::string& preset = options.at("preset").get_ref<const std::string&>();
  Tolerances tolerances;
  for (const TolerancePreset& known : tolerancePresets()) {
    if (known.name == preset) tolerances = Tolerances::preset(preset);
  }
  const Tolerances own = tolerances;
  tolerances.gapMm = json.at("gap_mm").get<double>();
  tolerances.angleDegrees = json.at("angle_deg").get<double>();
  tolerances.curvature = json.at("curvature").get<double>();
  tolerances.third = json.at("third").get<double>();
  tolerances.fourth = json.at("fourth").get<double>();
  bool isOwn = own.name == preset;
  for (int k = 0; k <= 4; ++k)
    isOwn = isOwn && own.ofOrder(k) == tolerances.ofOrder(k);
  if (!isOwn) tolerances.name = "custom";
  return tolerances;
}

AuditOptions optionsFrom(const Parsed& json) {
  AuditOptions options;
  options.analysis.order = json.at("order").get<int>();
  options.analysis.tolerances = tolerancesFrom(json);
  options.analysis.scaleMm = numberOr(json.at("scale_mm"), 0.0);
  options.pairs = joinPairs(json.at("pairs").get_ref<const std::string&>());
  options.touchMm = json.at("touch_mm").get<double>();
  options.cornerDegrees = numberOr(json.at("corner_deg"), options.cornerDegrees);
  checkAuditOptions(options);
  return options;
}

AuditedFile fileFrom(const Parsed& json, const AuditOptions& options) {
  AuditedFile file;
  file.file = textFrom(json.at("file"));
  file.status = named<FileStatus>(json.at("status"), 4, "status");
  file.message = textFrom(json.at("message"));
  file.notes = json.at("notes").get<std::vector<std::string>>();
  file.report.options = options;
  file.report.complete = json.at("complete").get<bool>();
  file.report.edgeCount = json.at("edges").get<int>();
  file.report.corners = json.at("corners_left_out").get<std::size_t>();
  for (const Parsed& edge : json.at("skipped")) {
    file.report.skipped.push_back({edge.at("edge").get<int>(), edge.at("degenerated").get<bool>(),
                                   edge.at("reason").get<std::string>()});
  }
  return file;
}

/// The rows are taken out one by one while the text is read, so that a report of a million rows
/// never stands in memory as JSON.
using RowsByFile = std::map<std::string, std::vector<AuditRow>>;

Parsed parseWithoutRows(std::istream& stream, RowsByFile& rows) {
  constexpr int kDepthOfRow = 2;  // of an element of a list of the root
  return Parsed::parse(stream, [&](int depth, Parsed::parse_event_t event, Parsed& value) {
    const bool isRow = event == Parsed::parse_event_t::object_end && depth == kDepthOfRow &&
                       value.contains("kind");
    if (!isRow) return true;
    rows[textFrom(value.at("file"))].push_back(rowFrom(value));
    return false;
  });
}

AuditDocument documentFrom(std::istream& stream) {
  RowsByFile rows;
  const Parsed json = parseWithoutRows(stream, rows);
  if (!json.is_object() || json.value("schema", "") != "osculate.audit/1")
    fail("it has another schema");
  AuditDocument document;
  document.options = optionsFrom(json.at("options"));
  std::set<std::string> listed;
  for (const Parsed& entry : json.at("files")) {
    document.files.push_back(fileFrom(entry, document.options));
    if (!listed.insert(document.files.back().file).second)
      fail("it lists the file '" + document.files.back().file + "' twice");
    const auto own = rows.find(document.files.back().file);
    if (own == rows.end()) continue;
    document.files.back().report.rows = std::move(own->second);
    rows.erase(own);
  }
  if (!rows.empty())
    fail("it has rows of the file '" + rows.begin()->first + "', which it does not list");
  return document;
}

}  // namespace

AuditDocument readAuditJson(std::istream& stream) {
  try {
    return documentFrom(stream);
  } catch (const Parsed::exception& error) {
    fail(error.what());
  }
}

}  // namespace osculate
