#include "osculate/bezier/tensor_patch.h"

#include <algorithm>
#include <stdexcept>

#include "osculate/bezier/bernstein.h"

namespace osculate {

namespace {

/// de Casteljau on the columns first, first + stride, ..
Eigen::Vector4d evaluateRow(SimplexNet row, double t) {
  for (Eigen::Index n = row.cols() - 1; n > 0; --n) {
    for (Eigen::Index i = 0; i < n; ++i)
      row.col(i) = (1.0 - t) * row.col(i) + t * row.col(i + 1);
  }
  return row.col(0);
}

}  // namespace

Vector3 TensorPatch::evaluate(double x, double y) const {
  SimplexNet column(4, degreeX + 1);
  for (int m = 0; m <= degreeX; ++m)
    column.col(m) = evaluateRow(net.middleCols(m * (degreeY + 1), degreeY + 1), y);
  const Eigen::Vector4d point = evaluateRow(column, x);
  return point.head<3>() / point[3];
}

TensorPatch tensorPatch(const BezierTriangle& triangle) {
  if (triangle.dimension() != 3) throw std::invalid_argument("patch: of a triangle in E3");
  const int n = triangle.degree();
  const SimplexNet b = triangle.homogeneousWithWeights();
  TensorPatch patch{n, n, SimplexNet::Zero(4, (n + 1) * (n + 1))};
  for (int m = 0; m <= n; ++m) {
    for (int l = 0; l <= n; ++l) {
      for (int k = std::max(0, l - n + m); k <= std::min(m, l); ++k) {
        const double factor = binomial(m, k) * binomial(n - m, l - k) / binomial(n, l);
        patch.net.col(m * (n + 1) + l) += factor * b.col(netIndex<3>({n - m, m - k, k}));
      }
    }
  }
  return patch;
}

TensorPatch conePatch(const Vector3& apex, const BezierCurve& base) {
  const int n = base.degree();
  TensorPatch patch{1, n, SimplexNet(4, 2 * (n + 1))};
  for (int l = 0; l <= n; ++l) {
    const double w = base.weight(l);
    patch.net.col(l) << w * apex, w;
    patch.net.col(n + 1 + l) << w * base.pole(l), w;
  }
  return patch;
}

}  // namespace osculate
