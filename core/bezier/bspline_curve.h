// A B-spline curve, polynomial or rational, clamped, unclamped or periodic, as an immutable value.
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "osculate/bezier/bezier_curve.h"
#include "osculate/bezier/knot_vector.h"

namespace osculate {

/// From which side a parameter at a knot is approached.
enum class Side : unsigned char { kLeft, kRight };

/// One Bézier segment of a B-spline.
struct BezierSegment {
  BezierCurve curve;  ///< over [0, 1]
  double first;       ///< the parameter interval it has on the B-spline
  double last;
  double poleError;  ///< bound of the error of its poles in mm: rounding of the extraction and the
                     ///< error of the curve it was taken from
  double length() const { return last - first; }
};

/// How the Bézier poles of a span come from the poles of its B-spline, both in homogeneous form:
/// Bézier pole j = sum_i factors(i, j) times pole firstPole + i (of a periodic curve, counted on
/// through its seam). Column j holds the values of the blossom; the rows are the B-spline basis
/// functions on the span in Bernstein form.
struct SpanExtraction {
  int firstPole;
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, kMaxDegree + 1,
                kMaxDegree + 1>
      factors;
};

/// The data a B-spline is made of, in the form of Part.BSplineCurve.
struct BSplineData {
  Poles poles;                  ///< 3 x m, mm
  std::vector<double> weights;  ///< m positive numbers, or empty for a polynomial curve
  KnotVector knots;
  int degree = 0;
  bool periodic = false;
  double poleError = 0.0;  ///< what is known of the error of the poles beyond rounding, in mm
};

/// A B-spline curve. Copies share their data, which never changes: safe between threads.
class BSplineCurve {
 public:
  /// Throws std::invalid_argument that names the argument and the rule.
  explicit BSplineCurve(BSplineData data);
  /// One Bézier segment over [first, last].
  explicit BSplineCurve(const BezierCurve& curve, double first = 0.0, double last = 1.0,
                        double poleError = 0.0);

  int degree() const;
  bool isRational() const;
  bool isPeriodic() const;
  const BSplineData& data() const;
  double poleError() const;

  /// The parameter range: [knots[degree], knots[poles]] of the flat knots.
  double first() const;
  double last() const;
  /// Its ends and the point at the middle of its parameter range, known since construction.
  const Vector3& endPoint(CurveEnd end) const;
  const Vector3& middlePoint() const;
  /// Periodic, or its ends are not farther apart than the tolerance (mm).
  bool isClosed(double tolerance) const;

  /// Spans of positive length, numbered from 0 in the direction of the parameter.
  int spanCount() const;
  /// The span that contains t; at a knot the one on that side. t outside the range takes the end
  /// span.
  int spanAt(double t, Side side = Side::kRight) const;
  /// The Bézier segment of one span, by blossoming: the cost does not depend on the other spans.
  BezierSegment segment(int span) const;
  /// How the poles of segment(span) depend on those of the curve.
  SpanExtraction extraction(int span) const;
  /// The first or last segment whose poles are not all one point.
  BezierSegment endSegment(CurveEnd end) const;
  /// The knots inside the range, with the number of the span that begins there.
  struct InnerKnot {
    double parameter;
    int multiplicity;
    int spanAfter;
  };
  std::vector<InnerKnot> innerKnots() const;

  /// Derivatives 0..count at t by the curve's own parameter.
  std::vector<Vector3> derivatives(double t, int count, Side side = Side::kRight) const;
  Vector3 evaluate(double t) const;

  BSplineCurve reversed() const;
  BSplineCurve elevated(int times = 1) const;
  std::pair<BSplineCurve, BSplineCurve> split(double t) const;
  /// The part [a, b], a < b, clamped; a periodic curve may be crossed at its seam (b up to a +
  /// period). Poles that stand over knots inside the part only keep their bits.
  BSplineCurve trimmed(double a, double b) const;
  BSplineCurve transformed(const Eigen::Affine3d& map) const;
  /// The same curve with knots mapped affinely on [first, last].
  BSplineCurve reparametrised(double first, double last) const;
  BSplineCurve withPoleError(double poleError) const;

  struct State;  ///< private to this floor

 private:
  explicit BSplineCurve(std::shared_ptr<const State> state);
  std::shared_ptr<const State> state_;
};

}  // namespace osculate
