// Where a command writes its results.
#pragma once

#include <functional>
#include <string>

#include "osculate/continuity/audit_document.h"

namespace osculate::cli {

/// "-": standard output.
inline bool isStandardOutput(const std::string& path) { return path == "-"; }

/// Gives `write` a sink for a file that takes the place of `path` once all has been written, or for
/// standard output. Throws std::runtime_error that names the path; the old file then stays.
void writeOutput(const std::string& path, const std::function<void(const TextSink&)>& write);

/// Throws as writeOutput does where nothing can be written there: to be asked before long work.
void checkWritable(const std::string& path);

/// Calls `make` with the path of a draft beside `path`, with the same ending, which then takes its
/// place. Throws std::runtime_error, and what `make` throws.
void replaceFile(const std::string& path, const std::function<void(const std::string&)>& make);

}  // namespace osculate::cli
