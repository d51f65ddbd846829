// One end segment of a B-spline beside OpenCASCADE's conversion to Bézier curves.
#include <benchmark/benchmark.h>

#include <GeomConvert_BSplineCurveToBezierCurve.hxx>

#include "sample_curves.h"

namespace {

using namespace osculate;

void endSegment(benchmark::State& state) {
  const BSplineCurve curve = bench::spline(static_cast<int>(state.range(0)), state.range(1) != 0);
  for (auto _ : state)
    benchmark::DoNotOptimize(curve.endSegment(CurveEnd::kEnd));
}
BENCHMARK(endSegment)->ArgNames({"spans", "rational"})->ArgsProduct({{50, 5000}, {0, 1}});

void toBezier(benchmark::State& state) {
  const auto curve =
      bench::geom(bench::spline(static_cast<int>(state.range(0)), state.range(1) != 0));
  for (auto _ : state) {
    GeomConvert_BSplineCurveToBezierCurve converter(curve);
    benchmark::DoNotOptimize(converter.Arc(converter.NbArcs()));
  }
}
BENCHMARK(toBezier)->ArgNames({"spans", "rational"})->ArgsProduct({{50}, {0, 1}});

}  // namespace
