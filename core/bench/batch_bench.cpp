// Joins in arrays: how many a second on one core.
#include <benchmark/benchmark.h>

#include <vector>

#include "osculate/continuity/batch.h"
#include "sample_curves.h"

namespace {

using namespace osculate;

constexpr std::size_t kJoins = 4096;

std::vector<double> repeatedPoles(const BezierCurve& curve) {
  std::vector<double> poles;
  const double* first = curve.view().poles;
  for (std::size_t i = 0; i < kJoins; ++i)
    poles.insert(poles.end(), first, first + 3 * (curve.degree() + 1));
  return poles;
}

void batchOfQuintics(benchmark::State& state) {
  const auto [first, second] = bench::quinticPair(false);
  const std::vector<double> firstPoles = repeatedPoles(first);
  const std::vector<double> secondPoles = repeatedPoles(second);
  std::vector<std::int8_t> order(kJoins);
  std::vector<std::int8_t> parametricOrder(kJoins);
  std::vector<std::uint8_t> verdicts(5 * kJoins);
  std::vector<double> residuals(5 * kJoins);
  std::vector<double> uncertainties(5 * kJoins);
  const BatchInput input{.count = kJoins,
                         .firstPoles = firstPoles.data(),
                         .secondPoles = secondPoles.data(),
                         .firstDegree = first.degree(),
                         .secondDegree = second.degree()};
  const BatchOutput output{order.data(), parametricOrder.data(), verdicts.data(), residuals.data(),
                           uncertainties.data()};
  for (auto _ : state)
    benchmark::DoNotOptimize(analyzeBatch(input, output));
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * kJoins));
}
BENCHMARK(batchOfQuintics);

}  // namespace
