// The commands of the program. Each returns its exit status; what it throws is said on standard
// error by main and ends the program with kFailure.
#pragma once

#include "osculate/cli/options.h"

namespace osculate::cli {

int analyze(const AnalyzeChoice& choice);
int audit(const AuditChoice& choice);
int blend(const BlendChoice& choice);
int merge(const MergeChoice& choice);

}  // namespace osculate::cli
