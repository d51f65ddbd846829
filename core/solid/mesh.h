// Bézier solids as meshes of linear tetrahedra and boundary triangles.
#pragma once

#include <vector>

#include "osculate/bezier/bezier_tetrahedron.h"

namespace osculate {

struct SolidMesh {
  std::vector<double> points;       ///< x y z a vertex, in mm
  std::vector<double> coordinates;  ///< 4 barycentric coordinates a vertex
  std::vector<int> tetrahedra;      ///< 4 vertices each, oriented as the domain
  std::vector<int> triangles;       ///< 3 vertices each, turning left seen from outside
  std::vector<int> triangleFaces;   ///< the face of the solid each triangle belongs to
};

/// One face for display.
struct FaceMesh {
  std::vector<double> points;  ///< x y z
  std::vector<double>
      normals;  ///< unit, outwards; where the face collapses, that of the place beside
  std::vector<int> triangles;  ///< 3 vertices each, turning left seen from outside
};

/// The finest division of a face: a million triangles.
inline constexpr int kMaxDivisions = 1000;

/// All m^3 small tetrahedra between the points at (i, j, k, l)/m (mathematics B10); vertices in the
/// order of a net of degree m. Throws std::invalid_argument unless 1 <= m <= 200, and in E4.
SolidMesh uniformMesh(const BezierTetrahedron& solid, int m);

/// Face `face` (opposite to that corner) in m^2 triangles, 1 <= m <= kMaxDivisions.
FaceMesh faceMesh(const BezierTetrahedron& solid, int face, int m);

/// The least m for which every face's triangles are within chordalMm of it, by bounds of the second
/// derivatives (not by samples): |B - L| <= 2/9 M/m^2 on a face, but for the quarter of a face's
/// edge beside a corner of weight 0, where there is no bound. At most kMaxDivisions. Throws
/// std::invalid_argument unless chordalMm is finite and > 0.
int divisionsFor(const BezierTetrahedron& solid, double chordalMm);

/// A conforming mesh that is fine only where the faces bend: every point of a face is within
/// chordalMm of its triangles (the control points of its part are, and it lies in their hull).
/// Halves the longest edges (Rivara 1984), so that no hanging vertices arise. Throws as
/// divisionsFor does, and std::runtime_error above maxTetrahedra.
SolidMesh adaptiveMesh(const BezierTetrahedron& solid, double chordalMm,
                       int maxTetrahedra = 2000000);

}  // namespace osculate
