#include <algorithm>
#include <fstream>
#include <map>
#include <new>
#include <stdexcept>

#include "osculate/cli/audit_results.h"
#include "osculate/cli/commands.h"

namespace osculate::cli {

namespace {

AuditDocument read(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw std::runtime_error("cannot read " + path);
  try {
    return readAuditJson(stream);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {  // of the content, and of a folder that is read
    throw std::runtime_error(path + ": " + error.what());
  }
}

bool areEqual(const AuditOptions& a, const AuditOptions& b) {
  const AnalysisOptions& first = a.analysis;
  const AnalysisOptions& second = b.analysis;
  for (int k = 0; k <= 4; ++k) {
    if (first.tolerances.ofOrder(k) != second.tolerances.ofOrder(k)) return false;
  }
  const bool sameAngle = a.pairs != JoinPairs::kTangent || a.cornerDegrees == b.cornerDegrees;
  return first.order == second.order && first.scaleMm == second.scaleMm && a.pairs == b.pairs &&
         a.touchMm == b.touchMm && sameAngle;
}

/// Reports gathered into one, each file once.
class Merger {
 public:
  explicit Merger(bool latest) : latest_(latest) {}

  void add(const std::string& path, AuditDocument part) {
    if (!first_.empty() && !areEqual(merged_.options, part.options)) {
      throw std::runtime_error(path +
                               " was made with other options (order, tolerances or pairs) "
                               "than " +
                               first_);
    }
    if (first_.empty()) {
      first_ = path;
      merged_.options = part.options;
    }
    for (AuditedFile& file : part.files)
      add(path, std::move(file));
  }

  AuditDocument take() { return std::move(merged_); }

 private:
  void add(const std::string& path, AuditedFile file) {
    const auto [place, isNew] = places_.try_emplace(file.file, merged_.files.size());
    if (isNew) {
      merged_.files.push_back(std::move(file));
    } else if (latest_) {
      merged_.files[place->second] = std::move(file);
    } else {
      throw std::runtime_error(path + ": the file " + file.file +
                               " is in another report too; --latest takes the later one");
    }
  }

  bool latest_;
  std::string first_;  ///< the report that the options are from
  AuditDocument merged_;
  std::map<std::string, std::size_t> places_;
};

}  // namespace

int merge(const MergeChoice& choice) {
  const ResultChoice early{.csv = choice.csv, .json = choice.json, .worst = {}, .least = {}};
  checkResults(early);
  Merger merger(choice.latest);
  for (const std::string& path : choice.reports)
    merger.add(path, read(path));
  const AuditDocument document = merger.take();
  const auto least = orderBelow(choice.failBelow, document.options.analysis.order,
                                "make the reports with osculate audit --order ");
  return deliver(document, {.csv = choice.csv,
                            .json = choice.json,
                            .worst = choice.worst,
                            .least = least,
                            .strict = choice.strict,
                            .quiet = choice.quiet});
}

}  // namespace osculate::cli
