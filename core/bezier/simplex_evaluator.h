// Fast evaluation of a tetrahedron at many points.
#pragma once

#include <span>

#include "osculate/bezier/bezier_tetrahedron.h"

namespace osculate {

/// A net prepared for many evaluations: the control points times the multinomials, so that a point
/// is a sum of monomials. Inside the tetrahedron all terms are products of non-negative numbers, so
/// that it is as accurate as de Casteljau there; outside use BezierSimplex::evaluate.
class TetrahedronEvaluator {
 public:
  explicit TetrahedronEvaluator(const BezierTetrahedron& solid);

  int dimension() const { return dimension_; }
  /// The number of points of grid(m): (m+1)(m+2)(m+3)/6.
  static std::size_t gridSize(int m);

  /// barycentric: 4 numbers a point; out: dimension() numbers a point. Nothing is checked. NaN
  /// where the weight vanishes.
  void points(std::span<const double> barycentric, std::span<double> out) const;
  /// The points at (i, j, k, l)/m, m >= 1, in the order of a net of degree m.
  void grid(int m, std::span<double> out) const;

 private:
  int degree_;
  int dimension_;
  bool rational_;
  /// Component by component: rows x net size.
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> scaled_;
};

}  // namespace osculate
