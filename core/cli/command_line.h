// The command line: what can be asked for, with the help that says so.
#pragma once

#include <functional>
#include <memory>

#include <CLI/CLI.hpp>

#include "osculate/cli/options.h"

namespace osculate::cli {

/// Everything that can be given, and which command was.
struct CommandLine {
  AnalyzeChoice analyze;
  AuditChoice audit;
  BlendChoice blend;
  MergeChoice merge;
  std::function<int()> run;  ///< the command that was given
};

/// The parser, which fills in `line`. The help and the manual page are made from it.
std::unique_ptr<CLI::App> makeParser(CommandLine& line);

}  // namespace osculate::cli
