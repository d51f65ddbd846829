// The edges of a file that a command was given by number.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "osculate/continuity/curve_joins.h"

namespace osculate::cli {

/// The curves of the edges. What the reader remarks on the file goes to standard error, what
/// OpenCASCADE prints nowhere. Throws std::invalid_argument for a number that no edge has, and what
/// readModel and curveFromEdge throw.
std::vector<BSplineCurve> readEdges(const std::string& file, const std::vector<int>& numbers);

/// Nothing for no words; throws std::invalid_argument for others than two of "start" and "end".
std::optional<JoinEnds> endsFrom(const std::vector<std::string>& words);

}  // namespace osculate::cli
