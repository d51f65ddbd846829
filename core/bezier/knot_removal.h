// Knots taken out of a B-spline, with the deviation that this costs.
#pragma once

#include <vector>

#include "osculate/bezier/spline_net.h"

namespace osculate {

/// What would become of a net if a knot lost some of its multiplicity.
struct KnotRemoval {
  int firstKnot = 0;                   ///< the flat knots that go, from here
  int times = 0;                       ///< so many
  int firstPole = 0;                   ///< the poles that change, from here
  int oldPoles = 0;                    ///< so many, of which there will be `times` less
  std::vector<Eigen::Vector4d> poles;  ///< the new ones
  /// Bound of the distance of the two curves at equal parameters, in mm; infinite where a weight
  /// would not be > 0.
  double deviationMm = 0.0;
};

/// The most that the multiplicity of this knot can be lowered by: it stays at least `least`, and of
/// a periodic net at least one pole must be left outside those that change.
int removableTimes(const SplineNet& net, SplineNet::Occurrence knot, int least = 0);

/// The removal whose re-insertion comes nearest to the old poles, in the sense of least squares
/// (Lyche and Mørken 1987, Knot removal for parametric B-spline curves and surfaces); poles that
/// have no more than the remaining copies among their knots stay, bit for bit. So the deviation of
/// an exact removal is rounding at every degree, where the two-sided recurrence (Tiller 1992; The
/// NURBS Book, A5.8) loses digits by extrapolation; for times = 1 at multiplicity `degree` both
/// are the same. times from 1 to removableTimes; multiplicity <= degree.
KnotRemoval proposeRemoval(const SplineNet& net, SplineNet::Occurrence knot, int times);

/// Carries it out. A periodic net then begins at the knot it began at before, or, where that is
/// gone, at the next one.
void apply(const KnotRemoval& removal, SplineNet& net);

}  // namespace osculate
