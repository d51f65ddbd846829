// Points that satisfy conditions, and the least value of a function among them; private to this
// floor.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "osculate/construction/minimize.h"

namespace osculate {

/// Conditions hold where their values are zero; their size should be about 1 elsewhere.
struct Conditions {
  Eigen::VectorXd values;
  Eigen::MatrixXd jacobian;  ///< values x unknowns
};
using ConditionFunction = std::function<Conditions(const Eigen::VectorXd& unknowns)>;

/// The unknowns near a start that satisfy the conditions, by steps of Levenberg and
/// Marquardt: with fewer conditions than unknowns, or dependent ones, as little as possible
/// changes. Nothing where that does not converge.
std::optional<Eigen::VectorXd> restore(const ConditionFunction& conditions, Eigen::VectorXd start);

/// How many numbers the conditions leave free at a point that satisfies them.
int freedomsAt(const ConditionFunction& conditions, const Eigen::VectorXd& point);

struct FeasibleMinimum {
  Eigen::VectorXd unknowns;
  double value;
};

/// The least value near a point that satisfies the conditions, among the points that do: a
/// quasi-Newton method in the plane that touches them there, each of its points brought back
/// onto them (generalised reduced gradient, Abadie and Carpentier 1969). Never worse than the
/// start.
FeasibleMinimum minimizeAmong(const ConditionFunction& conditions, const SmoothFunction& objective,
                              const Eigen::VectorXd& start);

/// The same minimum to rounding, by Newton's method; see polish.
FeasibleMinimum polishAmong(const ConditionFunction& conditions, const SmoothFunction& objective,
                            const Eigen::VectorXd& start);

}  // namespace osculate
