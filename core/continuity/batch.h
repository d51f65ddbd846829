// Many joins of Bézier segments in arrays, for audits and scripts.
#pragma once

#include <cstddef>
#include <cstdint>

#include "osculate/continuity/curve_joins.h"

namespace osculate {

/// Joins of equal degrees in contiguous arrays: the end of the first segment against the start of
/// the second. Poles (count, degree+1, 3), weights (count, degree+1) or null. Nothing is checked.
struct BatchInput {
  std::size_t count = 0;
  const double* firstPoles = nullptr;
  const double* secondPoles = nullptr;
  const double* firstWeights = nullptr;
  const double* secondWeights = nullptr;
  int firstDegree = 0;
  int secondDegree = 0;
};

/// Where the results go; every array belongs to the caller. `columns` is options.order + 1.
struct BatchOutput {
  std::int8_t* order = nullptr;            ///< (count)
  std::int8_t* parametricOrder = nullptr;  ///< (count)
  std::uint8_t* verdicts = nullptr;        ///< (count, columns), values of Verdict
  double* residuals = nullptr;             ///< (count, columns)
  double* uncertainties = nullptr;         ///< (count, columns)
};

/// Returns how many joins were done: all, unless `progress` stopped it.
std::size_t analyzeBatch(const BatchInput& input, const BatchOutput& output,
                         const AnalysisOptions& options = {}, const Progress& progress = {});

}  // namespace osculate
