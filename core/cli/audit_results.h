// What the commands audit and merge do with their results.
#pragma once

#include <optional>
#include <string>

#include "osculate/continuity/audit_document.h"

namespace osculate::cli {

struct ResultChoice {
  std::string csv;  ///< a path, "-", or empty
  std::string json;
  std::optional<int> worst;  ///< of each file in the text
  std::optional<int> least;  ///< --fail-below
  bool strict = false;       ///< a file that was not audited in full is a failure
  bool quiet = false;
};

/// Throws std::runtime_error where results could not be written, std::invalid_argument where both
/// would go to standard output.
void checkResults(const ResultChoice& choice);

/// Writes the files that were asked for, prints the text and, on standard error, what is amiss.
/// Returns the exit status.
int deliver(const AuditDocument& document, const ResultChoice& choice);

}  // namespace osculate::cli
