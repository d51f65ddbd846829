#include "osculate/bezier/bezier_simplex.h"

#include <limits>
#include <numeric>

#include "support/errors.h"
#include "support/simplex_samples.h"

namespace osculate::test {
namespace {

/// Where a point of a part lies in the whole.
template <int Corners>
Barycentric<Corners> combined(const PartCornersOf<Corners>& corners,
                              const Barycentric<Corners>& u) {
  Barycentric<Corners> sum = Barycentric<Corners>::Zero();
  for (int c = 0; c < Corners; ++c)
    sum += u[c] * corners[static_cast<std::size_t>(c)];
  return sum;
}

template <int Corners>
void expectEvaluation() {
  forSimplices<Corners>(1, [](Random& random, const BezierSimplex<Corners>& simplex) {
    for (int i = 0; i < 3; ++i) {
      const Barycentric<Corners> u = randomBary<Corners>(random);
      EXPECT_LE(distance(exactPoint<Corners>(simplex, exactBary<Corners, Rational>(u)),
                         simplex.evaluate(u)),
                roundingOf(simplex));
    }
  });
}

TEST(BezierSimplex, EvaluatesAsTheSumOfBernsteinPolynomials) {
  expectEvaluation<3>();
  expectEvaluation<4>();
}

TEST(BezierSimplex, EvaluatesOutsideToo) {
  forSimplices<4>(2, [](Random&, const BezierTetrahedron& solid) {
    if (solid.degree() > 5) return;
    const Barycentric<4> u(-0.25, 0.5, 0.5, 0.25);
    const double growth = std::pow(1.5, 2 * solid.degree());
    EXPECT_LE(distance(exactPoint<4>(solid, exactBary<4, Rational>(u)), solid.evaluate(u)),
              growth * roundingOf(solid));
  });
}

// Theorem 1.2.3: a net of one point is that point. Theorem 1.2.4: linear precision.
TEST(BezierSimplex, BernsteinPolynomialsAreAPartitionOfUnityWithLinearPrecision) {
  Random random(3);
  for (int degree = 1; degree <= kMaxSimplexDegree; ++degree) {
    Eigen::MatrixXd points(4, netSize<4>(degree));
    Eigen::Index position = 0;
    for (const MultiIndex<4>& index : multiIndices<4>(degree)) {
      for (int c = 0; c < 4; ++c)
        points(c, position) = static_cast<double>(index[static_cast<std::size_t>(c)]) / degree;
      ++position;
    }
    const Barycentric<4> u = randomBary<4>(random);
    EXPECT_LE((BezierTetrahedron(degree, points).evaluate(u) - u).norm(), 32 * kUnitRoundoff);
    points.colwise() = Eigen::Vector4d(1.0, -2.0, 3.0, 5.0);
    const BezierTetrahedron collapsed(degree, points, randomWeights(random, netSize<4>(degree)));
    EXPECT_LE((collapsed.evaluate(u) - points.col(0)).norm(), 64 * kUnitRoundoff * 6.3);
  }
}

// Theorem 1.3.1.
TEST(BezierSimplex, IsAffinelyInvariant) {
  forSimplices<4>(4, [](Random& random, const BezierTetrahedron& solid) {
    const int d = solid.dimension();
    Eigen::MatrixXd linear(d, d);
    SpacePoint translation(d);
    for (int row = 0; row < d; ++row) {
      translation[row] = random.uniform(-5, 5);
      for (int column = 0; column < d; ++column)
        linear(row, column) = random.uniform(-1, 1);
    }
    const Barycentric<4> u = randomBary<4>(random);
    const SpacePoint expected = linear * solid.evaluate(u) + translation;
    EXPECT_LE((solid.transformed(linear, translation).evaluate(u) - expected).norm(),
              8 * roundingOf(solid));
  });
}

// Theorem 1.3.2, as support in random directions.
TEST(BezierSimplex, LiesInTheConvexHullAndBoxOfItsPoints) {
  forSimplices<4>(5, [](Random& random, const BezierTetrahedron& solid) {
    const auto [low, high] = solid.box();
    for (int i = 0; i < 10; ++i) {
      const SpacePoint p = solid.evaluate(randomBary<4>(random));
      Eigen::RowVectorXd normal(solid.dimension());
      for (int row = 0; row < solid.dimension(); ++row)
        normal[row] = random.uniform(-1, 1);
      EXPECT_LE(normal.dot(p), (normal * solid.points()).maxCoeff() + roundingOf(solid));
      EXPECT_TRUE((p.array() >= low.array() - roundingOf(solid)).all());
      EXPECT_TRUE((p.array() <= high.array() + roundingOf(solid)).all());
    }
  });
}

// Theorem 1.3.3.
TEST(BezierSimplex, HasTheCornersOfItsNet) {
  forSimplices<4>(6, [](Random&, const BezierTetrahedron& solid) {
    for (int c = 0; c < 4; ++c) {
      MultiIndex<4> corner{};
      corner[static_cast<std::size_t>(c)] = solid.degree();
      EXPECT_LE((solid.evaluate(Barycentric<4>::Unit(c)) - solid.point(corner)).norm(),
                roundingOf(solid));
    }
  });
}

// Theorem 1.2.2 for partial points: V_i^r(u) = sum_{|j|=r} V_{i+j} B_j^r(u).
TEST(BezierSimplex, PartialPointsFollowTheRecursion) {
  Random random(7);
  const BezierTetrahedron solid = randomSolid(random, 5, false);
  const Barycentric<4> u = randomBary<4>(random);
  SimplexNet net = solid.homogeneous();
  for (int r = 1; r <= 5; ++r) {
    reduceNet<4>(net, 6 - r, u);
    int position = 0;
    for (const MultiIndex<4>& i : multiIndices<4>(5 - r)) {
      Point<Rational> sum = Point<Rational>::Constant(Rational(0));
      for (const MultiIndex<4>& j : multiIndices<4>(r)) {
        MultiIndex<4> both{};
        for (std::size_t c = 0; c < 4; ++c)
          both[c] = i[c] + j[c];
        sum += exactBernstein<4, Rational>(j, exactBary<4, Rational>(u)) *
               exact<Rational>(solid.point(both));
      }
      EXPECT_LE(distance(sum, Vector3(net.col(position++))), roundingOf(solid));
    }
  }
}

// Theorem 1.3.5 and its rational form.
template <int Corners>
void expectElevation() {
  forSimplices<Corners>(8, [](Random& random, const BezierSimplex<Corners>& simplex) {
    const int times = std::min(3, kMaxSimplexDegree - simplex.degree());
    const BezierSimplex<Corners> raised = simplex.elevated(times);
    EXPECT_EQ(raised.degree(), simplex.degree() + times);
    const Barycentric<Corners> u = randomBary<Corners>(random);
    EXPECT_LE((raised.evaluate(u) - simplex.evaluate(u)).norm(), 2 * roundingOf(raised));
  });
}

TEST(BezierSimplex, ElevationKeepsTheMap) {
  expectElevation<3>();
  expectElevation<4>();
}

/// The r-th mixed difference quotient in 100 digits; its own error is about h.
template <int Corners>
std::vector<Real> differenceQuotient(const BezierSimplex<Corners>& simplex,
                                     const Barycentric<Corners>& u,
                                     const std::vector<Barycentric<Corners>>& directions) {
  const Real h("1e-20");
  std::vector<Real> sum(static_cast<std::size_t>(simplex.dimension()), Real(0));
  for (unsigned subset = 0; subset < 1U << directions.size(); ++subset) {
    ExactBary<Corners, Real> at = exactBary<Corners, Real>(u);
    Real sign(1);
    for (std::size_t d = 0; d < directions.size(); ++d) {
      if ((subset >> d & 1U) == 0U) {
        sign = -sign;
        continue;
      }
      for (std::size_t c = 0; c < Corners; ++c)
        at[c] += h * Real(directions[d][static_cast<Eigen::Index>(c)]);
    }
    const std::vector<Real> value = exactPoint<Corners>(simplex, at);
    for (std::size_t row = 0; row < sum.size(); ++row)
      sum[row] += sign * value[row];
  }
  for (Real& value : sum)
    value /= pow(h, static_cast<int>(directions.size()));
  return sum;
}

template <int Corners>
void expectDerivatives() {
  forSimplices<Corners>(9, [](Random& random, const BezierSimplex<Corners>& simplex) {
    if (simplex.degree() > 5) return;
    const Barycentric<Corners> u = randomBary<Corners>(random);
    const Barycentric<Corners> d = randomDirection<Corners>(random);
    const Barycentric<Corners> e = randomDirection<Corners>(random);
    const std::vector<std::vector<Barycentric<Corners>>> cases{
        {d}, {d, d}, {d, e}, {d, e, d}, {e, e, e}};
    for (const auto& directions : cases) {
      const double scale = std::pow(4.0 * simplex.degree(), static_cast<double>(directions.size()));
      EXPECT_LE(distance(differenceQuotient<Corners>(simplex, u, directions),
                         simplex.derivative(u, directions)),
                scale * roundingOf(simplex))
          << "order " << directions.size();
    }
  });
}

TEST(BezierSimplex, DerivativesAreThoseOfDifferencesInHigherPrecision) {
  expectDerivatives<3>();
  expectDerivatives<4>();
}

TEST(BezierSimplex, PolynomialDerivativesVanishBeyondTheDegree) {
  Random random(10);
  const Barycentric<4> u = randomBary<4>(random);
  const std::vector<Barycentric<4>> directions(4, randomDirection<4>(random));
  EXPECT_EQ(randomSolid(random, 3, false).derivative(u, directions).norm(), 0.0);
  EXPECT_GT(randomSolid(random, 3, true).derivative(u, directions).norm(), 0.0);
}

// Theorem 1.4.1: D_d^r B = sum over |i| = r of (partial^i B) B_i^r(d).
TEST(BezierSimplex, PartialDerivativesMakeDirectionalOnes) {
  forSimplices<4>(11, [](Random& random, const BezierTetrahedron& solid) {
    if (solid.degree() > 5) return;
    const Barycentric<4> u = randomBary<4>(random);
    const Barycentric<4> d = randomDirection<4>(random);
    for (int r = 1; r <= 3; ++r) {
      SpacePoint sum = SpacePoint::Zero(solid.dimension());
      for (const MultiIndex<4>& index : multiIndices<4>(r))
        sum += toDouble(exactBernstein<4, Rational>(index, exactBary<4, Rational>(d))) *
               solid.partial(u, index);
      const std::vector<Barycentric<4>> directions(static_cast<std::size_t>(r), d);
      EXPECT_LE((sum - solid.derivative(u, directions)).norm(),
                std::pow(8.0 * solid.degree(), r) * roundingOf(solid));
    }
  });
}

template <int Corners>
void expectSameMap(const BezierSimplex<Corners>& whole, const BezierSimplex<Corners>& part,
                   const PartCornersOf<Corners>& corners, Random& random) {
  const Barycentric<Corners> u = randomBary<Corners>(random);
  EXPECT_LE((part.evaluate(u) - whole.evaluate(combined<Corners>(corners, u))).norm(),
            4 * roundingOf(whole));
}

TEST(BezierSimplex, SubdivisionAtAPointKeepsTheMap) {
  forSimplices<4>(12, [](Random& random, const BezierTetrahedron& solid) {
    const Barycentric<4> at = randomBary<4>(random);
    const auto parts = solid.subdivided(at);
    ASSERT_EQ(parts.size(), 4U);
    for (std::size_t c = 0; c < 4; ++c) {
      PartCornersOf<4> corners = unitCorners<4>();
      corners[c] = at;
      expectSameMap<4>(solid, parts[c], corners, random);
    }
  });
}

TEST(BezierSimplex, BisectionKeepsTheMap) {
  forSimplices<4>(13, [](Random& random, const BezierTetrahedron& solid) {
    for (int a = 0; a < 4; ++a) {
      for (int b = 0; b < 4; ++b) {
        if (a == b) continue;
        const auto [first, second] = solid.bisected(a, b);
        const Barycentric<4> middle = 0.5 * (Barycentric<4>::Unit(a) + Barycentric<4>::Unit(b));
        PartCornersOf<4> corners = unitCorners<4>();
        corners[static_cast<std::size_t>(b)] = middle;
        expectSameMap<4>(solid, first, corners, random);
        corners = unitCorners<4>();
        corners[static_cast<std::size_t>(a)] = middle;
        expectSameMap<4>(solid, second, corners, random);
      }
    }
  });
}

double orientedVolume(const BezierTetrahedron& linear) {
  const Eigen::MatrixXd& p = linear.points();
  Eigen::Matrix3d edges;
  edges << p.col(1) - p.col(0), p.col(2) - p.col(0), p.col(3) - p.col(0);
  return edges.determinant() / 6.0;
}

TEST(BezierSimplex, RefinementMakesEightEqualPartsOfTheSameOrientation) {
  Eigen::MatrixXd points = Eigen::MatrixXd::Zero(3, 4);
  points.rightCols<3>().setIdentity();
  for (const BezierTetrahedron& part : BezierTetrahedron(1, points).refined())
    EXPECT_DOUBLE_EQ(orientedVolume(part), 1.0 / 48.0);
}

TEST(BezierSimplex, RefinedPartsShareTheMap) {
  Random random(14);
  const BezierTetrahedron solid = randomSolid(random, 4, true);
  Eigen::MatrixXd points = Eigen::MatrixXd::Identity(4, 4);
  const auto domains = BezierTetrahedron(1, points).refined();
  const auto parts = solid.refined();
  ASSERT_EQ(parts.size(), 8U);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Barycentric<4> u = randomBary<4>(random);
    const Barycentric<4> inWhole = domains[i].evaluate(u);
    EXPECT_LE((parts[i].evaluate(u) - solid.evaluate(inWhole)).norm(), 4 * roundingOf(solid));
  }
}

TEST(BezierSimplex, TrianglesSubdivideToo) {
  Random random(15);
  const BezierTriangle triangle = randomSimplex<3>(random, 5, true);
  const BezierTriangle domain(1, (Eigen::MatrixXd(3, 3) << 1, 0, 0, 0, 1, 0, 0, 0, 1).finished());
  const auto parts = triangle.refined();
  const auto domains = domain.refined();
  ASSERT_EQ(parts.size(), 4U);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Barycentric<3> u = randomBary<3>(random);
    const Barycentric<3> inWhole = domains[i].evaluate(u);
    EXPECT_LE((parts[i].evaluate(u) - triangle.evaluate(inWhole)).norm(), 4 * roundingOf(triangle));
  }
  EXPECT_EQ(triangle.subdivided({0.2, 0.3, 0.5}).size(), 3U);
}

