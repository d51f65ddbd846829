#include "osculate/bezier/tensor_patch.h"

#include <fstream>
#include <nlohmann/json.hpp>

#include "support/errors.h"
#include "support/simplex_samples.h"

namespace osculate::test {
namespace {

TEST(TensorPatch, HoldsTheTriangleExactly) {
  forSimplices<3>(1, [](Random& random, const BezierTriangle& triangle) {
    if (triangle.dimension() == 4) return;
    const TensorPatch patch = tensorPatch(triangle);
    for (int i = 0; i < 5; ++i) {
      const double x = random.uniform(0.0, 1.0);
      const double y = random.uniform(0.0, 1.0);
      const Barycentric<3> u(1.0 - x, x * (1.0 - y), x * y);
      EXPECT_LE((patch.evaluate(x, y) - triangle.evaluate(u)).norm(), 2 * roundingOf(triangle));
    }
  });
}

TEST(TensorPatch, OneEdgeIsTheCornerAndTheOthersAreTheEdges) {
  Random random(2);
  const BezierTriangle triangle = randomSimplex<3>(random, 4, true);
  const TensorPatch patch = tensorPatch(triangle);
  for (const double t : {0.0, 0.3, 1.0}) {
    EXPECT_LE((patch.evaluate(0.0, t) - triangle.point({4, 0, 0})).norm(), 1e-14);
    EXPECT_LE((patch.evaluate(1.0, t) - edgeCurve(triangle, 1, 2).evaluate(t)).norm(), 1e-14);
    EXPECT_LE((patch.evaluate(t, 0.0) - edgeCurve(triangle, 0, 1).evaluate(t)).norm(), 1e-14);
    EXPECT_LE((patch.evaluate(t, 1.0) - edgeCurve(triangle, 0, 2).evaluate(t)).norm(), 1e-14);
  }
}

TEST(TensorPatch, WeightsArePositiveAfterOneElevationOfAConeSide) {
  // the side of the thesis' cone: weights 1; 0, 0; 1, 1/2, 1 (mathematics C6)
  Random random(3);
  const Eigen::MatrixXd points = randomSimplex<3>(random, 2, false).points();
  const BezierTriangle side(2, points, {1, 0, 0, 1, 0.5, 1});
  EXPECT_EQ(tensorPatch(side).net.row(3).minCoeff(), 0.0);
  EXPECT_GE(tensorPatch(side.elevated()).net.row(3).minCoeff(), 2.0 / 9.0 - 1e-15);
}

TEST(TensorPatch, AConePatchIsRuled) {
  Random random(4);
  const BezierCurve base = randomBezier(random, 3, true);
  const Vector3 apex(1.0, 2.0, 3.0);
  const TensorPatch patch = conePatch(apex, base);
  const Vector3 expected = 0.25 * apex + 0.75 * base.evaluate(0.4);
  EXPECT_LE((patch.evaluate(0.75, 0.4) - expected).norm(), 1e-14);
}

double number(const nlohmann::json& value) {
  return value.is_string() ? std::stod(value.get<std::string>()) : value.get<double>();
}

TEST(TensorPatch, OfTheOctantIsThatOfTheReference) {
  std::ifstream file(OSCULATE_SHARED_DIR "/oracle/solids.json");
  if (!file) GTEST_SKIP() << "needs oracle/solids.json in ../shared";
  const auto reference = nlohmann::json::parse(file);
  Eigen::MatrixXd points(3, 15);
  std::vector<double> weights(15);
  for (const auto& entry : reference.at("sphere_octant_quartic").at("net")) {
    const int i = netIndex<3>(entry.at("ijk").get<MultiIndex<3>>());
    for (int row = 0; row < 3; ++row)
      points(row, i) = number(entry.at("point")[static_cast<std::size_t>(row)]);
    weights[static_cast<std::size_t>(i)] = number(entry.at("weight"));
  }
  const TensorPatch patch = tensorPatch(BezierTriangle(4, points, weights));
  const auto& rows = reference.at("octant_as_tensor_4x4_collapsed_at_A");
  for (int m = 0; m <= 4; ++m) {
    for (int l = 0; l <= 4; ++l) {
      const auto& entry = rows[static_cast<std::size_t>(m)][static_cast<std::size_t>(l)];
      EXPECT_NEAR(patch.point(m, l)[3], number(entry.at("weight")), 1e-14);
      for (int row = 0; row < 3; ++row) {
        EXPECT_NEAR(patch.point(m, l)[row] / patch.point(m, l)[3],
                    number(entry.at("point")[static_cast<std::size_t>(row)]), 1e-13);
      }
    }
  }
}

TEST(TensorPatch, RefusesE4) {
  Random random(5);
  EXPECT_ERROR(tensorPatch(randomSimplex<3>(random, 2, false, 4)), "triangle in E3");
}

}  // namespace
}  // namespace osculate::test
