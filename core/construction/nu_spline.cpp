#include "osculate/construction/nu_spline.h"

#include <Eigen/SparseCholesky>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "osculate/bezier/spline_net.h"

namespace osculate {

namespace {

using Matrix = Eigen::SparseMatrix<double>;
/// A row for each point: what the solver takes.
using Rows = Eigen::Matrix<double, Eigen::Dynamic, 3>;

/// A point of a closed curve follows the last one: spans are numbered by their first point.
struct Task {
  const Poles& points;
  const NuSplineOptions& options;
  std::vector<double> parameters;  ///< of the points, then of the end of the period
  std::vector<double> nu;

  int count() const { return static_cast<int>(points.cols()); }
  int spans() const { return options.closed ? count() : count() - 1; }
  int next(int i) const { return i + 1 == count() ? 0 : i + 1; }
  double step(int span) const {
    const auto i = static_cast<std::size_t>(span);
    return parameters[i + 1] - parameters[i];
  }
  Vector3 difference(int span) const { return points.col(next(span)) - points.col(span); }
};

void checkPoints(const Poles& points, bool closed) {
  const Eigen::Index least = closed ? 3 : 2;
  if (points.cols() < least) {
    throw std::invalid_argument("points: at least " + std::to_string(least) + " are needed" +
                                (closed ? " for a closed curve" : "") + ", got " +
                                std::to_string(points.cols()));
  }
  if (!points.allFinite()) {
    throw std::invalid_argument("points: every coordinate must be finite (found NaN or infinity)");
  }
  if ((points.colwise() - points.col(0)).isZero(0.0))
    throw std::invalid_argument("points: all are one point");
}

std::string pair(const Task& task, int span) {
  return "points[" + std::to_string(span) + "] and points[" + std::to_string(task.next(span)) + "]";
}

/// From 0 to the length of the polygon.
std::vector<double> chosenParameters(const Task& task) {
  const Spacing spacing = task.options.spacing;
  const double exponent =
      spacing == Spacing::kUniform ? 0.0 : (spacing == Spacing::kChordal ? 1.0 : 0.5);
  std::vector<double> sums{0.0};
  double length = 0.0;
  for (int span = 0; span < task.spans(); ++span) {
    const double distance = task.difference(span).norm();
    if (distance == 0.0) {
      throw std::invalid_argument("points: " + pair(task, span) + " are one point" +
                                  (span + 1 == task.count() ? "; a closed curve returns to its "
                                                              "first point by itself"
                                                            : ", and no parameters are given"));
    }
    sums.push_back(sums.back() + std::pow(distance, exponent));
    length += distance;
  }
  const double scale = length / sums.back();
  for (double& sum : sums)
    sum *= scale;
  sums.back() = length;
  for (int span = 0; span < task.spans(); ++span) {
    const auto i = static_cast<std::size_t>(span);
    if (!(sums[i] < sums[i + 1])) {
      throw std::invalid_argument("points: " + pair(task, span) +
                                  " are too near for parameters that differ; give parameters");
    }
  }
  return sums;
}

std::vector<double> givenParameters(const Task& task) {
  const std::vector<double>& given = task.options.parameters;
  const auto wanted = static_cast<std::size_t>(task.spans()) + 1;
  if (given.size() != wanted) {
    throw std::invalid_argument("parameters: " + std::to_string(wanted) +
                                " are needed, one for each point" +
                                (task.options.closed ? " and the end of the period" : "") +
                                ", got " + std::to_string(given.size()));
  }
  for (std::size_t i = 0; i < given.size(); ++i) {
    if (!std::isfinite(given[i]) || (i > 0 && !(given[i - 1] < given[i]))) {
      throw std::invalid_argument("parameters: must be finite and increase, but number " +
                                  std::to_string(i) + " is " + std::to_string(given[i]));
    }
  }
  return given;
}

/// 1/2 (1/h before + 1/h behind), of one step where there is only one.
double meanInverseStep(const Task& task, int i) {
  const bool first = i == 0 && !task.options.closed;
  const bool last = i + 1 == task.count() && !task.options.closed;
  if (first) return 1.0 / task.step(0);
  const double before = 1.0 / task.step(i == 0 ? task.count() - 1 : i - 1);
  return last ? before : 0.5 * (before + 1.0 / task.step(i));
}

std::vector<double> nuOf(const Task& task) {
  const std::vector<double>& tension = task.options.tension;
  const auto count = static_cast<std::size_t>(task.count());
  if (tension.size() != 1 && tension.size() != count) {
    throw std::invalid_argument("tension: one number, or one for each of the " +
                                std::to_string(count) + " points, is needed, got " +
                                std::to_string(tension.size()));
  }
  std::vector<double> nu;
  for (std::size_t i = 0; i < count; ++i) {
    const double value = tension.size() == 1 ? tension[0] : tension[i];
    if (!(std::isfinite(value) && value >= 0.0)) {
      throw std::invalid_argument("tension: must be finite and >= 0, got " + std::to_string(value));
    }
    nu.push_back(value == 0.0 ? 0.0 : value * meanInverseStep(task, static_cast<int>(i)));
  }
  return nu;
}

/// The derivative at the first point of the parabola through the first three, or at the last one
/// of that through the last three (Bessel's end condition: Farin, CAGD); of two points the chord's.
Vector3 besselDerivative(const Task& task, bool atEnd) {
  const int spans = task.spans();
  const int near = atEnd ? spans - 1 : 0;
  Vector3 slope = task.difference(near) / task.step(near);
  if (spans == 1) return slope;
  const int far = atEnd ? spans - 2 : 1;
  const Vector3 other = task.difference(far) / task.step(far);
  const double share = task.step(near) / (task.step(near) + task.step(far));
  return slope - share * (other - slope);
}

Vector3 givenDerivative(const Task& task, bool atEnd) {
  const NuSplineEnd& end = task.options.ends[atEnd ? 1 : 0];
  if (end.kind == NuSplineEnd::Kind::kBessel) return besselDerivative(task, atEnd);
  if (!end.tangent.allFinite() || end.tangent.isZero(0.0)) {
    throw std::invalid_argument("ends: a tangent must be finite and not zero");
  }
  const int span = atEnd ? task.spans() - 1 : 0;
  return task.difference(span).norm() / task.step(span) * end.tangent;
}

/// The equations for the derivatives P'_i, with a_i = 1/h_i (theorem 1.10 of the textbook, row i
/// corrected): a_{i-1} P'_{i-1} + (2 (a_{i-1} + a_i) + nu_i/2) P'_i + a_i P'_{i+1} =
/// 3 (a_{i-1}^2 (P_i - P_{i-1}) + a_i^2 (P_{i+1} - P_i)). At natural ends the span outside is
/// missing. Every span adds a symmetric block: the matrix is positive definite.
class Equations {
 public:
  explicit Equations(const Task& task) : task_(task), sides_(Rows::Zero(task.count(), 3)) {
    for (int i = 0; i < task.count(); ++i)
      add(i, i, 0.5 * task.nu[static_cast<std::size_t>(i)]);
    for (int span = 0; span < task.spans(); ++span) {
      const double a = 1.0 / task.step(span);
      const Vector3 side = 3.0 * a * a * task.difference(span);
      const int next = task.next(span);
      add(span, span, 2.0 * a);
      add(next, next, 2.0 * a);
      add(span, next, a);
      add(next, span, a);
      sides_.row(span) += side;
      sides_.row(next) += side;
    }
  }

