#include "osculate/solid/jacobian.h"

#include "osculate/solid/neighbour.h"
#include "osculate/solid/primitives.h"
#include "support/errors.h"
#include "support/peer_cases.h"
#include "support/simplex_samples.h"

namespace osculate::test {
namespace {

/// The value of a Bernstein polynomial.
double valueAt(const JacobianNumerator& numerator, const Barycentric<4>& u) {
  SimplexNet net = numerator.coefficients;
  for (int d = numerator.degree; d > 0; --d)
    reduceNet<4>(net, d, u);
  return net(0, 0);
}

double weightAt(const BezierTetrahedron& solid, const Barycentric<4>& u) {
  SimplexNet net = solid.homogeneousWithWeights();
  for (int d = solid.degree(); d > 0; --d)
    reduceNet<4>(net, d, u);
  return net(net.rows() - 1, 0);
}

TEST(Jacobian, TheNumeratorIsTheDeterminantOfTheDerivatives) {
  forSimplices<4>(1, [](Random& random, const BezierTetrahedron& solid) {
    if (solid.dimension() == 4 || solid.degree() > 5) return;
    const JacobianNumerator numerator = jacobianNumerator(solid);
    EXPECT_EQ(numerator.degree, (solid.isRational() ? 4 : 3) * (solid.degree() - 1));
    for (int i = 0; i < 5; ++i) {
      const Barycentric<4> u = randomBary<4>(random);
      const double w = weightAt(solid, u);
      const double expected = jacobian(solid, u);
      EXPECT_NEAR(valueAt(numerator, u) / (w * w * w * w), expected,
                  1e-9 * std::max(1000.0, std::abs(expected)));
    }
  });
}

/// The numerator's coefficients in exact arithmetic are the products of all choices of four points,
/// sum over i1+i2+i3+i4 = i of factors times determinants; checked for degree 2.
TEST(Jacobian, ErrorsBoundTheRounding) {
  Random random(2);
  const BezierTetrahedron solid = randomSolid(random, 2, true);
  const JacobianNumerator numerator = jacobianNumerator(solid);
  std::vector<Rational> exactCoefficients(static_cast<std::size_t>(netSize<4>(4)), Rational(0));
  const auto linear = multiIndices<4>(1);
  const auto column = [&](int c, int k) {
    const int position = netIndex<4>(shifted<4>(linear[static_cast<std::size_t>(k)], c));
    Eigen::Matrix<Rational, 4, 1> x;
    const Rational w(solid.weight(position));
    x << w, Point<Rational>(w * exact<Rational>(solid.points().col(position)));
    return x;
  };
  for (int code = 0; code < 256; ++code) {
    Eigen::Matrix<Rational, 4, 4> m;
    MultiIndex<4> sum{};
    for (int c = 0; c < 4; ++c) {
      const int k = code >> (2 * c) & 3;
      m.col(c) = column(c, k);
      ++sum[static_cast<std::size_t>(k)];
    }
    const auto minor = [&](int a, int b, int r, int s) {
      return Rational(m(r, a) * m(s, b) - m(s, a) * m(r, b));
    };
    const Rational determinant =
        minor(0, 1, 0, 1) * minor(2, 3, 2, 3) - minor(0, 1, 0, 2) * minor(2, 3, 1, 3) +
        minor(0, 1, 0, 3) * minor(2, 3, 1, 2) + minor(0, 1, 1, 2) * minor(2, 3, 0, 3) -
        minor(0, 1, 1, 3) * minor(2, 3, 0, 2) + minor(0, 1, 2, 3) * minor(2, 3, 0, 1);
    exactCoefficients[static_cast<std::size_t>(netIndex<4>(sum))] +=
        Rational(8) * determinant / Rational(multinomial<4>(sum));
  }
  for (int i = 0; i < netSize<4>(4); ++i) {
    const Rational difference =
        exactCoefficients[static_cast<std::size_t>(i)] - Rational(numerator.coefficients[i]);
    EXPECT_LE(std::abs(toDouble(difference)), numerator.errors[i]);
    EXPECT_LE(numerator.errors[i], 1e-9 * 1000.0);
  }
}

TEST(Jacobian, ARegularSolidIsValid) {
  Random random(3);
  for (const int degree : {1, 2, 3, 4}) {
    for (const bool rational : {false, true}) {
      const BezierTetrahedron solid = randomSimplex<4>(random, degree, false, 3, 0.15);
      std::vector<double> weights;
      for (int i = 0; rational && i < solid.size(); ++i)
        weights.push_back(random.uniform(0.9, 1.1));
      const auto certificate = certify(BezierTetrahedron(degree, solid.points(), weights));
      EXPECT_EQ(describe(certificate), "valid") << degree << rational;
    }
  }
}

TEST(Jacobian, AMirrorImageIsInvertedEverywhere) {
  Random random(4);
  const BezierTetrahedron solid =
      randomSimplex<4>(random, 3, false, 3, 0.15).relabelled({1, 0, 2, 3});
  const auto certificate = certify(solid);
  EXPECT_EQ(certificate.validity, Validity::kInverted);
  EXPECT_TRUE(certificate.mirrored);
  EXPECT_NE(describe(certificate).find("everywhere (a mirror image)"), std::string::npos);
}

TEST(Jacobian, AFoldHasAWitness) {
  for (const double push : {0.9, 1.5, 3.0}) {
    Random random(5);
    Eigen::MatrixXd points = randomSimplex<4>(random, 3, false, 3, 0.0).points();
    points.col(netIndex<4>({1, 1, 1, 0})) += Vector3(0.0, 0.0, push * 10.0);
    const BezierTetrahedron solid(3, points);
    const auto certificate = certify(solid);
    ASSERT_EQ(certificate.validity, Validity::kInverted) << push;
    EXPECT_FALSE(certificate.mirrored);
    EXPECT_LT(jacobian(solid, *certificate.witness), 0.0);
  }
}

/// A fold of the given depth about a point inside that no small lattice hits: x -> (x - 1/3)^3 like
/// behaviour, J = c + 3 (x - 1/3)^2 with c of either sign.
BezierTetrahedron nearFold(double c) {
  // f(x) = c x + ((x - 1/3)^3 + 1/27); blossom of the cubic along x
  const auto f = [&](double p, double q, double r) {
    const double e2 = (p * q + q * r + r * p) / 3.0;
    const double e1 = (p + q + r) / 3.0;
    return c * e1 + p * q * r - e2 + e1 / 3.0;
  };
  Eigen::MatrixXd points(3, netSize<4>(3));
  Eigen::Index position = 0;
  for (const MultiIndex<4>& i : multiIndices<4>(3)) {
    const int ones = i[1];
    points.col(position++) << f(ones > 0 ? 1 : 0, ones > 1 ? 1 : 0, ones > 2 ? 1 : 0), i[2] / 3.0,
        i[3] / 3.0;
  }
  return BezierTetrahedron(3, points);
}

TEST(Jacobian, SeesFoldsAndGapsThatSamplesMiss) {
  EXPECT_EQ(certify(nearFold(1e-3)).validity, Validity::kValid);
  const auto certificate = certify(nearFold(-1e-6));
  ASSERT_EQ(certificate.validity, Validity::kInverted);
  EXPECT_NEAR((*certificate.witness)[1], 1.0 / 3.0, 1e-3);
  // J touches 0 on a whole plane inside: no proof is possible, and none is claimed
  const auto touching = certify(nearFold(0.0));
  EXPECT_TRUE(touching.validity == Validity::kUndecided ||
              touching.validity == Validity::kSingular);
}

TEST(Jacobian, SingularCornersEdgesAndFacesAreNamed) {
  const BezierTetrahedron octant = ballOctant(10.0);
  EXPECT_EQ(describe(certify(octant)), "singular at corner 3");
  EXPECT_EQ(describe(certify(cone(2.0, 3.0))), "singular at edge 0-3, edge 1-3, edge 2-3");
  Eigen::MatrixXd points = Eigen::MatrixXd::Zero(3, 4);
  points.col(1) << 1, 0, 0;
  points.col(2) << 0, 1, 0;
  points.col(3) << 1, 1, 0;
  EXPECT_EQ(describe(certify(BezierTetrahedron(1, points))), "singular at every point");
}

// The thesis' own cone (2.3.2): weights 0 next to the apex. It is the cone, but J = 0 on the base.
TEST(Jacobian, TheThesisConeIsSingularOnItsWholeBase) {
  const BezierTetrahedron good = cone(1.0, 3.0);
  std::vector<double> weights = good.weights();
  for (const MultiIndex<4>& i : {MultiIndex<4>{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}})
    weights[static_cast<std::size_t>(netIndex<4>(i))] = 0.0;
  const BezierTetrahedron thesis(2, good.points(), weights);
  EXPECT_EQ(describe(certify(thesis)), "singular at edge 0-3, edge 1-3, edge 2-3, face 3");
}

TEST(Jacobian, BoundsContainItAndAreTight) {
  Random random(6);
  for (const bool rational : {false, true}) {
    const BezierTetrahedron solid = randomSolid(random, 3, rational, 3, 0.2);
    const JacobianBounds bounds = jacobianBounds(solid, 1e-3);
    EXPECT_TRUE(bounds.reached);
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const MultiIndex<4>& i : multiIndices<4>(40)) {
      const double j = jacobian(solid, Barycentric<4>(i[0], i[1], i[2], i[3]) / 40.0);
      low = std::min(low, j);
      high = std::max(high, j);
    }
    EXPECT_LE(bounds.low, low);
    EXPECT_GE(bounds.high, high);
    const double scale = std::max(std::abs(low), std::abs(high));
    EXPECT_NEAR(bounds.low, low, 3e-2 * scale);
    EXPECT_NEAR(bounds.high, high, 3e-2 * scale);
    const JacobianBounds finer = jacobianBounds(solid, 1e-4, 2000000);
    EXPECT_GE(finer.low, bounds.low);
    EXPECT_LE(finer.high, bounds.high);
  }
}

TEST(Jacobian, OfALinearMapIsConstant) {
  Eigen::MatrixXd points = Eigen::MatrixXd::Zero(3, 4);
  points.rightCols<3>() = 2.0 * Eigen::Matrix3d::Identity();
  const JacobianBounds bounds = jacobianBounds(BezierTetrahedron(1, points).elevated(2));
  EXPECT_NEAR(bounds.low, 8.0, 1e-10);
  EXPECT_NEAR(bounds.high, 8.0, 1e-10);
}

/// Degree and points of a peer's tetrahedron: node (xi, eta, zeta) belongs to (1-xi-eta-zeta, ..).
std::optional<BezierTetrahedron> solidFrom(const nlohmann::json& input) {
  if (!input.contains("bezier_points")) return {};
  const int degree = input.at("order");
  Eigen::MatrixXd points(3, netSize<4>(degree));
  for (const auto& [key, point] : input.at("bezier_points").items()) {
    int xi = 0;
    int eta = 0;
    int zeta = 0;
    if (std::sscanf(key.c_str(), "(%d, %d, %d)", &xi, &eta, &zeta) != 3) return {};
    points.col(netIndex<4>({degree - xi - eta - zeta, xi, eta, zeta})) << vectorFrom(point);
  }
  return BezierTetrahedron(degree, points);
}

TEST(Jacobian, AgreesWithPeersOnValidity) {
  FOR_PEER_CASES("tet_validity") {
    const auto solid = solidFrom(peer.input);
    if (!solid) continue;
    SCOPED_TRACE(peer.id);
    EXPECT_EQ(certify(*solid).validity == Validity::kValid, peer.expect.at("valid").get<bool>());
    for (const auto& [key, value] : peer.expect.at("qa_jac").items()) {
      double xi = 0;
      double eta = 0;
      double zeta = 0;
      ASSERT_EQ(std::sscanf(key.c_str(), "%lf,%lf,%lf", &xi, &eta, &zeta), 3);
      EXPECT_NEAR(jacobian(*solid, {1 - xi - eta - zeta, xi, eta, zeta}), value.get<double>(),
                  toleranceOf(peer, 10.0));
    }
  }
}

TEST(Jacobian, RefusesE4AndBadTolerances) {
  Random random(7);
  EXPECT_ERROR(certify(randomSolid(random, 2, false, 4)), "project it from E4 first");
  EXPECT_ERROR(jacobianBounds(randomSolid(random, 2, false), 0.0),
               "tolerance: must be finite and > 0");
}

}  // namespace
}  // namespace osculate::test
