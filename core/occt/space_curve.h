// Curves in space of OpenCASCADE as B-splines over a range; private to this floor.
#pragma once

#include <Adaptor3d_Curve.hxx>
#include <Geom_Curve.hxx>

#include "osculate/occt/edge_curve.h"

namespace osculate {

/// The part [first, last] of a curve, with the rules of curveFromEdge.
EdgeCurve convertCurve(const opencascade::handle<Geom_Curve>& curve, double first, double last);

/// The part [first, last] of whatever can be evaluated, fitted.
EdgeCurve fitAdaptor(const Adaptor3d_Curve& adaptor, double first, double last);

}  // namespace osculate
