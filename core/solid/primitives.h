// Exact solids: rational Bézier tetrahedra that are tetrahedra, cones and parts of balls, cylinders
// and truncated cones.
//
// All have J > 0 inside; the apex of cones and wedges is the point (0, 0, 0, n) of the net. Where
// the corners given turn the other way, two of them are exchanged. Lengths in mm, angles in
// radians. All throw std::invalid_argument, with the rule, for what is flat, empty or not finite.
#pragma once

#include <cstdint>
#include <vector>

#include "osculate/bezier/bezier_tetrahedron.h"
#include "osculate/bezier/vector3.h"

namespace osculate {

/// Degree 1, with the corners as given (of either orientation).
BezierTetrahedron linearTetrahedron(const Vector3& a, const Vector3& b, const Vector3& c,
                                    const Vector3& d);

/// Base circle in the plane z = 0 about the origin, apex (0, 0, height); height may be negative.
/// Degree 2, all weights > 0 (mathematics C1): the disc is covered once, and J vanishes only on the
/// three rulings through the corners of the base, where two edges of it meet at 180 degrees.
BezierTetrahedron cone(double radius, double height);
/// Over the ellipse with half axes along x and y, to any apex off the plane z = 0.
BezierTetrahedron ellipticCone(double radiusX, double radiusY, const Vector3& apex);

/// The part of the sphere around `centre` through three points at the same distance from it,
/// bounded by great circles: degree 4 (mathematics C3, after Dietz, Hoschek and Jüttler 1993; the
/// octant is that of Farin, Piper and Worsey 1987). Also throws for corners on one great circle,
/// opposite corners, and a triangle so large that a weight is not > 0.
BezierTriangle sphericalTriangle(const Vector3& centre, const Vector3& a, const Vector3& b,
                                 const Vector3& c);
/// The same corners, degree 2, bounded by the circles through `pole` (mathematics C2); `pole` is a
/// point of the sphere outside the triangle. Throws where a corner is seen from another under 90
/// degrees or more through the pole.
BezierTriangle sphericalTriangleByCircles(const Vector3& centre, const Vector3& a, const Vector3& b,
                                          const Vector3& c, const Vector3& pole);

/// The solid between a surface and a point: all layers but the surface's at the point with weight 1
/// (mathematics C4). It has the degree of the surface, and the surface as the face opposite to
/// corner 3.
BezierTetrahedron wedgeOver(const BezierTriangle& base, const Vector3& apex);

/// The part of the ball over a spherical triangle, bounded by three planes through the centre; more
/// than one solid where the triangle is too large and is split at the middle of its longest side.
std::vector<BezierTetrahedron> sphereWedge(const Vector3& centre, const Vector3& a,
                                           const Vector3& b, const Vector3& c);
/// The same over the triangle bounded by circles through the point of the sphere opposite to its
/// middle; degree 2, one solid; its sides are cones.
BezierTetrahedron sphereWedgeByCircles(const Vector3& centre, const Vector3& a, const Vector3& b,
                                       const Vector3& c);
/// The eighth of the ball around the origin with x, y, z >= 0.
BezierTetrahedron ballOctant(double radius);

/// The sector of a truncated cone (of a cylinder, for equal radii) around the z axis from the plane
/// z = 0 to z = height > 0, from the x axis through 0 < angle <= 2 pi: solids of degree 3 with J >
/// 0 everywhere, edges and corners included; three for each 90 degrees begun. Neighbours meet in
/// whole faces.
std::vector<BezierTetrahedron> frustumWedge(double lowerRadius, double upperRadius, double height,
                                            double angle);

/// A solid to learn from, the same on every machine: the net of a regular tetrahedron of 100 mm
/// edges with shaken points and random weights; in E4 with random fourth coordinates too.
BezierTetrahedron randomTetrahedron(int degree, std::uint64_t seed, int dimension = 3);

}  // namespace osculate
