#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <unordered_set>

#include "osculate/cli/audit_results.h"
#include "osculate/cli/commands.h"
#include "osculate/cli/file_audits.h"
#include "osculate/cli/output_file.h"
#include "osculate/cli/progress_line.h"

namespace osculate::cli {

namespace {

/// Of a file that is given twice only the first, however it is written.
std::vector<std::string> distinct(std::vector<std::string> files) {
  std::unordered_set<std::string> known;
  std::erase_if(files, [&](const std::string& file) {
    std::error_code ignored;  // of one that is not there: it says so when it is read
    const auto path = std::filesystem::weakly_canonical(file, ignored);
    return !known.insert(path.empty() ? file : path.string()).second;
  });
  return files;
}

void addPaths(std::istream& stream, std::vector<std::string>& files) {
  for (std::string line; std::getline(stream, line);) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (!line.empty()) files.push_back(line);
  }
}

std::vector<std::string> filesOf(const AuditChoice& choice) {
  std::vector<std::string> files = choice.files;
  if (choice.filesFrom == "-") {
    addPaths(std::cin, files);
  } else if (!choice.filesFrom.empty()) {
    std::ifstream stream(choice.filesFrom);
    if (!stream) throw std::runtime_error("cannot read " + choice.filesFrom);
    addPaths(stream, files);
  }
  if (files.empty()) throw std::invalid_argument("no files to audit; see osculate audit --help");
  return distinct(std::move(files));
}

}  // namespace

int audit(const AuditChoice& choice) {
  FileAuditOptions options{.audit = {}, .jobs = choice.jobs, .timeLimit = choice.timeLimit};
  options.audit.analysis = choice.analysis.options();
  options.audit.pairs = joinPairs(choice.pairs);
  if (choice.cornerDegrees) {
    if (options.audit.pairs != JoinPairs::kTangent)
      throw std::invalid_argument("--corner-deg: has no effect without --pairs tangent");
    options.audit.cornerDegrees = *choice.cornerDegrees;
  }
  options.audit.touchMm = choice.touchMm;
  checkAuditOptions(options.audit);
  const ResultChoice results{.csv = choice.csv,
                             .json = choice.json,
                             .worst = choice.worst,
                             .least = orderBelow(choice.failBelow, choice.analysis.order),
                             .strict = choice.strict,
                             .quiet = choice.quiet};
  checkResults(results);
  const std::vector<std::string> files = filesOf(choice);

  AuditDocument document{.options = options.audit, .files = {}};
  {
    ProgressLine line(files.size(), !choice.quiet);
    document.files = auditFiles(
        files, options,
        [&](std::size_t done, const std::vector<double>& underWay) { line.show(done, underWay); });
  }
  return deliver(document, results);
}

}  // namespace osculate::cli
