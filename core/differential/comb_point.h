// All that combs need of a curve at one parameter; private to this floor.
#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "osculate/differential/flatness.h"
#include "osculate/differential/segment_cut.h"

namespace osculate {

/// What a point of a curve does not have, such as the torsion of a straight piece.
inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// The quantities of a comb, and the derivatives that their extrema are found by.
enum Rate : std::size_t {
  kCurvatureValue,
  kTorsionValue,
  kCurvatureRateValue,
  kCurvatureRate2Value,
  kTorsionRateValue,
  kCurvatureRate3Value,
  kTorsionRate2Value,
  kRateCount
};

/// The derivative by arc length of each quantity of a comb.
inline constexpr std::array<Rate, 5> kRateOf{kCurvatureRateValue, kTorsionRateValue,
                                             kCurvatureRate2Value, kCurvatureRate3Value,
                                             kTorsionRate2Value};

/// What sampling and marking note of a point.
struct CombNotes {
  bool isFlat = false;      ///< curvature not to be told from zero
  bool isSingular = false;  ///< first derivative not to be told from zero
  bool isTooth = false;
  bool endsRun = false;      ///< nothing joins it to the next point
  std::uint8_t marks = 0;    ///< bits of CombMarkKind, and of the quantities that have a peak here
  double uncertainty = 0.0;  ///< of the place of a mark, mm
};

/// Vectors and numbers are NaN where they do not exist.
struct CombPoint : CombNotes {
  double t;  ///< in the segment, 0 to 1
  Vector3 point;
  Vector3 tangent;
  Vector3 normal;
  Vector3 binormal;
  Vector3 curvatureVector;
  std::array<double, kRateCount> value;  ///< 1/mm, 1/mm, 1/mm^2, ...
  std::array<double, kRateCount> error;  ///< bounds of what rounding can do to them
  double growth;                         ///< kappa dkappa/ds = r_2 . r_3, smooth at inflections too
  double growthError;
  std::array<double, 5> speed;  ///< |dP/dt| and its derivatives by t
};

/// Where a limit is taken at a point without normal: from the points before it, from those after
/// it, or not at all.
enum class Limit : signed char { kFromBefore = -1, kNone = 0, kFromAfter = 1 };

/// The curvature vector is r_2 = r_m s^(m-2)/(m-2)! + ... at such a point: m is 3 where it turns
/// over, 4 where it only touches zero, or whichever does not vanish.
enum class Contact : unsigned char { kEither, kTurning = 3, kTouching = 4 };

/// Evaluates one segment of a curve. The rule of what is flat is that of geometryAt.
class SegmentSampler {
 public:
  SegmentSampler(const Flatness& flatness, const BezierSegment& segment);

  /// At a point where the curvature is zero and a limit is asked for, normal, binormal, torsion and
  /// rates are the limits, as far as they exist.
  CombPoint at(double t, Limit limit = Limit::kNone, Contact contact = Contact::kEither) const;
  /// Two at once, faster.
  void at(double first, double second, CombPoint& firstPoint, CombPoint& secondPoint) const;

  const BezierSegment& segment() const { return cutter_.segment(); }

 private:
  template <class Scalar, std::size_t Count>
  void evaluate(const std::array<double, Count>& parameters,
                const std::array<CombPoint*, Count>& points, Limit limit, Contact contact) const;

  SegmentCutter cutter_;
  Flatness flatness_;
};

}  // namespace osculate
