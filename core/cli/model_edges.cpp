#include "osculate/cli/model_edges.h"

#include <iostream>
#include <stdexcept>

#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>

#include "osculate/cli/child_process.h"
#include "osculate/occt/edge_curve.h"
#include "osculate/occt/model_file.h"

namespace osculate::cli {

namespace {

Model readSilently(const std::string& file) {
  const SilentOutput silent;
  return readModel(file);
}

BSplineCurve curveOf(const TopTools_IndexedMapOfShape& edges, int number) {
  if (number < 1 || number > edges.Extent()) {
    throw std::invalid_argument("--edges: the file has the edges 1 to " +
                                std::to_string(edges.Extent()) + ", got " + std::to_string(number));
  }
  try {
    return curveFromEdge(edges(number)).curve;
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument("edge " + std::to_string(number) + ": " + error.what());
  }
}

}  // namespace

std::vector<BSplineCurve> readEdges(const std::string& file, const std::vector<int>& numbers) {
  const Model model = readSilently(file);
  for (const std::string& note : model.notes)
    std::cerr << "osculate: " << file << ": " << note << "\n";
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(model.shape, TopAbs_EDGE, edges);
  std::vector<BSplineCurve> curves;
  for (const int number : numbers)
    curves.push_back(curveOf(edges, number));
  return curves;
}

std::optional<JoinEnds> endsFrom(const std::vector<std::string>& words) {
  if (words.empty()) return std::nullopt;
  const auto end = [](const std::string& word) {
    if (word == "start") return CurveEnd::kStart;
    if (word == "end") return CurveEnd::kEnd;
    throw std::invalid_argument("--ends: each must be start or end, got " + word);
  };
  if (words.size() != 2) throw std::invalid_argument("--ends: must be two of start and end");
  return JoinEnds{end(words[0]), end(words[1])};
}

}  // namespace osculate::cli
