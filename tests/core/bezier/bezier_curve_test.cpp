#include "osculate/bezier/bezier_curve.h"

#include <limits>
#include <thread>

#include "support/errors.h"
#include "support/exact.h"
#include "support/random_curves.h"

namespace osculate::test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Rounding of de Casteljau inside [0, 1]: each of n steps of convex combinations rounds by a few
/// units; for rational curves the weights' ratio (4 here) multiplies it.
double evaluationBound(const BezierCurve& curve) {
  return 8.0 * (curve.degree() + 1) * kUnitRoundoff * size(curve) *
         (curve.isRational() ? 4.0 : 1.0);
}

/// Low degrees, the highest and some between, polynomial and rational.
template <class Check>
void forDegrees(std::uint64_t seed, Check check) {
  Random random(seed);
  for (const int degree : {1, 2, 3, 4, 5, 7, 10, 16, kMaxDegree}) {
    for (const bool rational : {false, true}) {
      SCOPED_TRACE("degree " + std::to_string(degree) + (rational ? " rational" : " polynomial"));
      check(random, randomBezier(random, degree, rational));
    }
  }
}

TEST(BezierCurve, EvaluatesAsExactArithmeticDoes) {
  forDegrees(10, [](Random& random, const BezierCurve& curve) {
    for (const double t : {0.0, 1.0, 1.0 / 3.0, random.uniform(0.0, 1.0)}) {
      EXPECT_LE(distance(evaluate(exact<Rational>(curve), Rational(t)), curve.evaluate(t)),
                evaluationBound(curve));
    }
  });
}

TEST(BezierCurve, EvaluatesOutsideItsIntervalToo) {
  forDegrees(11, [](Random&, const BezierCurve& curve) {
    if (curve.degree() > 8) return;
    for (const double t : {-0.25, 1.125}) {
      const Point<Rational> expected = evaluate(exact<Rational>(curve), Rational(t));
      // the combinations are no longer convex: |1-t| + |t| <= 1.5 a step
      const double growth = std::pow(1.5, curve.degree());
      EXPECT_LE(distance(expected, curve.evaluate(t)), growth * growth * evaluationBound(curve));
    }
  });
}

TEST(BezierCurve, DerivativesAreThoseOfExactArithmeticBeyondTheDegreeToo) {
  forDegrees(12, [](Random& random, const BezierCurve& curve) {
    const double t = random.uniform(0.0, 1.0);
    const int count = std::min(curve.degree(), 6) + 2;
    const std::vector<Vector3> found = curve.derivatives(t, count);
    const auto expected = taylor(exact<Rational>(curve), Rational(t), count);
    ASSERT_EQ(found.size(), static_cast<std::size_t>(count) + 1);
    double amplification = 1.0;  // 2n for each derivative; rational ones add those of the weight
    for (int k = 0; k <= count; ++k) {
      const auto i = static_cast<std::size_t>(k);
      EXPECT_LE(distance(Point<Rational>(factorial<Rational>(k) * expected[i]), found[i]),
                amplification * evaluationBound(curve))
          << "derivative " << k;
      amplification *= 2.0 * curve.degree() * (curve.isRational() ? 4.0 : 1.0);
    }
  });
}

TEST(BezierCurve, DerivativesOfAPolynomialAboveItsDegreeAreZero) {
  const BezierCurve line(std::vector<Vector3>{{0, 0, 0}, {1, 2, 3}});
  EXPECT_EQ(line.derivatives(0.25, 3),
            (std::vector<Vector3>{{0.25, 0.5, 0.75}, {1, 2, 3}, {0, 0, 0}, {0, 0, 0}}));
}

/// b*_i = sum_j C(n,j) C(r,i-j) / C(n+r,i) b_j, the closed form of raising the degree by r at once.
template <class S>
std::vector<Homogeneous<S>> elevatedNet(const ExactBezier<S>& curve, int times) {
  const int n = curve.degree();
  std::vector<Homogeneous<S>> net;
  for (int i = 0; i <= n + times; ++i) {
    Homogeneous<S> sum = Homogeneous<S>::Constant(S(0));
    for (int j = std::max(0, i - times); j <= std::min(n, i); ++j) {
      sum += S(choose<S>(n, j) * choose<S>(times, i - j) / choose<S>(n + times, i)) * curve.net(j);
    }
    net.push_back(sum);
  }
  return net;
}

TEST(BezierCurve, ElevationGivesTheExactPolesAndWeights) {
  forDegrees(13, [](Random&, const BezierCurve& curve) {
    for (const int times : {0, 1, 3, kMaxDegree - curve.degree()}) {
      if (curve.degree() + times > kMaxDegree) continue;
      const BezierCurve raised = curve.elevated(times);
      const auto expected = elevatedNet(exact<Rational>(curve), times);
      ASSERT_EQ(raised.degree(), curve.degree() + times);
      ASSERT_EQ(raised.isRational(), curve.isRational());
      for (int i = 0; i <= raised.degree(); ++i) {
        const auto& point = expected[static_cast<std::size_t>(i)];
        EXPECT_LE(distance(Point<Rational>(point.head<3>() / point[3]), raised.pole(i)),
                  8.0 * (times + 1) * kUnitRoundoff * size(curve) * 4.0);
        EXPECT_NEAR(raised.weight(i), toDouble(point[3]), 8.0 * (times + 1) * kUnitRoundoff * 4.0);
      }
    }
  });
}

