// A varied set of blending tasks: what the fairness of blends is measured on.
#pragma once

#include <algorithm>
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

/// Largest distance of corresponding points of two curves over [0, 1].
inline double distance(const BezierCurve& a, const BezierCurve& b) {
  double largest = 0.0;
  for (int i = 0; i <= 64; ++i)
    largest = std::max(largest, (a.evaluate(i / 64.0) - b.evaluate(i / 64.0)).norm());
  return largest;
}

}  // namespace osculate::test
