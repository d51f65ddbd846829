// Combs of a hundred edges, a hundred samples each, beside OpenCASCADE's curvature at as many
// points.
#include <benchmark/benchmark.h>

#include <vector>

#include <GeomLProp_CLProps.hxx>

#include "osculate/differential/comb.h"
#include "sample_curves.h"

namespace {

using namespace osculate;

constexpr int kEdges = 100;
constexpr int kSegments = 5;
constexpr int kDensity = 19;  // with both ends 20 samples of each segment

std::vector<BSplineCurve> edges(bool rational) {
  return std::vector<BSplineCurve>(kEdges, bench::spline(kSegments, rational));
}

void combsOf(benchmark::State& state, const CombOptions& options) {
  const auto curves = edges(state.range(0) != 0);
  std::size_t samples = 0;
  for (auto _ : state) {
    samples = 0;
    for (const BSplineCurve& curve : curves)
      samples += comb(curve, options).samples.size();
  }
  state.counters["samples"] = static_cast<double>(samples);
}

/// Values, arc lengths, inflections, vertices and peaks of the curvature at even samples.
void combs(benchmark::State& state) {
  combsOf(state, {.density = kDensity, .tolerance = 0.0, .shown = {true}});
}
BENCHMARK(combs)->ArgName("rational")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

/// The same with samples where the comb of the curvature bends.
void refinedCombs(benchmark::State& state) {
  combsOf(state, {.density = kDensity, .shown = {true}});
}
BENCHMARK(refinedCombs)->ArgName("rational")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

/// The same for all quantities and their peaks.
void completeCombs(benchmark::State& state) { combsOf(state, {.density = kDensity}); }
BENCHMARK(completeCombs)->ArgName("rational")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

/// OpenCASCADE's point, tangent, normal and curvature, and nothing else, at as many points.
void curvatures(benchmark::State& state) {
  const Handle(Geom_BSplineCurve) curve =
      bench::geom(bench::spline(kSegments, state.range(0) != 0));
  const int count = kSegments * (kDensity + 1);
  for (auto _ : state) {
    for (int edge = 0; edge < kEdges; ++edge) {
      GeomLProp_CLProps properties(curve, 2, 1e-9);
      for (int i = 0; i < count; ++i) {
        properties.SetParameter(kSegments * static_cast<double>(i) / (count - 1));
        gp_Dir normal;
        if (properties.Curvature() > 0.0) properties.Normal(normal);
        benchmark::DoNotOptimize(normal);
      }
    }
  }
}
BENCHMARK(curvatures)->ArgName("rational")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

}  // namespace
