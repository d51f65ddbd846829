#include "osculate/construction/extend_problem.h"

#include <algorithm>
#include <cmath>

#include "osculate/bezier/bernstein.h"
#include "osculate/bezier/index.h"
#include "osculate/differential/arc_jet.h"

namespace osculate {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// d u_l / d C_k along the tangent: u_l = C(n,l) sum_k (-1)^(l-k) C(l,k) c_k.
double seriesFactor(int degree, int l, int k) {
  return ((l - k) % 2 == 0 ? 1.0 : -1.0) * binomial(degree, l) * binomial(l, k);
}

/// Rows: two unit vectors at right angles to a vector and to each other.
Eigen::Matrix<double, 2, 3> planeAcross(const Vector3& vector) {
  Eigen::Matrix<double, 2, 3> plane;
  plane.row(0) = vector.unitOrthogonal();
  plane.row(1) = vector.normalized().cross(plane.row(0).transpose());
  return plane;
}

Eigen::Map<const VectorXd> flat(const BoundedPoles& poles) { return {poles.data(), poles.size()}; }

}  // namespace

/// Collects conditions, a known number of them.
class ExtendProblem::Rows {
 public:
  Rows(Index count, Index unknowns) {
    conditions_.values = VectorXd::Zero(count);
    conditions_.jacobian = Eigen::MatrixXd::Zero(count, unknowns);
  }
  /// The next rows: their values, and their derivatives to be added to zero.
  auto next(const VectorXd& values) {
    conditions_.values.segment(used_, values.size()) = values;
    used_ += values.size();
    return conditions_.jacobian.middleRows(used_ - values.size(), values.size());
  }
  auto next(double value) {
    conditions_.values[used_] = value;
    return conditions_.jacobian.row(used_++);
  }
  Conditions take() && { return std::move(conditions_); }

 private:
  Conditions conditions_;
  Index used_ = 0;
};

ExtendProblem::ExtendProblem(const ExtendTask& task, Fairness fairness, Quadrature quadrature)
    : task_(task),
      order_(task.jet.overTangent.order),
      attached_(std::min(order_, task.degree)),
      fairness_(task.degree, fairness, quadrature),
      quadrature_(quadrature) {
  for (int k = 1; k <= attached_; ++k)
    firstPole_ += isGiven(k) ? 0 : 1;
  size_ = firstPole_ + 3 * (task_.degree - attached_);
}

ExtendProblem::Coordinates ExtendProblem::coordinates(const VectorXd& unknowns) const {
  Coordinates along{};
  Index next = 0;
  for (int k = 1; k <= attached_; ++k) {
    if (isGiven(k)) {
      along[index(k)] = *task_.tangential[index(k - 1)];
    } else {
      const double x = unknowns[next++];
      along[index(k)] = along[index(k - 1)] + step() * (k == 1 ? task_.leastStep + x * x : x);
    }
  }
  return along;
}

VectorXd ExtendProblem::unknownsOf(const Coordinates& along) const {
  constexpr double kOffBound = 1e-3;
  VectorXd unknowns = VectorXd::Zero(size_);
  Index next = 0;
  for (int k = 1; k <= attached_; ++k) {
    if (isGiven(k)) continue;
    const double x = (along[index(k)] - along[index(k - 1)]) / step();
    unknowns[next++] = k == 1 ? std::sqrt(std::max(x - task_.leastStep, kOffBound)) : x;
  }
  return unknowns;
}

ArcLengthSeries ExtendProblem::series(const Coordinates& along) const {
  ArcLengthSeries u{};
  for (int l = 1; l <= attached_; ++l) {
    for (int k = 1; k <= l; ++k)
      u[index(l - 1)] += seriesFactor(task_.degree, l, k) * along[index(k)];
  }
  return u;
}

/// The poles that the contact leaves free, from its last pole evenly to the targets.
void ExtendProblem::setFreePoles(BoundedPoles& poles) const {
  const int n = task_.degree;
  const Vector3 leaving =
      attached_ == 0 ? task_.tangent
                     : Vector3((poles.col(attached_) - poles.col(attached_ - 1)).normalized());
  const auto& direction = task_.targets.direction;
  const Vector3 arriving = direction ? direction->normalized() : leaving;
  const int count = n - attached_;
  for (int i = 1; i <= count; ++i) {
    const double share = static_cast<double>(i) / count;
    poles.col(attached_ + i) =
        poles.col(attached_ + i - 1) + step() * ((1.0 - share) * leaving + share * arriving);
  }
  if (!task_.targets.point) return;
  const Vector3 miss = *task_.targets.point - poles.col(n);
  for (int i = 1; i <= count; ++i)
    poles.col(attached_ + i) += static_cast<double>(i) / count * miss;
}

