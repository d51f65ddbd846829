// The free numbers of an extension of one degree as one vector, and its conditions and objective by
// them; private to this floor.
#pragma once

#include "osculate/construction/extend.h"
#include "osculate/construction/fairness.h"
#include "osculate/construction/feasible.h"
#include "osculate/construction/graph_jet.h"

namespace osculate {

/// What an extension of one degree has to be.
struct ExtendTask {
  GraphJet jet;
  Vector3 tangent;  ///< in which the extension leaves, where its order says so
  int degree = 0;
  GivenNumbers beta{};
  GivenNumbers tangential{};  ///< mm
  ExtendTargets targets{};    ///< the length where the task has one, given or not
  double unit = 1.0;          ///< mm: about the size of the extension
  double leastStep = 0.0;     ///< of C_1 where it is not given, in units of unit/n
};

/// The unknowns are the tangential coordinates of the poles C_1 .. C_K, K the smaller of order and
/// degree, that are not given: each as the step from the one before, in units of unit/n, the first
/// as the root of what it has above the least. Then the other poles, in units. All are about 1.
///
/// Remembers the last unknowns it was asked for: not to be shared between threads.
class ExtendProblem {
 public:
  ExtendProblem(const ExtendTask& task, Fairness fairness, Quadrature quadrature);

  Eigen::Index size() const { return size_; }

  /// Steps of speed * unit/n along the tangent, each `growth` times the one before, then evenly to
  /// the targets.
  Eigen::VectorXd start(double speed, double growth) const;
  /// The tangential coordinates are those that t -> `u` would give; degree <= order only.
  Eigen::VectorXd startFrom(const ArcLengthSeries& u) const;
  /// The unknowns of a curve of this degree that satisfies the contact.
  Eigen::VectorXd startFrom(const BezierCurve& curve) const;

  BoundedPoles poles(const Eigen::VectorXd& unknowns) const { return at(unknowns).poles; }
  Conditions conditions(const Eigen::VectorXd& unknowns) const;
  double objective(const Eigen::VectorXd& unknowns, double* gradient) const;

 private:
  class Rows;

  using Coordinates = std::array<double, kMaxOrder + 1>;  ///< [k] of C_k along the tangent, mm
  /// Derivatives by the unknowns that stand for coordinates.
  template <int MaxRows>
  using ByCoordinates =
      Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, MaxRows, kMaxOrder>;

  /// The curve at some unknowns.
  struct Sample {
    Eigen::VectorXd unknowns;
    ArcLengthSeries u{};  ///< the tangential series
    BoundedPoles taylor;  ///< q_0 .. q_order
    BoundedPoles poles;
    ByCoordinates<kMaxOrder> seriesBy;              ///< of u_1 .. u_K
    ByCoordinates<3 * (kMaxOrder + 1)> taylorBy;    ///< of q_0 .. q_order, one after the other
    ByCoordinates<3 * (kMaxOrder + 1)> attachedBy;  ///< of C_0 .. C_K likewise
  };

  bool isGiven(int k) const {
    return task_.tangential[static_cast<std::size_t>(k - 1)].has_value();
  }
  double step() const { return task_.unit / task_.degree; }
  Coordinates coordinates(const Eigen::VectorXd& unknowns) const;
  Eigen::VectorXd unknownsOf(const Coordinates& along) const;
  ArcLengthSeries series(const Coordinates& along) const;
  void setFreePoles(BoundedPoles& poles) const;
  void storeFreePoles(const BoundedPoles& poles, Eigen::VectorXd& unknowns) const;
  const Sample& at(const Eigen::VectorXd& unknowns) const;
  void setPoles(Sample& sample) const;
  void setDerivatives(Sample& sample) const;

  template <class Gradient>
  void addByPoles(const Sample& sample, const BoundedPoles& byPoles, Gradient&& gradient) const;
  template <class Coefficients, class Block>
  void addPole(const Sample& sample, int i, const Coefficients& coefficients, Block&& block) const;
  Eigen::Index conditionCount() const;
  void addExcess(const Sample& sample, Rows& rows) const;
  void addBeta(const Sample& sample, Rows& rows) const;
  void addEnd(const Sample& sample, Rows& rows) const;
  void addCurvature(const Sample& sample, Rows& rows) const;

  ExtendTask task_;
  int order_;
  int attached_;  ///< K
  FairnessObjective fairness_;
  Quadrature quadrature_;
  Eigen::Index size_ = 0;
  Eigen::Index firstPole_ = 0;  ///< the first unknown of the free poles
  mutable Sample last_;
};

}  // namespace osculate
