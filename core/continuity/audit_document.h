// Audits of one or many files as one document: JSON (schema osculate.audit/1), CSV, text.
#pragma once

#include <functional>
#include <istream>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "osculate/continuity/audit_report.h"

namespace osculate {

/// What became of a file.
enum class FileStatus : unsigned char {
  kAudited,
  kUnreadable,  ///< the message says why
  kCrashed,     ///< the reader broke down
  kTimedOut     ///< it took longer than was allowed
};
std::string_view name(FileStatus status);

struct AuditedFile {
  std::string file;  ///< its path; empty: a shape that came from no file
  FileStatus status = FileStatus::kAudited;
  std::string message;             ///< why there are no joins
  std::vector<std::string> notes;  ///< what the reader remarked on a file that was audited
  AuditReport report;
};

struct AuditDocument {
  AuditOptions options;  ///< of every file
  std::vector<AuditedFile> files;
};

/// Takes the pieces of a text one after the other.
using TextSink = std::function<void(std::string_view)>;

/// One object; `rows` of all files in one list, a line each. What does not exist is null, doubles
/// keep their bits.
void writeAuditJson(const AuditDocument& document, const TextSink& sink);
/// What the key `summary` holds.
nlohmann::ordered_json auditSummaryJson(const AuditSummary& summary, const AuditOptions& options);
/// Reads what writeAuditJson wrote. Throws std::invalid_argument that says what is amiss.
AuditDocument readAuditJson(std::istream& stream);

/// A row for each join, with a header. Columns: file, kind, edge1, edge2, end1, end2, parameter, x,
/// y, z, order, parametric_order, gk_verdict and gk_residual of each order, the deviations,
/// warnings. What does not exist is an empty cell; doubles keep their bits.
void writeAuditCsv(const AuditDocument& document, const TextSink& sink);

/// What a person reads: a summary of each file with its `worst` worst joins, and of all files.
std::string auditText(const AuditDocument& document, std::size_t worst);

}  // namespace osculate
