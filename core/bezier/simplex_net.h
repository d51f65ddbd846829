// Operations on triangular and tetrahedral nets of numbers or homogeneous points: blossoms, parts,
// elevation, products. The floor below the values BezierTriangle and BezierTetrahedron.
#pragma once

#include <Eigen/Core>
#include <span>

#include "osculate/bezier/simplex_index.h"

namespace osculate {

/// Barycentric coordinates: of a point (sum 1) or of a direction (sum 0).
template <int Corners>
using Barycentric = Eigen::Matrix<double, Corners, 1>;

/// One column for each point of a net, in its order. Rows: coordinates, and the weight last in
/// homogeneous nets.
using SimplexNet = Eigen::MatrixXd;

/// The corners of a part of a Corners-simplex, a point each.
template <int Corners, int PartCorners = Corners>
using PartCornersOf = std::array<Barycentric<Corners>, static_cast<std::size_t>(PartCorners)>;

/// One step of de Casteljau, V_i <- sum_c u_c V_{i+e_c}: a net of degree n becomes one of degree
/// n-1, in its first columns (the others are left over).
template <int Corners>
void reduceNet(SimplexNet& net, int degree, const Barycentric<Corners>& at);

/// V[a_1, ..., a_r] of degree n - r: one step for each argument, in any order.
template <int Corners>
void blossomNet(SimplexNet& net, int degree, std::span<const Barycentric<Corners>> arguments);

/// The net of the same polynomial over the part with these corners, by blossoms:
/// X'_(i,j,..) = X[p_1^i, p_2^j, ..] (Ramshaw 1989). Two PartCorners give a curve, three a
/// triangle, four a tetrahedron.
template <int Corners, int PartCorners>
SimplexNet partNet(const SimplexNet& net, int degree,
                   const PartCornersOf<Corners, PartCorners>& corners);

/// The two halves of a simplex cut at the middle of the edge between corners a and b: `net` becomes
/// the one that keeps corner a; the one that keeps corner b is returned.
template <int Corners>
SimplexNet bisectNet(SimplexNet& net, int degree, int a, int b);

/// The same polynomial one degree higher: X*_i = sum_c i_c X_{i-e_c} / (n+1).
template <int Corners>
SimplexNet elevateNet(const SimplexNet& net, int degree);

/// The points V_{i + e_corner} as a net of degree n - 1; n times it is the plain partial derivative
/// of the polynomial in Corners independent variables.
template <int Corners>
SimplexNet shiftedNet(const SimplexNet& net, int degree, int corner);

/// The points with index 0 at one corner, as a net with one corner less.
template <int Corners>
SimplexNet faceNet(const SimplexNet& net, int degree, int oppositeCorner);

/// Between Bernstein coefficients and coefficients of the monomials u^i v^j ..: a factor each.
template <int Corners>
Eigen::RowVectorXd multinomials(int degree);

/// The product of two polynomials given by the coefficients of their monomials.
template <int Corners>
Eigen::RowVectorXd multiplyMonomials(const Eigen::RowVectorXd& a, int degreeA,
                                     const Eigen::RowVectorXd& b, int degreeB);

/// The corners of the whole simplex.
template <int Corners>
PartCornersOf<Corners> unitCorners() {
  PartCornersOf<Corners> corners;
  for (int c = 0; c < Corners; ++c)
    corners[static_cast<std::size_t>(c)] = Barycentric<Corners>::Unit(c);
  return corners;
}

}  // namespace osculate
