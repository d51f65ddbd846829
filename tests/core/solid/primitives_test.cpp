#include "osculate/solid/primitives.h"

#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>

#include "osculate/solid/jacobian.h"
#include "osculate/solid/measure.h"
#include "osculate/solid/solid_contact.h"
#include "support/errors.h"
#include "support/simplex_samples.h"

namespace osculate::test {
namespace {

constexpr double kPi = std::numbers::pi;

template <class Check>
void forLattice(const BezierTriangle& surface, int m, Check check) {
  for (const MultiIndex<3>& i : multiIndices<3>(m)) {
    const SpacePoint p = surface.evaluate(Barycentric<3>(i[0], i[1], i[2]) / m);
    if (p.allFinite()) check(Vector3(p));
  }
}

double totalVolume(const std::vector<BezierTetrahedron>& solids) {
  double sum = 0.0;
  for (const BezierTetrahedron& solid : solids)
    sum += measure(solid).volume;
  return sum;
}

TEST(Primitives, TheConeIsACone) {
  for (const double height : {3.0, -3.0}) {
    const BezierTetrahedron solid = cone(2.0, height);
    EXPECT_EQ(solid.point({0, 0, 0, 2}), Vector3(0.0, 0.0, height));
    for (const double weight : solid.weights())
      EXPECT_GT(weight, 0.0);
    for (int side = 0; side < 3; ++side) {
      forLattice(face(solid, side), 12, [&](const Vector3& p) {
        EXPECT_NEAR(std::hypot(p.x(), p.y()), 2.0 * (1.0 - p.z() / height), 4e-15);
      });
    }
    forLattice(face(solid, 3), 12, [](const Vector3& p) {
      EXPECT_NEAR(p.z(), 0.0, 1e-15);
      EXPECT_LE(std::hypot(p.x(), p.y()), 2.0 + 1e-14);
    });
    EXPECT_NEAR(measure(solid).volume, kPi * 4.0, 1e-10);
  }
}

TEST(Primitives, TheEllipticConeIsAnAffineImage) {
  const Vector3 apex(1.0, -2.0, 5.0);
  const BezierTetrahedron solid = ellipticCone(3.0, 2.0, apex);
  for (int side = 0; side < 3; ++side) {
    forLattice(face(solid, side), 12, [&](const Vector3& p) {
      const double lambda = 1.0 - p.z() / 5.0;
      const Vector3 onBase = p - (1.0 - lambda) * apex;
      EXPECT_NEAR(std::hypot(onBase.x() / 3.0, onBase.y() / 2.0), lambda, 1e-14);
    });
  }
  EXPECT_NEAR(measure(solid).volume, kPi * 3.0 * 2.0 * 5.0 / 3.0, 1e-10);
  EXPECT_EQ(describe(certify(solid)), "singular at edge 0-3, edge 1-3, edge 2-3");
}

TEST(Primitives, TheOctantIsAnEighthOfTheBall) {
  const double radius = 7.0;
  const BezierTetrahedron solid = ballOctant(radius);
  forLattice(face(solid, 3), 20, [&](const Vector3& p) {
    EXPECT_NEAR(p.squaredNorm() / (radius * radius), 1.0, 1e-13);
    EXPECT_GE(p.minCoeff(), -1e-14);
  });
  for (int side = 0; side < 3; ++side)
    forLattice(face(solid, side), 12,
               [&](const Vector3& p) { EXPECT_NEAR(p.minCoeff(), 0.0, 1e-14); });
  const SolidMeasure found = measure(solid);
  EXPECT_NEAR(found.volume, kPi * radius * radius * radius / 6.0, 1e-10);
  EXPECT_LE(found.volumeError, 1e-9);
  EXPECT_LE((found.centroid - Vector3::Constant(3.0 * radius / 8.0)).norm(), 1e-10);
}

/// Random corners on the unit sphere, of both orientations.
struct Corners {
  Vector3 a, b, c;
};
Corners randomCorners(Random& random) {
  return {random.direction(), random.direction(), random.direction()};
}

double solidAngleOf(const Corners& t) {
  return 2.0 * std::abs(std::atan2(t.a.dot(t.b.cross(t.c)),
                                   1.0 + t.a.dot(t.b) + t.b.dot(t.c) + t.c.dot(t.a)));
}

TEST(Primitives, WedgesOverAnySphericalTriangleHaveTheirVolume) {
  Random random(1);
  const Vector3 centre(1.0, 2.0, 3.0);
  int split = 0;
  for (int i = 0; i < 40; ++i) {
    const Corners t = randomCorners(random);
    if (std::abs(t.a.dot(t.b.cross(t.c))) < 0.02) continue;
    const auto solids =
        sphereWedge(centre, centre + 2.0 * t.a, centre + 2.0 * t.b, centre + 2.0 * t.c);
    split += solids.size() > 1 ? 1 : 0;
    for (const BezierTetrahedron& solid : solids) {
      EXPECT_EQ(solid.point({0, 0, 0, 4}), centre);
      forLattice(face(solid, 3), 10, [&](const Vector3& p) {
        EXPECT_NEAR((p - centre).squaredNorm() / 4.0, 1.0, 1e-13);
      });
      EXPECT_EQ(describe(certify(solid)), "singular at corner 3");
    }
    EXPECT_NEAR(totalVolume(solids), 8.0 * solidAngleOf(t) / 3.0, 1e-10);
  }
  EXPECT_GT(split, 0);
}

TEST(Primitives, SidesOfWedgesArePlaneSectors) {
  Random random(2);
  const Corners t = randomCorners(random);
  for (const BezierTetrahedron& solid : sphereWedge(Vector3::Zero(), t.a, t.b, t.c)) {
    for (int side = 0; side < 3; ++side) {
      const BezierTriangle plane = face(solid, side);
      const Vector3 normal =
          Vector3(plane.point({4, 0, 0})).cross(Vector3(plane.point({0, 4, 0}))).normalized();
      forLattice(plane, 8, [&](const Vector3& p) { EXPECT_NEAR(normal.dot(p), 0.0, 1e-14); });
    }
  }
}

TEST(Primitives, PartsOfASplitWedgeMeet) {
  const Corners t{Vector3(1, 0.1, -0.3).normalized(), Vector3(-0.6, 0.8, -0.3).normalized(),
                  Vector3(-0.5, -0.85, -0.3).normalized()};
  const auto solids = sphereWedge(Vector3::Zero(), t.a, t.b, t.c);
  ASSERT_GT(solids.size(), 1U);
  EXPECT_GE(contact(solids[0], solids[1]).cartesian.order, -1);
  EXPECT_NEAR(totalVolume(solids), solidAngleOf(t) / 3.0, 1e-10);
}

TEST(Primitives, WedgesWithCircularEdgesLieOnTheSphereToo) {
  Random random(3);
  int made = 0;
  for (int i = 0; i < 20; ++i) {
    const Vector3 axis = random.direction();
    const auto near = [&] { return (axis + 0.6 * random.direction()).normalized(); };
    const Corners t{near(), near(), near()};
    if (std::abs(t.a.dot(t.b.cross(t.c))) < 0.02) continue;
    const BezierTetrahedron solid = sphereWedgeByCircles(Vector3::Zero(), t.a, t.b, t.c);
    ++made;
    EXPECT_EQ(solid.degree(), 2);
    forLattice(face(solid, 3), 10,
               [](const Vector3& p) { EXPECT_NEAR(p.squaredNorm(), 1.0, 1e-13); });
    EXPECT_EQ(describe(certify(solid)), "singular at corner 3");
  }
  EXPECT_GE(made, 10);
}

// The thesis' own wedge (2.3.3): middle points at 2R with weight 1/2. Off the sphere by up to
// 0.2945 R^2 for the octant.
TEST(Primitives, TheThesisWedgeIsNotOnTheSphere) {
  Eigen::MatrixXd points(3, 6);
  const double m = std::sqrt(2.0);
  points << 1, m, m, 0, 0, 0,  //
      0, m, 0, 1, m, 0,        //
      0, 0, m, 0, m, 1;
  const BezierTriangle thesis(2, points, {1, 0.5, 0.5, 1, 0.5, 1});
  double worst = 0.0;
  forLattice(thesis, 40,
             [&](const Vector3& p) { worst = std::max(worst, std::abs(p.squaredNorm() - 1.0)); });
  EXPECT_NEAR(worst, 0.2945, 1e-2);
}

TEST(Primitives, CylindersAndFrustumsAreRegularEverywhere) {
  for (const double angle : {0.3, 0.5 * kPi, 2.5, 2.0 * kPi}) {
    for (const auto& [lower, upper] :
         {std::pair{2.0, 2.0}, std::pair{3.0, 1.0}, std::pair{0.5, 4.0}}) {
      const auto solids = frustumWedge(lower, upper, 5.0, angle);
      for (const BezierTetrahedron& solid : solids) {
        EXPECT_EQ(solid.degree(), 3);
        EXPECT_EQ(describe(certify(solid)), "valid") << angle << " " << lower << " " << upper;
      }
      const double expected =
          angle / 2.0 * 5.0 * (lower * lower + lower * upper + upper * upper) / 3.0;
      EXPECT_NEAR(totalVolume(solids), expected, 1e-10);
    }
  }
}

TEST(Primitives, TheMantleOfAFrustumIsAConeExactly) {
  const auto solids = frustumWedge(3.0, 1.0, 5.0, 0.5 * kPi);
  ASSERT_EQ(solids.size(), 3U);
  const auto radiusAt = [](double z) { return 3.0 - 2.0 * z / 5.0; };
  // corners (axis, a, b, b'), (axis, a, b', a'): faces opposite to the axis
  for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
    forLattice(face(solids[i], 0), 12, [&](const Vector3& p) {
      EXPECT_NEAR(std::hypot(p.x(), p.y()), radiusAt(p.z()), 1e-14);
    });
  }
}

TEST(Primitives, SolidsOfAFrustumMeetInWholeFaces) {
  const auto solids = frustumWedge(3.0, 1.0, 5.0, kPi);
  ASSERT_EQ(solids.size(), 6U);
  for (std::size_t i = 0; i + 1 < 3; ++i) {
    EXPECT_TRUE(contact(solids[i], solids[i + 1]).meets) << i;
    EXPECT_EQ(contact(solids[i], solids[i + 1]).cartesian.order, 3) << "one map in parts";
  }
  // across the plane between two sectors: below with the middle one, above the last with itself
  EXPECT_TRUE(contact(solids[0], solids[4]).meets);
  EXPECT_TRUE(contact(solids[2], solids[5]).meets);
}

TEST(Primitives, RandomSolidsAreTheSameAgain) {
  for (const int dimension : {3, 4}) {
    for (const int degree : {1, 3, 12}) {
      const BezierTetrahedron solid = randomTetrahedron(degree, 5, dimension);
      EXPECT_EQ(solid, randomTetrahedron(degree, 5, dimension));
      EXPECT_NE(solid, randomTetrahedron(degree, 6, dimension));
      EXPECT_EQ(solid.dimension(), dimension);
    }
  }
  int valid = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed)
    valid += certify(randomTetrahedron(3, seed)).validity == Validity::kValid ? 1 : 0;
  EXPECT_GE(valid, 15);
}

