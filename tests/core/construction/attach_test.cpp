// Contact of the attached poles for any free numbers, and the thesis's formulas (corrected) as
// cases.
#include "osculate/construction/attach.h"

#include <gtest/gtest.h>

#include <random>

#include "osculate/bezier/bernstein.h"
#include "osculate/continuity/curve_joins.h"
#include "osculate/differential/arc_jet.h"

namespace osculate {
namespace {

BezierCurve quintic() {
  const std::vector<Vector3> poles{{0, 0, 0},  {9, 4, 1},   {21, -2, 5},
                                   {30, 6, 2}, {42, 3, -4}, {50, 9, 3}};
  return BezierCurve(poles);
}

/// The attached poles, then two more anywhere.
BezierCurve attached(const ContactJet& target, const ArcLengthSeries& sigma, int degree) {
  BoundedPoles poles(3, degree + 1);
  const BoundedPoles first = attach(target, sigma, degree);
  poles.leftCols(first.cols()) = first;
  for (Eigen::Index i = first.cols(); i <= degree; ++i)
    poles.col(i) << 60.0 + 10.0 * static_cast<double>(i), 5.0, -7.0;
  return bezierFromPoles(poles.data(), degree);
}

TEST(Attach, MeetsEveryOrderForAnyFreeNumbers) {
  std::mt19937 generator(41);
  std::uniform_real_distribution<double> number(-6.0, 6.0);
  const BSplineCurve first(quintic());
  for (int order = 0; order <= kMaxOrder; ++order) {
    for (int trial = 0; trial < 20; ++trial) {
      ArcLengthSeries sigma;
      for (double& value : sigma)
        value = number(generator);
      sigma[0] = 20.0 + sigma[0];
      const BSplineCurve second(attached(contactJet(first, {}, order), sigma, order + 2));
      const AnalysisOptions options{.order = order, .tolerances = Tolerances::preset("exact")};
      const JoinReport report = analyzeCurves(first, second, options, JoinEnds{}).report;
      for (int k = 0; k <= order; ++k) {
        const auto i = static_cast<std::size_t>(k);
        EXPECT_LE(report.residuals[i], std::max(1e-9, report.uncertainties[i]))
            << "order " << order << ", k " << k;
      }
    }
  }
}

TEST(Attach, GivesTheFreeNumbersBackAsBeta) {
  const BSplineCurve first(quintic());
  const ArcLengthSeries sigma{25.0, 3.0, -2.0, 1.5};
  const BSplineCurve second(attached(contactJet(first, {}, 4), sigma, 6));
  // beta of the report relates both parameters; of a first curve by arc length it would be k!
  // sigma_k
  const auto arc = arcJet(endJet<4>(second.segment(0).curve.view(), CurveEnd::kStart, 0.0));
  for (std::size_t k = 1; k <= 4; ++k)
    EXPECT_NEAR(arc.arcLength[k], sigma[k - 1], 1e-12) << k;
}

TEST(Attach, BinormalOfThirdPoleHasTheSignThatKeepsTorsion) {
  // thesis (131), corrected: C_3b = - n2^2 (n1-1)(n1-2) / (n1^2 (n2-1)(n2-2)) q^3 D_{n-3,b}
  const BezierCurve first = quintic();
  const BSplineCurve curve(first);
  const JoinReport report =
      analyzeCurves(curve, BSplineCurve(attached(contactJet(curve, {}, 3), {25.0}, 5)), {},
                    JoinEnds{})
          .report;
  const Vector3 binormal = *report.sides[0].frame.binormal;
  const double q = 25.0 / 5.0 / ((first.pole(5) - first.pole(4)).norm());  // ratio of the end legs
  const BoundedPoles poles = attach(contactJet(curve, {}, 3), {25.0}, 5);
  const double c3 = binormal.dot(poles.col(3) - poles.col(0));
  const double d3 = binormal.dot(first.pole(2) - first.pole(5));
  EXPECT_NEAR(c3, -q * q * q * d3, 1e-12 * std::abs(d3));
}

TEST(Attach, DerivativesAgreeWithDifferences) {
  const ContactJet target = contactJet(BSplineCurve(quintic()), {}, 6);
  const ArcLengthSeries sigma{20.0, 4.0, -3.0, 2.0, 1.0, -1.0};
  std::array<BoundedPoles, kMaxOrder> derivative;
  attachDerivatives(target, sigma, 9, derivative);
  for (std::size_t l = 0; l < 6; ++l) {
    constexpr double kStep = 1e-5;
    ArcLengthSeries above = sigma;
    ArcLengthSeries below = sigma;
    above[l] += kStep;
    below[l] -= kStep;
    const BoundedPoles difference =
        (attach(target, above, 9) - attach(target, below, 9)) / (2.0 * kStep);
    EXPECT_LE((difference - derivative[l]).norm(), 1e-7 * (1.0 + derivative[l].norm())) << l;
  }
}

TEST(Attach, SecondDerivativesAgreeWithDifferences) {
  const ContactJet target = contactJet(BSplineCurve(quintic()), {}, 5);
  const ArcLengthSeries sigma{20.0, 4.0, -3.0, 2.0, 1.0};
  const BoundedPoles curvature = attachedTaylorCurvature(target, sigma);
  constexpr double kStep = 1e-5;
  for (int i = 1; i <= 5; ++i) {
    std::array<ArcLengthSeries, 2> beside{sigma, sigma};
    beside[0][static_cast<std::size_t>(i - 1)] -= kStep;
    beside[1][static_cast<std::size_t>(i - 1)] += kStep;
    std::array<std::array<BoundedPoles, kMaxOrder>, 2> slope;
    attachedTaylorDerivatives(target, beside[0], slope[0]);
    attachedTaylorDerivatives(target, beside[1], slope[1]);
    for (int j = 1; j <= 5; ++j) {
      const auto l = static_cast<std::size_t>(j - 1);
      BoundedPoles expected = BoundedPoles::Zero(3, 6);
      const int count = std::max(6 - i - j, 0);
      expected.rightCols(count) = curvature.leftCols(count);
      const BoundedPoles difference = (slope[1][l] - slope[0][l]) / (2.0 * kStep);
      EXPECT_LE((difference - expected).norm(), 1e-7 * (1.0 + expected.norm())) << i << ' ' << j;
    }
  }
}

TEST(ContactJet, LeavesFromInsideInBothDirections) {
  const BSplineCurve curve(quintic());
  const ContactJet forward =
      contactJet(curve, {.inside = true, .parameter = 0.3, .forward = true}, 4);
  const ContactJet backward =
      contactJet(curve, {.inside = true, .parameter = 0.3, .forward = false}, 4);
  for (std::size_t k = 0; k <= 4; ++k) {
    const double sign = k % 2 == 1 ? -1.0 : 1.0;
    EXPECT_LE((forward.r[k] - sign * backward.r[k]).norm(), 1e-12 * (1.0 + forward.r[k].norm()))
        << k;
  }
  EXPECT_THROW(contactJet(curve, {}, kMaxOrder + 1), std::invalid_argument);
  EXPECT_THROW(contactJet(curve, {}, -1), std::invalid_argument);
  EXPECT_THROW(contactJet(curve, {.inside = true, .parameter = 0.0, .forward = true}, 2),
               std::invalid_argument);
  EXPECT_THROW(contactJet(curve, {.inside = true, .parameter = 1.5}, 2), std::invalid_argument);
}

}  // namespace
}  // namespace osculate