void ExtendProblem::storeFreePoles(const BoundedPoles& poles, VectorXd& unknowns) const {
  for (int i = attached_ + 1; i <= task_.degree; ++i) {
    unknowns.segment<3>(firstPole_ + 3 * (i - attached_ - 1)) =
        (poles.col(i) - task_.jet.overTangent.r[0]) / task_.unit;
  }
}

VectorXd ExtendProblem::start(double speed, double growth) const {
  Coordinates along{};
  double leg = speed * step();
  for (int k = 1; k <= attached_; ++k, leg *= growth)
    along[index(k)] = along[index(k - 1)] + leg;
  VectorXd unknowns = unknownsOf(along);
  BoundedPoles all = poles(unknowns);
  setFreePoles(all);
  storeFreePoles(all, unknowns);
  return unknowns;
}

VectorXd ExtendProblem::startFrom(const ArcLengthSeries& u) const {
  Coordinates along{};
  for (int k = 1; k <= attached_; ++k) {
    for (int l = 1; l <= k; ++l)
      along[index(k)] += binomial(k, l) / binomial(task_.degree, l) * u[index(l - 1)];
  }
  return unknownsOf(along);
}

VectorXd ExtendProblem::startFrom(const BezierCurve& curve) const {
  const Vector3 origin = task_.jet.overTangent.r[0];
  Coordinates along{};
  for (int k = 1; k <= attached_; ++k)
    along[index(k)] = task_.tangent.dot(curve.pole(k) - origin);
  VectorXd unknowns = unknownsOf(along);
  BoundedPoles all(3, task_.degree + 1);
  for (int i = 0; i <= task_.degree; ++i)
    all.col(i) = curve.pole(i);
  storeFreePoles(all, unknowns);
  return unknowns;
}

void ExtendProblem::setPoles(Sample& sample) const {
  sample.u = series(coordinates(sample.unknowns));
  sample.taylor = attachedTaylor(task_.jet.overTangent, sample.u);
  sample.poles.resize(3, task_.degree + 1);
  sample.poles.leftCols(attached_ + 1) =
      polesOfTaylor(sample.taylor.leftCols(attached_ + 1), task_.degree);
  for (int i = attached_ + 1; i <= task_.degree; ++i) {
    sample.poles.col(i) =
        task_.jet.overTangent.r[0] +
        task_.unit * sample.unknowns.segment<3>(firstPole_ + 3 * (i - attached_ - 1));
  }
}

void ExtendProblem::setDerivatives(Sample& sample) const {
  ByCoordinates<kMaxOrder + 1> coordinateBy =  // row k: of c_k, c_0 = 0
      ByCoordinates<kMaxOrder + 1>::Zero(attached_ + 1, firstPole_);
  Index next = 0;
  for (int k = 1; k <= attached_; ++k) {
    if (isGiven(k)) continue;
    coordinateBy.row(k) = coordinateBy.row(k - 1);
    coordinateBy(k, next) = step() * (k == 1 ? 2.0 * sample.unknowns[next] : 1.0);
    ++next;
  }
  sample.seriesBy.setZero(attached_, firstPole_);
  for (int l = 1; l <= attached_; ++l) {
    for (int k = 1; k <= l; ++k)
      sample.seriesBy.row(l - 1) += seriesFactor(task_.degree, l, k) * coordinateBy.row(k);
  }
  std::array<BoundedPoles, kMaxOrder> change;
  attachedTaylorDerivatives(task_.jet.overTangent, sample.u, change);
  sample.taylorBy.setZero(3 * (order_ + 1), firstPole_);
  for (int l = 1; l <= attached_; ++l) {
    // q_k changes from k = l on
    const Index first = 3 * l;
    const Index count = sample.taylorBy.rows() - first;
    for (Index j = 0; j < firstPole_; ++j) {
      sample.taylorBy.col(j).tail(count) +=
          sample.seriesBy(l - 1, j) * flat(change[index(l - 1)]).tail(count);
    }
  }
  sample.attachedBy.setZero(3 * (attached_ + 1), firstPole_);
  for (int k = 1; k <= attached_; ++k) {
    for (int i = k; i <= attached_; ++i) {
      sample.attachedBy.middleRows(3 * i, 3) +=
          binomial(i, k) / binomial(task_.degree, k) * sample.taylorBy.middleRows(3 * k, 3);
    }
  }
}