using Json = nlohmann::json;

Json referenceSolids() {
  std::ifstream file(OSCULATE_SHARED_DIR "/oracle/solids.json");
  return file ? Json::parse(file) : Json();
}

double number(const Json& value) {
  return value.is_string() ? std::stod(value.get<std::string>()) : value.get<double>();
}
Vector3 vectorOf(const Json& value) {
  return {number(value[0]), number(value[1]), number(value[2])};
}

void expectNet(const BezierTriangle& found, const Json& net) {
  for (const Json& entry : net) {
    const MultiIndex<3> index = entry.at("ijk").get<MultiIndex<3>>();
    EXPECT_LE((Vector3(found.point(index)) - vectorOf(entry.at("point"))).norm(), 1e-13);
    EXPECT_NEAR(found.weight(index), number(entry.at("weight")), 1e-14);
  }
}

TEST(Primitives, NetsAreThoseOfTheReference) {
  const Json reference = referenceSolids();
  if (reference.is_null()) GTEST_SKIP() << "needs oracle/solids.json in ../shared";
  const Json& octant = reference.at("sphere_octant_quartic");
  expectNet(sphericalTriangle(Vector3::Zero(), vectorOf(octant.at("A")), vectorOf(octant.at("B")),
                              vectorOf(octant.at("C"))),
            octant.at("net"));
  for (const Json& entry : reference.at("sphere_triangles_quartic_great_circle_edges")) {
    const Vector3 a = vectorOf(entry.at("A"));
    const Vector3 b = vectorOf(entry.at("B"));
    const Vector3 c = vectorOf(entry.at("C"));
    expectNet(sphericalTriangle(Vector3::Zero(), a, b, c), entry.at("net"));
    EXPECT_NEAR(totalVolume(sphereWedge(Vector3::Zero(), a, b, c)),
                number(entry.at("wedge_volume")), 1e-12);
  }
  const Json& coneData = reference.at("cone_R1_h3_positive_weights");
  const BezierTetrahedron solid = cone(1.0, 3.0);
  for (const Json& entry : coneData.at("net")) {
    const MultiIndex<4> index = entry.at("ijkl").get<MultiIndex<4>>();
    EXPECT_LE((Vector3(solid.point(index)) - vectorOf(entry.at("point"))).norm(), 1e-15);
    EXPECT_EQ(solid.weight(index), number(entry.at("weight")));
  }
  EXPECT_NEAR(measure(solid).volume, number(coneData.at("volume")), 1e-10);
}

