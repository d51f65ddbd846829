// The report of a join as the table that a person reads.
#pragma once

#include <string>

#include "osculate/continuity/join_report.h"

namespace osculate {

/// One line: "G2, misses G3 by 0.13 (tolerance 0.02)".
std::string headline(const JoinReport& report);
/// The table of orders, both sides, the definitions, the warnings; lines up to 100 columns.
std::string reportTable(const JoinReport& report);
/// Why the definitions disagree at this join, one sentence; empty where they agree.
std::string disagreement(const JoinReport& report);

}  // namespace osculate
