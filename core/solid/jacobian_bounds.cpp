// The range of the Jacobian by bisection of the domain.
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "osculate/solid/domain_part.h"
#include "osculate/solid/jacobian.h"

namespace osculate {

namespace {

struct Interval {
  double low;
  double high;
};

/// numerator / weight^4 for a weight in [w.low, w.high], w.low >= 0.
Interval divided(const Interval& numerator, const Interval& weight) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const auto quotient = [](double a, double w) {
    const double power = w * w * w * w;
    if (power > 0.0) return a / power;
    return a == 0.0 ? 0.0 : std::copysign(kInfinity, a);
  };
  return {quotient(numerator.low, numerator.low < 0.0 ? weight.low : weight.high),
          quotient(numerator.high, numerator.high > 0.0 ? weight.low : weight.high)};
}

/// A part of the domain with the numerator and the weight of J over it.
struct Piece {
  DomainPart numerator;
  DomainPart weight;
  Interval range{};

  Piece(DomainPart n, DomainPart w) : numerator(std::move(n)), weight(std::move(w)) {
    range =
        divided({numerator.low(), numerator.high()}, {std::max(0.0, weight.low()), weight.high()});
  }

  Piece bisect() {
    Piece other(numerator.bisect(), weight.bisect());
    *this = Piece(std::move(numerator), std::move(weight));
    return other;
  }
};

class Bounder {
 public:
  Bounder(const JacobianNumerator& numerator, const BezierTetrahedron& solid) {
    Eigen::RowVectorXd weights = Eigen::RowVectorXd::Ones(solid.size());
    for (int i = 0; i < solid.size(); ++i)
      weights[i] = solid.weight(i);
    push(Piece(DomainPart(numerator.coefficients, numerator.errors, numerator.degree),
               DomainPart(weights, Eigen::RowVectorXd::Zero(solid.size()), solid.degree())));
  }

  /// Bisects every piece that reaches beyond the values seen by more than the tolerance.
  JacobianBounds run(double tolerance, int maxParts) {
    JacobianBounds bounds{seen_.low, seen_.high, true};
    for (int parts = 1; !pieces_.empty(); parts += 2) {
      Piece piece = std::move(pieces_.back());
      pieces_.pop_back();
      const double allowed = tolerance * std::max(std::abs(seen_.low), std::abs(seen_.high));
      const bool accepted = excess(piece) <= allowed;
      if (accepted || parts >= maxParts) {
        bounds.low = std::min(bounds.low, piece.range.low);
        bounds.high = std::max(bounds.high, piece.range.high);
        bounds.reached = bounds.reached && accepted;
        continue;
      }
      push(piece.bisect());
      push(std::move(piece));
    }
    bounds.low = std::min(bounds.low, seen_.low);
    bounds.high = std::max(bounds.high, seen_.high);
    return bounds;
  }

 private:
  /// How far the range of a piece reaches beyond the values that J is known to take.
  double excess(const Piece& piece) const {
    return std::max(seen_.low - piece.range.low, piece.range.high - seen_.high);
  }

  void push(Piece piece) {
    for (int c = 0; c < 4; ++c) {
      const double w = piece.weight.cornerValue(c);
      if (!(w > 0.0)) continue;
      const double value = piece.numerator.cornerValue(c) / (w * w * w * w);
      seen_.low = std::min(seen_.low, value);
      seen_.high = std::max(seen_.high, value);
    }
    pieces_.push_back(std::move(piece));
  }

  std::vector<Piece> pieces_;
  Interval seen_{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
};

}  // namespace

JacobianBounds jacobianBounds(const BezierTetrahedron& solid, double tolerance, int maxParts) {
  if (!(std::isfinite(tolerance) && tolerance > 0.0)) {
    throw std::invalid_argument("tolerance: must be finite and > 0, got " +
                                std::to_string(tolerance));
  }
  return Bounder(jacobianNumerator(solid), solid).run(tolerance, maxParts);
}

}  // namespace osculate
