#include <cmath>
#include <nlohmann/json.hpp>

#include "osculate/continuity/audit_document.h"
#include "osculate/continuity/deviation_fields.h"
#include "osculate/continuity/text_format.h"
#include "osculate/continuity/text_pieces.h"

namespace osculate {

namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }
Json text(const std::string& value) { return value.empty() ? Json(nullptr) : Json(value); }

/// One line; bytes of a file's name that are no UTF-8 become the replacement character.
std::string line(const Json& value) {
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json optionsJson(const AuditOptions& options) {
  const AnalysisOptions& analysis = options.analysis;
  const Tolerances& tolerances = analysis.tolerances;
  Json result{{"order", analysis.order},
              {"preset", tolerances.name},
              {"tolerances",
               {{"gap_mm", tolerances.gapMm},
                {"angle_deg", tolerances.angleDegrees},
                {"curvature", tolerances.curvature},
                {"third", tolerances.third},
                {"fourth", tolerances.fourth}}},
              {"scale_mm", analysis.scaleMm > 0.0 ? Json(analysis.scaleMm) : Json(nullptr)},
              {"pairs", name(options.pairs)},
              {"touch_mm", options.touchMm}};
  const bool leavesOut = options.pairs == JoinPairs::kTangent;
  result["corner_deg"] = leavesOut ? Json(options.cornerDegrees) : Json(nullptr);
  return result;
}

Json fileJson(const AuditedFile& file, const AuditOptions& options) {
  Json skipped = Json::array();
  for (const SkippedEdge& edge : file.report.skipped) {
    skipped.push_back(
        {{"edge", edge.edge}, {"degenerated", edge.degenerated}, {"reason", edge.reason}});
  }
  return {{"file", text(file.file)},
          {"status", name(file.status)},
          {"message", text(file.message)},
          {"notes", file.notes},
          {"complete", file.report.complete},
          {"edges", file.report.edgeCount},
          {"corners_left_out", file.report.corners},
          {"summary", auditSummaryJson(summarize(file.report.rows), options)},
          {"skipped", std::move(skipped)}};
}

Json deviationJson(const Deviation& deviation) {
  Json result{{"gap_mm", deviation.gapMm}};
  for (const auto& [name, member] : kDeviationFields) {
    const std::optional<double>& value = deviation.*member;
    result[std::string(name)] = value ? number(*value) : Json(nullptr);
  }
  return result;
}

Json rowJson(const AuditRow& row, const std::string& file, int order) {
  const bool isKnot = row.kind == JoinKind::kKnot;
  const auto end = [](CurveEnd which) { return which == CurveEnd::kStart ? "start" : "end"; };
  Json verdicts = Json::array();
  Json residuals = Json::array();
  for (std::size_t k = 0; k <= static_cast<std::size_t>(order); ++k) {
    verdicts.push_back(name(row.verdicts[k]));
    residuals.push_back(number(row.residuals[k]));
  }
  Json warnings = Json::array();
  for (const Warning warning : row.warnings.list())
    warnings.push_back(code(warning));
  return {{"file", text(file)},
          {"kind", name(row.kind)},
          {"edges", row.edges},
          {"ends", isKnot ? Json(nullptr) : Json{end(row.ends.first), end(row.ends.second)}},
          {"parameter", isKnot ? Json(row.parameter) : Json(nullptr)},
          {"point", row.point},
          {"order", row.order},
          {"parametric_order", row.parametricOrder},
          {"verdicts", std::move(verdicts)},
          {"residuals", std::move(residuals)},
          {"deviation", deviationJson(row.deviation())},
          {"warnings", std::move(warnings)}};
}

}  // namespace

nlohmann::ordered_json auditSummaryJson(const AuditSummary& summary, const AuditOptions& options) {
  Json orders{{"gap", summary.orders[0]}};
  for (int k = 0; k <= options.analysis.order; ++k)
    orders[orderName(k)] = summary.orders[static_cast<std::size_t>(k) + 1];
  Json kinds = Json::object();
  for (int i = 0; i < kJoinKindCount; ++i) {
    kinds[std::string(name(static_cast<JoinKind>(i)))] = summary.kinds[static_cast<std::size_t>(i)];
  }
  return {{"joins", summary.joins},
          {"kinds", std::move(kinds)},
          {"orders", std::move(orders)},
          {"undecided", summary.undecided}};
}

void writeAuditJson(const AuditDocument& document, const TextSink& sink) {
  TextPieces out(sink);
  AuditSummary total;
  for (const AuditedFile& file : document.files)
    add(summarize(file.report.rows), total);
  out << R"({"schema": "osculate.audit/1",)"
      << "\n\"options\": " << line(optionsJson(document.options))
      << ",\n\"summary\": " << line(auditSummaryJson(total, document.options)) << ",\n\"files\": [";
  const char* separator = "\n";
  for (const AuditedFile& file : document.files) {
    out << separator << line(fileJson(file, document.options));
    separator = ",\n";
  }
  out << "\n],\n\"rows\": [";
  separator = "\n";
  for (const AuditedFile& file : document.files) {
    for (const AuditRow& row : file.report.rows) {
      out << separator << line(rowJson(row, file.file, document.options.analysis.order));
      separator = ",\n";
    }
  }
  out << "\n]}\n";
  out.flush();
}

}  // namespace osculate
