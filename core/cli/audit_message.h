// What a child process tells of the file it audits, as bytes between two copies of one program.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "osculate/continuity/audit_document.h"

namespace osculate::cli {

/// Progress, or the end of it.
struct AuditMessage {
  double share = 0.0;
  std::optional<AuditedFile> result;  ///< without name and options, which the parent knows
};

std::string packProgress(double share);
std::string packResult(const AuditedFile& file);

/// Takes the first whole message off `bytes`, if there is one. Throws std::runtime_error for what
/// is none.
std::optional<AuditMessage> takeMessage(std::string& bytes);

}  // namespace osculate::cli
