// An extension with given numbers, and a fair one.
#include <benchmark/benchmark.h>

#include "osculate/construction/extend.h"

namespace {

using namespace osculate;

BSplineCurve twistedCubic() {
  const std::vector<Vector3> poles{{0, 0, 0}, {10, 0, 0}, {20, 10, 0}, {20, 20, 10}};
  return BSplineCurve(BezierCurve(poles));
}

void timeExtension(benchmark::State& state, const ExtendOptions& options) {
  const BSplineCurve curve = twistedCubic();
  for (auto _ : state)
    benchmark::DoNotOptimize(extend(curve, options));
}

void extendByTangentialCoordinates(benchmark::State& state) {
  ExtendOptions options;
  options.tangential = {5.0, 10.0, 15.0, 20.0};
  timeExtension(state, options);
}
BENCHMARK(extendByTangentialCoordinates);

void extendByBeta(benchmark::State& state) {
  ExtendOptions options;
  options.beta = {1.0, 0.0, 0.0, 0.0};
  timeExtension(state, options);
}
BENCHMARK(extendByBeta);

void extendFairly(benchmark::State& state) {
  timeExtension(state, {.order = static_cast<int>(state.range(0))});
}
BENCHMARK(extendFairly)->ArgName("order")->DenseRange(2, 4)->Unit(benchmark::kMicrosecond);

}  // namespace
