#include <iostream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "osculate/cli/child_process.h"
#include "osculate/cli/commands.h"
#include "osculate/cli/exit_status.h"
#include "osculate/cli/model_edges.h"
#include "osculate/continuity/report_json.h"
#include "osculate/continuity/report_text.h"

namespace osculate::cli {

namespace {

/// Of one edge the joins within it, of two their join; of the same edge twice its closing join.
std::vector<CurveJoin> joinsOf(const AnalyzeChoice& choice, const AnalysisOptions& options) {
  const std::vector<BSplineCurve> curves = readEdges(choice.file, choice.edges);
  if (curves.size() == 1) return analyzeInnerJoins(curves[0], options);
  if (choice.edges[0] != choice.edges[1])
    return {analyzeCurves(curves[0], curves[1], options, endsFrom(choice.ends))};
  if (!curves[0].isClosed(options.tolerances.gapMm))
    throw std::invalid_argument(
        "--edges: the same edge twice asks for its closing join, but it is open");
  return {analyzeClosing(curves[0], options)};
}

void print(const AnalyzeChoice& choice, const std::vector<CurveJoin>& joins) {
  const bool isList = choice.edges.size() == 1;
  if (choice.json) {
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const CurveJoin& join : joins)
      json.push_back(toJson(join));
    std::cout << (isList ? json : json.at(0)).dump(1) << "\n";
    return;
  }
  if (joins.empty()) std::cout << "the edge has no inner knots and is open: no joins\n";
  for (const CurveJoin& join : joins) {
    if (isList && join.parameter) std::cout << "at the inner knot " << *join.parameter << ":\n";
    if (isList && !join.parameter) std::cout << "where the edge closes:\n";
    std::cout << reportTable(join.report) << "\n";
  }
}

int run(const AnalyzeChoice& choice) {
  const AnalysisOptions options = choice.analysis.options();
  const std::optional<int> least = orderBelow(choice.failBelow, options.order);
  const std::vector<CurveJoin> joins = joinsOf(choice, options);
  print(choice, joins);
  const bool isBelow = least && std::any_of(joins.begin(), joins.end(), [&](const CurveJoin& join) {
                         return join.report.order < *least;
                       });
  return isBelow ? kBelow : kFine;
}

}  // namespace

int analyze(const AnalyzeChoice& choice) {
  return runContained(choice.file, choice.timeLimit, [&] { return run(choice); });
}

}  // namespace osculate::cli