TEST(Primitives, RefuseBadArguments) {
  const Vector3 o = Vector3::Zero();
  const Vector3 x = Vector3::UnitX();
  const Vector3 y = Vector3::UnitY();
  EXPECT_ERROR(cone(0.0, 1.0), "radius: must be finite and > 0");
  EXPECT_ERROR(cone(1.0, 0.0), "height: must be finite and not 0");
  EXPECT_ERROR(ellipticCone(1.0, 1.0, x), "off the plane z = 0");
  EXPECT_ERROR(linearTetrahedron(o, x, y, x + y), "lie in one plane");
  EXPECT_ERROR(sphereWedge(o, x, y, 2.0 * Vector3::UnitZ()),
               "at the same distance from the centre");
  EXPECT_ERROR(sphereWedge(o, x, y, (x + y).normalized()), "one great circle");
  EXPECT_ERROR(sphereWedge(o, o, o, o), "must differ from the centre");
  EXPECT_ERROR(ballOctant(-1.0), "radius: must be finite and > 0");
  EXPECT_ERROR(frustumWedge(1.0, 0.0, 1.0, 1.0), "upper radius: must be finite and > 0");
  EXPECT_ERROR(frustumWedge(1.0, 1.0, 1.0, 7.0), "angle: must be at most 2 pi");
  EXPECT_ERROR(randomTetrahedron(0, 1), "degree: must be 1 to 12, got 0");
  EXPECT_ERROR(randomTetrahedron(2, 1, 5), "dimension: must be 3 or 4");
  EXPECT_ERROR(sphericalTriangleByCircles(o, x, y, Vector3::UnitZ(), x), "pole");
}

}  // namespace
}  // namespace osculate::test
