// What a person should know of joined curves; private to this floor.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "osculate/construction/construction.h"
#include "osculate/construction/curve_chain.h"

namespace osculate {

/// Sentences that begin with a code: "order" where the list was sorted, "gap" where gaps were
/// closed, "corner" where joins are G^0 only, "speed" where smooth joins keep a knot of full
/// multiplicity because the speeds differ there. One sentence of each kind, with the worst case.
std::vector<std::string> joinWarnings(std::span<const BSplineCurve> curves, const CurveChain& chain,
                                      const Construction& result);

}  // namespace osculate
