#include "osculate/differential/singular_end.h"

#include "support/designed_curves.h"
#include "support/perturbation.h"

namespace osculate::test {
namespace {

/// The curve with these Taylor coefficients at its start (c_0 first, all of them).
BezierCurve withCoefficients(const std::vector<Vector3>& coefficients) {
  PointSeries exactCoefficients;
  for (const Vector3& c : coefficients)
    exactCoefficients.push_back(exact<Real>(c));
  return roundedCurve(bezierNet(exactCoefficients));
}

/// The plane curve (t^a, t^b).
BezierCurve powers(int a, int b) {
  std::vector<Vector3> coefficients(static_cast<std::size_t>(std::max(a, b)) + 1, Vector3::Zero());
  coefficients[static_cast<std::size_t>(a)].x() = 1.0;
  coefficients[static_cast<std::size_t>(b)].y() = 1.0;
  return withCoefficients(coefficients);
}

/// P(t^m): the trace of P with an m-fold end pole; numerator and weights both.
BezierCurve slowedDown(const BezierCurve& curve, int m) {
  const int n = curve.degree();
  const auto own = homogeneousTaylor(exact<Real>(curve), Real(0), n);
  std::vector<Homogeneous<Real>> coefficients(static_cast<std::size_t>(m * n) + 1,
                                              Homogeneous<Real>::Constant(Real(0)));
  for (int k = 0; k <= n; ++k)
    coefficients[static_cast<std::size_t>(m * k)] = own[static_cast<std::size_t>(k)];
  std::vector<Vector3> poles;
  std::vector<double> weights;
  for (const auto& point : bezierNet(coefficients)) {
    poles.push_back(toDouble(Point<Real>(point.head<3>() / point[3])));
    if (curve.isRational()) weights.push_back(toDouble(point[3]));
  }
  return BezierCurve(poles, weights);
}

TEST(SingularEnd, ACuspKeepsOnlyTheDerivativesBeforeItsFractionalPower) {
  struct Case {
    int a, b, smoothness;
  };
  // (t^a, t^b) is a series in s^(1/a) with the term s^(b/a): C^floor(b/a)
  for (const auto& [a, b, smoothness] : {Case{2, 3, 1}, Case{2, 5, 2}, Case{2, 9, 4}, Case{3, 4, 1},
                                         Case{3, 5, 1}, Case{3, 7, 2}, Case{4, 13, 3}}) {
    SCOPED_TRACE("(t^" + std::to_string(a) + ", t^" + std::to_string(b) + ")");
    const BezierCurve curve = powers(a, b);
    const SingularEnd start = singularEnd(curve.view(), CurveEnd::kStart, 0.0, kMaxArcOrder);
    EXPECT_EQ(start.multiplicity, a);
    EXPECT_EQ(start.smoothness, smoothness);
    EXPECT_LE((start.r[1] - Vector3::UnitX()).norm(), start.error[1]);
    const SingularEnd end = singularEnd(curve.reversed().view(), CurveEnd::kEnd, 0.0, kMaxArcOrder);
    EXPECT_EQ(end.multiplicity, a);
    EXPECT_EQ(end.smoothness, smoothness);
    EXPECT_EQ(end.r, start.r);
  }
}

TEST(SingularEnd, ARepeatedPoleOfARegularTraceHasTheDerivativesOfTheTrace) {
  Random random(140);
  BoundStatistics statistics;
  for (int round = 0; round < 40; ++round) {
    const bool rational = round % 2 == 1;
    const int m = 2 + round % 3;
    const BezierCurve curve = randomBezier(random, 2 + round % 4, rational);
    const BezierCurve slow = slowedDown(curve, m);
    SCOPED_TRACE("degree " + std::to_string(curve.degree()) + " in t^" + std::to_string(m) +
                 (rational ? ", rational" : ", polynomial"));
    const PointSeries expected =
        arcDerivatives(outwardTaylor(exact<Real>(curve), CurveEnd::kStart, kMaxArcOrder));
    const SingularEnd end = singularEnd(slow.view(), CurveEnd::kStart, 0.0, kMaxArcOrder);
    EXPECT_EQ(end.multiplicity, m);
    EXPECT_EQ(end.smoothness, kMaxArcOrder);
    for (std::size_t k = 1; k <= kMaxArcOrder; ++k) {
      EXPECT_LE(distance(expected[k], end.r[k]), end.error[k]) << "order " << k;
      statistics.add(end.error[k], distance(expected[k], end.r[k]));
    }
  }
  EXPECT_LE(statistics.median(), 1e4) << "a bound this loose says nothing";
}

TEST(SingularEnd, SmoothnessIsAtMostTheOrderAskedFor) {
  Random random(141);
  const BezierCurve slow = slowedDown(randomBezier(random, 3, false), 2);
  for (int order = 1; order <= kMaxArcOrder; ++order) {
    EXPECT_EQ(singularEnd(slow.view(), CurveEnd::kStart, 0.0, order).smoothness, order);
  }
}

TEST(SingularEnd, AFractionalPowerFarBeyondTheDegreeOfTheTraceEndsTheSmoothnessThere) {
  // the parabola (t^2, t^4) with (0, 0, t^13) added: one s^(13/2) term, C^6
  std::vector<Vector3> coefficients(14, Vector3::Zero());
  coefficients[2].x() = 1.0;
  coefficients[4].y() = 1.0;
  coefficients[13].z() = 1.0;
  const SingularEnd end =
      singularEnd(withCoefficients(coefficients).view(), CurveEnd::kStart, 0.0, kMaxArcOrder);
  EXPECT_EQ(end.smoothness, 6);
  EXPECT_LE((end.r[2] - Vector3(0, 2, 0)).norm(), end.error[2]) << "the parabola's curvature";
}

TEST(SingularEnd, AllButOneDerivativeMayVanish) {
  std::vector<Vector3> poles(kMaxDegree + 1, Vector3(1, 2, 3));
  poles.back() += Vector3(0, 0, 4);
  const SingularEnd end =
      singularEnd(BezierCurve(poles).view(), CurveEnd::kStart, 0.0, kMaxArcOrder);
  EXPECT_EQ(end.multiplicity, kMaxDegree);
  EXPECT_EQ(end.smoothness, kMaxArcOrder);
  EXPECT_LE((end.r[1] - Vector3::UnitZ()).norm(), end.error[1]);
  EXPECT_LE(end.error[1], 1e-6) << "2^25 of a unit roundoff";
  for (std::size_t k = 2; k <= kMaxArcOrder; ++k)
    EXPECT_LE(end.r[k].norm(), end.error[k]) << "order " << k;
}

TEST(SingularEnd, WhereAllPolesAreOnePointNothingExists) {
  const std::vector<Vector3> poles(5, Vector3(1, 2, 3));
  const SingularEnd end =
      singularEnd(BezierCurve(poles).view(), CurveEnd::kStart, 0.0, kMaxArcOrder);
  EXPECT_EQ(end.multiplicity, 5);
  EXPECT_EQ(end.smoothness, 0);
  EXPECT_TRUE(end.r[1].isZero(0.0));
}

TEST(SingularEnd, PolesWithinTheirErrorOfEachOtherAreOnePole) {
  std::vector<Vector3> poles{{0, 0, 0}, {1e-6, 0, 0}, {1, 0, 0}, {2, 1, 0}};
  EXPECT_EQ(singularEnd(BezierCurve(poles).view(), CurveEnd::kStart, 0.0, 4).multiplicity, 1);
  EXPECT_EQ(singularEnd(BezierCurve(poles).view(), CurveEnd::kStart, 1e-6, 4).multiplicity, 2);
}

}  // namespace
}  // namespace osculate::test
