// Curves on surfaces, for edges that have no curve in space; private to this floor.
#pragma once

#include <Geom2d_Curve.hxx>
#include <Geom_Surface.hxx>

#include "osculate/occt/edge_curve.h"

namespace osculate {

/// The part [first, last] of the curve that `pcurve` draws in the surface's parameters, with the
/// rules of curveFromEdge.
EdgeCurve convertSurfaceCurve(const opencascade::handle<Geom2d_Curve>& pcurve,
                              const opencascade::handle<Geom_Surface>& surface, double first,
                              double last);

}  // namespace osculate
