// A varied set of blending tasks: what the fairness of blends is measured on.
#pragma once

#include <string>
#include <vector>

#include "osculate/bezier/bspline_curve.h"

namespace osculate::test {

struct BlendCase {
  std::string name;
  BSplineCurve first;   ///< the blend leaves its end
  BSplineCurve second;  ///< the blend arrives at its start
};

/// Planar and spatial, S, U-turns, near-straight, tight, unequal lengths, rational: 32 tasks.
std::vector<BlendCase> blendCases();

}  // namespace osculate::test