const ExtendProblem::Sample& ExtendProblem::at(const VectorXd& unknowns) const {
  if (last_.unknowns.size() == size_ && last_.poles.cols() > 0 && last_.unknowns == unknowns)
    return last_;
  last_.unknowns = unknowns;
  setPoles(last_);
  setDerivatives(last_);
  return last_;
}

/// Adds the derivatives by the unknowns of a number with these derivatives by the poles.
template <class Gradient>
void ExtendProblem::addByPoles(const Sample& sample, const BoundedPoles& byPoles,
                               Gradient&& gradient) const {
  const auto by = flat(byPoles);
  const Index attached = 3 * (attached_ + 1);
  gradient.head(firstPole_) += sample.attachedBy.transpose().lazyProduct(by.head(attached));
  gradient.tail(size_ - firstPole_) += task_.unit * by.tail(by.size() - attached);
}

/// Adds coefficients (r x 3) times the derivatives of C_i to a block of r rows.
template <class Coefficients, class Block>
void ExtendProblem::addPole(const Sample& sample, int i, const Coefficients& coefficients,
                            Block&& block) const {
  if (i <= attached_) {
    block.leftCols(firstPole_) += coefficients.lazyProduct(sample.attachedBy.middleRows(3 * i, 3));
  } else {
    block.middleCols(firstPole_ + 3 * (i - attached_ - 1), 3) += task_.unit * coefficients;
  }
}

/// Below the order of contact: the Taylor coefficients above the degree vanish.
void ExtendProblem::addExcess(const Sample& sample, Rows& rows) const {
  const Index count = 3 * (order_ - task_.degree);
  if (count <= 0) return;
  rows.next(flat(sample.taylor).tail(count) / task_.unit).leftCols(firstPole_) =
      sample.taylorBy.bottomRows(count) / task_.unit;
}

/// k! sigma_k = beta_k chord, in units of steps.
void ExtendProblem::addBeta(const Sample& sample, Rows& rows) const {
  const Vector3 span = sample.poles.rightCols<1>() - sample.poles.col(0);
  const double chord = span.norm();
  const ArcLengthSeries sigma = arcLengthOf(task_.jet, sample.u);
  const SeriesDerivatives change = arcLengthDerivatives(task_.jet, sample.u);
  double weight = task_.degree / task_.unit;
  for (int k = 1; k <= order_; ++k) {
    weight *= static_cast<double>(k) / task_.degree;
    const auto& number = task_.beta[index(k - 1)];
    if (!number) continue;
    const double perChord = *number / detail::kFactorials[index(k)];
    auto row = rows.next(weight * (sigma[index(k - 1)] - perChord * chord));
    addPole(sample, task_.degree, Eigen::RowVector3d(-weight * perChord / chord * span), row);
    for (int l = 1; l <= attached_; ++l)
      row.head(firstPole_) +=
          weight * change[index(l - 1)][index(k - 1)] * sample.seriesBy.row(l - 1);
  }
}

void ExtendProblem::addEnd(const Sample& sample, Rows& rows) const {
  const auto& [point, direction, vector, curvature, length] = task_.targets;
  const int n = task_.degree;
  if (point) {
    addPole(sample, n, Eigen::Matrix3d(Eigen::Matrix3d::Identity() / task_.unit),
            rows.next((sample.poles.col(n) - *point) / task_.unit));
  }
  if (direction) {
    const Eigen::Matrix<double, 2, 3> across = planeAcross(*direction) / step();
    auto block = rows.next(across * (sample.poles.col(n) - sample.poles.col(n - 1)));
    addPole(sample, n, across, block);
    addPole(sample, n - 1, (-across).eval(), block);
  }
  if (length) {
    BoundedPoles byPoles;
    const double value = lengthOf(sample.poles, quadrature_, &byPoles) - *length;
    byPoles /= task_.unit;
    addByPoles(sample, byPoles, rows.next(value / task_.unit));
  }
}

