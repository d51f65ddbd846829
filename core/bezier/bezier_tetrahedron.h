// A Bézier tetrahedron as an immutable value.
#pragma once

#include "osculate/bezier/bezier_triangle.h"

namespace osculate {

/// Its net is ordered (n,0,0,0), (n-1,1,0,0), (n-1,0,1,0), (n-1,0,0,1), .., (0,0,0,n).
using BezierTetrahedron = BezierSimplex<4>;

/// The face opposite to a corner; its corners are the others in their order.
BezierTriangle face(const BezierTetrahedron& solid, int oppositeCorner);

/// The surface over the triangle with these corners (points of the domain): a cut through it.
BezierTriangle cut(const BezierTetrahedron& solid, const PartCornersOf<4, 3>& corners);

/// The surface where one barycentric coordinate has the value c, 0 <= c < 1.
BezierTriangle isoSurface(const BezierTetrahedron& solid, int coordinate, double c);

/// The edge from corner a to corner b as a curve; as edgeCurve of a triangle.
BezierCurve edgeCurve(const BezierTetrahedron& solid, int a, int b);

}  // namespace osculate
