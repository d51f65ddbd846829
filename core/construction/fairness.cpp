#include "osculate/construction/fairness.h"

#include <cmath>
#include <limits>

#include "osculate/construction/fairness_kernel.h"

namespace osculate {

namespace {

constexpr double kSpeedShare = 0.3;
constexpr double kLeastEnergy = 1e-12;

template <int Nodes>
AtNodes<Nodes> arrayOf(const double (&numbers)[Nodes]) {
  return Eigen::Map<const AtNodes<Nodes>>(numbers);
}

template <int Nodes>
double evaluateAt(int degree, bool isBending, const BoundedPoles& poles, BoundedPoles* gradient) {
  const NodeTable<Nodes>& table = nodeTable<Nodes>(degree);
  const AtNodes<Nodes>& weights = table.weights;
  NodeDerivatives<Nodes> d;
  setDerivatives(table, poles, d);
  const AtNodes<Nodes> v = arrayOf(d.speed);
  if (!(v.minCoeff() > 0.0)) return std::numeric_limits<double>::infinity();
  NodeDensity<Nodes> density;
  isBending ? setBending(d, density) : setVariation(d, density);

  const double length = (weights * v).sum();
  const double integral = (weights * arrayOf(density.f)).sum();
  const double power = isBending ? 1.0 : 3.0;
  const double perIntegral = isBending ? length : length * length * length;
  const AtNodes<Nodes> logarithm = (v / length).log();
  const double energy = perIntegral * integral + kLeastEnergy;
  const double objective = std::log(energy) + kSpeedShare * (weights * logarithm.square()).sum();
  if (gradient == nullptr) return objective;

  const double byLength = power * perIntegral / length * integral / energy -
                          2.0 * kSpeedShare * (weights * logarithm).sum() / length;
  gradient->resize(3, poles.cols());
  const NodeFactors<Nodes> factors{weights * (perIntegral / energy),
                                   weights * (byLength + 2.0 * kSpeedShare * logarithm / v)};
  setGradient(table, d, density, factors, *gradient);
  return objective;
}

template <int Nodes>
double lengthAt(const BoundedPoles& poles, BoundedPoles* gradient) {
  const NodeTable<Nodes>& table = nodeTable<Nodes>(static_cast<int>(poles.cols()) - 1);
  NodeDerivatives<Nodes> d;
  setDerivatives(table, poles, d);
  if (gradient != nullptr) {
    gradient->resize(3, poles.cols());
    for (Eigen::Index x = 0; x < 3; ++x) {
      const AtNodes<Nodes> a = arrayOf(d.a.at[x]);
      const AtNodes<Nodes> v = arrayOf(d.speed);
      const AtNodes<Nodes> tangent = (v > 0.0).select(a / v, 0.0);
      gradient->row(x) = (table.weights * tangent).matrix().transpose().lazyProduct(table.basis[0]);
    }
  }
  return (table.weights * arrayOf(d.speed)).sum();
}

}  // namespace

double lengthOf(const BoundedPoles& poles, Quadrature quadrature, BoundedPoles* gradient) {
  return quadrature == Quadrature::kCoarse ? lengthAt<kCoarseNodes>(poles, gradient)
                                           : lengthAt<kFineNodes>(poles, gradient);
}

double leastSpeed(const BoundedPoles& poles) {
  NodeDerivatives<kFineNodes> d;
  setDerivatives(nodeTable<kFineNodes>(static_cast<int>(poles.cols()) - 1), poles, d);
  return arrayOf(d.speed).minCoeff();
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