TEST(BezierSimplex, RelabellingPermutesTheCoordinates) {
  Random random(16);
  const BezierTetrahedron solid = randomSolid(random, 4, true);
  const MultiIndex<4> order{2, 0, 3, 1};
  const BezierTetrahedron turned = solid.relabelled(order);
  const Barycentric<4> u = randomBary<4>(random);
  Barycentric<4> old;
  for (std::size_t c = 0; c < 4; ++c)
    old[order[c]] = u[static_cast<Eigen::Index>(c)];
  EXPECT_LE((turned.evaluate(u) - solid.evaluate(old)).norm(), roundingOf(solid));
  EXPECT_EQ(turned.relabelled({1, 3, 0, 2}), solid);
}

TEST(BezierSimplex, ProjectiveMapsActOnEveryPoint) {
  Random random(17);
  const BezierTetrahedron solid = randomSolid(random, 3, true);
  Eigen::Matrix4d map = Eigen::Matrix4d::Identity();
  map.row(3) << 0.01, -0.02, 0.03, 1.0;
  const Barycentric<4> u = randomBary<4>(random);
  const Eigen::Vector4d image = map * solid.evaluate(u).homogeneous();
  EXPECT_LE((solid.mapped(map).evaluate(u) - image.head<3>() / image[3]).norm(),
            8 * roundingOf(solid));
  EXPECT_EQ(solid.mapped(-map).weights().front(), solid.mapped(map).weights().front());
  map.row(3) << 1.0, 0.0, 0.0, -5.0;
  EXPECT_ERROR(solid.mapped(map), "through infinity");
}

