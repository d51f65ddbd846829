// The stated uncertainty of a residual: a true bound of what double coordinates carry, and what
// turns a verdict into "undecided".
#include "osculate/continuity/curve_joins.h"
#include "support/exact_spline.h"
#include "support/joins.h"
#include "support/perturbation.h"
#include "support/spline_samples.h"

namespace osculate::test {
namespace {

/// The largest change of each residual over some perturbed joins, exactly computed, beside its
/// bound.
void collect(const BezierCurve& first, const BezierCurve& second, double poleError, Random& random,
             int order, std::vector<BoundStatistics>& statistics) {
  JoinSide before = arriving(first);
  JoinSide after = leaving(second);
  before.poleError = after.poleError = poleError;
  const JoinReport report = analyzeJoin(before, after, withPreset("exact", order));
  std::vector<double> largest(static_cast<std::size_t>(order) + 1, 0.0);
  for (int round = 0; round < 6; ++round) {
    const auto moved =
        residuals(arrivingDerivatives(perturbed(first, random, poleError), order),
                  leavingDerivatives(perturbed(second, random, poleError), order), report.scaleMm);
    for (std::size_t k = 0; k < largest.size(); ++k) {
      largest[k] = std::max(largest[k], std::abs(moved[k] - report.residuals[k]));
    }
  }
  for (std::size_t k = 0; k < largest.size(); ++k) {
    if (std::isfinite(report.uncertainties[k]))
      statistics[k].add(report.uncertainties[k], largest[k]);
  }
}

/// `loosest`: the bound over the largest change found, in the median up to order 4.
void expectHonest(const std::vector<BoundStatistics>& statistics, double loosest = 1e4) {
  for (std::size_t k = 0; k < statistics.size(); ++k) {
    EXPECT_GE(statistics[k].smallest(), 1.0) << "order " << k << ": not a bound";
    EXPECT_LE(statistics[k].median(), k <= 4 ? loosest : 10.0 * loosest)
        << "order " << k << ": a bound this loose says nothing";
  }
}

TEST(Uncertainty, BoundsWhatHalfAUnitInTheLastPlaceOfEveryPoleDoesToTheResiduals) {
  Random random(240);
  std::vector<BoundStatistics> statistics(9);
  for (int round = 0; round < 120; ++round) {
    const auto [first, second] = randomJoin(random, round % 8 - 1, 5 + round % 4);
    collect(first, second, 0.0, random, kMaxOrder, statistics);
  }
  expectHonest(statistics);
}

TEST(Uncertainty, HoldsForRationalCurvesOfUnrelatedShape) {
  Random random(241);
  std::vector<BoundStatistics> statistics(9);
  for (int round = 0; round < 60; ++round) {
    const BezierCurve first = randomBezier(random, 1 + round % 9, true);
    const BezierCurve second = randomBezier(random, 1 + round % 7, round % 2 == 0);
    collect(first, second, 0.0, random, kMaxOrder, statistics);
  }
  expectHonest(statistics);
}

TEST(Uncertainty, HoldsForRationalCurvesThatJoin) {
  Random random(242);
  std::vector<BoundStatistics> statistics(5);
  for (int round = 0; round < 60; ++round) {
    const auto [first, second] =
        randomBezier(random, 2 + round % 5, true).split(random.uniform(0.3, 0.7));
    collect(first, moebius(second, random.uniform(0.3, 3.0)), 0.0, random, 4, statistics);
  }
  expectHonest(statistics);
}

TEST(Uncertainty, HoldsFarFromTheOriginAndForTinyAndHugeCurves) {
  Random random(243);
  std::vector<BoundStatistics> statistics(5);
  for (int round = 0; round < 60; ++round) {
    const auto [first, second] = randomJoin(random, round % 4, 5);
    const double scale = std::pow(10.0, random.uniform(-4.0, 4.0));
    const Eigen::Affine3d map =
        Eigen::Translation3d(random.vector(1e5 * scale)) * Eigen::Scaling(scale);
    collect(first.transformed(map), second.transformed(map), 0.0, random, 4, statistics);
  }
  expectHonest(statistics);
}

TEST(Uncertainty, HoldsForAStatedErrorOfThePoles) {
  Random random(244);
  std::vector<BoundStatistics> statistics(5);
  for (int round = 0; round < 60; ++round) {
    const auto [first, second] = randomJoin(random, round % 5 - 1, 5);
    collect(first, second, std::pow(10.0, random.uniform(-10.0, -5.0)), random, 4, statistics);
  }
  expectHonest(statistics);
}

/// The homogeneous poles off by half a unit in the last place of poles and weights.
ExactSpline<Real> perturbedSpline(const BSplineData& data, Random& random) {
  ExactSpline<Real> spline = exactSpline<Real>(data);
  for (Eigen::Index i = 0; i < data.poles.cols(); ++i) {
    Homogeneous<Real>& point = spline.net[static_cast<std::size_t>(i)];
    Point<Real> pole = point.head<3>() / point[3];
    for (int axis = 0; axis < 3; ++axis) {
      const double half = halfUnit(data.poles(axis, i));
      pole[axis] += Real(random.coin() ? half : -half);
    }
    Real weight = point[3];
    if (!data.weights.empty()) {
      const double half = halfUnit(data.weights[static_cast<std::size_t>(i)]);
      weight += Real(random.coin() ? half : -half);
    }
    point << Point<Real>(weight * pole), weight;
  }
  return spline;
}

/// A line against the start of unclamped B-splines whose weights are within exp(-spread) and
/// exp(spread).
std::vector<BoundStatistics> ofEndSegments(double spread, Random& random) {
  std::vector<BoundStatistics> statistics(5);
  for (int round = 0; round < 40; ++round) {
    const int degree = 2 + round % 5;
    BSplineData data = randomSplineData(random, degree, unclampedKnots(degree), spread > 0.0);
    for (double& weight : data.weights)
      weight = std::exp(random.uniform(-spread, spread));
    const BSplineCurve curve(data);
    const Vector3& start = curve.endPoint(CurveEnd::kStart);
    const BezierCurve line = bezier({start - Vector3(5, 1, 0), start});
    const JoinReport report =
        analyzeCurves(BSplineCurve(line), curve, withPreset("exact"), JoinEnds{}).report;
    std::vector<double> largest(5, 0.0);
    for (int turn = 0; turn < 4; ++turn) {
      const PointSeries moved = taylor(perturbedSpline(data, random), Real(curve.first()), 4);
      const auto found = residuals(arrivingDerivatives(exact<Real>(line), 4), arcDerivatives(moved),
                                   report.scaleMm);
      for (std::size_t k = 0; k <= 4; ++k)
        largest[k] = std::max(largest[k], std::abs(found[k] - report.residuals[k]));
    }
    for (std::size_t k = 0; k <= 4; ++k)
      statistics[k].add(report.uncertainties[k], largest[k]);
  }
  return statistics;
}

TEST(Uncertainty, HoldsForEndSegmentsOfUnclampedBSplines) {
  Random random(249);
  // extraction moves neighbouring poles together; the bound takes their roundings for independent
  expectHonest(ofEndSegments(0.0, random), 1e6);
  expectHonest(ofEndSegments(0.5, random), 1e6);
}

TEST(Uncertainty, IsABoundForWeightsOfVeryDifferentSizeToo) {
  Random random(250);
  for (const BoundStatistics& order : ofEndSegments(5.0, random))
    EXPECT_GE(order.smallest(), 1.0);
}

TEST(Uncertainty, HoldsForHighDegrees) {
  Random random(245);
  std::vector<BoundStatistics> statistics(5);
  for (int round = 0; round < 20; ++round) {
    collect(randomBezier(random, kMaxDegree, round % 2 == 0), randomBezier(random, 15, false), 0.0,
            random, 4, statistics);
  }
  expectHonest(statistics);
}

TEST(Uncertainty, HoldsForAnglesNearZeroNinetyAndStraight) {
  Random random(246);
  std::vector<BoundStatistics> statistics(2);
  for (const double degrees : {0.0, 1e-7, 1e-4, 0.1, 45.0, 90.0, 179.9, 179.9999999, 180.0}) {
    const double angle = degrees * std::numbers::pi / 180.0;
    const Vector3 corner = random.vector(10.0);
    const BezierCurve first = bezier({corner - Vector3(3, 0, 0), corner});
    const BezierCurve second =
        bezier({corner, corner + 2.0 * Vector3(std::cos(angle), std::sin(angle), 0)});
    collect(first, second, 0.0, random, 1, statistics);
    collect(first, second, 1e-6, random, 1, statistics);
  }
  expectHonest(statistics);
}

TEST(Uncertainty, TurnsTheVerdictExactlyWhereTheToleranceLiesWithinIt) {
  Random random(247);
  int undecided = 0;
  for (int round = 0; round < 200; ++round) {
    const auto [first, second] = randomJoin(random, round % 5 - 1, 5);
    JoinSide before = arriving(first);
    JoinSide after = leaving(second);
    before.poleError = after.poleError = std::pow(10.0, random.uniform(-12.0, -1.0));
    const JoinReport report = analyzeJoin(before, after, AnalysisOptions{});
    for (std::size_t k = 0; k <= 4; ++k) {
      const double low = report.residuals[k] - report.uncertainties[k];
      const double high = report.residuals[k] + report.uncertainties[k];
      const Verdict expected = high <= report.tolerances[k] ? Verdict::kPass
                               : low > report.tolerances[k] ? Verdict::kFail
                                                            : Verdict::kUndecided;
      EXPECT_EQ(report.verdicts[k], expected) << "order " << k;
      undecided += expected == Verdict::kUndecided ? 1 : 0;
    }
    const bool any = std::find(report.verdicts.begin(), report.verdicts.end(),
                               Verdict::kUndecided) != report.verdicts.end();
    EXPECT_EQ(report.warnings.has(Warning::kUndecided), any);
  }
  EXPECT_GT(undecided, 20) << "the test must meet the case";
}

TEST(Uncertainty, AnUndecidedOrderEndsTheOrderThatIsReached) {
  Random random(248);
  const auto [first, second] = randomJoin(random, 4, 5);
  JoinSide before = arriving(first);
  before.poleError = 1e-10;
  const JoinReport report = analyzeJoin(before, leaving(second), withPreset("exact"));
  int reached = -1;
  while (reached < 4 && report.verdicts[static_cast<std::size_t>(reached) + 1] == Verdict::kPass)
    ++reached;
  EXPECT_LT(reached, 4);
  EXPECT_EQ(report.order, reached);
  EXPECT_EQ(report.verdicts[static_cast<std::size_t>(reached) + 1], Verdict::kUndecided);
}

TEST(Uncertainty, IsBoundlessWhereTheFirstDerivativeIsHardlyToBeToldFromZero) {
  const BezierCurve first = bezier({{-1, 0, 0}, {0, 0, 0}});
  const BezierCurve second = bezier({{0, 0, 0}, {1e-3, 0, 0}, {1, 1, 0}, {2, 0, 0}});
  JoinSide after = leaving(second);
  after.poleError = 1e-4;
  const JoinReport report = analyzeJoin(arriving(first), after, AnalysisOptions{});
  for (std::size_t k = 1; k <= 4; ++k)
    EXPECT_EQ(report.verdicts[k], Verdict::kUndecided) << "order " << k;
}

}  // namespace
}  // namespace osculate::test
