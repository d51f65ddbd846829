// Whether this is the build for AddressSanitizer, which is ten times slower and looks for leaks.
#pragma once

#if defined(__SANITIZE_ADDRESS__)  // GCC's way to say it
#define OSCULATE_SANITIZED
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)  // Clang's
#define OSCULATE_SANITIZED
#endif
#endif

namespace osculate::test {

#ifdef OSCULATE_SANITIZED
inline constexpr bool kIsSanitized = true;
#else
inline constexpr bool kIsSanitized = false;
#endif

}  // namespace osculate::test
