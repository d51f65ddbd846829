// The arrays of Geom_BSplineCurve and Geom_BezierCurve; private to this floor.
#pragma once

#include <Geom_BSplineCurve.hxx>
#include <Geom_BezierCurve.hxx>

#include "osculate/bezier/bspline_curve.h"

namespace osculate {

/// The same bits; of a Bézier curve over [0, 1].
BSplineData dataOf(const Geom_BSplineCurve& spline);
BSplineData dataOf(const Geom_BezierCurve& bezier);

/// The same bits; throws std::invalid_argument where an inner knot has multiplicity degree + 1.
Handle(Geom_BSplineCurve) geomFrom(const BSplineData& data);

}  // namespace osculate