TEST(BezierCurve, SplitGivesTheExactPolesOfBothParts) {
  forDegrees(14, [](Random& random, const BezierCurve& curve) {
    const double t = random.uniform(0.0, 1.0);
    const auto [left, right] = curve.split(t);
    const ExactBezier<Rational> whole = exact<Rational>(curve);
    for (int i = 0; i <= curve.degree(); ++i) {
      // left: the curve of the first i+1 poles at t; right: that of the poles from i on
      ExactBezier<Rational> first = whole;
      first.poles.resize(static_cast<std::size_t>(i) + 1);
      first.weights.resize(first.poles.size());
      EXPECT_LE(distance(evaluate(first, Rational(t)), left.pole(i)), evaluationBound(curve));
      ExactBezier<Rational> last = whole;
      last.poles.erase(last.poles.begin(), last.poles.begin() + i);
      last.weights.erase(last.weights.begin(), last.weights.begin() + i);
      EXPECT_LE(distance(evaluate(last, Rational(t)), right.pole(i)), evaluationBound(curve));
    }
    EXPECT_EQ(left.pole(curve.degree()), right.pole(0)) << "the parts must meet without a gap";
  });
}

TEST(BezierCurve, SegmentIsTheSameTraceOverItsPart) {
  forDegrees(15, [](Random& random, const BezierCurve& curve) {
    const double a = random.uniform(0.0, 0.7);
    const double b = random.uniform(a + 0.1, 1.0);
    const auto part = exact<Rational>(curve.segment(a, b));
    const auto back = exact<Rational>(curve.segment(b, a));
    const auto whole = exact<Rational>(curve);
    for (const char* text : {"0", "1/7", "1/2", "9/10", "1"}) {
      const Rational s(text);
      const Rational t = Rational(a) + (Rational(b) - Rational(a)) * s;
      const Vector3 expected = toDouble(evaluate(whole, t));
      EXPECT_LE(distance(evaluate(part, s), expected), 3.0 * evaluationBound(curve));
      EXPECT_LE(distance(evaluate(back, Rational(1 - s)), expected), 3.0 * evaluationBound(curve));
    }
  });
}

TEST(BezierCurve, SegmentMayReachBeyondTheCurve) {
  const BezierCurve parabola(std::vector<Vector3>{{0, 0, 0}, {1, 0, 0}, {2, 2, 0}});  // (2t, 2t^2)
  const BezierCurve part = parabola.segment(-1.0, 2.0);
  EXPECT_EQ(polesOf(part), (std::vector<Vector3>{{-2, 2, 0}, {1, -4, 0}, {4, 8, 0}}));
}

TEST(BezierCurve, ReversalExchangesPolesAndWeightsWithoutRounding) {
  forDegrees(16, [](Random&, const BezierCurve& curve) {
    const BezierCurve turned = curve.reversed();
    for (int i = 0; i <= curve.degree(); ++i) {
      EXPECT_EQ(turned.pole(i), curve.pole(curve.degree() - i));
      EXPECT_EQ(turned.weight(i), curve.weight(curve.degree() - i));
    }
    EXPECT_TRUE(identical(turned.reversed(), curve));
  });
}

TEST(BezierCurve, EndPolesStayWhereTheyAreUnderElevationAndSplit) {
  forDegrees(17, [](Random&, const BezierCurve& curve) {
    const int n = curve.degree();
    const auto [left, right] = curve.split(0.375);
    EXPECT_EQ(left.pole(0), curve.pole(0));
    EXPECT_EQ(right.pole(n), curve.pole(n));
    if (n == kMaxDegree) return;
    EXPECT_EQ(curve.elevated().pole(0), curve.pole(0));
    EXPECT_EQ(curve.elevated().pole(n + 1), curve.pole(n));
  });
}

TEST(BezierCurve, AnAffineMapOfThePolesIsTheMapOfTheCurve) {
  Random random(18);
  const BezierCurve curve = randomBezier(random, 5, true);
  Eigen::Affine3d map(Eigen::AngleAxisd(0.7, random.direction()));
  map = Eigen::Translation3d(random.vector(5.0)) * map * Eigen::Scaling(1.0, 2.0, -3.0);
  const BezierCurve moved = curve.transformed(map);
  EXPECT_EQ(weightsOf(moved), weightsOf(curve));
  for (const double t : {0.0, 0.3, 1.0}) {
    EXPECT_LT((moved.evaluate(t) - map * curve.evaluate(t)).norm(), 1e-13 * size(moved));
  }
}

