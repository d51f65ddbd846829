#include "osculate/solid/net_shape.h"

#include <algorithm>
#include <array>

#include <Eigen/SVD>

#include "osculate/solid/every_row.h"

namespace osculate {

namespace {

/// The control points of positive weight on the face of the net between some corners.
Eigen::MatrixXd pointsBetween(const BezierTetrahedron& solid, const std::vector<int>& corners) {
  std::vector<int> used;
  int position = 0;
  for (const MultiIndex<4>& index : multiIndices<4>(solid.degree())) {
    int sum = 0;
    for (const int corner : corners)
      sum += index[static_cast<std::size_t>(corner)];
    if (sum == solid.degree() && solid.weight(position) > 0.0) used.push_back(position);
    ++position;
  }
  const Eigen::MatrixXd& points = solid.points();
  return points(everyRow(points), used);
}

/// The singular values of the points about the first one: their extents along principal axes.
Eigen::VectorXd extents(Eigen::MatrixXd points) {
  points.colwise() -= Eigen::VectorXd(points.col(0));
  return Eigen::JacobiSVD<Eigen::MatrixXd>(points).singularValues();
}

/// What of the net counts as nothing: points far from the origin carry the rounding of their
/// coordinates.
double limitOf(const BezierTetrahedron& solid, double relativeTolerance) {
  const Eigen::MatrixXd all = pointsBetween(solid, {0, 1, 2, 3});
  return std::max(relativeTolerance * extents(all)[0], 4.0 * 0x1p-53 * all.cwiseAbs().maxCoeff());
}

/// Of the points between some corners; -1 where all their weights are 0.
int dimensionBetween(const BezierTetrahedron& solid, const std::vector<int>& corners,
                     double limit) {
  const Eigen::MatrixXd points = pointsBetween(solid, corners);
  if (points.cols() == 0) return -1;
  return static_cast<int>((extents(points).array() > limit).count());
}

/// Collapsed faces, and collapsed edges that belong to no face that is a point.
std::vector<std::string> collapsedParts(const BezierTetrahedron& solid) {
  std::vector<std::string> warnings;
  const double limit = limitOf(solid, kNetTolerance);
  std::array<bool, 4> isPoint{};
  for (int face = 0; face < 4; ++face) {
    const int dimension =
        dimensionBetween(solid, {(face + 1) % 4, (face + 2) % 4, (face + 3) % 4}, limit);
    isPoint[static_cast<std::size_t>(face)] = dimension == 0;
    if (dimension == 0 || dimension == 1) {
      warnings.push_back("face " + std::to_string(face) + " is collapsed to a " +
                         (dimension == 0 ? "point" : "line"));
    }
  }
  for (int a = 0; a < 4; ++a) {
    for (int b = a + 1; b < 4; ++b) {
      bool isSaid = false;
      for (int face = 0; face < 4; ++face)
        isSaid = isSaid || (face != a && face != b && isPoint[static_cast<std::size_t>(face)]);
      if (!isSaid && dimensionBetween(solid, {a, b}, limit) == 0) {
        warnings.push_back("edge " + std::to_string(a) + "-" + std::to_string(b) +
                           " is collapsed to a point");
      }
    }
  }
  return warnings;
}

}  // namespace

int dimensionOfNet(const BezierTetrahedron& solid, double relativeTolerance) {
  return dimensionBetween(solid, {0, 1, 2, 3}, limitOf(solid, relativeTolerance));
}

std::vector<std::string> netWarnings(const BezierTetrahedron& solid) {
  std::vector<std::string> warnings;
  switch (dimensionOfNet(solid)) {
    case 0:
      warnings.emplace_back("the net is collapsed to a point");
      break;
    case 1:
      warnings.emplace_back("the net is collapsed to a line");
      break;
    case 2:
      warnings.emplace_back("the net is flat: all points lie in one plane");
      break;
    default:
      warnings = collapsedParts(solid);
      break;
  }
  for (int c = 0; c < 4; ++c) {
    MultiIndex<4> corner{};
    corner[static_cast<std::size_t>(c)] = solid.degree();
    if (solid.weight(corner) == 0.0) {
      warnings.push_back("corner " + std::to_string(c) +
                         " has weight 0: the solid has no point there");
    }
  }
  return warnings;
}

}  // namespace osculate
