#include "osculate/occt/conic_arc.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace osculate {

namespace {

/// Bound of the rounding of a pole, centre + (x cos u + y sin u) / cos d, or the like: eight units
/// for axes, functions, products, sum and quotient, u that is rounded itself, and the sum with the
/// centre. `growth` bounds the functions.
double roundingBound(const ConicAxes& axes, double growth, double largestParameter) {
  const double axesSize = growth * (axes.x.norm() + axes.y.norm());
  return kUnitRoundoff * (2.0 * axes.centre.norm() + (8.0 + 2.0 * largestParameter) * axesSize);
}

double largestParameter(double first, double last) {
  return std::max(std::abs(first), std::abs(last));
}

/// Far more than any arc has: 256 turns; the hyperbola overflows at 710 in its parameter.
constexpr double kMostPieces = 1024;

struct Circular {
  static double cosine(double u) { return std::cos(u); }
  static double sine(double u) { return std::sin(u); }
  static double growth(double, double) { return std::numbers::sqrt2; }  // 1 / cos 45 degrees
  static constexpr double kLongestPiece = 0.5 * std::numbers::pi;
};

struct Hyperbolic {
  static double cosine(double u) { return std::cosh(u); }
  static double sine(double u) { return std::sinh(u); }
  static double growth(double first, double last) {
    return std::cosh(largestParameter(first, last));
  }
  static constexpr double kLongestPiece = 1.0;
};

int pieceCount(double range, double longestPiece) {
  // a range that is a whole number of pieces but for rounding gets no piece more
  const double pieces = std::ceil(range / longestPiece - 1e-9);
  if (!(pieces <= kMostPieces)) {
    throw std::invalid_argument("edge: its range on a conic is too long, " + std::to_string(range));
  }
  return std::max(1, static_cast<int>(pieces));
}

template <typename Functions>
Vector3 pointAt(const ConicAxes& axes, double u) {
  return axes.centre + Functions::cosine(u) * axes.x + Functions::sine(u) * axes.y;
}

/// The piece [m - d, m + d] of centre + x cos u + y sin u has the poles P(m - d), S, P(m + d) and
/// the weights 1, cos d, 1, S = centre + (x cos m + y sin m) / cos d (Piegl-Tiller, The NURBS Book,
/// sec. 7.3); cosh and sinh for the hyperbola, by the same identities with imaginary arguments.
template <typename Functions>
BSplineCurve rationalArc(const ConicAxes& axes, double first, double last) {
  const int pieces = pieceCount(last - first, Functions::kLongestPiece);
  BSplineData data{.poles = Poles(3, 2 * pieces + 1),
                   .weights = {1.0},
                   .knots = {{first}, {3}},
                   .degree = 2,
                   .periodic = false,
                   .poleError = 0.0};
  data.poles.col(0) = pointAt<Functions>(axes, first);
  for (int i = 1; i <= pieces; ++i) {
    const double begin = data.knots.knots.back();
    const double end = i == pieces ? last : first + i * (last - first) / pieces;
    const double cosine = Functions::cosine(0.5 * (end - begin));
    const Vector3 onArc =
        pointAt<Functions>({Vector3::Zero(), axes.x, axes.y}, 0.5 * (begin + end));
    data.poles.col(2 * i - 1) = axes.centre + onArc / cosine;
    data.poles.col(2 * i) = pointAt<Functions>(axes, end);
    data.weights.insert(data.weights.end(), {cosine, 1.0});
    data.knots.knots.push_back(end);
    data.knots.multiplicities.push_back(i == pieces ? 3 : 2);
  }
  data.poleError =
      roundingBound(axes, Functions::growth(first, last), largestParameter(first, last));
  return BSplineCurve(std::move(data));
}

}  // namespace

BSplineCurve ellipticArc(const ConicAxes& axes, double first, double last) {
  BSplineCurve arc = rationalArc<Circular>(axes, first, last);
  constexpr double kTurn = 2.0 * std::numbers::pi;
  if (std::abs(last - first - kTurn) > 8.0 * kUnitRoundoff * (kTurn + std::abs(first))) return arc;
  BSplineData closed = arc.data();
  closed.poles.rightCols<1>() = closed.poles.col(0);
  return BSplineCurve(std::move(closed));
}

BSplineCurve hyperbolicArc(const ConicAxes& axes, double first, double last) {
  return rationalArc<Hyperbolic>(axes, first, last);
}

BSplineCurve parabolicArc(const ConicAxes& axes, double first, double last) {
  // the poles are the blossom: u^2 at (first, last) is first last, u is their mean
  const auto blossom = [&](double a, double b) -> Vector3 {
    return axes.centre + a * b * axes.x + 0.5 * (a + b) * axes.y;
  };
  const double u = largestParameter(first, last);
  const std::array<Vector3, 3> poles{blossom(first, first), blossom(first, last),
                                     blossom(last, last)};
  return BSplineCurve(BezierCurve(poles), first, last,
                      roundingBound({axes.centre, u * u * axes.x, u * axes.y}, 1.0, 0.0));
}

BSplineCurve lineSegment(const Vector3& origin, const Vector3& direction, double first,
                         double last) {
  const std::array<Vector3, 2> poles{origin + first * direction, origin + last * direction};
  const double u = largestParameter(first, last);
  return BSplineCurve(BezierCurve(poles), first, last,
                      roundingBound({origin, u * direction, Vector3::Zero()}, 1.0, 0.0));
}

}  // namespace osculate
