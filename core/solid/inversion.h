// From a point of space back to the domain of a solid.
#pragma once

#include <vector>

#include "osculate/bezier/bezier_tetrahedron.h"
#include "osculate/bezier/vector3.h"

namespace osculate {

struct InversionOptions {
  double toleranceMm = 1e-9;  ///< how near the solid's point must come
  int maxParts = 20000;       ///< of the domain that are looked at
};

/// All coordinates u in the closed domain with B(u) = point to within the tolerance: none outside,
/// one inside a valid solid, more where it folds over itself.
///
/// Parts of the domain whose box of control points misses the point are left out; in the rest,
/// halved until they are small, Newton's method finds the solutions. Of a place where the solid
/// collapses (the apex of a wedge) some of the coordinates are given. Throws std::invalid_argument
/// in E4 and for a point that is not finite.
std::vector<Barycentric<4>> locate(const BezierTetrahedron& solid, const Vector3& point,
                                   const InversionOptions& options = {});

}  // namespace osculate
