// The curves that the benchmarks use, as core values and as OpenCASCADE's.
#pragma once

#include <utility>

#include <Geom_BSplineCurve.hxx>
#include <Geom_BezierCurve.hxx>
#include <TopoDS_Wire.hxx>

#include "osculate/bezier/bspline_curve.h"

namespace osculate::bench {

/// A quintic in space cut at 0.4: two segments that join with every order.
std::pair<BezierCurve, BezierCurve> quinticPair(bool rational);

/// A clamped quintic of simple knots.
BSplineCurve spline(int spans, bool rational);

/// Two splines of this many spans each that join with every order.
std::pair<BSplineCurve, BSplineCurve> splinePair(int spans, bool rational);

/// Cubic edges one after the other that share their vertices, each with an inner knot.
TopoDS_Wire chain(int edges);

Handle(Geom_BezierCurve) geom(const BezierCurve& curve);
Handle(Geom_BSplineCurve) geom(const BSplineCurve& curve);

}  // namespace osculate::bench
