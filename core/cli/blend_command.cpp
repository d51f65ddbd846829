#include <iostream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "osculate/cli/child_process.h"
#include "osculate/cli/commands.h"
#include "osculate/cli/exit_status.h"
#include "osculate/cli/model_edges.h"
#include "osculate/cli/output_file.h"
#include "osculate/construction/blend_curves.h"
#include "osculate/continuity/report_json.h"
#include "osculate/continuity/report_text.h"
#include "osculate/occt/edge_curve.h"
#include "osculate/occt/model_file.h"

namespace osculate::cli {

namespace {

using Json = nlohmann::ordered_json;

std::optional<Fairness> fairnessFrom(const std::string& name) {
  if (name == "mvc") return Fairness::kMinimumVariation;
  if (name == "bending") return Fairness::kBending;
  return std::nullopt;
}

/// Given numbers of one end, from beta_1 on.
auto betaFrom(const std::vector<double>& numbers, int order, const char* option) {
  std::array<std::optional<double>, kMaxOrder> beta{};
  if (static_cast<int>(numbers.size()) > order) {
    throw std::invalid_argument(std::string(option) + ": at most as many numbers as the order, " +
                                std::to_string(order) + ", got " + std::to_string(numbers.size()));
  }
  std::copy(numbers.begin(), numbers.end(), beta.begin());
  return beta;
}

BlendOptions blendOptions(const BlendChoice& choice) {
  BlendOptions options;
  options.order = {choice.order.front(), choice.order.back()};
  options.degree = choice.degree.value_or(0);
  options.symmetric = choice.symmetric;
  options.fairness = fairnessFrom(choice.fairness);
  options.beta = {betaFrom(choice.betaFirst, options.order[0], "--beta-first"),
                  betaFrom(choice.betaSecond, options.order[1], "--beta-second")};
  return options;
}

std::array<Departure, 2> departures(const BlendChoice& choice, const BSplineCurve& first,
                                    const BSplineCurve& second) {
  const std::optional<JoinEnds> ends = endsFrom(choice.ends);
  if (!ends) return nearestDepartures(first, second);
  return {Departure{.end = ends->first}, Departure{.end = ends->second}};
}

Json curveJson(const BSplineCurve& curve) {
  const BSplineData& data = curve.data();
  Json poles = Json::array();
  for (const auto& pole : data.poles.colwise())
    poles.push_back({pole.x(), pole.y(), pole.z()});
  return {{"degree", data.degree},
          {"poles", std::move(poles)},
          {"knots", data.knots.knots},
          {"multiplicities", data.knots.multiplicities}};
}

void printJson(const Construction& construction) {
  const Energies energy = energies(construction.curve);
  Json reports = Json::array();
  for (const CurveJoin& join : construction.joins)
    reports.push_back(toJson(join));
  const Json json{
      {"schema", "osculate.blend/1"},
      {"curve", curveJson(construction.curve)},
      {"beta", construction.beta},
      {"energy",
       {{"bending", energy.bending},
        {"mvc", energy.variation},
        {"speed", energy.speed},
        {"length_mm", energy.lengthMm},
        {"objective", construction.objective ? Json(*construction.objective) : Json(nullptr)}}},
      {"warnings", construction.warnings},
      {"reports", std::move(reports)}};
  std::cout << json.dump(1) << "\n";
}

void printText(const BlendChoice& choice, const Construction& construction) {
  std::cout << choice.output << ": degree " << construction.curve.degree() << ", length "
            << energies(construction.curve).lengthMm << " mm\n";
  for (std::size_t i = 0; i < construction.joins.size(); ++i) {
    std::cout << "  at edge " << choice.edges[i] << ": " << headline(construction.joins[i].report)
              << "; beta";
    for (const double beta : construction.beta[i])
      std::cout << " " << beta;
    std::cout << "\n";
  }
}

int run(const BlendChoice& choice) {
  formatByName(choice.output);
  checkWritable(choice.output);
  const BlendOptions options = blendOptions(choice);
  const std::vector<BSplineCurve> curves = readEdges(choice.file, choice.edges);
  const Construction construction =
      blendCurves(curves[0], curves[1], departures(choice, curves[0], curves[1]), options);
  replaceFile(choice.output, [&](const std::string& draft) {
    const SilentOutput silent;
    writeModel(edgeFromCurve(construction.curve), draft);
  });
  choice.json ? printJson(construction) : printText(choice, construction);
  for (const std::string& warning : construction.warnings)
    std::cerr << "osculate: " << warning << "\n";
  return kFine;
}

}  // namespace

int blend(const BlendChoice& choice) {
  return runContained(choice.file, choice.timeLimit, [&] { return run(choice); });
}

}  // namespace osculate::cli
