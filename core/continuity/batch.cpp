#include "osculate/continuity/batch.h"

#include <algorithm>

namespace osculate {

namespace {

JoinSide sideOf(const double* poles, const double* weights, int degree, std::size_t row,
                CurveEnd end) {
  const std::size_t count = static_cast<std::size_t>(degree) + 1;
  return {{poles + 3 * count * row, weights == nullptr ? nullptr : weights + count * row, degree},
          end};
}

/// Where the results of one row go.
BatchOutput rowOf(const BatchOutput& output, std::size_t row, std::size_t columns) {
  return {output.order + row, output.parametricOrder + row, output.verdicts + row * columns,
          output.residuals + row * columns, output.uncertainties + row * columns};
}

void store(const JoinDecision& decision, std::size_t columns, const BatchOutput& row) {
  *row.order = static_cast<std::int8_t>(decision.order);
  *row.parametricOrder = static_cast<std::int8_t>(decision.parametricOrder);
  for (std::size_t k = 0; k < columns; ++k)
    row.verdicts[k] = static_cast<std::uint8_t>(decision.verdicts[k]);
  std::copy_n(decision.residuals.begin(), columns, row.residuals);
  std::copy_n(decision.uncertainties.begin(), columns, row.uncertainties);
}

}  // namespace

std::size_t analyzeBatch(const BatchInput& input, const BatchOutput& output,
                         const AnalysisOptions& options, const Progress& progress) {
  constexpr std::size_t kBetweenReports = 65536;
  const auto columns = static_cast<std::size_t>(options.order) + 1;
  for (std::size_t row = 0; row < input.count; ++row) {
    if (progress && row % kBetweenReports == 0 &&
        !progress(static_cast<double>(row) / static_cast<double>(input.count))) {
      return row;
    }
    const JoinSide arriving =
        sideOf(input.firstPoles, input.firstWeights, input.firstDegree, row, CurveEnd::kEnd);
    const JoinSide leaving =
        sideOf(input.secondPoles, input.secondWeights, input.secondDegree, row, CurveEnd::kStart);
    store(decideJoin(arriving, leaving, options), columns, rowOf(output, row, columns));
  }
  if (progress) progress(1.0);
  return input.count;
}

}  // namespace osculate