TEST(BezierCurve, OperationsLeaveTheCurveUntouched) {
  Random random(19);
  const BezierCurve curve = randomBezier(random, 6, true);
  const BezierCurve copy = curve;
  const auto use = [&] {
    return std::tuple(curve.evaluate(0.2), curve.derivatives(0.4, 3), curve.reversed(),
                      curve.elevated(2), curve.split(0.5), curve.segment(0.1, 0.2),
                      curve.transformed(Eigen::Affine3d::Identity()));
  };
  const auto first = use();
  const auto second = use();
  EXPECT_TRUE(identical(curve, copy));
  EXPECT_EQ(std::get<0>(first), std::get<0>(second));
  EXPECT_TRUE(identical(std::get<3>(first), std::get<3>(second)));
}

TEST(BezierCurve, MayBeReadByManyThreadsAtOnce) {
  Random random(20);
  const BezierCurve curve = randomBezier(random, 9, true);
  const std::vector<Vector3> expected = curve.derivatives(0.3, 5);
  std::vector<int> equal(4, 0);
  {
    std::vector<std::jthread> threads;
    for (std::size_t i = 0; i < equal.size(); ++i) {
      threads.emplace_back([&, i] {
        for (int round = 0; round < 200; ++round)
          equal[i] += curve.derivatives(0.3, 5) == expected ? 1 : 0;
      });
    }
  }
  EXPECT_EQ(equal, std::vector<int>(4, 200));
}

TEST(BezierCurve, CopiesTheDataOfAView) {
  Random random(21);
  const BezierCurve curve = randomBezier(random, 3, true);
  EXPECT_TRUE(identical(BezierCurve(curve.view()), curve));
}

TEST(BezierCurve, NamesWrongNumbersOfPoles) {
  EXPECT_ERROR(BezierCurve(std::vector<Vector3>(1)), "poles: a Bézier curve has 2 to 26 poles");
  EXPECT_ERROR(BezierCurve(std::vector<Vector3>(27, Vector3::Zero())), "got 27");
  EXPECT_NO_THROW(BezierCurve(std::vector<Vector3>(26, Vector3::Zero())));
}

TEST(BezierCurve, NamesPolesThatAreNotFinite) {
  EXPECT_ERROR(BezierCurve(std::vector<Vector3>{{0, 0, 0}, {0, kNaN, 0}}),
               "poles: every coordinate must be finite");
  EXPECT_ERROR(BezierCurve(std::vector<Vector3>{{0, -kInfinity, 0}, {0, 1, 0}}),
               "poles: every coordinate must be finite");
}

TEST(BezierCurve, NamesBadWeights) {
  const std::vector<Vector3> poles{{0, 0, 0}, {1, 0, 0}};
  const auto with = [&](const std::vector<double>& weights) { return BezierCurve(poles, weights); };
  EXPECT_ERROR(with({1.0}), "weights: one for each pole is needed, got 1 for 2 poles");
  EXPECT_ERROR(with({1.0, 0.0}), "weights: every weight must be finite and > 0");
  EXPECT_ERROR(with({1.0, -1.0}), "weights: every weight must be finite and > 0");
  EXPECT_ERROR(with({kNaN, 1.0}), "weights: every weight must be finite and > 0");
  EXPECT_ERROR(with({kInfinity, 1.0}), "weights: every weight must be finite and > 0");
}

TEST(BezierCurve, NamesElevationsOutOfRange) {
  Random random(22);
  const BezierCurve curve = randomBezier(random, 20, false);
  EXPECT_ERROR(curve.elevated(6), "times: the degree 20 can be raised by 0 to 5, got 6");
  EXPECT_ERROR(curve.elevated(-1), "got -1");
}

TEST(BezierCurve, NamesPartsThatAreNone) {
  Random random(23);
  const BezierCurve curve = randomBezier(random, 3, false);
  EXPECT_ERROR(curve.segment(0.5, 0.5), "segment: a and b must differ");
  EXPECT_ERROR(curve.segment(kNaN, 0.5), "segment: a and b must be finite");
  EXPECT_ERROR(curve.segment(0.0, kInfinity), "segment: a and b must be finite");
  EXPECT_ERROR(curve.split(kNaN), "split: t must be finite");
}

TEST(BezierCurve, RefusesPartsBeyondARationalCurveWhoseWeightsWouldNotBePositive) {
  const BezierCurve arc(std::vector<Vector3>{{1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                        std::vector<double>{1.0, 2.0, 1.0});
  EXPECT_NO_THROW(arc.segment(-0.125, 1.0));
  EXPECT_ERROR(arc.split(-2.0), "beyond [0, 1] this rational curve has weights <= 0");
  EXPECT_ERROR(arc.segment(0.0, 40.0), "beyond [0, 1] this rational curve has weights <= 0");
}

}  // namespace
}  // namespace osculate::test
