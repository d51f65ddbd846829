// The whole report of a join beside OpenCASCADE's analysis up to G2.
#include <benchmark/benchmark.h>

#include <LocalAnalysis_CurveContinuity.hxx>

#include "osculate/continuity/curve_joins.h"
#include "sample_curves.h"

namespace {

using namespace osculate;
using bench::geom;

// OpenCASCADE's default, 0.001, is used as a threshold of curvature too
constexpr double kZero = 1e-9;

void reportOfBeziers(benchmark::State& state) {
  const auto [first, second] = bench::quinticPair(state.range(0) != 0);
  const JoinSide arriving{.segment = first.view(), .end = CurveEnd::kEnd};
  const JoinSide leaving{.segment = second.view(), .end = CurveEnd::kStart};
  for (auto _ : state)
    benchmark::DoNotOptimize(analyzeJoin(arriving, leaving));
}
BENCHMARK(reportOfBeziers)->ArgName("rational")->Arg(0)->Arg(1);

template <GeomAbs_Shape kShape>
void localAnalysisOfBeziers(benchmark::State& state) {
  const auto [first, second] = bench::quinticPair(state.range(0) != 0);
  const auto a = geom(first);
  const auto b = geom(second);
  for (auto _ : state) {
    LocalAnalysis_CurveContinuity analysis(a, 1.0, b, 0.0, kShape, kZero);
    benchmark::DoNotOptimize(analysis);
  }
}
BENCHMARK(localAnalysisOfBeziers<GeomAbs_G2>)->ArgName("rational")->Arg(0)->Arg(1);

void localAnalysisOfBeziersAllOrders(benchmark::State& state) {
  const auto [first, second] = bench::quinticPair(state.range(0) != 0);
  const auto a = geom(first);
  const auto b = geom(second);
  for (auto _ : state) {
    for (const auto shape : {GeomAbs_C0, GeomAbs_G1, GeomAbs_C1, GeomAbs_G2, GeomAbs_C2}) {
      LocalAnalysis_CurveContinuity analysis(a, 1.0, b, 0.0, shape, kZero);
      benchmark::DoNotOptimize(analysis);
    }
  }
}
BENCHMARK(localAnalysisOfBeziersAllOrders)->ArgName("rational")->Arg(0)->Arg(1);

void reportOfSplines(benchmark::State& state) {
  const auto [first, second] =
      bench::splinePair(static_cast<int>(state.range(0)), state.range(1) != 0);
  const AnalysisOptions options;
  for (auto _ : state)
    benchmark::DoNotOptimize(reportCurves(first, second, options, JoinEnds{}));
}
BENCHMARK(reportOfSplines)->ArgNames({"spans", "rational"})->ArgsProduct({{50, 5000}, {0, 1}});

void localAnalysisOfSplines(benchmark::State& state) {
  const auto [first, second] =
      bench::splinePair(static_cast<int>(state.range(0)), state.range(1) != 0);
  const auto a = geom(first);
  const auto b = geom(second);
  for (auto _ : state) {
    LocalAnalysis_CurveContinuity analysis(a, first.last(), b, second.first(), GeomAbs_G2, kZero);
    benchmark::DoNotOptimize(analysis);
  }
}
BENCHMARK(localAnalysisOfSplines)
    ->ArgNames({"spans", "rational"})
    ->ArgsProduct({{50, 5000}, {0, 1}});

}  // namespace
