#include "osculate/solid/neighbour.h"

#include "osculate/construction/contact_error.h"
#include "support/errors.h"
#include "support/simplex_samples.h"

namespace osculate::test {
namespace {

/// The layers of the neighbour in exact arithmetic: V^r_i(w) = sum_{|j|=r} V_{i+j} B_j^r(w).
Point<Rational> exactLayerPoint(const BezierTetrahedron& solid, const MultiIndex<4>& i, int r,
                                const Barycentric<4>& apex) {
  Point<Rational> sum = Point<Rational>::Constant(Rational(0));
  for (const MultiIndex<4>& j : multiIndices<4>(r)) {
    MultiIndex<4> both{};
    for (std::size_t c = 0; c < 4; ++c)
      both[c] = i[c] + j[c];
    sum += exactBernstein<4, Rational>(j, exactBary<4, Rational>(apex)) *
           exact<Rational>(solid.point(both));
  }
  return sum;
}

const std::vector<Barycentric<4>> kApexes{{-1.0, 0.75, 0.5, 0.75},
                                          {-0.5, 1.25, -0.25, 0.5},
                                          {0.25, 0.25, 0.25, 0.25},
                                          {-2.0, 1.0, 1.0, 1.0}};

// Theorem 1.5.1: the layers are V^r(w), for apexes on both sides of the face.
TEST(Neighbour, ForcedLayersAreThePartialPoints) {
  Random random(1);
  const BezierTetrahedron solid = randomSolid(random, 4, false);
  for (const Barycentric<4>& apex : kApexes) {
    const SimplexNet layers = forcedLayers(solid.homogeneous(), 4, 0, apex, 3);
    int position = 0;
    for (const MultiIndex<4>& i : multiIndices<4>(4)) {
      const int at = position++;
      if (i[0] > 3) {
        EXPECT_TRUE(layers.col(at).hasNaN());
        continue;
      }
      const Point<Rational> expected = exactLayerPoint(solid, {0, i[1], i[2], i[3]}, i[0], apex);
      EXPECT_LE(distance(expected, Vector3(layers.col(at))),
                std::pow(7.0, i[0]) * roundingOf(solid));
    }
  }
}

/// D_e^r of the neighbour minus D_d^r of the solid at a point of the face, in 100 digits: the r-th
/// difference along the line from the face towards the apex. The quotient has an error of about h.
double derivativeGap(const BezierTetrahedron& solid, const BezierTetrahedron& next, int face,
                     const Barycentric<4>& apex, int r, const Barycentric<4>& u) {
  const Real h("1e-18");
  std::vector<Real> sum(static_cast<std::size_t>(solid.dimension()), Real(0));
  for (int k = 0; k <= r; ++k) {
    ExactBary<4, Real> inSolid = exactBary<4, Real>(u);
    ExactBary<4, Real> inNext = inSolid;
    for (std::size_t c = 0; c < 4; ++c) {
      const auto i = static_cast<Eigen::Index>(c);
      inSolid[c] += Real(k) * h * (Real(apex[i]) - Real(u[i]));
      inNext[c] += Real(k) * h * (Real(i == face ? 1.0 : 0.0) - Real(u[i]));
    }
    const auto a = exactPoint<4>(solid, inSolid);
    const auto b = exactPoint<4>(next, inNext);
    const Real sign((r - k) % 2 == 0 ? 1 : -1);
    for (std::size_t row = 0; row < sum.size(); ++row)
      sum[row] += sign * choose<Real>(r, k) * (a[row] - b[row]);
  }
  double norm = 0.0;
  for (const Real& value : sum)
    norm = std::max(norm, std::abs(toDouble(Real(value / pow(h, r)))));
  return norm;
}

// Theorem 1.5.1 the first way: the layers make the derivatives across the face equal. The neighbour
// is made of exact doubles only to rounding, which the difference quotient divides by h^r: the
// layers are compared at coordinates that are small integers.
BezierTetrahedron integerSolid(Random& random, int degree) {
  Eigen::MatrixXd points(3, netSize<4>(degree));
  for (Eigen::Index i = 0; i < points.size(); ++i)
    points.data()[i] = random.integer(-8, 8);
  return BezierTetrahedron(degree, points);
}

TEST(Neighbour, DerivativesAcrossTheFaceAgreeUpToTheOrderAndNotBeyond) {
  Random random(2);
  for (const int face : {0, 2, 3}) {
    for (int order = 0; order <= 3; ++order) {
      const BezierTetrahedron solid = integerSolid(random, 4);
      Barycentric<4> apex(0.5, 0.75, 0.5, 0.25);
      apex[face] = -0.5;
      apex[(face + 1) % 4] += 1.0 - apex.sum();
      const BezierTetrahedron next = neighbour(solid, face, apex, order);
      Barycentric<4> u(0.25, 0.25, 0.25, 0.25);
      u[face] = 0.0;
      u[(face + 1) % 4] += 0.25;
      for (int r = 0; r <= order; ++r)
        EXPECT_LE(derivativeGap(solid, next, face, apex, r, u), 1e-11) << "order " << r;
      EXPECT_GE(derivativeGap(solid, next, face, apex, order + 1, u), 1e-2);
    }
  }
}

// The other way: equal derivatives force the layers, so that a changed layer breaks its order.
TEST(Neighbour, AChangedLayerBreaksItsOrder) {
  Random random(3);
  const BezierTetrahedron solid = integerSolid(random, 4);
  const Barycentric<4> apex(-0.5, 0.5, 0.5, 0.5);
  const BezierTetrahedron next = neighbour(solid, 0, apex, 3);
  for (int layer = 0; layer <= 3; ++layer) {
    Eigen::MatrixXd points = next.points();
    points(1, netIndex<4>({layer, 2, 1, 1 - layer >= 0 ? 1 - layer : 0})) += 0.0;
    for (const MultiIndex<4>& i : multiIndices<4>(4)) {
      if (i[0] == layer) {
        points(1, netIndex<4>(i)) += 1.0;
        break;
      }
    }
    const BezierTetrahedron changed(4, points);
    const Barycentric<4> u(0.0, 0.5, 0.25, 0.25);
    for (int r = 0; r < layer; ++r)
      EXPECT_LE(derivativeGap(solid, changed, 0, apex, r, u), 1e-11);
    EXPECT_GE(derivativeGap(solid, changed, 0, apex, layer, u), 1e-2) << "layer " << layer;
  }
}

// With the full order the neighbour is the same polynomial beyond the face.
TEST(Neighbour, FullOrderContinuesTheMap) {
  for (const bool rational : {false, true}) {
    Random random(4);
    const BezierTetrahedron solid = randomSolid(random, 3, rational, 3, 0.1);
    const Barycentric<4> apex(-0.1, 0.4, 0.3, 0.4);
    const BezierTetrahedron next = neighbour(solid, 0, apex, 3);
    const Barycentric<4> u = randomBary<4>(random);
    Barycentric<4> inSolid = u;
    inSolid[0] = 0.0;
    inSolid += u[0] * apex;
    EXPECT_LE((next.evaluate(u) - solid.evaluate(inSolid)).norm(), 1e-13);
  }
}

TEST(Neighbour, FreeLayersOfAFlatMapStayAffine) {
  Random random(5);
  const BezierTetrahedron solid = randomSolid(random, 1, false).elevated(3);
  const Barycentric<4> apex(-1.0, 0.75, 0.5, 0.75);
  for (int order = 0; order <= 4; ++order) {
    const BezierTetrahedron next = neighbour(solid, 0, apex, order);
    const BezierTetrahedron straight = neighbour(solid, 0, apex, 4);
    EXPECT_LE((next.points() - straight.points()).norm(), 1e-12) << "order " << order;
  }
}

TEST(Neighbour, TheApexPointIsMetWhereItIsFree) {
  Random random(6);
  const BezierTetrahedron solid = randomSolid(random, 4, true);
  const SpacePoint wanted = Vector3(-9.0, 2.0, 1.0);
  for (int order = 0; order < 4; ++order) {
    const BezierTetrahedron next =
        neighbour(solid, 0, Barycentric<4>(-0.2, 0.4, 0.4, 0.4), order, {.apexPoint = wanted});
    EXPECT_EQ(next.point({4, 0, 0, 0}), wanted);
    for (const double weight : next.weights())
      EXPECT_GT(weight, 0.0);
  }
}

TEST(Neighbour, AChainHasItsContactAtEveryLink) {
  Random random(7);
  const BezierTetrahedron solid = randomSolid(random, 3, false);
  const std::vector<ChainLink> links{{0, {-1.0, 0.5, 0.75, 0.75}, 2},
                                     {1, {0.5, -1.0, 1.0, 0.5}, 1}};
  const auto solids = chain(solid, links);
  ASSERT_EQ(solids.size(), 3U);
  EXPECT_EQ(solids[0], solid);
  for (std::size_t i = 0; i < links.size(); ++i) {
    const SimplexNet layers =
        forcedLayers(solids[i].points(), 3, links[i].face, links[i].apex, links[i].order);
    const auto indices = multiIndices<4>(3);
    for (std::size_t k = 0; k < indices.size(); ++k) {
      if (indices[k][static_cast<std::size_t>(links[i].face)] > links[i].order) continue;
      const auto column = static_cast<Eigen::Index>(k);
      EXPECT_EQ(layers.col(column), solids[i + 1].points().col(column));
    }
  }
}

TEST(Neighbour, SaysWhereAWeightWouldBeNegative) {
  Eigen::MatrixXd points = Eigen::MatrixXd::Zero(3, 4);
  points.rightCols<3>().setIdentity();
  const BezierTetrahedron solid(1, points, {5.0, 1.0, 1.0, 1.0});
  const Barycentric<4> apex(-1.0, 0.5, 0.5, 1.0);
  EXPECT_THROW(neighbour(solid, 0, apex, 1), ContactError);
  EXPECT_ERROR(neighbour(solid, 0, apex, 1), "choose the apex nearer to the face");
  EXPECT_NO_THROW(neighbour(solid, 0, apex, 0));
}

TEST(Neighbour, RefusesBadArguments) {
  Random random(8);
  const BezierTetrahedron solid = randomSolid(random, 2, false);
  const Barycentric<4> apex(-1.0, 0.5, 0.5, 1.0);
  EXPECT_ERROR(neighbour(solid, 4, apex, 1), "face: must be 0 to 3");
  EXPECT_ERROR(neighbour(solid, 0, apex, 3), "order: must be 0 to the degree 2, got 3");
  EXPECT_ERROR(neighbour(solid, 1, apex, 1), "must lie beyond the face");
  EXPECT_ERROR(neighbour(solid, 0, Barycentric<4>(-1.0, 1.0, 1.0, 1.0), 1), "sum 1");
  EXPECT_ERROR(neighbour(solid, 0, apex, 1, {.apexPoint = SpacePoint::Zero(4)}),
               "apexPoint: needs 3");
}

}  // namespace
}  // namespace osculate::test
