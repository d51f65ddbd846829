#include "osculate/cli/options.h"

#include <cctype>
#include <stdexcept>

namespace osculate::cli {

AnalysisOptions AnalysisChoice::options() const {
  AnalysisOptions result;
  result.order = order;
  Tolerances& tolerances = result.tolerances = Tolerances::preset(preset);
  const auto set = [&](const std::optional<double>& own, double& value) {
    if (!own || *own == value) return;
    value = *own;
    tolerances.name = "custom";
  };
  set(gapMm, tolerances.gapMm);
  set(angleDegrees, tolerances.angleDegrees);
  set(curvature, tolerances.curvature);
  set(third, tolerances.third);
  set(fourth, tolerances.fourth);
  checkOptions(result);
  return result;
}

std::optional<int> orderBelow(const std::string& text, int order, const std::string& remedy) {
  if (text.empty()) return std::nullopt;
  const bool hasLetter = std::toupper(static_cast<unsigned char>(text[0])) == 'G';
  const std::string digit = hasLetter ? text.substr(1) : text;
  if (digit.size() != 1 || digit[0] < '0' || digit[0] > '8')
    throw std::invalid_argument("--fail-below: must be G0 to G8, got " + text);
  const int wanted = digit[0] - '0';
  if (wanted > order) {
    throw std::invalid_argument("--fail-below: G" + digit +
                                " is above the highest order analysed; " + remedy + digit);
  }
  return wanted;
}

}  // namespace osculate::cli
