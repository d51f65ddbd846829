#include <algorithm>

#include "osculate/continuity/audit_document.h"
#include "osculate/continuity/text_format.h"

namespace osculate {

namespace {

std::string counted(std::size_t count, const char* noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

/// "gap 3   G0 12   G1 40 ...", those that occur.
std::string orderCounts(const AuditSummary& summary) {
  std::string text;
  for (int order = -1; order <= kMaxOrder; ++order) {
    const std::size_t count = summary.orders[static_cast<std::size_t>(order + 1)];
    const char* separator = text.empty() ? "  " : "   ";
    if (count > 0) text += format("%s%s %zu", separator, orderName(order).c_str(), count);
  }
  return text + "\n";
}

std::string joinCounts(const AuditSummary& summary) {
  return counted(summary.joins, "join") + ": " + std::to_string(summary.kinds[0]) +
         " at vertices, " + std::to_string(summary.kinds[1]) + " at inner knots, " +
         std::to_string(summary.kinds[2]) + " at seams";
}

/// "12 end + 14 start", "17 at 0.5", "3 seam".
std::string place(const AuditRow& row) {
  const auto end = [](CurveEnd which) { return which == CurveEnd::kStart ? " start" : " end"; };
  const std::string first = std::to_string(row.edges[0]);
  switch (row.kind) {
    case JoinKind::kKnot:
      return first + " at " + format("%.6g", row.parameter);
    case JoinKind::kSeam:
      return first + " seam";
    default:
      return first + end(row.ends.first) + " + " + std::to_string(row.edges[1]) +
             end(row.ends.second);
  }
}

std::string missed(const AuditRow& row, const AnalysisOptions& options) {
  if (row.order >= options.order) return orderName(row.order);
  const int next = row.order + 1;
  const auto i = static_cast<std::size_t>(next);
  const double tolerance = options.tolerances.ofOrder(next);
  if (row.verdicts[i] != Verdict::kUndecided)
    return missText(row.order, row.residuals[i], tolerance);
  return (next == 0 ? "" : orderName(row.order) + ", ") + orderName(next) +
         " undecided: " + amount(row.residuals[i], next) + " (tolerance " +
         amount(tolerance, next) + ")";
}

std::string worstText(const AuditReport& report, std::size_t count) {
  std::string text;
  for (const std::size_t i : worstRows(report.rows, count, report.options.analysis)) {
    const AuditRow& row = report.rows[i];
    text += format("  %-28s%-46s(%.6g, %.6g, %.6g)", place(row).c_str(),
                   missed(row, report.options.analysis).c_str(), row.point[0], row.point[1],
                   row.point[2]);
    for (const Warning warning : row.warnings.list()) {
      if (warning != Warning::kUndecided) text.append(" ").append(code(warning));
    }
    text += "\n";
  }
  return text;
}

std::string skippedText(const AuditReport& report) {
  constexpr std::size_t kShown = 5;
  const auto& skipped = report.skipped;
  const auto points = static_cast<std::size_t>(std::count_if(
      skipped.begin(), skipped.end(), [](const SkippedEdge& edge) { return edge.degenerated; }));
  std::string text;
  if (points > 0) text += "  " + counted(points, "degenerated edge") + " left out\n";
  const std::size_t others = skipped.size() - points;
  if (others > 0) text += "  " + counted(others, "edge") + " could not be analysed:\n";
  std::size_t shown = 0;
  for (const SkippedEdge& edge : skipped) {
    if (edge.degenerated) continue;
    if (shown++ == kShown) return text + "    ...\n";
    text += "    edge " + std::to_string(edge.edge) + ": " + edge.reason + "\n";
  }
  return text;
}

std::string fileText(const AuditedFile& file, std::size_t worst) {
  const std::string prefix = file.file.empty() ? "" : file.file + ": ";
  if (file.status != FileStatus::kAudited)
    return prefix + std::string(name(file.status)) + ": " + file.message + "\n";
  const AuditReport& report = file.report;
  const AuditSummary summary = summarize(report.rows);
  std::string text = prefix + counted(static_cast<std::size_t>(report.edgeCount), "edge") + ", " +
                     joinCounts(summary) + "\n";
  if (summary.joins > 0) text += orderCounts(summary);
  if (summary.undecided > 0) text += "  " + counted(summary.undecided, "join") + " undecided\n";
  if (report.corners > 0) {
    text += "  " + counted(report.corners, "corner") +
            format(" of more than %.6g deg left out\n", report.options.cornerDegrees);
  }
  if (!report.complete) text += "  stopped before the end\n";
  for (const std::string& note : file.notes)
    text += "  note: " + note + "\n";
  text += skippedText(report);
  return text + worstText(report, worst);
}

}  // namespace

std::string_view name(FileStatus status) {
  static constexpr std::array<std::string_view, 4> kNames{"audited", "unreadable", "crashed",
                                                          "timed-out"};
  return kNames[static_cast<std::size_t>(status)];
}

std::string auditText(const AuditDocument& document, std::size_t worst) {
  std::string text;
  AuditSummary total;
  for (const AuditedFile& file : document.files) {
    text += fileText(file, worst);
    add(summarize(file.report.rows), total);
  }
  if (document.files.size() > 1) {
    text += "all " + std::to_string(document.files.size()) + " files: " + joinCounts(total) + "\n";
    if (total.joins > 0) text += orderCounts(total);
  }
  return text;
}

}  // namespace osculate
