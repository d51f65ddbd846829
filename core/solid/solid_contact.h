// Which contact two Bézier tetrahedra have over a common face.
#pragma once

#include <optional>
#include <vector>

#include "osculate/bezier/bezier_tetrahedron.h"

namespace osculate {

/// A face of the first solid, one of the second, and which corners meet.
struct FaceMatch {
  int first = 0;   ///< the corner of the first solid opposite to its face
  int second = 0;  ///< likewise of the second
  /// For each corner of the first solid the corner of the second that takes its place; the one of
  /// `first` is `second`.
  MultiIndex<4> corners{};
};

struct SolidContactOptions {
  double toleranceMm = 1e-7;  ///< for the residual of order 0; order r allows growth^r of it
  int maxOrder = kMaxSimplexDegree;
  /// Where the second solid's free corner lies in the domain of the first; without, the place that
  /// fits the first order best is found.
  std::optional<Barycentric<4>> apex;
};

/// One reading of contact: of the homogeneous maps (sufficient), or of the maps into space.
struct ContactOrders {
  /// Highest s with contact C^0 .. C^s; -1 if the faces do not meet.
  int order = -1;
  /// For each order 0, 1, .. the largest difference as a displacement of control points, in mm.
  std::vector<double> residualsMm;
  /// The free corner of the second solid in barycentric coordinates of the first.
  Barycentric<4> apex = Barycentric<4>::Zero();
};

struct SolidContact {
  FaceMatch faces;            ///< that meet, or come nearest
  double gapMm = 0.0;         ///< the largest distance of corresponding points of the two faces
  ContactOrders homogeneous;  ///< of the homogeneous nets, up to a common factor
  ContactOrders cartesian;    ///< of the points of space
  bool meets = false;         ///< gapMm within the tolerance
  bool overlaps = false;      ///< both lie on the same side of the face
  int degree = 0;             ///< of both, after raising the lower one
};

/// Compares all pairs of faces under all ways to lay one on the other, and takes the pair with the
/// highest contact, or the smallest gap.
///
/// Equal maps have equal homogeneous nets up to a factor only where the weights have no common
/// factor that cancels: the Cartesian order is never below the homogeneous one but for rounding.
/// The Cartesian residuals are taken on a lattice of the face on which the difference, a polynomial
/// over the product of the weights, must vanish everywhere if it vanishes there (for 2 (s+1) degree
/// <= 48; above it is a sample). Throws std::invalid_argument for solids in spaces of different
/// dimension and bad options.
SolidContact contact(const BezierTetrahedron& first, const BezierTetrahedron& second,
                     const SolidContactOptions& options = {});

}  // namespace osculate
