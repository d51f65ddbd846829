// Fills in the other systems' definitions of a report; private to this floor.
#pragma once

#include "osculate/continuity/join_report.h"

namespace osculate {

/// Needs residuals, verdicts, deviation, sides and scale of the report.
void setDefinitions(const Tolerances& tolerances, JoinReport& report);

}  // namespace osculate
