// For tests that call what of OpenCASCADE keeps memory to the end of the program: its STEP writer.
#pragma once

#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/lsan_interface.h>
#endif

namespace osculate::test {

#ifdef __SANITIZE_ADDRESS__
using IgnoredLeaks = __lsan::ScopedDisabler;
#else
struct IgnoredLeaks {
  IgnoredLeaks() {}  // NOLINT(modernize-use-equals-default): a variable that is used
};
#endif

}  // namespace osculate::test
