// A B-spline while its knots change: homogeneous poles over flat knots.
#pragma once

#include <vector>

#include "osculate/bezier/bernstein.h"
#include "osculate/bezier/bspline_curve.h"

namespace osculate {

/// A B-spline as the algorithms on knots change it in place; nothing is checked.
///
/// Pole i is the blossom at the knots i+1 .. i+degree. A clamped net has degree+1 equal knots at
/// each end. A periodic one holds the poles and knots of one period: knot(i + poles) = knot(i) +
/// period and pole(i + poles) = pole(i) for every integer i.
struct SplineNet {
  int degree = 0;
  bool rational = false;               ///< false: every weight is 1
  std::vector<double> flat;            ///< knots repeated by their multiplicities
  std::vector<Eigen::Vector4d> poles;  ///< (w x, w y, w z, w)
  double period = 0.0;                 ///< 0: clamped

  bool isPeriodic() const { return period > 0.0; }
  int poleCount() const { return static_cast<int>(poles.size()); }
  double knot(int i) const;
  const Eigen::Vector4d& pole(int i) const;
  /// Where the knot u begins in `flat`, and its multiplicity there (0 where u is no knot).
  struct Occurrence {
    int first;
    int multiplicity;
  };
  Occurrence find(double u) const;
};

/// The net of a curve; a periodic curve is cut at its first knot, an unclamped one clamped.
SplineNet clampedNet(const BSplineCurve& curve);
/// The periodic net of a clamped one whose first and last pole are equal: the knot at its closing
/// then has the multiplicity `degree`.
SplineNet periodicNet(const SplineNet& clamped);
/// The clamped net of a periodic one whose first knot has the multiplicity `degree`: the inverse.
SplineNet openedNet(const SplineNet& periodic);
/// The curve of a net. A periodic one begins at its knot flat[0].
BSplineCurve curveOf(const SplineNet& net, double poleError = 0.0);

/// The Bézier net of the interval [a, b], a < b within one span: 3 rows for a polynomial net, 4 for
/// a rational one.
Net bezierNet(const SplineNet& net, double a, double b);

}  // namespace osculate
