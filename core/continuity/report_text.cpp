#include "osculate/continuity/report_text.h"

#include <cmath>
#include <sstream>
#include <string_view>
#include <vector>

#include "osculate/continuity/text_format.h"

namespace osculate {

namespace {

/// Words as lines of up to 100 columns: the first indented by 2, the others by 4.
std::string paragraph(const std::string& words) {
  constexpr std::size_t kColumns = 100;
  std::string text;
  std::string line = " ";
  std::istringstream stream(words);
  for (std::string word; stream >> word;) {
    if (line.size() + 1 + word.size() > kColumns) {
      text += line + "\n";
      line = "   ";
    }
    line += " " + word;
  }
  return text + line + "\n";
}

std::string_view sign(Verdict verdict) {
  switch (verdict) {
    case Verdict::kPass:
      return "pass";
    case Verdict::kFail:
      return "FAIL";
    case Verdict::kUndecided:
      return "undecided";
  }
  return "";
}

std::string optional(const std::optional<double>& value) {
  return value ? format("%13.6g", *value + 0.0) : format("%13s", "-");  // no "-0"
}

std::string orderRows(const JoinReport& report) {
  std::string text =
      "  order   residual            tolerance     uncertainty   verdict    C^m residual\n";
  for (int k = 0; k <= report.requestedOrder; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const std::string unit(unitOf(k));
    const std::string parametric =
        k <= report.parametricOrder + 1 ? format("%.3g", report.parametricResiduals[i]) : "-";
    text += format("  G%d      %-20s%-14s%-14s%-11s%s\n", k, amount(report.residuals[i], k).c_str(),
                   (format("%.3g", report.tolerances[i]) + unit).c_str(),
                   (format("%.1e", report.uncertainties[i]) + unit).c_str(),
                   sign(report.verdicts[i]).data(), parametric.c_str());
  }
  return text;
}

std::string sideRow(const char* label, const std::optional<double>& first,
                    const std::optional<double>& second, const char* unit) {
  return format("  %-20s", label) + optional(first) + "   " + optional(second) + "  " + unit + "\n";
}

std::string sideRows(const JoinReport& report) {
  const auto& [first, second] = report.sides;
  const auto endName = [](const SideReport& side) {
    return side.end == CurveEnd::kStart ? "its start" : "its end";
  };
  const auto radius = [](const SideReport& side) -> std::optional<double> {
    if (!side.invariants.curvature || !side.frame.normal) return std::nullopt;
    return 1.0 / *side.invariants.curvature;
  };
  std::string text = format("  %-20s%13s   %13s\n", "at the join", endName(first), endName(second));
  text += sideRow("curvature", first.invariants.curvature, second.invariants.curvature, "1/mm");
  text += sideRow("radius", radius(first), radius(second), "mm");
  text += sideRow("torsion", first.invariants.torsion, second.invariants.torsion, "1/mm");
  text += sideRow("d curvature/ds", first.invariants.curvatureRate, second.invariants.curvatureRate,
                  "1/mm^2");
  text += sideRow("d2 curvature/ds2", first.invariants.curvatureRate2,
                  second.invariants.curvatureRate2, "1/mm^3");
  text += sideRow("d torsion/ds", first.invariants.torsionRate, second.invariants.torsionRate,
                  "1/mm^2");
  text += format("  %-20s%13d   %13d\n", "legs on the tangent", first.linearity, second.linearity);
  return text;
}

std::string betaRow(const JoinReport& report) {
  if (report.betaCount == 0) return "";
  std::string words = "beta";
  for (int k = 0; k < report.betaCount; ++k) {
    words += format(" %.6g", report.beta[static_cast<std::size_t>(k)]);
  }
  return paragraph(words);
}

std::string definitionRows(const JoinReport& report) {
  std::string text;
  for (int i = 0; i < kDefinitionCount; ++i) {
    const DefinitionResult& result = report.definitions[static_cast<std::size_t>(i)];
    const DefinitionInfo& about = info(static_cast<Definition>(i));
    if (!result.verdict) continue;
    const std::string value = std::isfinite(result.value) ? format("%.3g", result.value) : "-";
    text += format("  %-19s%-11s%-11s%s\n", about.name.data(), sign(*result.verdict).data(),
                   value.c_str(), about.who.data());
  }
  return text;
}

bool has(const JoinReport& report, Definition definition, Verdict verdict) {
  return report.definitions[static_cast<std::size_t>(definition)].verdict == verdict;
}

bool passes(const JoinReport& report, Definition definition) {
  return has(report, definition, Verdict::kPass);
}
bool fails(const JoinReport& report, Definition definition) {
  return has(report, definition, Verdict::kFail);
}

/// Names of the systems whose definition has this verdict.
std::string systems(const JoinReport& report, std::initializer_list<Definition> definitions,
                    Verdict verdict) {
  std::string list;
  for (const Definition definition : definitions) {
    if (!has(report, definition, verdict)) continue;
    list += list.empty() ? "" : "; ";
    list += info(definition).who;
  }
  return list;
}

std::string curvatureDisagreement(const JoinReport& report) {
  using enum Definition;
  const std::initializer_list<Definition> others{kG2Maximum, kG2OpenNurbs, kG2Sum, kG2Mean,
                                                 kG2GeometricMean};
  const auto& plane = report.deviation.osculatingPlaneAngleDegrees;
  if (fails(report, kG2Vector)) {
    const std::string who = systems(report, others, Verdict::kPass);
    if (who.empty()) return "";
    const auto& n1 = report.sides[0].frame.normal;
    const auto& n2 = report.sides[1].frame.normal;
    if (n1 && n2 && n1->dot(*n2) < 0.0)
      return "G2 by number only (" + who +
             "): the curvatures are equal but bend to opposite sides.";
    if (plane && *plane > report.tolerances[1]) {
      return "G2 by number only (" + who +
             "): the curvatures are equal but their planes differ by " + format("%.3g", *plane) +
             " deg.";
    }
    return "G2 by a milder metric (" + who + "): their percentages count the same difference less.";
  }
  const std::string who = systems(report, others, Verdict::kFail);
  if (!passes(report, kG2Vector) || who.empty()) return "";
  return "Not G2 by a metric that is stricter or meaningless near zero curvature (" + who + ").";
}

std::string thirdOrderDisagreement(const JoinReport& report) {
  using enum Definition;
  const std::initializer_list<Definition> others{kG3FrenetFrame, kG3ScalarRate, kG3GraphAngle,
                                                 kG3Torsion};
  if (fails(report, kG3Vector)) {
    const std::string who = systems(report, others, Verdict::kPass);
    if (who.empty()) return "";
    std::string cause;
    if (fails(report, kG2Vector)) {
      cause = "the curvature vectors already differ";
    } else if (passes(report, kG3ScalarRate)) {
      cause = "the curvature's rate is equal, but the torsion is not";
    } else if (passes(report, kG3Torsion)) {
      cause = "the torsion is equal, but the curvature's rate is not";
    } else {
      cause = "a slope of the curvature graph below 0.1 deg hides the difference";
    }
    return "G3 only by part of the condition (" + who + "): " + cause + ".";
  }
  if (passes(report, kG3Vector) && fails(report, kC3)) {
    return "Not C3 (Rhino's help): the shapes agree, the curves' parametrisations do not.";
  }
  return "";
}

}  // namespace

std::string headline(const JoinReport& report) {
  if (report.order == report.requestedOrder) return orderName(report.order);
  const int next = report.order + 1;
  const auto i = static_cast<std::size_t>(next);
  const std::string name = orderName(report.order);
  if (report.verdicts[i] == Verdict::kUndecided) {
    return (next == 0 ? "" : name + ", ") + orderName(next) +
           " undecided: " + amount(report.residuals[i], next) + " +- " +
           amount(report.uncertainties[i], next);
  }
  return missText(report.order, report.residuals[i], report.tolerances[i]);
}

std::string disagreement(const JoinReport& report) {
  const std::string second = curvatureDisagreement(report);
  const std::string third = thirdOrderDisagreement(report);
  return second + (second.empty() || third.empty() ? "" : " ") + third;
}

std::string reportTable(const JoinReport& report) {
  std::string text = headline(report) + "\n";
  text += format("  parametric: C%d   L = %.6g mm   tolerances: %s   frame: %s\n",
                 report.parametricOrder, report.scaleMm, report.preset.data(),
                 name(report.frameKind).data());
  text += orderRows(report) + sideRows(report) + betaRow(report) + definitionRows(report);
  const std::string why = disagreement(report);
  if (!why.empty()) text += paragraph(why);
  for (const Warning warning : report.warnings.list()) {
    text += paragraph(std::string(code(warning)) + ": " + std::string(sentence(warning)));
  }
  text.pop_back();  // whoever prints it ends the line
  return text;
}

}  // namespace osculate
