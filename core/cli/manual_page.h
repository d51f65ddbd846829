// The manual page osculate(1), made from the parser: one source for it and for --help.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace osculate::cli {

/// In the macros of man(7).
std::string manualPage(const CLI::App& parser);

}  // namespace osculate::cli
