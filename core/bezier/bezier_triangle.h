// A Bézier triangle as an immutable value.
#pragma once

#include "osculate/bezier/bezier_curve.h"
#include "osculate/bezier/bezier_simplex.h"

namespace osculate {

/// Its net is ordered (n,0,0), (n-1,1,0), (n-1,0,1), .., (0,0,n).
using BezierTriangle = BezierSimplex<3>;

/// The edge from corner a to corner b as a curve. Zero weights inside are lifted by raising the
/// degree. Throws std::invalid_argument in E4, for corners that are no edge, and for an end of
/// weight 0.
BezierCurve edgeCurve(const BezierTriangle& triangle, int a, int b);

}  // namespace osculate
