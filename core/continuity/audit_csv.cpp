#include <array>
#include <charconv>
#include <cmath>

#include "osculate/continuity/audit_document.h"
#include "osculate/continuity/deviation_fields.h"
#include "osculate/continuity/text_pieces.h"

namespace osculate {

namespace {

/// The shortest digits that read back as the same bits; empty for what does not exist.
std::string cell(double value) {
  if (!std::isfinite(value)) return "";
  std::array<char, 32> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  return {digits.data(), end};
}

std::string cell(const std::optional<double>& value) { return value ? cell(*value) : ""; }

/// In quotes where RFC 4180 wants them.
std::string cell(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text)
    quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

void writeHeader(int order, TextPieces& out) {
  out << "file,kind,edge1,edge2,end1,end2,parameter,x,y,z,order,parametric_order";
  for (int k = 0; k <= order; ++k) {
    const std::string number = std::to_string(k);
    out << ",g" << number << "_verdict,g" << number << "_residual";
  }
  out << ",gap_mm";
  for (const DeviationField& field : kDeviationFields)
    out << "," << field.name;
  out << ",warnings\n";
}

/// What says which join it is.
void writePlace(const AuditRow& row, TextPieces& out) {
  const auto end = [](CurveEnd which) { return which == CurveEnd::kStart ? "start" : "end"; };
  out << name(row.kind) << "," << std::to_string(row.edges[0]) << ","
      << std::to_string(row.edges[1]) << ",";
  if (row.kind == JoinKind::kKnot) {
    out << ",," << cell(row.parameter);
  } else {
    out << end(row.ends.first) << "," << end(row.ends.second) << ",";
  }
  for (const double coordinate : row.point)
    out << "," << cell(coordinate);
}

void writeWarnings(const WarningSet& warnings, TextPieces& out) {
  const char* separator = "";
  for (const Warning warning : warnings.list()) {
    out << separator << code(warning);
    separator = " ";
  }
}

void writeRow(const std::string& file, const AuditRow& row, int order, TextPieces& out) {
  out << file << ",";
  writePlace(row, out);
  out << "," << std::to_string(row.order) << "," << std::to_string(row.parametricOrder);
  for (std::size_t k = 0; k <= static_cast<std::size_t>(order); ++k)
    out << "," << name(row.verdicts[k]) << "," << cell(row.residuals[k]);
  const Deviation deviation = row.deviation();
  out << "," << cell(deviation.gapMm);
  for (const DeviationField& field : kDeviationFields)
    out << "," << cell(deviation.*field.member);
  out << ",";
  writeWarnings(row.warnings, out);
  out << "\n";
}

}  // namespace

void writeAuditCsv(const AuditDocument& document, const TextSink& sink) {
  TextPieces out(sink);
  const int order = document.options.analysis.order;
  writeHeader(order, out);
  for (const AuditedFile& file : document.files) {
    const std::string name = cell(file.file);
    for (const AuditRow& row : file.report.rows)
      writeRow(name, row, order, out);
  }
  out.flush();
}

}  // namespace osculate
