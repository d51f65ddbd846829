// An index that Eigen 3.4 calls Eigen::all and Eigen 5 Eigen::placeholders::all; private to this
// floor.
#pragma once

#include <Eigen/Core>

namespace osculate {

/// All rows of a matrix: matrix(everyRow(matrix), columns).
template <class Matrix>
auto everyRow(const Matrix& matrix) {
  return Eigen::seqN(Eigen::Index{0}, matrix.rows());
}

}  // namespace osculate
