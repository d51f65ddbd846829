// Rectangular patches that hold a Bézier triangle exactly.
#pragma once

#include "osculate/bezier/bezier_curve.h"
#include "osculate/bezier/bezier_triangle.h"

namespace osculate {

/// A rational tensor-product patch in E3. Row m, column l of the net is column m (degreeY+1) + l of
/// `net`: (w x, w y, w z, w).
struct TensorPatch {
  int degreeX = 0;
  int degreeY = 0;
  SimplexNet net;

  Eigen::Vector4d point(int m, int l) const { return net.col(m * (degreeY + 1) + l); }
  /// The point at x, y, by de Casteljau.
  Vector3 evaluate(double x, double y) const;
};

/// The triangle of degree n as a patch of degree (n, n) whose edge x = 0 is corner 0: u = 1-x,
/// v = x(1-y), w = xy. Row m is the degree-m row of the net raised to degree n (mathematics C5):
/// p_{m,l} = sum_k C(m,k) C(n-m,l-k)/C(n,l) b_{n-m,m-k,k}. A convex combination: weights > 0 where
/// all of the triangle's are. Throws std::invalid_argument in E4.
TensorPatch tensorPatch(const BezierTriangle& triangle);

/// The ruled patch of degree (1, n) from a point (x = 0) to a curve (x = 1).
TensorPatch conePatch(const Vector3& apex, const BezierCurve& base);

}  // namespace osculate