  /// Puts P'_i in place of its equation; its neighbour is `neighbour`, over the span `span`.
  void fix(int i, int neighbour, int span, const Vector3& derivative) {
    sides_.row(neighbour) -= derivative / task_.step(span);
    for (Eigen::Triplet<double>& entry : entries_) {
      if (entry.row() == i || entry.col() == i) entry = {entry.row(), entry.col(), 0.0};
    }
    add(i, i, 1.0);
    fixed_.emplace_back(i, derivative);
  }

  Rows solve() {
    for (const auto& [i, derivative] : fixed_)  // last: of two points each is the other's neighbour
      sides_.row(i) = derivative;
    Matrix matrix(task_.count(), task_.count());
    matrix.setFromTriplets(entries_.begin(), entries_.end());
    const Eigen::SimplicialLDLT<Matrix> factors(matrix);
    Rows derivatives = factors.solve(sides_);
    if (factors.info() != Eigen::Success || !derivatives.allFinite()) {
      throw std::invalid_argument("points: their equations leave the range of doubles");
    }
    return derivatives;
  }

 private:
  void add(int row, int column, double value) { entries_.emplace_back(row, column, value); }

  const Task& task_;
  std::vector<Eigen::Triplet<double>> entries_;
  std::vector<std::pair<int, Vector3>> fixed_;
  Rows sides_;
};

Rows derivativesOf(const Task& task) {
  Equations equations(task);
  const int last = task.count() - 1;
  const auto& ends = task.options.ends;
  if (!task.options.closed && ends[0].kind != NuSplineEnd::Kind::kNatural) {
    equations.fix(0, 1, 0, givenDerivative(task, false));
  }
  if (!task.options.closed && ends[1].kind != NuSplineEnd::Kind::kNatural) {
    equations.fix(last, last - 1, last - 1, givenDerivative(task, true));
  }
  return equations.solve();
}

/// The poles of a cubic B-spline from points and derivatives at its knots.
class HermitePoles {
 public:
  HermitePoles(const Task& task, const Rows& derivatives)
      : task_(task), derivatives_(derivatives) {}

