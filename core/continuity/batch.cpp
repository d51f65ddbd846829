#include "osculate/continuity/batch.h"

#include <algorithm>

namespace osculate {

namespace {

JoinSide sideOf(const double* poles, const double* weights, int degree, std::size_t row, CurveEnd end) {
  const std::size_t count = static_cast<std::size_t>(degree) + 1;
  return {{poles + 3 * count * row, weights == nullptr ? nullptr : weights + count * row, degree}, end};
}

void store(const JoinDecision& decision, const BatchOutput& output, std::size_t row, std::size_t columns) {
  output.order[row] = static_cast<std::int8_t>(decision.order);
  output.parametricOrder[row] = static_cast<std::int8_t>(decision.parametricOrder);
  for (std::size_t k = 0; k < columns; ++k) {
    output.verdicts[row * columns + k] = static_cast<std::uint8_t>(decision.verdicts[k]);
    output.residuals[row * columns + k] = decision.residuals[k];
    output.uncertainties[row * columns + k] = decision.uncertainties[k];
  }
}

}  // namespace

std::size_t analyzeBatch(const BatchInput& input, const BatchOutput& output, const AnalysisOptions& options,
                         const Progress& progress) {
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
    store(decideJoin(arriving, leaving, options), output, row, columns);
  }
  if (progress) progress(1.0);
  return input.count;
}

}  // namespace osculate