TEST(BezierSimplex, ZeroWeightsContributeNothing) {
  Random random(18);
  BezierTetrahedron solid = randomSolid(random, 2, true);
  std::vector<double> weights = solid.weights();
  weights[4] = weights[7] = 0.0;
  Eigen::MatrixXd points = solid.points();
  const BezierTetrahedron zero(2, points, weights);
  points.col(4).setConstant(1e6);
  const BezierTetrahedron moved(2, points, weights);
  const Barycentric<4> u = randomBary<4>(random);
  EXPECT_EQ(zero.evaluate(u), moved.evaluate(u));
  EXPECT_EQ(zero.box(), moved.box());
  const BezierTetrahedron raised = zero.elevated();
  EXPECT_LE((raised.evaluate(u) - zero.evaluate(u)).norm(), roundingOf(solid));
}

TEST(BezierSimplex, ACornerOfWeightZeroHasNoPoint) {
  Eigen::MatrixXd points = Eigen::MatrixXd::Zero(3, 4);
  points.rightCols<3>().setIdentity();
  const BezierTetrahedron solid(1, points, {0.0, 1.0, 1.0, 1.0});
  EXPECT_TRUE(solid.evaluate(Barycentric<4>::Unit(0)).hasNaN());
  const Barycentric<4> inside(0.7, 0.1, 0.1, 0.1);
  EXPECT_LE((solid.evaluate(inside) - Vector3::Constant(1.0 / 3.0)).norm(), 1e-15);
}

