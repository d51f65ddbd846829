#include "osculate/construction/natural.h"

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include "osculate/bezier/bernstein.h"
#include "osculate/construction/contact_error.h"
#include "osculate/differential/arc_jet.h"
#include "osculate/differential/arc_length.h"
#include "osculate/differential/jet.h"

namespace osculate {

namespace {

constexpr double kLeastWeight =
    0.5;  // of the largest, in a piece with equal end weights: 120 degrees of a circle
constexpr double kRounding = 1e-12;
constexpr int kMostPieces = 100;

double lengthOf(const BezierCurve& curve) { return length(BSplineCurve(curve)); }

/// The t in [low, high] where a growing function is zero.
template <class Function>
double rootBetween(const Function& function, double low, double high) {
  const double atLow = function(low);
  const double atHigh = function(high);
  if (atLow >= 0.0) return low;
  if (atHigh <= 0.0) return high;
  std::uintmax_t evaluations = 100;
  const auto root = boost::math::tools::toms748_solve(
      function, low, high, atLow, atHigh, boost::math::tools::eps_tolerance<double>(), evaluations);
  return 0.5 * (root.first + root.second);
}

/// The part of [1, infinity) that has the length; a polynomial curve goes on for ever.
BezierCurve polynomialPart(const BezierCurve& curve, double lengthMm) {
  const auto missing = [&](double t) { return lengthOf(curve.segment(1.0, t)) - lengthMm; };
  double last = 2.0;
  while (missing(last) < 0.0)
    last = 1.0 + 2.0 * (last - 1.0);
  const double least = last > 2.0 ? 0.5 * (1.0 + last) : 1.0 + kRounding;
  return curve.segment(1.0, rootBetween(missing, least, last));
}

/// True where a homogeneous net is that of a lower degree, raised: its polynomial vanishes at t =
/// infinity. A continuation through there would meet 0/0.
bool isRaised(const Net& net) {
  const int n = static_cast<int>(net.cols()) - 1;
  NetPoint atInfinity = NetPoint::Zero(4);
  double size = 0.0;
  for (int i = 0; i <= n; ++i) {
    atInfinity += ((n - i) % 2 == 0 ? 1.0 : -1.0) * binomial(n, i) * net.col(i);
    size += binomial(n, i) * net.col(i).norm();
  }
  constexpr double kVanishes = 1e-13;
  return n > 1 && atInfinity.norm() <= kVanishes * size;
}

/// The net of the lower degree: b*_i = i/n b_{i-1} + (1 - i/n) b_i (Farin, CAGD, sec. 6.1) solved
/// from both ends.
Net lowered(const Net& net) {
  const Eigen::Index n = net.cols() - 1;
  Net lower(4, n);
  lower.col(0) = net.col(0);
  lower.col(n - 1) = net.col(n);
  for (Eigen::Index i = 1; 2 * i < n; ++i) {
    const auto a = static_cast<double>(i);
    const auto rest = static_cast<double>(n - i);
    lower.col(i) = (static_cast<double>(n) * net.col(i) - a * lower.col(i - 1)) / rest;
    const Eigen::Index j = n - 1 - i;
    if (j > i)
      lower.col(j) = (static_cast<double>(n) * net.col(j + 1) - a * lower.col(j + 1)) / rest;
  }
  return lower;
}

/// A homogeneous net whose weights w_i become w_i rho^i: the same curve, with equal end weights of
/// 1 (Moebius transformation of the parameter: Piegl-Tiller, The NURBS Book, sec. 6.4).
void balance(Net& net) {
  const Eigen::Index n = net.cols() - 1;
  const double ratio = std::pow(net(3, 0) / net(3, n), 1.0 / static_cast<double>(n));
  double scale = 1.0 / net(3, 0);
  for (Eigen::Index i = 0; i <= n; ++i) {
    net.col(i) *= scale;
    scale *= ratio;
  }
}

/// A rational curve over its whole projective line: the angle a stands for the parameter t with
/// (1 - t) : t = cos a : sin a, so that the given segment is [0, pi/2].
class ProjectiveCurve {
 public:
  explicit ProjectiveCurve(const BezierCurve& segment) : net_(toNet(segment.view())) {
    while (isRaised(net_))
      net_ = lowered(net_);
    balance(net_);
  }

