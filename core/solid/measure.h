// Volume and centroid of a Bézier solid.
#pragma once

#include "osculate/bezier/bezier_tetrahedron.h"
#include "osculate/bezier/vector3.h"

namespace osculate {

struct SolidMeasure {
  /// The integral of the Jacobian, in mm^3: positive for a solid oriented right, negative for its
  /// mirror image; where the solid folds, parts that are covered inside out count negative.
  double volume = 0.0;
  /// Bound of the error of the quadrature as estimated by halving the faces, with the rounding, in
  /// mm^3.
  double volumeError = 0.0;
  Vector3 centroid = Vector3::Zero();  ///< in mm; NaN where the volume is 0
  double centroidErrorMm = 0.0;
};

/// By Gauss' theorem over the faces, V = 1/3 of the flux of the position. Gauss-Legendre quadrature
/// on the collapsed square: exact for a polynomial solid; a rational one in parts, until halving
/// changes a face's share by at most relativeTolerance of the whole. Throws std::invalid_argument
/// in E4.
SolidMeasure measure(const BezierTetrahedron& solid, double relativeTolerance = 1e-12);

}  // namespace osculate