  /// The blossom at three knots that follow each other, given by the numbers of their points; of a
  /// closed curve these go on beyond its last point.
  Vector3 at(int a, int b, int c) const {
    if (a == c) return task_.points.col(turned(b));
    if (a == b) return after(b);
    if (b == c) return before(b);
    // a simple knot, C2: on the longer of the spans beside it the blossom is a smaller
    // extrapolation
    const double left = task_.step(turned(a));
    const double right = task_.step(turned(b));
    if (left >= right) return after(a) + (left + right) / left * (before(b) - after(a));
    return after(b) - left / right * (before(c) - after(b));
  }

 private:
  int turned(int i) const { return i % task_.count(); }
  /// The inner Bézier poles of the spans behind and before a point.
  Vector3 after(int i) const {
    const int k = turned(i);
    return task_.points.col(k) + task_.step(k) / 3.0 * derivatives_.row(k).transpose();
  }
  Vector3 before(int i) const {
    const int k = turned(i);
    return task_.points.col(k) - task_.step(turned(i - 1)) / 3.0 * derivatives_.row(k).transpose();
  }

  const Task& task_;
  const Rows& derivatives_;
};

BSplineCurve curveOf(const Task& task, const Rows& derivatives) {
  SplineNet net{.degree = 3, .rational = false, .flat = {}, .poles = {}, .period = 0.0};
  const int count = task.count();
  std::vector<int> points;  // the number of the point at each flat knot
  for (int i = 0; i < count; ++i) {
    const bool isEnd = !task.options.closed && (i == 0 || i + 1 == count);
    const auto k = static_cast<std::size_t>(i);
    const std::size_t copies = isEnd ? 4 : (task.nu[k] > 0.0 ? 2 : 1);
    net.flat.insert(net.flat.end(), copies, task.parameters[k]);
    points.insert(points.end(), copies, i);
  }
  if (task.options.closed) {
    net.period = task.parameters.back() - task.parameters.front();
    for (std::size_t i = 0; i < 3; ++i)  // pole i stands over the flat knots i+1 .. i+3
      points.push_back(points[i] + count);
  }
  const HermitePoles poles(task, derivatives);
  const std::size_t poleCount = task.options.closed ? net.flat.size() : net.flat.size() - 4;
  for (std::size_t i = 0; i < poleCount; ++i) {
    const Vector3 pole = poles.at(points[i + 1], points[i + 2], points[i + 3]);
    net.poles.emplace_back(pole.homogeneous());
  }
  return osculate::curveOf(net);
}

}  // namespace

BSplineCurve nuSpline(const Poles& points, const NuSplineOptions& options) {
  checkPoints(points, options.closed);
  Task task{points, options, {}, {}};
  task.parameters = options.parameters.empty() ? chosenParameters(task) : givenParameters(task);
  task.nu = nuOf(task);
  return curveOf(task, derivativesOf(task));
}

}  // namespace osculate
