#include "osculate/construction/nu_spline.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <numbers>

#include "osculate/continuity/curve_joins.h"
#include "support/errors.h"
#include "support/random_curves.h"

namespace osculate {
namespace {

using namespace test;
using Kind = NuSplineEnd::Kind;

Poles randomPoints(Random& random, int count) {
  Poles points(3, count);
  for (int i = 0; i < count; ++i)
    points.col(i) = Vector3(2.0 * i, 0, 0) + random.vector(3.0);
  return points;
}

std::vector<double> randomParameters(Random& random, int count) {
  std::vector<double> parameters{random.uniform(-2, 2)};
  while (static_cast<int>(parameters.size()) < count)
    parameters.push_back(parameters.back() + random.uniform(0.3, 3));
  return parameters;
}

std::vector<double> randomTension(Random& random, int count) {
  std::vector<double> tension;
  for (int i = 0; i < count; ++i)
    tension.push_back(i % 3 == 1 ? 0.0 : random.uniform(0, 20));
  return tension;
}

/// The jump P''(t+) - P''(t-), over the closing of a periodic curve at its ends.
Vector3 jump(const BSplineCurve& curve, double t) {
  const bool closing = t == curve.first() || t == curve.last();
  const double before = closing ? curve.last() : t;
  const double behind = closing ? curve.first() : t;
  return curve.derivatives(behind, 2, Side::kRight)[2] -
         curve.derivatives(before, 2, Side::kLeft)[2];
}

double nuAt(const NuSplineOptions& options, std::size_t i, std::size_t count) {
  const auto& t = options.parameters;
  const double tension = options.tension.size() == 1 ? options.tension[0] : options.tension[i];
  double sum = 0.0;
  int steps = 0;
  const auto add = [&](std::size_t span) {
    sum += 1.0 / (t[span + 1] - t[span]);
    ++steps;
  };
  if (i > 0 || options.closed) add(i > 0 ? i - 1 : count - 1);
  if (i + 1 < count || options.closed) add(i);
  return tension * sum / steps;
}

void expectInterpolates(const BSplineCurve& curve, const Poles& points,
                        const std::vector<double>& parameters) {
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const double t = parameters[static_cast<std::size_t>(i)];
    EXPECT_LE((curve.evaluate(t) - points.col(i)).norm(), 1e-13 * (1.0 + points.col(i).norm()))
        << i;
  }
}

/// Interpolation, C1, and the jump of the second derivative at every knot inside.
void expectNuSpline(const BSplineCurve& curve, const Poles& points,
                    const NuSplineOptions& options) {
  expectInterpolates(curve, points, options.parameters);
  const auto count = static_cast<std::size_t>(points.cols());
  for (std::size_t i = options.closed ? 0 : 1; i + (options.closed ? 0 : 1) < count; ++i) {
    const double t = options.parameters[i];
    const auto derivatives = curve.derivatives(t, 2);
    const double nu = nuAt(options, i, count);
    const double scale = derivatives[2].norm() + nu * derivatives[1].norm();
    EXPECT_LE((jump(curve, t) - nu * derivatives[1]).norm(), 1e-10 * scale) << i;
  }
}

TEST(NuSpline, IsG2WithTheJumpOfItsTension) {
  Random random(300);
  for (const bool closed : {false, true}) {
    for (const int count : {3, 4, 5, 12}) {
      SCOPED_TRACE(testing::Message() << count << (closed ? " closed" : " open"));
      const Poles points = randomPoints(random, count);
      NuSplineOptions options{.tension = randomTension(random, count),
                              .parameters = randomParameters(random, count + (closed ? 1 : 0)),
                              .closed = closed};
      const BSplineCurve curve = nuSpline(points, options);
      EXPECT_EQ(curve.isPeriodic(), closed);
      EXPECT_EQ(curve.first(), options.parameters.front());
      EXPECT_DOUBLE_EQ(curve.last(), options.parameters.back());
      expectNuSpline(curve, points, options);
      for (const CurveJoin& join :
           analyzeInnerJoins(curve, {.order = 2, .tolerances = Tolerances::preset("exact")})) {
        EXPECT_EQ(join.report.order, 2);
      }
    }
  }
}

TEST(NuSpline, HasSimpleKnotsWithoutTensionAndDoubleOnesWithIt) {
  Random random(301);
  const Poles points = randomPoints(random, 6);
  NuSplineOptions options{.tension = {0, 1, 0, 0, 2, 0}};
  EXPECT_EQ(nuSpline(points, options).data().knots.multiplicities,
            (std::vector<int>{4, 2, 1, 1, 2, 4}));
  options.closed = true;
  EXPECT_EQ(nuSpline(points, options).data().knots.multiplicities,
            (std::vector<int>{1, 2, 1, 1, 2, 1, 1}));
  options.tension = {3, 1, 0, 0, 2, 0};
  EXPECT_EQ(nuSpline(points, options).data().knots.multiplicities,
            (std::vector<int>{2, 2, 1, 1, 2, 1, 2}));
}

/// The C2 cubic spline by its second derivatives M_i (de Boor, A Practical Guide to Splines, ch.
/// IV), densely: h_{i-1} M_{i-1} + 2 (h_{i-1} + h_i) M_i + h_i M_{i+1} = 6 (slope_i - slope_{i-1}).
Eigen::MatrixXd moments(const Poles& points, const std::vector<double>& t, bool closed) {
  const auto count = static_cast<std::size_t>(points.cols());
  const auto n = static_cast<Eigen::Index>(count);
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(n, n);
  Eigen::MatrixXd sides = Eigen::MatrixXd::Zero(n, 3);
  const auto slope = [&](std::size_t span) -> Vector3 {
    const auto next = static_cast<Eigen::Index>((span + 1) % count);
    return (points.col(next) - points.col(static_cast<Eigen::Index>(span))) /
           (t[span + 1] - t[span]);
  };
  for (std::size_t i = closed ? 0 : 1; i + (closed ? 0 : 1) < count; ++i) {
    const std::size_t before = (i + count - 1) % count;
    const double left = t[before + 1] - t[before];
    const double right = t[i + 1] - t[i];
    const auto row = static_cast<Eigen::Index>(i);
    matrix(row, row) = 2.0 * (left + right);
    matrix(row, static_cast<Eigen::Index>(before)) = left;
    matrix(row, static_cast<Eigen::Index>((i + 1) % count)) = right;
    sides.row(row) = 6.0 * (slope(i) - slope(before)).transpose();
  }
  return matrix.fullPivLu().solve(sides);
}

TEST(NuSpline, WithoutTensionIsTheC2CubicSpline) {
  Random random(302);
  for (const bool closed : {false, true}) {
    const Poles points = randomPoints(random, 9);
    NuSplineOptions options{.parameters = randomParameters(random, closed ? 10 : 9),
                            .closed = closed};
    const BSplineCurve curve = nuSpline(points, options);
    const Eigen::MatrixXd expected = moments(points, options.parameters, closed);
    for (Eigen::Index i = 0; i < 9; ++i) {
      const double t = options.parameters[static_cast<std::size_t>(i)];
      EXPECT_LE((curve.derivatives(t, 2)[2] - expected.row(i).transpose()).norm(), 1e-11) << i;
    }
    for (const BSplineCurve::InnerKnot& knot : curve.innerKnots())
      EXPECT_EQ(knot.multiplicity, 1);
  }
}

/// int |P''|^2 dt + sum nu_i |P'(t_i)|^2 of the cubic with these derivatives at the points; |P''|^2
/// is quadratic, so that two Gauss points are exact.
double energy(const Poles& points, const NuSplineOptions& options, const Poles& derivatives) {
  const auto count = static_cast<std::size_t>(points.cols());
  const auto& t = options.parameters;
  double sum = 0.0;
  for (std::size_t span = 0; span + 1 < t.size(); ++span) {
    const auto i = static_cast<Eigen::Index>(span);
    const auto j = static_cast<Eigen::Index>((span + 1) % count);
    const double h = t[span + 1] - t[span];
    for (const double x : {0.5 - 0.5 / std::sqrt(3.0), 0.5 + 0.5 / std::sqrt(3.0)}) {
      // second derivatives of the Hermite polynomials
      const Vector3 second =
          ((12 * x - 6) * (points.col(i) - points.col(j)) + h * (6 * x - 4) * derivatives.col(i) +
           h * (6 * x - 2) * derivatives.col(j)) /
          (h * h);
      sum += 0.5 * h * second.squaredNorm();
    }
  }
  for (std::size_t i = 0; i < count; ++i)
    sum += nuAt(options, i, count) * derivatives.col(static_cast<Eigen::Index>(i)).squaredNorm();
  return sum;
}

TEST(NuSpline, HasTheLeastEnergy) {
  Random random(303);
  for (const bool closed : {false, true}) {
    const Poles points = randomPoints(random, 7);
    NuSplineOptions options{.tension = randomTension(random, 7),
                            .parameters = randomParameters(random, closed ? 8 : 7),
                            .closed = closed};
    const BSplineCurve curve = nuSpline(points, options);
    Poles derivatives(3, 7);
    for (Eigen::Index i = 0; i < 7; ++i)
      derivatives.col(i) = curve.derivatives(options.parameters[static_cast<std::size_t>(i)], 1)[1];
    const double least = energy(points, options, derivatives);
    for (int trial = 0; trial < 200; ++trial) {
      Poles other = derivatives;
      other.col(random.integer(0, 6)) += std::pow(10.0, random.integer(-3, 0)) * random.direction();
      EXPECT_GT(energy(points, options, other), least);
    }
    // the least of a quadratic: its gradient vanishes
    for (Eigen::Index i = 0; i < derivatives.size(); ++i) {
      Poles ahead = derivatives;
      Poles behind = derivatives;
      ahead.data()[i] += 0.01;
      behind.data()[i] -= 0.01;
      EXPECT_NEAR(energy(points, options, ahead), energy(points, options, behind), 1e-11 * least);
    }
  }
}

/// The distance of the curve from its polygon, at its points that lie farthest.
double distanceFromPolygon(const BSplineCurve& curve, const Poles& points,
                           const std::vector<double>& t) {
  double largest = 0.0;
  for (std::size_t i = 0; i + 1 < t.size(); ++i) {
    const Vector3 from = points.col(static_cast<Eigen::Index>(i));
    const Vector3 leg = points.col(static_cast<Eigen::Index>(i) + 1) - from;
    for (int k = 1; k < 20; ++k) {
      const Vector3 p = curve.evaluate(std::lerp(t[i], t[i + 1], k / 20.0)) - from;
      const double along = std::clamp(p.dot(leg) / leg.squaredNorm(), 0.0, 1.0);
      largest = std::max(largest, (p - along * leg).norm());
    }
  }
  return largest;
}

TEST(NuSpline, TendsToThePolygonAsTheTensionGrows) {
  Random random(304);
  const Poles points = randomPoints(random, 8);
  NuSplineOptions options{.parameters = randomParameters(random, 8)};
  double before = std::numeric_limits<double>::infinity();
  for (const double tension : {0.0, 10.0, 1e3, 1e5, 1e7}) {
    options.tension = {tension};
    const double distance =
        distanceFromPolygon(nuSpline(points, options), points, options.parameters);
    EXPECT_LT(distance, before);
    // as 1 / tension
    if (tension > 1e4) {
      EXPECT_NEAR(distance / before, 0.01, 2e-3);
    }
    before = distance;
  }
  EXPECT_LT(before, 1e-5);
}

TEST(NuSpline, OfOneTensePointLeavesTheFarOnes) {
  Random random(305);
  const Poles points = randomPoints(random, 40);
  const NuSplineOptions loose{.parameters = randomParameters(random, 40)};
  NuSplineOptions tense = loose;
  tense.tension.assign(40, 0.0);
  tense.tension[20] = 100.0;
  const BSplineCurve first = nuSpline(points, loose);
  const BSplineCurve second = nuSpline(points, tense);
  const auto difference = [&](double t) { return (first.evaluate(t) - second.evaluate(t)).norm(); };
  EXPECT_GT(difference(loose.parameters[20] + 0.15), 1e-2);
  EXPECT_LT(difference(loose.parameters[2] + 0.1), 1e-7);
  EXPECT_LT(second.derivatives(loose.parameters[20], 1)[1].norm(),
            0.3 * first.derivatives(loose.parameters[20], 1)[1].norm());
}

TEST(NuSpline, ReproducesWhatItsEndsDetermine) {
  const std::vector<double> t{0, 0.4, 1, 1.7, 2};
  const auto parabola = [](double x) { return Vector3(x, 1 - x * x, 3 * x + x * x); };
  const auto cubic = [](double x) { return Vector3(x * x * x, x - x * x, 2 * x); };
  Poles onParabola(3, 5);
  Poles onCubic(3, 5);
  for (Eigen::Index i = 0; i < 5; ++i) {
    onParabola.col(i) = parabola(t[static_cast<std::size_t>(i)]);
    onCubic.col(i) = cubic(t[static_cast<std::size_t>(i)]);
  }
  NuSplineOptions options{.parameters = t};
  options.ends[0].kind = options.ends[1].kind = Kind::kBessel;
  const BSplineCurve first = nuSpline(onParabola, options);
  // tangents are multiples of the speed of the end chord
  const double startSpeed = (onCubic.col(1) - onCubic.col(0)).norm() / 0.4;
  const double endSpeed = (onCubic.col(4) - onCubic.col(3)).norm() / (2.0 - 1.7);
  options.ends[0] = {Kind::kTangent, Vector3(0, 1, 2) / startSpeed};
  options.ends[1] = {Kind::kTangent, Vector3(12, -3, 2) / endSpeed};
  const BSplineCurve second = nuSpline(onCubic, options);
  for (int i = 0; i <= 20; ++i) {
    EXPECT_LE((first.evaluate(0.1 * i) - parabola(0.1 * i)).norm(), 1e-14) << i;
    EXPECT_LE((second.evaluate(0.1 * i) - cubic(0.1 * i)).norm(), 1e-14) << i;
  }
}

TEST(NuSpline, HasTheEndsAskedFor) {
  Random random(306);
  const Poles points = randomPoints(random, 6);
  NuSplineOptions options{.tension = {7}, .parameters = randomParameters(random, 6)};
  options.ends[1] = {Kind::kTangent, Vector3(0, 0, 0.5)};
  const BSplineCurve curve = nuSpline(points, options);
  expectNuSpline(curve, points, options);
  const auto start = curve.derivatives(curve.first(), 2);
  EXPECT_LE((start[2] - nuAt(options, 0, 6) * start[1]).norm(), 1e-10 * start[2].norm());
  const double h = options.parameters[5] - options.parameters[4];
  const double speed = (points.col(5) - points.col(4)).norm() / h;
  EXPECT_LE((curve.derivatives(curve.last(), 1)[1] - Vector3(0, 0, 0.5 * speed)).norm(), 1e-12);
}

TEST(NuSpline, OfTwoPointsIsTheSegmentOrAHermiteCubic) {
  Poles points(3, 2);
  points << 0, 3, 0, 4, 0, 0;
  for (const Kind kind : {Kind::kNatural, Kind::kBessel}) {
    NuSplineOptions options{.tension = {5}};
    options.ends[0].kind = options.ends[1].kind = kind;
    if (kind == Kind::kNatural) options.tension = {0};
    const BSplineCurve curve = nuSpline(points, options);
    EXPECT_EQ(curve.last(), 5.0);
    EXPECT_LE((curve.evaluate(2.0) - Vector3(1.2, 1.6, 0)).norm(), 1e-14);
  }
  NuSplineOptions options;
  options.ends[0] = {Kind::kTangent, Vector3(1, 0, 0)};
  options.ends[1] = {Kind::kTangent, Vector3(0, 0, 2)};
  const BSplineCurve curve = nuSpline(points, options);
  EXPECT_LE((curve.derivatives(0, 1)[1] - Vector3(1, 0, 0)).norm(), 1e-14);
  EXPECT_LE((curve.derivatives(5, 1)[1] - Vector3(0, 0, 2)).norm(), 1e-14);
}

TEST(NuSpline, ChoosesParametersBySpacing) {
  Poles points(3, 4);
  points << 0, 4, 4, 5, 0, 0, 9, 9, 0, 0, 0, 0;  // steps 4, 9, 1
  const auto knots = [&](Spacing spacing, bool closed) {
    return nuSpline(points, {.spacing = spacing, .closed = closed}).data().knots.knots;
  };
  EXPECT_EQ(knots(Spacing::kChordal, false), (std::vector<double>{0, 4, 13, 14}));
  const std::vector<double> centripetal = knots(Spacing::kCentripetal, false);
  const double roots[] = {0, 2, 5, 6};  // sums of 2, 3, 1
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(centripetal[i], 14.0 / 6.0 * roots[i], 1e-14);
  EXPECT_NEAR(knots(Spacing::kUniform, false)[1], 14.0 / 3.0, 1e-14);
  EXPECT_NEAR(knots(Spacing::kChordal, true)[4], 14.0 + std::sqrt(25.0 + 81.0), 1e-13);
}

TEST(NuSpline, FollowsScalingReversalAndRigidMotion) {
  Random random(307);
  for (const Spacing spacing : {Spacing::kUniform, Spacing::kCentripetal, Spacing::kChordal}) {
    const Poles points = randomPoints(random, 7);
    NuSplineOptions options{.tension = randomTension(random, 7), .spacing = spacing};
    const BSplineCurve curve = nuSpline(points, options);
    Eigen::Affine3d map(Eigen::AngleAxisd(1.1, random.direction()));
    map = Eigen::Translation3d(random.vector(10)) * map * Eigen::Scaling(1000.0);
    const BSplineCurve moved = nuSpline(map * points, options);
    EXPECT_NEAR(moved.last(), 1000.0 * curve.last(), 1e-9);
    const BSplineCurve expected = curve.transformed(map);
    EXPECT_LE((moved.data().poles - expected.data().poles).colwise().norm().maxCoeff(), 1e-9);

    const Poles backwards = points.rowwise().reverse();
    std::reverse(options.tension.begin(), options.tension.end());
    const BSplineCurve reversed = nuSpline(backwards, options).reversed();
    EXPECT_LE((reversed.data().poles - curve.data().poles).colwise().norm().maxCoeff(), 1e-12);
  }
}

TEST(NuSpline, DoesNotDependOnTheScaleOfParameters) {
  Random random(308);
  const Poles points = randomPoints(random, 7);
  NuSplineOptions options{.tension = randomTension(random, 7),
                          .parameters = randomParameters(random, 7)};
  const BSplineCurve curve = nuSpline(points, options);
  for (double& parameter : options.parameters)
    parameter = 5.0 + 1e-3 * parameter;
  const BSplineCurve scaled = nuSpline(points, options);
  EXPECT_LE((scaled.data().poles - curve.data().poles).colwise().norm().maxCoeff(), 1e-9);
}

TEST(NuSpline, ThroughACircleHasItsSymmetry) {
  Poles points(3, 6);
  for (Eigen::Index i = 0; i < 6; ++i) {
    const double angle = static_cast<double>(i) * std::numbers::pi / 3.0;
    points.col(i) = Vector3(std::cos(angle), std::sin(angle), 0);
  }
  for (const double tension : {0.0, 3.0}) {
    const BSplineCurve curve = nuSpline(points, {.tension = {tension}, .closed = true});
    for (int i = 0; i < 6; ++i) {
      const auto derivatives = curve.derivatives(curve.last() * i / 6.0, 1);
      EXPECT_NEAR(derivatives[0].dot(derivatives[1]), 0.0, 1e-14);
      const double middle = curve.evaluate(curve.last() * (i + 0.5) / 6.0).norm();
      EXPECT_NEAR(middle, curve.evaluate(curve.last() / 12.0).norm(), 1e-14);
    }
  }
}

TEST(NuSpline, OfAHundredThousandPointsIsLinearInCost) {
  Random random(309);
  for (const bool closed : {false, true}) {
    const Poles points = randomPoints(random, 100000);
    const BSplineCurve curve = nuSpline(points, {.tension = {1}, .closed = closed});
    const std::vector<double>& knots = curve.data().knots.knots;
    for (const Eigen::Index i : {1, 777, 50000, 99998}) {
      const double t = knots[static_cast<std::size_t>(i)];
      EXPECT_LE((curve.evaluate(t) - points.col(i)).norm(), 1e-9) << i;
    }
  }
}

TEST(NuSpline, TakesEqualNeighboursWhereParametersAreGiven) {
  Poles points(3, 4);
  points << 0, 1, 1, 2, 0, 1, 1, 0, 0, 0, 0, 0;
  EXPECT_ERROR(nuSpline(points),
               "points: points[1] and points[2] are one point, and no parameters");
  const BSplineCurve curve = nuSpline(points, {.parameters = {0, 1, 2, 3}});
  expectInterpolates(curve, points, {0, 1, 2, 3});
}

TEST(NuSpline, NamesBadArguments) {
  Random random(310);
  const Poles points = randomPoints(random, 4);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_ERROR(nuSpline(points.leftCols(1)), "points: at least 2 are needed, got 1");
  EXPECT_ERROR(nuSpline(points.leftCols(2), {.closed = true}),
               "points: at least 3 are needed for a closed curve, got 2");
  Poles bad = points;
  bad(1, 2) = nan;
  EXPECT_ERROR(nuSpline(bad), "points: every coordinate must be finite");
  EXPECT_ERROR(nuSpline(Poles::Ones(3, 4)), "points: all are one point");
  bad = points;
  bad.col(3) = bad.col(0);
  EXPECT_ERROR(nuSpline(bad, {.closed = true}), "points[3] and points[0] are one point; a closed");
  bad = points;
  bad.col(2).x() = 0.0;
  bad.col(3) = bad.col(2) + Vector3(1e-60, 0, 0);
  EXPECT_ERROR(nuSpline(bad), "are too near for parameters that differ");
  for (const double tension : {-1.0, nan, std::numeric_limits<double>::infinity()})
    EXPECT_ERROR(nuSpline(points, {.tension = {tension}}), "tension: must be finite and >= 0");
  EXPECT_ERROR(nuSpline(points, {.tension = {1, 2}}),
               "tension: one number, or one for each of the 4 points, is needed, got 2");
  EXPECT_ERROR(nuSpline(points, {.parameters = {0, 1, 2}}),
               "parameters: 4 are needed, one for each point, got 3");
  EXPECT_ERROR(nuSpline(points, {.parameters = {0, 1, 2, 3}, .closed = true}),
               "parameters: 5 are needed, one for each point and the end of the period, got 4");
  EXPECT_ERROR(nuSpline(points, {.parameters = {0, 1, 1, 3}}),
               "parameters: must be finite and increase, but number 2 is 1.0");
  NuSplineOptions options;
  options.ends[0] = {Kind::kTangent, Vector3::Zero()};
  EXPECT_ERROR(nuSpline(points, options), "ends: a tangent must be finite and not zero");
}

}  // namespace
}  // namespace osculate
