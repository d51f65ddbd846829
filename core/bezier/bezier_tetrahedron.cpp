#include "osculate/bezier/bezier_tetrahedron.h"

#include <cmath>
#include <stdexcept>
#include <string>

#include "osculate/bezier/simplex_edge.h"

namespace osculate {

BezierTriangle face(const BezierTetrahedron& solid, int oppositeCorner) {
  if (oppositeCorner < 0 || oppositeCorner > 3) {
    throw std::invalid_argument("face: must be 0 to 3, the number of the opposite corner, got " +
                                std::to_string(oppositeCorner));
  }
  const int n = solid.degree();
  std::vector<double> weights;
  if (solid.isRational()) {
    const Eigen::Map<const Eigen::RowVectorXd> all(solid.weights().data(), solid.size());
    const SimplexNet chosen = faceNet<4>(all, n, oppositeCorner);
    weights.assign(chosen.data(), chosen.data() + chosen.size());
  }
  return BezierTriangle(n, faceNet<4>(solid.points(), n, oppositeCorner), std::move(weights));
}

BezierTriangle cut(const BezierTetrahedron& solid, const PartCornersOf<4, 3>& corners) {
  for (const Barycentric<4>& corner : corners) {
    if (!corner.allFinite() || std::abs(corner.sum() - 1.0) > 1e-9) {
      throw std::invalid_argument("corners: barycentric coordinates must be finite with the sum 1");
    }
  }
  const SimplexNet net = partNet<4, 3>(solid.homogeneous(), solid.degree(), corners);
  return BezierTriangle::fromHomogeneous(solid.degree(), solid.dimension(), net);
}

BezierTriangle isoSurface(const BezierTetrahedron& solid, int coordinate, double c) {
  if (!(c >= 0.0 && c < 1.0)) {
    throw std::invalid_argument(
        "c: must be from 0 to below 1 (at 1 the surface is a corner), got " + std::to_string(c));
  }
  if (coordinate < 0 || coordinate > 3) {
    throw std::invalid_argument("coordinate: must be 0 to 3, got " + std::to_string(coordinate));
  }
  PartCornersOf<4, 3> corners;
  std::size_t next = 0;
  for (int corner = 0; corner < 4; ++corner) {
    if (corner == coordinate) continue;
    corners[next++] =
        c * Barycentric<4>::Unit(coordinate) + (1.0 - c) * Barycentric<4>::Unit(corner);
  }
  return cut(solid, corners);
}

BezierCurve edgeCurve(const BezierTetrahedron& solid, int a, int b) {
  return curveFromEdgeNet(solid.edgeNet(a, b), solid.dimension(), solid.isRational());
}

}  // namespace osculate
