#include "osculate/cli/manual_page.h"

#include <sstream>
#include <vector>

namespace osculate::cli {

namespace {

/// Text as roff wants it: no backslash, no hyphen that may become a dash, no line that begins as a
/// request.
std::string roff(const std::string& text) {
  std::string result;
  bool isLineStart = true;
  for (const char c : text) {
    if (isLineStart && (c == '.' || c == '\'')) result += "\\&";
    if (c == '\\') {
      result += "\\e";
    } else if (c == '-') {
      result += "\\-";
    } else {
      result += c;
    }
    isLineStart = c == '\n';
  }
  return result;
}

/// "--order INT [4]", or the name of what is given by its place.
std::string term(const CLI::Option& option) {
  const bool isPositional = !option.get_positional() ? false : option.nonpositional() == false;
  std::string text = isPositional ? option.get_name() : option.get_name(false, true);
  const std::string type = option.get_type_name();
  if (!isPositional && option.get_items_expected_max() > 0 && !type.empty()) text += " " + type;
  const std::string value = option.get_default_str();
  if (!value.empty()) text += " [" + value + "]";
  return text;
}

void writeOptions(const CLI::App& app, std::ostream& out) {
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_group().empty()) continue;
    out << ".TP\n.B " << roff(term(*option)) << "\n" << roff(option->get_description()) << "\n";
  }
}

/// The examples stand as they are.
void writeFooter(const CLI::App& app, std::ostream& out) {
  std::istringstream lines(app.get_footer());
  std::string line;
  bool isVerbatim = false;
  while (std::getline(lines, line)) {
    const bool isIndented = !line.empty() && line.front() == ' ';
    if (isIndented != isVerbatim) out << (isIndented ? ".PP\n.nf\n" : ".fi\n.PP\n");
    isVerbatim = isIndented;
    out << roff(line) << "\n";
  }
  if (isVerbatim) out << ".fi\n";
}

std::string upper(std::string text) {
  for (char& c : text)
    c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

}  // namespace

std::string manualPage(const CLI::App& parser) {
  std::ostringstream out;
  out << ".\\\" Made by osculate itself from its command line.\n"
      << ".TH OSCULATE 1 \"\" \"osculate " OSCULATE_VERSION "\" \"User Commands\"\n"
      << ".SH NAME\nosculate \\- continuity of the curves of CAD models\n.SH SYNOPSIS\n";
  const auto commands = parser.get_subcommands([](const CLI::App*) { return true; });
  for (const CLI::App* command : commands) {
    out << ".B osculate " << command->get_name() << "\n.RI [ OPTION \"]...\"\n";
    for (const CLI::Option* option : command->get_options()) {
      if (option->get_positional()) out << ".I " << upper(option->get_name()) << "\n";
    }
    out << ".br\n";
  }
  out << ".SH DESCRIPTION\n" << roff(parser.get_description()) << "\n.SH OPTIONS\n";
  writeOptions(parser, out);
  for (const CLI::App* command : commands) {
    out << ".SH \"OSCULATE " << upper(command->get_name()) << "\"\n"
        << roff(command->get_description()) << "\n";
    writeOptions(*command, out);
    writeFooter(*command, out);
  }
  out << ".SH EXAMPLES\n";
  writeFooter(parser, out);
  return out.str();
}

}  // namespace osculate::cli
