// The free numbers of a contact that move the first poles of a curve least; private to this floor.
#pragma once

#include <optional>

#include "osculate/construction/attach.h"

namespace osculate {

/// A square matrix with a row for each of the first poles, without allocation.
using FirstPolesMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor,
                                       kMaxOrder + 1, kMaxOrder + 1>;

/// The first poles of a curve, which a contact determines, and what it costs to move them.
struct FirstPoles {
  BoundedPoles old;  ///< C_0 .. C_m as they are, mm
  /// C_i - C_0 = sum_{k>=1} byTaylor(i, k) c_k, c_k the Taylor coefficients at the end.
  FirstPolesMatrix byTaylor;
  /// The objective: for each coordinate the quadratic form of the displacements C_i - old_i.
  FirstPolesMatrix cost;
};

struct FitOptions {
  std::array<std::optional<double>, kMaxOrder> given{};  ///< sigma_k that are not free
  ArcLengthSeries start{};   ///< a series to begin with, such as that of the curve as it is
  double lowestSpeed = 0.0;  ///< a free sigma_1 is at least this
};

struct ContactFit {
  ArcLengthSeries sigma{};  ///< up to the order of the target
  BoundedPoles poles;       ///< C_0 .. C_m
  double cost = 0.0;
};

/// The least cost over the free numbers by Newton's method with a damped Hessian, from the start
/// and from the solution for one order less; the better counts. The same input gives the same
/// numbers.
ContactFit fitContact(const ContactJet& target, const FirstPoles& first, const FitOptions& options);

}  // namespace osculate
