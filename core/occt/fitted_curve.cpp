#include "osculate/occt/fitted_curve.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/LU>

#include "osculate/bezier/bernstein.h"

namespace osculate {

namespace {

/// High enough that a piece of a smooth curve is long (40 degrees of a circle at rounding level),
/// low enough that its poles are well conditioned.
constexpr int kFitDegree = 9;
constexpr int kMostHalvings = 8;
/// Evaluation through a surface or an offset rounds some tens of times.
constexpr double kEvaluationUlps = 64.0;
/// From the largest deviation found to the largest there is: between two nodes one point is tried.
constexpr double kSafety = 4.0;
/// Largest pole of a polynomial of degree 9 that is at most 1 on [0, 1]: C(18, 8) / C(9, 4), the
/// largest Bernstein coefficient C(2n, 2i) / C(n, i) of the Chebyshev polynomial (Lyche and
/// Scherer, "On the p-norm condition number of the multivariate triangular Bernstein basis", 2000).
constexpr double kPoleCondition = 43758.0 / 126.0;

using FitPoles = Eigen::Matrix<double, 3, kFitDegree + 1>;

struct Piece {
  double first;
  double last;
  FitPoles poles;
  double deviation;
};

/// Chebyshev points of the second kind on [0, 1], ends included.
double node(int i) { return 0.5 - 0.5 * std::cos(i * std::numbers::pi / kFitDegree); }
/// Between node i and the next one, where the interpolation error is about largest.
double betweenNodes(int i) {
  return 0.5 - 0.5 * std::cos((i + 0.5) * std::numbers::pi / kFitDegree);
}

/// Maps values at the nodes to Bernstein coefficients.
const Eigen::MatrixXd& coefficientsFromValues() {
  static const Eigen::MatrixXd kInverse = [] {
    Eigen::MatrixXd values(kFitDegree + 1, kFitDegree + 1);
    for (int i = 0; i <= kFitDegree; ++i)
      values.col(i) = bernstein(kFitDegree, node(i));
    return Eigen::MatrixXd(values.inverse());
  }();
  return kInverse;
}

class Fitter {
 public:
  Fitter(const std::function<Vector3(double)>& pointAt, std::span<const double> breaks)
      : pointAt_(pointAt) {
    for (std::size_t i = 1; i < breaks.size(); ++i)
      fit(breaks[i - 1], breaks[i], kMostHalvings);
  }

  FittedCurve joined() const {
    const auto count = static_cast<Eigen::Index>(pieces_.size());
    BSplineData data{.poles = Poles(3, kFitDegree * count + 1),
                     .weights = {},
                     .knots = {{pieces_.front().first}, {kFitDegree + 1}},
                     .degree = kFitDegree,
                     .periodic = false,
                     .poleError = 0.0};
    double deviation = 0.0;
    for (Eigen::Index i = 0; i < count; ++i) {
      const Piece& piece = pieces_[static_cast<std::size_t>(i)];
      data.poles.middleCols<kFitDegree + 1>(kFitDegree * i) = piece.poles;
      data.knots.knots.push_back(piece.last);
      data.knots.multiplicities.push_back(i + 1 == count ? kFitDegree + 1 : kFitDegree);
      deviation = std::max(deviation, piece.deviation);
    }
    const double error = kSafety * deviation + kUnitRoundoff * largestNorm_;
    data.poleError = kPoleCondition * error;
    return {BSplineCurve(std::move(data)), error};
  }

 private:
  void fit(double first, double last, int halvings) {
    const Piece piece = interpolated(first, last);
    const double middle = 0.5 * (first + last);
    const bool divisible = halvings > 0 && first < middle && middle < last;
    if (piece.deviation <= kEvaluationUlps * kUnitRoundoff * largestNorm_ || !divisible) {
      pieces_.push_back(piece);
      return;
    }
    fit(first, middle, halvings - 1);
    fit(middle, last, halvings - 1);
  }

  /// Interpolates the difference from the chord: its values are small, and so is their rounding.
  Piece interpolated(double first, double last) {
    const auto parameter = [&](double t) { return (1.0 - t) * first + t * last; };
    const Vector3 start = pointAt_(first);
    const Vector3 end = pointAt_(last);
    const auto chord = [&](double t) -> Vector3 { return (1.0 - t) * start + t * end; };
    FitPoles differences = FitPoles::Zero();
    for (int i = 1; i < kFitDegree; ++i) {
      differences.col(i) = pointAt_(parameter(node(i))) - chord(node(i));
    }
    Piece piece{first, last, differences * coefficientsFromValues(), 0.0};
    for (int i = 0; i <= kFitDegree; ++i)
      piece.poles.col(i) += chord(double(i) / kFitDegree);
    piece.poles.col(0) = start;
    piece.poles.col(kFitDegree) = end;
    for (int i = 0; i < kFitDegree; ++i) {
      const double t = betweenNodes(i);
      const Vector3 expected = pointAt_(parameter(t));
      const Vector3 fitted = piece.poles * bernstein(kFitDegree, t);
      piece.deviation = std::max(piece.deviation, (fitted - expected).norm());
      largestNorm_ = std::max(largestNorm_, expected.norm());
    }
    return piece;
  }

  const std::function<Vector3(double)>& pointAt_;
  std::vector<Piece> pieces_;
  double largestNorm_ = 0.0;
};

}  // namespace

FittedCurve fitCurve(const std::function<Vector3(double)>& pointAt,
                     std::span<const double> breaks) {
  return Fitter(pointAt, breaks).joined();
}

}  // namespace osculate
