// Arcs of conics as rational B-splines of degree 2; private to this floor.
#pragma once

#include "osculate/bezier/bspline_curve.h"

namespace osculate {

/// A conic by its centre (a parabola: its apex; a line: its origin) and two axis vectors with
/// length.
struct ConicAxes {
  Vector3 centre;
  Vector3 x;
  Vector3 y;
};

/// centre + x cos u + y sin u, first < last, in the least number of equal pieces of at most 90
/// degrees. An arc of a whole turn ends in the bits of its start.
BSplineCurve ellipticArc(const ConicAxes& axes, double first, double last);
/// centre + x cosh u + y sinh u, in equal pieces of at most 1 in u.
BSplineCurve hyperbolicArc(const ConicAxes& axes, double first, double last);
/// centre + x u^2 + y u, exact in the parameter too.
BSplineCurve parabolicArc(const ConicAxes& axes, double first, double last);
/// origin + direction u, exact in the parameter too.
BSplineCurve lineSegment(const Vector3& origin, const Vector3& direction, double first,
                         double last);

}  // namespace osculate
