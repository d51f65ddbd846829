// Nets that are legal but less than a solid.
#pragma once

#include <string>

#include "osculate/bezier/bezier_tetrahedron.h"

namespace osculate {

/// What is less than this part of a net's extent counts as nothing.
inline constexpr double kNetTolerance = 1e-12;

/// The dimension of the smallest flat (point 0, line 1, plane 2, hyperplane 3) that holds all
/// control points of positive weight, to within relativeTolerance of their extent.
int dimensionOfNet(const BezierTetrahedron& solid, double relativeTolerance = kNetTolerance);

/// What a person should know about the net, or nothing: "collapsed to a point", "collapsed to a
/// line", "flat: all points lie in one plane", else which faces are collapsed to a line or a point
/// and which edges to a point; and zero weights at corners.
std::vector<std::string> netWarnings(const BezierTetrahedron& solid);

}  // namespace osculate