TEST(BezierSimplex, RefusesBadInput) {
  const Eigen::MatrixXd points = Eigen::MatrixXd::Random(3, 10);
  EXPECT_ERROR(BezierTetrahedron(0, points), "degree: must be 1 to 12, got 0");
  EXPECT_ERROR(BezierTetrahedron(13, points), "degree: must be 1 to 12, got 13");
  EXPECT_ERROR(BezierTetrahedron(3, points), "points: a net of degree 3 has 20 points, got 10");
  EXPECT_ERROR(BezierTriangle(2, points), "points: a net of degree 2 has 6 points, got 10");
  EXPECT_ERROR(BezierTetrahedron(2, Eigen::MatrixXd::Random(2, 10)), "must have 3 coordinates");
  Eigen::MatrixXd broken = points;
  broken(1, 3) = kNaN;
  EXPECT_ERROR(BezierTetrahedron(2, broken), "points: every coordinate must be finite");
  EXPECT_ERROR(BezierTetrahedron(2, points, {1.0}),
               "weights: one for each point is needed, got 1 for 10");
  std::vector<double> weights(10, 0.0);
  EXPECT_ERROR(BezierTetrahedron(2, points, weights), "weights: at least one must be > 0");
  weights[2] = -1.0;
  EXPECT_ERROR(BezierTetrahedron(2, points, weights),
               "weights: every weight must be finite and >= 0");
  weights[2] = kNaN;
  EXPECT_ERROR(BezierTetrahedron(2, points, weights),
               "weights: every weight must be finite and >= 0");
  const BezierTetrahedron solid(2, points);
  EXPECT_ERROR(solid.elevated(11), "times: the degree 2 can be raised by 0 to 10, got 11");
  EXPECT_ERROR(solid.bisected(1, 1), "two different corners");
  EXPECT_ERROR(solid.edgeNet(0, 4), "two different corners");
  EXPECT_ERROR(solid.relabelled({0, 1, 1, 2}), "must be a permutation");
  EXPECT_ERROR(solid.subdivided({0.5, 0.5, 0.5, 0.5}), "sum 1");
  const std::vector<Barycentric<4>> direction{{1.0, 0.0, 0.0, 0.0}};
  EXPECT_ERROR(solid.derivative({0.25, 0.25, 0.25, 0.25}, direction), "sum 0");
  EXPECT_ERROR(solid.transformed(Eigen::Matrix4d::Identity(), SpacePoint::Zero(4)),
               "a column for each");
}

TEST(BezierSimplex, AFarPartOfARationalOneIsRefused) {
  Eigen::MatrixXd points = Eigen::MatrixXd::Zero(3, 4);
  points.rightCols<3>().setIdentity();
  const BezierTetrahedron solid(1, points, {4.0, 1.0, 1.0, 1.0});
  EXPECT_ERROR(solid.subdivided({-2.0, 1.0, 1.0, 1.0}), "weights");
}

}  // namespace
}  // namespace osculate::test
