// Audits of many files, several at once, each in a process of its own.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "osculate/continuity/audit_document.h"

namespace osculate::cli {

struct FileAuditOptions {
  AuditOptions audit;
  int jobs = 0;            ///< files at once; 0: as many as the machine runs
  double timeLimit = 0.0;  ///< seconds for each file; 0: none
};

/// Called now and then: how many files are done, and the shares done of those under way.
using FilesProgress = std::function<void(std::size_t done, const std::vector<double>& underWay)>;

/// In the order of the files, whatever became of each: nothing that a file does ends this. Throws
/// std::runtime_error only where the system makes no processes.
std::vector<AuditedFile> auditFiles(const std::vector<std::string>& files,
                                    const FileAuditOptions& options, const FilesProgress& progress);

}  // namespace osculate::cli
