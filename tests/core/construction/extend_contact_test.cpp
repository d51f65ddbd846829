// The order of contact of extensions, and the thesis's formulas (corrected) as cases of it.
#include <gtest/gtest.h>

#include <algorithm>

#include "construction/extend_curves.h"
#include "osculate/bezier/bernstein.h"
#include "osculate/construction/contact_error.h"
#include "osculate/construction/extend_curve.h"
#include "osculate/construction/graph_jet.h"
#include "osculate/differential/point_geometry.h"
#include "support/errors.h"

namespace osculate {
namespace {

using test::NamedCurve;

/// The residuals of all orders are zero as far as double coordinates can tell.
void expectContact(const Construction& construction, int order, const std::string& what) {
  const JoinReport& report = construction.joins.at(0).report;
  ASSERT_EQ(report.requestedOrder, order);
  for (int k = 0; k <= order; ++k) {
    const auto i = static_cast<std::size_t>(k);
    EXPECT_LE(report.residuals[i], std::max(report.tolerances[i], report.uncertainties[i]))
        << what << ", order " << k;
    EXPECT_NE(report.verdicts[i], Verdict::kFail) << what << ", order " << k;
  }
}

/// Components of derivatives in the frame at the end of a curve, [k] of the k-th.
struct Frame {
  Vector3 t, n, b;
  explicit Frame(const BSplineCurve& curve) {
    const PointGeometry geometry = geometryAt(curve, curve.last(), Side::kLeft);
    t = geometry.frame.tangent;
    n = *geometry.frame.normal;
    b = t.cross(n);
  }
};

std::vector<double> components(const std::vector<Vector3>& derivatives, const Vector3& axis) {
  std::vector<double> result;
  for (const Vector3& derivative : derivatives)
    result.push_back(derivative.dot(axis));
  return result;
}

TEST(ExtendContact, HoldsForAllOrdersAtBothEndsOfEveryKindOfCurve) {
  for (const auto& [name, curve] : test::curvesToExtend()) {
    for (const CurveEnd end : {CurveEnd::kStart, CurveEnd::kEnd}) {
      for (int order = 0; order <= kMaxOrder; ++order) {
        const Construction result = extendCurve(curve, {.end = end, .order = order});
        const std::string what = name + " G" + std::to_string(order);
        EXPECT_EQ(result.curve.degree(), std::max(order, 1)) << what;
        expectContact(result, order, what);
        if (order > 4) continue;
        EXPECT_EQ(result.joins[0].report.order, order) << what;
        EXPECT_TRUE(result.warnings.empty()) << what;
      }
    }
  }
}

TEST(ExtendContact, HoldsForHigherDegrees) {
  for (const auto& [name, curve] : test::curvesToExtend()) {
    for (const int order : {0, 2, 4}) {
      for (const int degree : {order + 1, order + 3}) {
        const Construction result = extendCurve(curve, {.order = order, .degree = degree});
        EXPECT_EQ(result.curve.degree(), degree);
        expectContact(result, order, name + " degree " + std::to_string(degree));
      }
    }
  }
  const Construction highest = extendCurve(test::twistedCubic(), {.order = 3, .degree = 25});
  EXPECT_EQ(highest.curve.degree(), 25);
  expectContact(highest, 3, "degree 25");
}

TEST(ExtendContact, HoldsAtARepeatedPoleThatIsOnlyAParameter) {
  for (int order = 0; order <= 4; ++order) {
    const Construction result = extendCurve(test::doublePole(), {.order = order});
    expectContact(result, order, "double pole G" + std::to_string(order));
  }
  // a cusp's own end has no curvature
  const BSplineCurve cusp = test::bezier({{-20, 5, 0}, {-10, 0, 0}, {0, 0, 0}, {0, 0, 0}});
  expectContact(extendCurve(cusp, {.order = 1}), 1, "cusp");
  EXPECT_THROW(extend(cusp, {.order = 2}), ContactError);
}

TEST(ExtendContact, ACubicMeetsACurveThatBendsAndTwistsWithG4) {
  // mathematics: q2 = -q1^2 W4/(6 W3), q3 = -(V4 q1^4 + 6 V3 q1^2 q2 + 3 V2 q2^2)/(4 q1 V2)
  for (const auto& [name, curve] :
       {NamedCurve{"quintic", test::twistedQuintic()}, {"rational", test::rationalQuartic()}}) {
    const Construction result = extendCurve(curve, {.order = 4, .degree = 3});
    EXPECT_EQ(result.curve.degree(), 3);
    EXPECT_EQ(result.joins[0].report.order, 4) << name;
    EXPECT_EQ(result.freeNumbers, 0) << name;
    const Frame frame(curve);
    const auto q = components(result.curve.derivatives(0.0, 3), frame.t);
    const GraphJet graph = graphJet(contactJet(curve, {}, 4));
    const auto v = [&](std::size_t k) { return graph.overTangent.r[k].dot(frame.n); };
    const auto w = [&](std::size_t k) { return graph.overTangent.r[k].dot(frame.b); };
    const double q2 = -q[1] * q[1] * w(4) / (6.0 * w(3));
    EXPECT_NEAR(q[2], q2, 1e-8 * std::abs(q2)) << name;
    const double q3 =
        -(v(4) * std::pow(q[1], 4) + 6.0 * v(3) * q[1] * q[1] * q2 + 3.0 * v(2) * q2 * q2) /
        (4.0 * q[1] * v(2));
    EXPECT_NEAR(q[3], q3, 1e-8 * (std::abs(q3) + std::abs(q[1]))) << name;
  }
}

TEST(ExtendContact, AQuadraticMeetsAPlanarCurveWithG3) {
  // q2 = -V3 q1^2/(3 V2)
  const Construction result = extendCurve(test::planarCubic(), {.order = 3, .degree = 2});
  EXPECT_EQ(result.curve.degree(), 2);
  EXPECT_EQ(result.joins[0].report.order, 3);
  const Frame frame(test::planarCubic());
  const auto q = components(result.curve.derivatives(0.0, 2), frame.t);
  const GraphJet graph = graphJet(contactJet(test::planarCubic(), {}, 3));
  const double v2 = graph.overTangent.r[2].dot(frame.n);
  const double v3 = graph.overTangent.r[3].dot(frame.n);
  EXPECT_NEAR(q[2], -v3 * q[1] * q[1] / (3.0 * v2), 1e-8 * q[1]);
}

TEST(ExtendContact, BelowTheOrderWhereCountingSaysSo) {
  // in the plane 2n >= m + 1, in space 3n >= 2m + 1 (Hoellig and Koch 1996)
  for (int order = 3; order <= 6; ++order) {
    const int planar = (order + 2) / 2;
    const Construction inPlane =
        extendCurve(test::planarCubic(), {.order = order, .degree = std::max(planar, 3)});
    expectContact(inPlane, order, "plane G" + std::to_string(order));
    const int spatial = (2 * order + 3) / 3;
    const Construction inSpace =
        extendCurve(test::twistedCubic(), {.order = order, .degree = std::max(spatial, 3)});
    expectContact(inSpace, order, "space G" + std::to_string(order));
  }
}

TEST(ExtendContact, SaysWhichDegreeCan) {
  const auto meet = [](const BSplineCurve& curve, int order, int degree) {
    return extend(curve, {.order = order, .degree = degree});
  };
  EXPECT_ERROR(meet(test::twistedQuintic(), 4, 2), "degree 3 can");
  EXPECT_ERROR(meet(test::twistedQuintic(), 3, 2), "degree 3 can");
  EXPECT_ERROR(meet(test::planarCubic(), 2, 1), "degree 2 can");
  EXPECT_ERROR(meet(test::planarCubic(), 3, 1), "degree 2 can");
  EXPECT_THROW(meet(test::planarCubic(), 3, 1), ContactError);
}

TEST(ExtendContact, ThesisEquationsOfTheSecondAndThirdPole) {
  // (131) with the sign of C_3b corrected; q the ratio of the legs at the join
  const BSplineCurve curve = test::twistedQuintic();
  const Frame frame(curve);
  for (const int n2 : {3, 4, 6}) {
    ExtendOptions options{.order = 3, .degree = n2, .fairness = Fairness::kBending};
    const BSplineCurve result = extendCurve(curve, options).curve;
    const auto pole = [&](Eigen::Index i) -> Vector3 { return result.data().poles.col(i); };
    const auto back = [&](Eigen::Index i) -> Vector3 {
      return curve.data().poles.col(5 - i) - curve.data().poles.col(5);
    };
    const double n1 = 5.0;
    const double q = (pole(1) - pole(0)).norm() / back(1).norm();
    const double c2 = n2 * (n1 - 1.0) / (n1 * (n2 - 1.0)) * q * q * back(2).dot(frame.n);
    EXPECT_NEAR((pole(2) - pole(0)).dot(frame.n), c2, 1e-11) << n2;
    EXPECT_NEAR((pole(2) - pole(0)).dot(frame.b), 0.0, 1e-11) << n2;
    const double c3 = -n2 * n2 * (n1 - 1.0) * (n1 - 2.0) / (n1 * n1 * (n2 - 1.0) * (n2 - 2.0)) *
                      std::pow(q, 3) * back(3).dot(frame.b);
    EXPECT_NEAR((pole(3) - pole(0)).dot(frame.b), c3, 1e-10) << n2;
  }
}

TEST(ExtendContact, ThesisEquationOfTheFourthDerivative) {
  // (133), its normal part corrected; u, v, w of the curve, q_k = u^(k) of the extension times u1'
  const BSplineCurve curve = test::twistedQuintic();
  const Frame frame(curve);
  const BSplineCurve result = extendCurve(curve, {.order = 4}).curve;
  const auto derivatives = curve.derivatives(1.0, 4);
  const auto u = components(derivatives, frame.t);
  const auto v = components(derivatives, frame.n);
  const auto w = components(derivatives, frame.b);
  const auto of = result.derivatives(0.0, 4);
  const auto q = components(of, frame.t);
  const double q4 = std::pow(q[1], 4);
  const double normal =
      q4 * (v[4] / std::pow(u[1], 4) +
            6.0 * q[2] / (q[1] * q[1] * std::pow(u[1], 3)) * (v[3] - 3.0 * v[2] * u[2] / u[1]) -
            (6.0 * v[3] * u[2] + 4.0 * u[3] * v[2]) / std::pow(u[1], 5) +
            4.0 * q[3] * v[2] / (u[1] * u[1] * std::pow(q[1], 3)) +
            3.0 * q[2] * q[2] * v[2] / (u[1] * u[1] * q4) +
            15.0 * u[2] * u[2] * v[2] / std::pow(u[1], 6));
  const double binormal = q4 * (w[4] / std::pow(u[1], 4) - 6.0 * w[3] * u[2] / std::pow(u[1], 5) +
                                6.0 * q[2] * w[3] / (q[1] * q[1] * std::pow(u[1], 3)));
  EXPECT_NEAR(of[4].dot(frame.n), normal, 1e-8 * (std::abs(normal) + q4));
  EXPECT_NEAR(of[4].dot(frame.b), binormal, 1e-8 * (std::abs(binormal) + q4));
}

TEST(ExtendContact, ThesisLimitingCaseOfPolesOnTheTangent) {
  // (137) with its indices and sign corrected: with C_1 .. C_{m-1} and D_{n-1} .. D_{n-m+1} on the
  // tangent, C_m across it is (-1)^m (n2 q/n1)^m n1!(n2-m)!/(n2!(n1-m)!) D_{n-m} across it
  for (int m = 2; m <= 5; ++m) {
    std::vector<Vector3> poles;
    for (int i = 0; i <= 6; ++i) {
      const bool onTangent = i < m;
      poles.insert(poles.begin(),
                   Vector3(-7.0 * i, onTangent ? 0.0 : 4.0 + i, onTangent ? 0.0 : -3.0));
    }
    const BSplineCurve curve = test::bezier(poles);
    const Construction result = extendCurve(curve, {.order = m});
    const BSplineCurve& extension = result.curve;
    const double q = extension.data().poles(0, 1) / 7.0;
    const double factor = (m % 2 == 0 ? 1.0 : -1.0) * std::pow(m * q / 6.0, m) * binomial(6, m);
    for (int i = 1; i < m; ++i)
      EXPECT_LE(extension.data().poles.col(i).tail<2>().norm(), 1e-12) << m;
    const Vector3 expected = factor * curve.data().poles.col(6 - m);
    const Vector3 found = extension.data().poles.col(m);
    EXPECT_NEAR(found.y(), expected.y(), 1e-9 * std::abs(expected.y())) << m;
    EXPECT_NEAR(found.z(), expected.z(), 1e-9 * std::abs(expected.z())) << m;
    EXPECT_EQ(result.joins[0].report.sides[1].linearity, m - 1) << m;
  }
}

TEST(ExtendContact, AStraightLineIsContinuedStraight) {
  const Vector3 direction = Vector3(30, 10, -5).normalized();
  for (int order = 1; order <= kMaxOrder; ++order) {
    const BSplineCurve result = extendCurve(test::line(), {.order = order}).curve;
    for (Eigen::Index i = 1; i < result.data().poles.cols(); ++i) {
      const Vector3 pole = result.data().poles.col(i);
      EXPECT_LE(pole.cross(direction).norm(), 1e-11) << order;
      const Vector3 before = result.data().poles.col(i - 1);
      EXPECT_GT((pole - before).dot(direction), 0.0) << order;  // ascending
    }
    EXPECT_NEAR(result.endPoint(CurveEnd::kEnd).norm(), reachFrom(test::line(), CurveEnd::kEnd),
                1e-9);
  }
}

TEST(ExtendContact, PoleNumberOrderPlusOneLeavesALine) {
  // thesis 4.2.1: the first m poles on the tangent, the next anywhere
  ExtendOptions options{.order = 3};
  options.targets.point = Vector3(20, 15, 5);
  const Construction result = extendCurve(test::line(), options);
  EXPECT_EQ(result.curve.degree(), 4);
  EXPECT_EQ(result.joins[0].report.order, 3);
  EXPECT_EQ(result.joins[0].report.sides[1].linearity, 3);
  EXPECT_LE((result.curve.endPoint(CurveEnd::kEnd) - *options.targets.point).norm(), 1e-9);
}

TEST(ExtendContact, ParametricContinuityIsThatOfTheThesis) {
  // (55): C_4 = 16 D_n - 32 D_{n-1} + 24 D_{n-2} - 8 D_{n-3} + D_{n-4}
  const BSplineCurve curve = test::twistedQuintic();
  const Construction result = extendCurve(curve, {.order = 4, .degree = 5, .parametric = true});
  EXPECT_EQ(result.joins[0].report.parametricOrder, 4);
  const auto d = [&](Eigen::Index i) -> Vector3 { return curve.data().poles.col(i); };
  const Vector3 expected = 16.0 * d(5) - 32.0 * d(4) + 24.0 * d(3) - 8.0 * d(2) + d(1);
  EXPECT_LE((result.curve.data().poles.col(4) - expected).norm(), 1e-10);
}

TEST(ExtendContact, ParametricContinuityHoldsForAllOrdersAndCurves) {
  for (const auto& [name, curve] : test::curvesToExtend()) {
    for (const CurveEnd end : {CurveEnd::kStart, CurveEnd::kEnd}) {
      for (int order = 1; order <= 4; ++order) {
        const Construction result =
            extendCurve(curve, {.end = end, .order = order, .parametric = true});
        EXPECT_EQ(result.joins[0].report.parametricOrder, order) << name;
        EXPECT_EQ(result.curve.last(), curve.endSegment(end).length()) << name;
      }
    }
  }
}

TEST(ExtendContact, ParametricDegreeFromTheCurvesOwn) {
  // a cubic has no derivatives above the third, so that a cubic can be C^4
  const Construction cubic =
      extendCurve(test::twistedCubic(), {.order = 4, .degree = 3, .parametric = true});
  EXPECT_EQ(cubic.joins[0].report.parametricOrder, 4);
  const Construction raised =
      extendCurve(test::twistedCubic().elevated(2), {.order = 8, .degree = 3, .parametric = true});
  EXPECT_EQ(raised.curve.degree(), 3);
  EXPECT_ERROR(extend(test::twistedQuintic(), {.order = 4, .degree = 3, .parametric = true}),
               "degree 4 can");
  EXPECT_THROW(extend(test::doublePole(), {.order = 2, .parametric = true}), ContactError);
}

TEST(ExtendContact, AParameterCutsTheParametricCurve) {
  for (const double t : {0.3, 1.0, 1.7}) {
    const Construction whole =
        extendCurve(test::twistedQuintic(), {.order = 4, .parametric = true});
    const Construction part = extendCurve(test::twistedQuintic(), {.order = 4, .parameter = t});
    EXPECT_EQ(part.joins[0].report.order, 4);
    const BezierCurve expected = whole.curve.segment(0).curve.segment(0.0, t);
    for (int i = 0; i <= 4; ++i)
      EXPECT_LE((part.curve.data().poles.col(i) - expected.pole(i)).norm(), 1e-9) << t;
  }
}

}  // namespace
}  // namespace osculate
