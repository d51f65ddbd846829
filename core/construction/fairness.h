// How fair a curve is: energies without dimension, and the objective that blends minimise.
#pragma once

#include "osculate/bezier/bspline_curve.h"
#include "osculate/construction/attach.h"

namespace osculate {

enum class Fairness : unsigned char {
  kMinimumVariation,  ///< "mvc": ln(mvc + 1e-12) + 0.3 speed
  kBending            ///< "bending": ln(bending + 1e-12) + 0.3 speed
};

/// Over a curve of length L; bending, variation and speed have no dimension (Moreton and Sequin
/// 1992, Functional optimization for fair surface design: scale-invariant minimum variation
/// curves).
struct Energies {
  double lengthMm = 0.0;
  double bending = 0.0;    ///< L int kappa^2 ds
  double variation = 0.0;  ///< L^3 int |d(kappa vector)/ds|^2 ds: "mvc"
  double speed = 0.0;      ///< int ln^2(|Q'|/L) dt over t in [0, 1]

  double objective(Fairness fairness) const;
};

/// The energies of a curve, to a relative error of about 1e-9; its parameter is taken as [0, 1].
Energies energies(const BSplineCurve& curve);

/// How many quadrature nodes an objective has.
enum class Quadrature : unsigned char {
  kCoarse,  ///< 2 panels of 20 Gauss-Legendre nodes: enough where the speed is not nearly zero
            ///< anywhere
  kFine     ///< 8 panels
};

/// The objective of a polynomial Bézier curve by a fixed quadrature, with its derivatives by the
/// poles: what an optimiser evaluates often. Tables are shared and made at the first use of a
/// degree.
class FairnessObjective {
 public:
  FairnessObjective(int degree, Fairness fairness, Quadrature quadrature);

  /// poles 3 x (degree+1). `gradient`, where not null, becomes d objective / d poles, of the same
  /// shape. Infinite where the curve stops (zero speed at a node).
  double evaluate(const BoundedPoles& poles, BoundedPoles* gradient) const;

 private:
  int degree_;
  Fairness fairness_;
  Quadrature quadrature_;
};

/// The length in mm of a polynomial Bézier curve by a fixed quadrature, with its derivatives by the
/// poles where `gradient` is not null.
double lengthOf(const BoundedPoles& poles, Quadrature quadrature, BoundedPoles* gradient);

/// The least |Q'| of a polynomial Bézier curve at the nodes of the fine quadrature, mm.
double leastSpeed(const BoundedPoles& poles);

}  // namespace osculate
