// Nets that are legal but less than a solid.
#pragma once

#include <string>

#include "osculate/bezier/bezier_tetrahedron.h"

namespace osculate {

/// The dimension of the smallest flat (point 0, line 1, plane 2, hyperplane 3) that holds all
/// control points of positive weight, to within relativeTolerance of their extent.
int dimensionOfNet(const BezierTetrahedron& solid, double relativeTolerance = 1e-12);

/// What a person should know about the net, or nothing: "collapsed to a point", "collapsed to a
/// line", "flat: all points lie in one plane", and zero weights at corners.
std::vector<std::string> netWarnings(const BezierTetrahedron& solid);

}  // namespace osculate
