#include "osculate/cli/audit_results.h"

#include <algorithm>
#include <iostream>
#include <stdexcept>

#include "osculate/cli/exit_status.h"
#include "osculate/cli/output_file.h"

namespace osculate::cli {

namespace {

constexpr int kWorstOfOne = 10;
constexpr int kWorstOfMany = 3;

/// What the audit of a file leaves out: what the reader remarked, and edges without a curve.
std::vector<std::string> omissions(const AuditedFile& file) {
  std::vector<std::string> sentences = file.notes;
  const auto& skipped = file.report.skipped;
  const auto count = std::count_if(skipped.begin(), skipped.end(),
                                   [](const SkippedEdge& edge) { return !edge.degenerated; });
  if (count > 0) {
    sentences.push_back(std::to_string(count) + (count == 1 ? " edge" : " edges") +
                        " could not be analysed");
  }
  return sentences;
}

/// Says which files failed, and whether any did.
bool reportFailures(const AuditDocument& document, bool strict) {
  bool failed = false;
  const auto say = [](const AuditedFile& file, std::string_view what) {
    std::cerr << "osculate: " << file.file << ": " << what << "\n";
  };
  for (const AuditedFile& file : document.files) {
    if (file.status != FileStatus::kAudited) {
      say(file, std::string(name(file.status)) + ": " + file.message);
      failed = true;
    }
    for (const std::string& omission : omissions(file)) {
      say(file, omission);
      failed = failed || strict;
    }
  }
  return failed;
}

bool reportBelow(const AuditDocument& document, int least) {
  AuditSummary total;
  for (const AuditedFile& file : document.files)
    add(summarize(file.report.rows), total);
  const std::size_t below = countBelow(total, least);
  if (below == 0) return false;
  std::cerr << "osculate: " << below << " of " << total.joins << " joins are below G" << least
            << "\n";
  return true;
}

}  // namespace

void checkResults(const ResultChoice& choice) {
  if (isStandardOutput(choice.csv) && isStandardOutput(choice.json))
    throw std::invalid_argument("--csv, --json: only one can go to standard output");
  for (const std::string& path : {choice.csv, choice.json}) {
    if (!path.empty()) checkWritable(path);
  }
}

int deliver(const AuditDocument& document, const ResultChoice& choice) {
  if (!choice.csv.empty())
    writeOutput(choice.csv, [&](const TextSink& sink) { writeAuditCsv(document, sink); });
  if (!choice.json.empty())
    writeOutput(choice.json, [&](const TextSink& sink) { writeAuditJson(document, sink); });
  const bool isTaken = isStandardOutput(choice.csv) || isStandardOutput(choice.json);
  if (!choice.quiet && !isTaken) {
    const int worst = choice.worst.value_or(document.files.size() > 1 ? kWorstOfMany : kWorstOfOne);
    std::cout << auditText(document, static_cast<std::size_t>(worst)) << std::flush;
  }
  const bool failed = reportFailures(document, choice.strict);
  const bool below = choice.least && reportBelow(document, *choice.least);
  if (failed) return kFailure;
  return below ? kBelow : kFine;
}

}  // namespace osculate::cli