  bool isPolynomial() const { return (net_.row(3).array() - 1.0).abs().maxCoeff() <= kRounding; }
  BezierCurve polynomial() const { return fromNet(Net(net_.topRows(3))); }

  /// The part [from, to]; nothing where its weights are too uneven or not all positive.
  std::optional<BezierCurve> part(double from, double to) const {
    const Eigen::Index n = net_.cols() - 1;
    Net part(4, n + 1);
    for (Eigen::Index i = 0; i <= n; ++i)
      part.col(i) = blossom(from, n - i, to);
    if (part(3, 0) < 0.0) part = -part;  // an odd degree changes the sign every half turn
    if (!(part.row(3).minCoeff() > 0.0)) return {};
    balance(part);
    const auto weights = part.row(3);
    if (!(weights.minCoeff() > (kLeastWeight - kRounding) * weights.maxCoeff())) return {};
    return fromNet(part);
  }

 private:
  /// f(from, .., from, to, .., to) with `count` times `from`.
  NetPoint blossom(double from, Eigen::Index count, double to) const {
    Net points = net_;
    for (Eigen::Index left = net_.cols() - 1; left > 0; --left) {
      const double angle = left > net_.cols() - 1 - count ? from : to;
      for (Eigen::Index i = 0; i < left; ++i)
        points.col(i) = std::cos(angle) * points.col(i) + std::sin(angle) * points.col(i + 1);
    }
    return points.col(0);
  }

  Net net_;
};

[[noreturn]] void failToReach() {
  throw ContactError("length: the curve's own continuation would take more than " +
                     std::to_string(kMostPieces) +
                     " segments (it runs to infinity, or winds that often); take less");
}

/// The curve from its end on, in pieces with even weights: where each length is.
class Ruler {
 public:
  Ruler(const ProjectiveCurve& curve, double lengthMm) : curve_(curve), length_(lengthMm) {
    constexpr double kLargestStep = 0.25 * std::numbers::pi;
    constexpr double kSmallestStep = 1e-9;
    double step = kLargestStep;
    while (lengths_.back() < lengthMm) {
      const auto part = curve.part(angles_.back(), angles_.back() + step);
      if (part) {
        angles_.push_back(angles_.back() + step);
        lengths_.push_back(lengths_.back() + lengthOf(*part));
      }
      step = part ? std::min(2.0 * step, kLargestStep) : 0.5 * step;
      if (step < kSmallestStep || pieceCount() > kMostPieces) failToReach();
    }
  }

  int pieceCount() const { return static_cast<int>(angles_.size()) - 1; }

  double angleAt(double lengthMm) const {
    const auto above = std::lower_bound(lengths_.begin() + 1, lengths_.end() - 1, lengthMm);
    const auto i = static_cast<std::size_t>(above - lengths_.begin());
    const double from = angles_[i - 1];
    const auto missing = [&](double angle) {
      const auto part = angle > from ? curve_.part(from, angle) : std::nullopt;
      return lengths_[i - 1] + (part ? lengthOf(*part) : 0.0) - lengthMm;
    };
    return rootBetween(missing, from, angles_[i]);
  }

  /// The angles between `count` pieces of even length.
  std::vector<double> evenAngles(int count) const {
    std::vector<double> angles;
    for (int i = 0; i <= count; ++i)
      angles.push_back(angleAt(length_ * i / count));
    return angles;
  }
  /// Those between the pieces that were measured.
  std::vector<double> ownAngles() const {
    std::vector<double> angles = angles_;
    angles.back() = angleAt(length_);
    return angles;
  }

