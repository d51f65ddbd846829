// For tests that call what of OpenCASCADE keeps memory to the end of the program: its readers and
// its STEP writer.
#pragma once

#if defined(__SANITIZE_ADDRESS__)  // GCC's way to say it
#define OSCULATE_FINDS_LEAKS
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)  // Clang's
#define OSCULATE_FINDS_LEAKS
#endif
#endif

#ifdef OSCULATE_FINDS_LEAKS
#include <sanitizer/lsan_interface.h>
#endif

namespace osculate::test {

#ifdef OSCULATE_FINDS_LEAKS
using IgnoredLeaks = __lsan::ScopedDisabler;
#else
struct IgnoredLeaks {
  IgnoredLeaks() {}  // NOLINT(modernize-use-equals-default): a variable that is used
};
#endif

}  // namespace osculate::test
