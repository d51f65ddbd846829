// Curves joined to one B-spline.
#pragma once

#include <span>

#include "osculate/construction/construction.h"

namespace osculate {

/// One B-spline that runs through the curves of a chain (see orderChain), with the lowest knot
/// multiplicities that their parametric continuity allows.
///
/// The degree is the highest of the curves'; the first keeps its parameter, those of the others are
/// scaled by one factor each (see joinScales), and so are the weights. Rational curves are judged
/// in homogeneous form: a knot of multiplicity m stands for C^(degree-m) of numerators and
/// denominator, so that the arcs of a circle, C^1 as they are, keep multiplicity 2 at degree 2.
///
/// Tolerance 0: the curve is that of the inputs to rounding (kJoinRounding of the coordinates and
/// the known errors of the poles). A tolerance > 0 closes gaps, each end moving half of it, and
/// lowers the multiplicities at joins, as long as no point moves farther; maxDisplacementMm is the
/// measured bound at equal parameters, in either case. A closed chain makes a closed curve:
/// periodic with the lowest multiplicity, at least 1, at its closing, or clamped where that can
/// only be C^0.
///
/// joins and inputJoins: at each place where two curves of the list meet, in the order of travel,
/// the closing last; those of the result with its parameter there, even where no knot is left.
/// Throws as orderChain and joinParts do.
Construction joinCurves(std::span<const BSplineCurve> curves, double toleranceMm = 0.0);

}  // namespace osculate
