#include "osculate/solid/vtu.h"

#include <algorithm>
#include <sstream>

#include "osculate/solid/primitives.h"
#include "support/errors.h"
#include "support/simplex_samples.h"

namespace osculate::test {
namespace {

TEST(Vtu, TheOrderIsAPermutationThatBeginsWithTheCorners) {
  for (int degree = 1; degree <= kMaxSimplexDegree; ++degree) {
    std::vector<int> order = vtkOrder(degree);
    ASSERT_EQ(static_cast<int>(order.size()), netSize<4>(degree)) << degree;
    EXPECT_EQ(order[0], netIndex<4>({degree, 0, 0, 0}));
    EXPECT_EQ(order[1], netIndex<4>({0, degree, 0, 0}));
    EXPECT_EQ(order[2], netIndex<4>({0, 0, degree, 0}));
    EXPECT_EQ(order[3], netIndex<4>({0, 0, 0, degree}));
    std::sort(order.begin(), order.end());
    for (std::size_t i = 0; i < order.size(); ++i)
      EXPECT_EQ(order[i], static_cast<int>(i));
  }
}

TEST(Vtu, QuadraticOrderIsThatOfVtksQuadraticTetrahedron) {
  const std::vector<int> order = vtkOrder(2);
  const std::vector<MultiIndex<4>> edges{{1, 1, 0, 0}, {0, 1, 1, 0}, {1, 0, 1, 0},
                                         {1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}};
  for (std::size_t i = 0; i < edges.size(); ++i)
    EXPECT_EQ(order[4 + i], netIndex<4>(edges[i]));
}

TEST(Vtu, NumbersReadBackAsTheyWere) {
  Random random(1);
  const BezierTetrahedron solid = randomSolid(random, 2, true);
  std::ostringstream stream;
  const std::vector<BezierTetrahedron> solids{solid, cone(1.0, 2.0)};
  writeVtu(stream, solids);
  const std::string text = stream.str();
  std::istringstream weights(text.substr(text.find("RationalWeights\" format") + 33));
  for (const int position : vtkOrder(2)) {
    std::string number;
    weights >> number;
    EXPECT_EQ(std::stod(number), solid.weight(position));
  }
  EXPECT_NE(text.find("NumberOfPoints=\"20\" NumberOfCells=\"2\""), std::string::npos);
}

TEST(Vtu, RefusesWhatVtkCannotShow) {
  std::ostringstream stream;
  EXPECT_ERROR(writeVtu(stream, {}), "at least one solid");
  const std::vector<BezierTetrahedron> inE4{randomTetrahedron(2, 1, 4)};
  EXPECT_ERROR(writeVtu(stream, inE4), "project it from E4 first");
  const std::vector<BezierTetrahedron> zero{
      BezierTetrahedron(1, Eigen::MatrixXd::Random(3, 4), {0, 1, 1, 1})};
  EXPECT_ERROR(writeVtu(stream, zero), "raise the degree first");
}

}  // namespace
}  // namespace osculate::test
