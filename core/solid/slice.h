// Plane sections of Bézier solids.
#pragma once

#include <vector>

#include "osculate/bezier/bezier_tetrahedron.h"
#include "osculate/bezier/vector3.h"

namespace osculate {

/// The section as triangles.
struct SolidSlice {
  std::vector<double> points;       ///< x y z a vertex: on the plane and on the solid to rounding
  std::vector<double> coordinates;  ///< 4 barycentric coordinates a vertex
  std::vector<int> triangles;       ///< 3 vertices each, turning left seen against the normal
};

/// The section with the plane through `origin`: marching through the m^3 tetrahedra of the domain
/// (1 <= m <= 200); every vertex lies on the plane exactly, between them the section is a chord.
/// Thin parts between the points of the lattice can be missed. Throws std::invalid_argument in E4
/// and for a normal that is 0 or not finite.
SolidSlice slice(const BezierTetrahedron& solid, const Vector3& origin, const Vector3& normal,
                 int m);

}  // namespace osculate
