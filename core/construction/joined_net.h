// The B-spline of a chain of curves, without the knots that it can spare; private to this floor.
#pragma once

#include <vector>

#include "osculate/bezier/spline_net.h"
#include "osculate/construction/join_scales.h"

namespace osculate {

/// A curve of a chain, or a part of one that is torn at a knot; clamped, in the direction of
/// travel.
struct ChainPart {
  BSplineCurve curve;
  std::size_t index;  ///< of the curve in the list that was given
};

/// A segment of a curve as it was given, over its interval of the joined net, of the degree of
/// that.
struct Reference {
  double first;
  double last;
  Net net;
};

struct JoinedNet {
  SplineNet net;              ///< periodic if its closing has a knot below full multiplicity
  std::vector<double> knots;  ///< where the parts meet: the last knot of each but the last
  std::vector<Reference> references;  ///< in the order of the intervals
};

/// The parts one behind the other, of their highest degree, the parameter of each scaled, ends that
/// meet moved to the point between them. Every knot of the parts gets the lowest multiplicity that
/// leaves the curve within rounding. At the joins (of a closed chain at its closing too, where at
/// least 1 stays) it then becomes as low as the tolerance allows: C^1 at every join before C^2 at
/// any, and so on, the smallest changes first. Throws ContactError where the scaled knots or
/// weights leave what doubles can tell apart.
JoinedNet joinParts(const std::vector<ChainPart>& parts, const JoinScales& scales, bool closed,
                    double toleranceMm);

/// The largest distance of the net from the references at equal parameters, in mm, from above.
double displacementMm(const JoinedNet& joined);

}  // namespace osculate
