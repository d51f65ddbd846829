// osculate: the continuity of the curves of CAD models, from the command line.
#include <exception>
#include <iostream>
#include <string>

#include "osculate/cli/command_line.h"
#include "osculate/cli/exit_status.h"
#include "osculate/cli/manual_page.h"

namespace {

using namespace osculate::cli;

int runCommand(const CommandLine& line) {
  try {
    return line.run();
  } catch (const std::exception& error) {
    std::cerr << "osculate: " << error.what() << "\n";
    return kFailure;
  }
}

}  // namespace

int main(int argc, char** argv) {
  CommandLine line;
  const auto parser = makeParser(line);
  // not a command: what makes osculate.1 when the program is built
  if (argc == 2 && std::string(argv[1]) == "--manual-page") {
    std::cout << manualPage(*parser);
    return kFine;
  }
  try {
    parser->parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return parser->exit(error) == 0 ? kFine : kFailure;
  }
  return runCommand(line);
}
