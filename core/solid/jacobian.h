// The Jacobian determinant of a Bézier solid: its sign with proof, and its range.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "osculate/bezier/bezier_tetrahedron.h"

namespace osculate {

/// The numerator of the Jacobian as a Bernstein polynomial over the domain.
///
/// J = d(x,y,z)/d(v,w,t) with u = 1-v-w-t, so that J > 0 where the corners 1, 2, 3 turn as a right
/// hand seen from corner 0: J = det[X_u, X_v, X_w, X_t]/(n W^4), rows (W, wx, wy, wz), X_c the
/// plain partials n X^(n-1)_{e_c}. The numerator n^3 det has degree 4(n-1); of a polynomial solid
/// it is J itself, of degree 3(n-1).
struct JacobianNumerator {
  int degree = 0;
  Eigen::RowVectorXd coefficients;  ///< in the order of a net
  Eigen::RowVectorXd errors;        ///< bounds of the rounding error of each coefficient
};
/// Throws std::invalid_argument in E4.
JacobianNumerator jacobianNumerator(const BezierTetrahedron& solid);

/// J at a point; NaN where the weight vanishes.
double jacobian(const BezierTetrahedron& solid, const Barycentric<4>& u);

enum class Validity : unsigned char {
  kValid,     ///< J > 0 everywhere: no folding
  kSingular,  ///< J >= 0, and 0 (within its rounding error) at `places`
  kInverted,  ///< J < 0 at `witness`
  kUndecided  ///< the work allowed did not suffice; |J| is small near `witness`
};
std::string_view name(Validity validity);

/// A point or a simplex of the domain on which J vanishes, by its corners.
struct SingularPlace {
  std::vector<Barycentric<4>>
      corners;  ///< 1: a point, 2: a segment, 3: a triangle, 4: a tetrahedron
  /// The corners of the solid between which it lies: 1 for a corner, 2 within an edge, 3 a face.
  std::vector<int> between;
};

struct ValidityCertificate {
  Validity validity = Validity::kUndecided;
  std::vector<SingularPlace> places;
  std::optional<Barycentric<4>> witness;
  /// J <= 0 everywhere: the solid is the mirror image of a right one; exchange two corners.
  bool mirrored = false;
  int parts = 0;  ///< how many parts of the domain were looked at
};

struct CertificateOptions {
  int maxParts = 20000;
};

/// Decides by the Bernstein coefficients of the numerator, with bisection of the domain where they
/// differ in sign, and never by samples: coefficients > 0 beyond their rounding error prove J > 0
/// on a part, a corner value < 0 beyond its error proves J < 0 there, and coefficients >= 0 vanish
/// on exactly the faces of a part all of whose coefficients are 0 (after Johnen, Remacle and
/// Geuzaine 2013, for rational tetrahedra by mathematics B10).
ValidityCertificate certify(const BezierTetrahedron& solid, const CertificateOptions& options = {});
/// In words: "valid", "singular at corner 3 and edge 0-3", "inverted at (..)", "undecided near
/// (..)".
std::string describe(const ValidityCertificate& certificate);

/// An interval that contains J, each end within tolerance * max|J| of a value J takes, where the
/// work allowed suffices; `reached` says whether it did. Infinite where the weight vanishes.
struct JacobianBounds {
  double low = 0.0;
  double high = 0.0;
  bool reached = true;
};
JacobianBounds jacobianBounds(const BezierTetrahedron& solid, double tolerance = 1e-3,
                              int maxParts = 20000);

}  // namespace osculate
