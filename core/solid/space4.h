// Bézier tetrahedra in four-dimensional space: embedding E3 in it, projecting it to E3, normals.
#pragma once

#include "osculate/bezier/bezier_tetrahedron.h"

namespace osculate {

/// Orthonormal vectors e, f, g of the hyperplane a.x = 0 through the origin, as columns; with a as
/// the fourth they turn as the axes do (det [e f g a] > 0), and for a = (0, 0, 0, 1) they are the
/// first three axes. Throws std::invalid_argument for a = 0 or not finite.
Eigen::Matrix<double, 4, 3> hyperplaneBasis(const Eigen::Vector4d& a);

/// The solid of E3 in the hyperplane with normal a: X = x e + y f + z g.
BezierTetrahedron embedded(const BezierTetrahedron& solid, const Eigen::Vector4d& a);

/// Orthogonal projection from E4 to the hyperplane with normal a, in the coordinates of its basis.
BezierTetrahedron parallelProjection(const BezierTetrahedron& solid, const Eigen::Vector4d& a);

/// Projection from the point `centre` to the hyperplane a.x = 0, in the coordinates of its basis;
/// the result is rational. Throws std::invalid_argument where the centre lies in the hyperplane,
/// and where points of the solid lie on both sides of the parallel hyperplane through the centre,
/// or on it.
BezierTetrahedron perspectiveProjection(const BezierTetrahedron& solid,
                                        const Eigen::Vector4d& centre,
                                        const Eigen::Vector4d& a = Eigen::Vector4d::UnitW());

/// Unit normal of the tangent hyperplane of a solid in E4: across the three derivatives along the
/// edges from corner 0, so that det [D_1, D_2, D_3, normal] > 0. Zero where they are dependent (the
/// map is singular).
Eigen::Vector4d tangentHyperplaneNormal(const BezierTetrahedron& solid, const Barycentric<4>& u);

}  // namespace osculate