/// kappa n = (n-1)/n b / |v|^2, b = w - (w.v) v/|v|^2, v and w the last two differences of the
/// poles: multiplied by |v|^2, which keeps the condition nearly linear.
void ExtendProblem::addCurvature(const Sample& sample, Rows& rows) const {
  const auto& [point, direction, vector, curvature, length] = task_.targets;
  if (!vector && !curvature) return;
  const int n = task_.degree;
  if (n < 2) {  // a line
    rows.next(task_.unit * (vector ? vector->norm() : *curvature));
    return;
  }
  const Vector3 v = sample.poles.col(n) - sample.poles.col(n - 1);
  const Vector3 w = v - (sample.poles.col(n - 1) - sample.poles.col(n - 2));
  const double squared = v.squaredNorm();
  const double along = w.dot(v) / squared;
  const double factor = (n - 1.0) / n / step();
  const Eigen::Matrix3d identity = Eigen::Matrix3d::Identity();
  const Vector3 bent = factor * (w - along * v);
  const Eigen::Matrix3d byW = factor * (identity - v * v.transpose() / squared);
  const Eigen::Matrix3d byV =
      -factor * (v * (w - 2.0 * along * v).transpose() / squared + along * identity);
  const auto add = [&](const auto& ofV, const auto& ofW, auto block) {
    addPole(sample, n, (ofV + ofW).eval(), block);
    addPole(sample, n - 1, (-ofV - 2.0 * ofW).eval(), block);
    addPole(sample, n - 2, ofW.eval(), block);
  };
  if (curvature && *curvature > 0.0) {
    const double perSquare = *curvature / step();
    const double wanted = perSquare * squared;
    const double scale = 1.0 / std::max(*curvature * task_.unit, 1.0);
    add(scale * (bent.transpose() * byV - 2.0 * wanted * perSquare * v.transpose()),
        scale * bent.transpose() * byW,
        rows.next(0.5 * scale * (bent.squaredNorm() - wanted * wanted)));
    return;
  }
  const Vector3 perSquare = (vector ? *vector : Vector3(Vector3::Zero())) / step();
  const Vector3 value = bent - squared * perSquare;
  const Eigen::Matrix3d ofV = byV - 2.0 * perSquare * v.transpose();
  if (vector && !direction) {
    add(ofV, byW, rows.next(value));
  } else {  // no more than two of the three components are independent
    const auto across = planeAcross(direction ? *direction : v);
    add(across * ofV, across * byW, rows.next(across * value));
  }
}

Index ExtendProblem::conditionCount() const {
  const auto& [point, direction, vector, curvature, length] = task_.targets;
  Index count = 3 * std::max(order_ - task_.degree, 0) + (point ? 3 : 0) + (direction ? 2 : 0) +
                (length ? 1 : 0);
  if (task_.degree < 2) {
    count += vector || curvature ? 1 : 0;
  } else if (vector || (curvature && *curvature == 0.0)) {
    count += vector && !direction ? 3 : 2;
  } else {
    count += curvature ? 1 : 0;
  }
  for (const auto& number : task_.beta)
    count += number ? 1 : 0;
  return count;
}

Conditions ExtendProblem::conditions(const VectorXd& unknowns) const {
  const Sample& sample = at(unknowns);
  Rows rows(conditionCount(), size_);
  addExcess(sample, rows);
  addBeta(sample, rows);
  addEnd(sample, rows);
  addCurvature(sample, rows);
  return std::move(rows).take();
}

double ExtendProblem::objective(const VectorXd& unknowns, double* gradient) const {
  const Sample& sample = at(unknowns);
  if (gradient == nullptr) return fairness_.evaluate(sample.poles, nullptr);
  BoundedPoles byPoles;
  const double value = fairness_.evaluate(sample.poles, &byPoles);
  Eigen::Map<VectorXd> result(gradient, size_);
  result.setZero();
  if (std::isfinite(value)) addByPoles(sample, byPoles, result);
  return value;
}

}  // namespace osculate
