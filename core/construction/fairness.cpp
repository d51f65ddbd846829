#include "osculate/construction/fairness.h"

#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>

#include "osculate/bezier/bernstein.h"

namespace osculate {

namespace {

constexpr double kSpeedShare = 0.3;
constexpr double kLeastEnergy = 1e-12;

constexpr int kPanelNodes = 20;

/// A number at each node.
template <int Nodes>
using Numbers = Eigen::Array<double, Nodes, 1>;
template <int Nodes>
using Vectors = std::array<Numbers<Nodes>, 3>;

template <int Nodes>
Numbers<Nodes> dot(const Vectors<Nodes>& a, const Vectors<Nodes>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// A curve's first three derivatives at the nodes, and what both energies need of them.
template <int Nodes>
struct Derivatives {
  Vectors<Nodes> a, b, c;
  Numbers<Nodes> inverse;  ///< 1/|a|
  Numbers<Nodes> p;        ///< a.b
};

/// An energy's density f per parameter, with its derivatives by a, b, c.
template <int Nodes>
struct Density {
  Numbers<Nodes> f;
  Vectors<Nodes> byA, byB, byC;
};

/// |r_3|^2 |a|, r_3 = c/v^3 - 3 p b/v^5 - (b.b + a.c) a/v^5 + 4 p^2 a/v^7 (v = |a|): d/ds of
/// kappa n = b/v^2 - p a/v^4.
template <int Nodes>
void setVariation(const Derivatives<Nodes>& d, Density<Nodes>& out) {
  using AtNodes = Numbers<Nodes>;
  const AtNodes i2 = d.inverse * d.inverse;
  const AtNodes i3 = i2 * d.inverse;
  const AtNodes i5 = i3 * i2;
  const AtNodes i7 = i5 * i2;
  const AtNodes q = dot<Nodes>(d.b, d.b) + dot<Nodes>(d.a, d.c);
  const AtNodes byTangent = 4.0 * d.p * d.p * i7 - q * i5;
  const AtNodes byB = -3.0 * d.p * i5;
  Vectors<Nodes> g;  // 2 v r_3, the derivative of the density by r_3
  for (std::size_t x = 0; x < 3; ++x)
    g[x] = d.c[x] * i3 + byB * d.b[x] + byTangent * d.a[x];
  const AtNodes squared = dot<Nodes>(g, g);
  out.f = squared / d.inverse;
  for (std::size_t x = 0; x < 3; ++x)
    g[x] *= 2.0 / d.inverse;
  const AtNodes ga = dot<Nodes>(g, d.a);
  const AtNodes gb = dot<Nodes>(g, d.b);
  const AtNodes gc = dot<Nodes>(g, d.c);
  const AtNodes byQ = -ga * i5;
  const AtNodes byP = 8.0 * d.p * ga * i7 - 3.0 * gb * i5;
  // by v, divided by v: |r_3|^2 / v and the powers of v in r_3
  const AtNodes byV = squared * d.inverse + (-3.0 * gc * i5 + 15.0 * d.p * gb * i7 +
                                             (5.0 * q * i7 - 28.0 * d.p * d.p * i7 * i2) * ga);
  for (std::size_t x = 0; x < 3; ++x) {
    out.byC[x] = g[x] * i3 + byQ * d.a[x];
    out.byB[x] = byB * g[x] + byP * d.a[x] + 2.0 * byQ * d.b[x];
    out.byA[x] = byTangent * g[x] + byP * d.b[x] + byQ * d.c[x] + byV * d.a[x];
  }
}

/// kappa^2 |a| = b.b/v^3 - p^2/v^5.
template <int Nodes>
void setBending(const Derivatives<Nodes>& d, Density<Nodes>& out) {
  using AtNodes = Numbers<Nodes>;
  const AtNodes i2 = d.inverse * d.inverse;
  const AtNodes i3 = i2 * d.inverse;
  const AtNodes i5 = i3 * i2;
  const AtNodes bb = dot<Nodes>(d.b, d.b);
  out.f = bb * i3 - d.p * d.p * i5;
  const AtNodes byV = 5.0 * d.p * d.p * i5 * i2 - 3.0 * bb * i5;
  for (std::size_t x = 0; x < 3; ++x) {
    out.byC[x].setZero();
    out.byB[x] = 2.0 * (d.b[x] * i3 - d.p * d.a[x] * i5);
    out.byA[x] = -2.0 * d.p * d.b[x] * i5 + byV * d.a[x];
  }
}

/// Derivatives 1..3 of the Bernstein polynomials at the nodes: (nodes) x (degree+1) each.
template <int Nodes>
struct Table {
  std::array<Eigen::Matrix<double, Nodes, Eigen::Dynamic>, 3> basis;
  Numbers<Nodes> weights;
};

/// Row `order` of derivatives: B_j^(r) = n!/(n-r)! sum_k (-1)^(r-k) C(r,k) B_{j-k}^{n-r} (Farin,
/// sec. 5.3).
Eigen::RowVectorXd derivativeOfBasis(int degree, int order, double t) {
  Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(degree + 1);
  if (order > degree) return row;
  double factor = 1.0;
  for (int r = 0; r < order; ++r)
    factor *= degree - r;
  const Eigen::VectorXd lower = bernstein(degree - order, t);
  for (int k = 0; k <= order; ++k) {
    const double sign = (order - k) % 2 == 0 ? 1.0 : -1.0;
    row.segment(k, lower.size()) += sign * factor * binomial(order, k) * lower.transpose();
  }
  return row;
}

template <int Nodes>
std::unique_ptr<const Table<Nodes>> makeTable(int degree) {
  using Rule =
      boost::math::quadrature::gauss<double, kPanelNodes>;  // lists the nodes x > 0 of [-1, 1]
  constexpr double kHalfPanel = 0.5 * kPanelNodes / Nodes;
  auto table = std::make_unique<Table<Nodes>>();
  for (auto& matrix : table->basis)
    matrix.resize(Nodes, degree + 1);
  for (int i = 0; i < Nodes; ++i) {
    const int j = i % kPanelNodes;
    const auto k = static_cast<std::size_t>(j % (kPanelNodes / 2));
    const double x = (j < kPanelNodes / 2 ? -1.0 : 1.0) * Rule::abscissa()[k];
    const double t = kHalfPanel * (2 * (i / kPanelNodes) + 1 + x);
    table->weights[i] = kHalfPanel * Rule::weights()[k];
    for (int order = 1; order <= 3; ++order) {
      table->basis[static_cast<std::size_t>(order - 1)].row(i) =
          derivativeOfBasis(degree, order, t);
    }
  }
  return table;
}

template <int Nodes>
const Table<Nodes>& tableOf(int degree) {
  static std::array<std::once_flag, kMaxDegree + 1> once;
  static std::array<std::unique_ptr<const Table<Nodes>>, kMaxDegree + 1> tables;
  const auto i = static_cast<std::size_t>(degree);
  std::call_once(once[i], [&] { tables[i] = makeTable<Nodes>(degree); });
  return *tables[i];
}

template <int Nodes>
Derivatives<Nodes> derivativesAt(const Table<Nodes>& table, const BoundedPoles& poles) {
  Derivatives<Nodes> d;
  Vectors<Nodes>* const derivatives[3] = {&d.a, &d.b, &d.c};
  for (std::size_t order = 0; order < 3; ++order) {
    for (std::size_t x = 0; x < 3; ++x) {
      const auto row = poles.row(static_cast<Eigen::Index>(x)).transpose();
      (*derivatives[order])[x] = table.basis[order].lazyProduct(row).array();
    }
  }
  return d;
}

template <int Nodes>
double evaluateAt(int degree, bool bending, const BoundedPoles& poles, BoundedPoles* gradient) {
  const Table<Nodes>& table = tableOf<Nodes>(degree);
  const Numbers<Nodes>& weights = table.weights;
  Derivatives<Nodes> d = derivativesAt(table, poles);
  const Numbers<Nodes> v = dot<Nodes>(d.a, d.a).sqrt();
  if (!(v.minCoeff() > 0.0)) return std::numeric_limits<double>::infinity();
  d.inverse = v.inverse();
  d.p = dot<Nodes>(d.a, d.b);
  Density<Nodes> density;
  bending ? setBending(d, density) : setVariation(d, density);

  const double length = (weights * v).sum();
  const double integral = (weights * density.f).sum();
  const double power = bending ? 1.0 : 3.0;
  const double perIntegral = bending ? length : length * length * length;
  const Numbers<Nodes> logarithm = (v / length).log();
  const double energy = perIntegral * integral + kLeastEnergy;
  const double objective = std::log(energy) + kSpeedShare * (weights * logarithm.square()).sum();
  if (gradient == nullptr) return objective;

  const double byLength = power * perIntegral / length * integral / energy -
                          2.0 * kSpeedShare * (weights * logarithm).sum() / length;
  const Numbers<Nodes> byDensity = weights * (perIntegral / energy);
  // by v, divided by v
  const Numbers<Nodes> bySpeed =
      weights * d.inverse * (byLength + 2.0 * kSpeedShare * logarithm * d.inverse);
  gradient->resize(3, poles.cols());
  for (std::size_t x = 0; x < 3; ++x) {
    const Numbers<Nodes> byA = byDensity * density.byA[x] + bySpeed * d.a[x];
    const Numbers<Nodes> byB = byDensity * density.byB[x];
    const Numbers<Nodes> byC = byDensity * density.byC[x];
    gradient->row(static_cast<Eigen::Index>(x)) =
        byA.matrix().transpose().lazyProduct(table.basis[0]) +
        byB.matrix().transpose().lazyProduct(table.basis[1]) +
        byC.matrix().transpose().lazyProduct(table.basis[2]);
  }
  return objective;
}

template <int Nodes>
Vectors<Nodes> hodographAt(const BoundedPoles& poles) {
  const Table<Nodes>& table = tableOf<Nodes>(static_cast<int>(poles.cols()) - 1);
  Vectors<Nodes> a;
  for (std::size_t x = 0; x < 3; ++x) {
    const auto row = poles.row(static_cast<Eigen::Index>(x)).transpose();
    a[x] = table.basis[0].lazyProduct(row).array();
  }
  return a;
}

template <int Nodes>
double lengthAt(const BoundedPoles& poles, BoundedPoles* gradient) {
  const Table<Nodes>& table = tableOf<Nodes>(static_cast<int>(poles.cols()) - 1);
  const Vectors<Nodes> a = hodographAt<Nodes>(poles);
  const Numbers<Nodes> v = dot<Nodes>(a, a).sqrt();
  if (gradient != nullptr) {
    const Numbers<Nodes> factor = (v > 0.0).select(table.weights / v, 0.0);
    gradient->resize(3, poles.cols());
    for (std::size_t x = 0; x < 3; ++x) {
      gradient->row(static_cast<Eigen::Index>(x)) =
          (factor * a[x]).matrix().transpose().lazyProduct(table.basis[0]);
    }
  }
  return (table.weights * v).sum();
}

constexpr int kCoarseNodes = 2 * kPanelNodes;
constexpr int kFineNodes = 8 * kPanelNodes;

}  // namespace

double lengthOf(const BoundedPoles& poles, Quadrature quadrature, BoundedPoles* gradient) {
  return quadrature == Quadrature::kCoarse ? lengthAt<kCoarseNodes>(poles, gradient)
                                           : lengthAt<kFineNodes>(poles, gradient);
}

double leastSpeed(const BoundedPoles& poles) {
  const Vectors<kFineNodes> a = hodographAt<kFineNodes>(poles);
  return dot<kFineNodes>(a, a).sqrt().minCoeff();
}

FairnessObjective::FairnessObjective(int degree, Fairness fairness, Quadrature quadrature)
    : degree_(degree), fairness_(fairness), quadrature_(quadrature) {}

double FairnessObjective::evaluate(const BoundedPoles& poles, BoundedPoles* gradient) const {
  const bool bending = fairness_ == Fairness::kBending;
  return quadrature_ == Quadrature::kCoarse
             ? evaluateAt<kCoarseNodes>(degree_, bending, poles, gradient)
             : evaluateAt<kFineNodes>(degree_, bending, poles, gradient);
}

}  // namespace osculate