 private:
  const ProjectiveCurve& curve_;
  double length_;
  std::vector<double> angles_{0.5 * std::numbers::pi};
  std::vector<double> lengths_{0.0};
};

/// The pieces between angles; none where one has uneven weights.
std::vector<BezierCurve> piecesBetween(const std::vector<double>& angles,
                                       const ProjectiveCurve& curve) {
  std::vector<BezierCurve> pieces;
  for (std::size_t i = 1; i < angles.size(); ++i) {
    const auto piece = curve.part(angles[i - 1], angles[i]);
    if (!piece) return {};
    pieces.push_back(*piece);
  }
  return pieces;
}

/// As few pieces of even length as have even weights, but not more than uneven ones.
std::vector<BezierCurve> rationalPieces(const ProjectiveCurve& curve, double lengthMm) {
  const Ruler ruler(curve, lengthMm);
  for (int count = 1; count <= ruler.pieceCount(); ++count) {
    std::vector<BezierCurve> pieces = piecesBetween(ruler.evenAngles(count), curve);
    if (!pieces.empty()) return pieces;
  }
  return piecesBetween(ruler.ownAngles(), curve);
}

/// |P'| at the start or the end of a curve with end weights 1.
double speedAt(const BezierCurve& curve, CurveEnd end) {
  const auto jet = endJet<1>(curve.view(), end, 0.0);
  return jet.c[1].norm();
}

/// One curve of the pieces over [0, 1], with continuous speed: each has an interval as long as its
/// speed asks for.
BSplineCurve joined(const std::vector<BezierCurve>& pieces) {
  const int n = pieces.front().degree();
  std::vector<double> ends{0.0};
  double rate = 1.0;  // per unit of the parameter, at the end of the piece before
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const double interval = i == 0 ? 1.0 : speedAt(pieces[i], CurveEnd::kStart) / rate;
    rate = speedAt(pieces[i], CurveEnd::kEnd) / interval;
    ends.push_back(ends.back() + interval);
  }
  BSplineData data;
  data.degree = n;
  data.poles.resize(3, n * static_cast<Eigen::Index>(pieces.size()) + 1);
  data.weights.assign(static_cast<std::size_t>(data.poles.cols()), 1.0);
  for (std::size_t i = 0; i <= pieces.size(); ++i) {
    data.knots.knots.push_back(i == pieces.size() ? 1.0 : ends[i] / ends.back());
    data.knots.multiplicities.push_back(i == 0 || i == pieces.size() ? n + 1 : n);
  }
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    for (int k = i == 0 ? 0 : 1; k <= n; ++k) {
      const Eigen::Index at = static_cast<Eigen::Index>(i) * n + k;
      data.poles.col(at) = pieces[i].pole(k);
      data.weights[static_cast<std::size_t>(at)] = pieces[i].weight(k);
    }
  }
  return BSplineCurve(std::move(data));
}

BSplineCurve continued(const BezierCurve& segment, double lengthMm) {
  if (!segment.isRational()) return BSplineCurve(polynomialPart(segment, lengthMm));
  const ProjectiveCurve projective(segment);
  if (projective.isPolynomial())
    return BSplineCurve(polynomialPart(projective.polynomial(), lengthMm));
  return joined(rationalPieces(projective, lengthMm));
}

/// Without the rounding of the first pole.
BSplineCurve startingAt(const Vector3& point, const BSplineCurve& curve) {
  BSplineData data = curve.data();
  data.poles.col(0) = point;
  return BSplineCurve(std::move(data));
}

}  // namespace

BSplineCurve naturalContinuation(const BSplineCurve& curve, CurveEnd end, double lengthMm) {
  if (!(std::isfinite(lengthMm) && lengthMm > 0.0))
    throw std::invalid_argument("length: must be finite and > 0");
  const BezierSegment last = curve.endSegment(end);
  if (isSingular(endJet<1>(last.curve.view(), end, last.poleError))) {
    throw ContactError(
        "natural: the curve's end is singular (repeated poles), so that it may turn back there; "
        "take an order of contact");
  }
  const BezierCurve segment = end == CurveEnd::kEnd ? last.curve : last.curve.reversed();
  return startingAt(segment.pole(segment.degree()), continued(segment, lengthMm));
}

}  // namespace osculate
