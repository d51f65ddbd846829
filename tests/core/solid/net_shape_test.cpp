#include "osculate/solid/net_shape.h"

#include "osculate/solid/primitives.h"
#include "support/errors.h"
#include "support/simplex_samples.h"

namespace osculate::test {
namespace {

TEST(NetShape, CollapsedFacesAndEdgesAreNamed) {
  Random random(8);
  const BezierTetrahedron solid = randomSolid(random, 2, true);
  Eigen::MatrixXd points = solid.points();
  const SpacePoint place = points.col(netIndex<4>({0, 2, 0, 0}));
  for (const MultiIndex<4>& index : {MultiIndex<4>{0, 1, 1, 0}, {0, 0, 2, 0}})
    points.col(netIndex<4>(index)) = place;
  EXPECT_EQ(netWarnings(BezierTetrahedron(2, points, solid.weights())),
            std::vector<std::string>{"edge 1-2 is collapsed to a point"});
  for (const MultiIndex<4>& index : {MultiIndex<4>{0, 1, 0, 1}, {0, 0, 1, 1}, {0, 0, 0, 2}})
    points.col(netIndex<4>(index)) = place;
  EXPECT_EQ(netWarnings(BezierTetrahedron(2, points, solid.weights())),
            std::vector<std::string>{"face 0 is collapsed to a point"});
  for (const BezierTetrahedron& whole : {ballOctant(3.0), cone(1.0, 2.0)})
    EXPECT_TRUE(netWarnings(whole).empty());
}

TEST(NetShape, FlatAndCollapsedNetsAreLegalButSaidToBe) {
  Random random(7);
  EXPECT_TRUE(netWarnings(randomSolid(random, 3, true)).empty());
  Eigen::MatrixXd points = randomSolid(random, 3, false).points();
  points.row(2).setConstant(5.0);
  EXPECT_EQ(netWarnings(BezierTetrahedron(3, points)).front(),
            "the net is flat: all points lie in one plane");
  points.row(1) = 2.0 * points.row(0);
  EXPECT_EQ(netWarnings(BezierTetrahedron(3, points)).front(), "the net is collapsed to a line");
  points.setConstant(1e6);
  EXPECT_EQ(netWarnings(BezierTetrahedron(3, points)).front(), "the net is collapsed to a point");
  const BezierTetrahedron zero(1, randomSolid(random, 1, false).points(), {1, 0, 1, 1});
  EXPECT_NE(netWarnings(zero).back().find("corner 1 has weight 0"), std::string::npos);
}

}  // namespace
}  // namespace osculate::test
