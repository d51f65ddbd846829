// How the other poles near an end follow its first ones, so that the curve changes least; private
// to this floor.
#pragma once

#include <vector>

#include "osculate/construction/knot_contact.h"

namespace osculate {

/// The part of a curve, from one of its ends, that may change.
struct ChangeWindow {
  int spans = 0;
  int poles = 0;            ///< those that have no influence beyond it, and may move
  bool wholeCurve = false;  ///< it reaches the far end, whose last poles are not among them
};

/// The answer to given displacements of the first poles: what all poles of the window do.
struct LeastChange {
  Eigen::MatrixXd response;  ///< window.poles x first: displacements, for each coordinate alike
  Eigen::MatrixXd cost;      ///< first x first: int |displacement|^2 ds = sum of quadratic forms
  double lengthMm = 0.0;     ///< of the window on the curve
};

/// The least int |displacement|^2 ds over the window, s the arc length of the curve as it is, where
/// the first poles move as given and the curve keeps its contact with itself at the inner knots of
/// `contacts` and at the end of the window: with D_-, D_+ the displacement before and after a knot,
/// D_+(t) = D_-(phi(t)) up to the order there, phi the re-parametrisation of the curve itself (beta
/// constraints: linear, since phi is kept). An equality-constrained least squares problem.
/// `head` is at least the window, its pole 0 at the end. Throws ContactError where the constraints
/// leave no freedom.
LeastChange leastChange(const BSplineCurve& head, const std::vector<KnotContact>& contacts,
                        const ChangeWindow& window, int first);

}  // namespace osculate
