#include "osculate/solid/net_shape.h"

#include <Eigen/SVD>

namespace osculate {

int dimensionOfNet(const BezierTetrahedron& solid, double relativeTolerance) {
  std::vector<int> used;
  for (int i = 0; i < solid.size(); ++i) {
    if (solid.weight(i) > 0.0) used.push_back(i);
  }
  Eigen::MatrixXd points = solid.points()(Eigen::all, used);
  const double largest = points.cwiseAbs().maxCoeff();
  points.colwise() -= Eigen::VectorXd(points.col(0));
  const Eigen::VectorXd extents = Eigen::JacobiSVD<Eigen::MatrixXd>(points).singularValues();
  // points far from the origin carry the rounding of their coordinates
  const double limit = std::max(relativeTolerance * extents[0], 4.0 * 0x1p-53 * largest);
  return static_cast<int>((extents.array() > limit).count());
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
