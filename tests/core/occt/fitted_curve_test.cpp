// Fits: what they claim of their error holds for points and for derivatives.
#include "osculate/occt/fitted_curve.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

namespace osculate::test {
namespace {

/// (e^t cos 3t, e^t sin 3t, t): its derivatives are powers of the complex number 1 + 3i.
std::array<Vector3, 5> spiral(double t) {
  std::array<Vector3, 5> result;
  double x = std::exp(t) * std::cos(3.0 * t);
  double y = std::exp(t) * std::sin(3.0 * t);
  for (std::size_t k = 0; k < 5; ++k) {
    result[k] = {x, y, k == 0 ? t : (k == 1 ? 1.0 : 0.0)};
    const double next = x - 3.0 * y;
    y = 3.0 * x + y;
    x = next;
  }
  return result;
}

/// |sin t| beside t: no derivative at 0.
Vector3 kink(double t) { return {t, std::abs(std::sin(t)), 0.0}; }

double largestError(const FittedCurve& fitted, const std::function<Vector3(double)>& pointAt) {
  double largest = 0.0;
  const double first = fitted.curve.first();
  const double last = fitted.curve.last();
  for (int i = 0; i <= 5000; ++i) {
    const double t = first + i * (last - first) / 5000;
    largest = std::max(largest, (fitted.curve.evaluate(t) - pointAt(t)).norm());
  }
  return largest;
}

TEST(FittedCurve, ReachesRoundingAndStatesIt) {
  const auto pointAt = [](double t) { return spiral(t)[0]; };
  const FittedCurve fitted = fitCurve(pointAt, std::array{-1.0, 0.5, 2.0});
  EXPECT_LE(fitted.errorMm, 1e-13 * spiral(2.0)[0].norm());
  EXPECT_LE(largestError(fitted, pointAt), fitted.errorMm);
  EXPECT_EQ(fitted.curve.endPoint(CurveEnd::kStart), pointAt(-1.0));
  EXPECT_EQ(fitted.curve.endPoint(CurveEnd::kEnd), pointAt(2.0));
}

TEST(FittedCurve, BeginsAndEndsPiecesAtTheBreaks) {
  const FittedCurve fitted =
      fitCurve([](double t) { return kink(t); }, std::array{-0.5, 0.0, 0.75});
  EXPECT_LE(fitted.errorMm, 1e-13);
  const auto inner = fitted.curve.innerKnots();
  EXPECT_TRUE(
      std::any_of(inner.begin(), inner.end(), [](auto knot) { return knot.parameter == 0.0; }));
  const auto left = fitted.curve.derivatives(0.0, 1, Side::kLeft)[1];
  const auto right = fitted.curve.derivatives(0.0, 1, Side::kRight)[1];
  EXPECT_NEAR(left.y(), -1.0, 1e-10);
  EXPECT_NEAR(right.y(), 1.0, 1e-10);
}

TEST(FittedCurve, StatesTheErrorThatAnUnknownBreakLeaves) {
  const FittedCurve fitted = fitCurve(kink, std::array{-0.5, 0.8});
  const double error = largestError(fitted, kink);
  EXPECT_GT(error, 1e-6);
  EXPECT_LE(error, fitted.errorMm);
  EXPECT_LE(fitted.errorMm, 0.01);
}

/// The k-th derivative of a piece of degree n and length h moves by n!/(n-k)! 2^k / h^k times what
/// its poles move.
TEST(FittedCurve, PoleErrorBoundsTheErrorOfDerivatives) {
  const FittedCurve fitted = fitCurve([](double t) { return spiral(t)[0]; }, std::array{-1.0, 2.0});
  double worst = 0.0;
  for (int span = 0; span < fitted.curve.spanCount(); ++span) {
    const BezierSegment segment = fitted.curve.segment(span);
    for (const double share : {0.0, 0.3, 0.5, 1.0}) {
      const double t = segment.first + share * segment.length();
      const auto exact = spiral(t);
      const auto derivatives =
          fitted.curve.derivatives(t, 4, share == 1.0 ? Side::kLeft : Side::kRight);
      double factor = fitted.curve.poleError();
      for (std::size_t k = 1; k <= 4; ++k) {
        factor *= (10.0 - static_cast<double>(k)) * 2.0 / segment.length();
        worst = std::max(worst, (derivatives[k] - exact[k]).norm() / factor);
        EXPECT_LE((derivatives[k] - exact[k]).norm(), 1e-6 * exact[k].norm());
      }
    }
  }
  EXPECT_LE(worst, 1.0);
}

}  // namespace
}  // namespace osculate::test
