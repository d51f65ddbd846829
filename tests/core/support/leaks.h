// For tests that call what of OpenCASCADE keeps memory to the end of the program: its readers and
// its STEP writer.
#pragma once

#include "support/sanitized.h"

#ifdef OSCULATE_SANITIZED
#include <sanitizer/lsan_interface.h>
#endif

namespace osculate::test {

#ifdef OSCULATE_SANITIZED
using IgnoredLeaks = __lsan::ScopedDisabler;
#else
struct IgnoredLeaks {
  IgnoredLeaks() {}  // NOLINT(modernize-use-equals-default): a variable that is used
};
#endif

}  // namespace osculate::test
