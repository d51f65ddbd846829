// What a B-spline knows of itself; private to this floor.
#pragma once

#include <vector>

#include "osculate/bezier/bernstein.h"
#include "osculate/bezier/bspline_curve.h"

namespace osculate {

struct BSplineCurve::State {
  BSplineData data;
  std::vector<double> flat;  ///< flat knots; of a periodic curve continued on both sides
  Poles unrolled;            ///< poles of a periodic curve repeated to fit `flat`, else empty
  std::vector<double> unrolledWeights;
  std::vector<int> spans;  ///< indices i with flat[i] < flat[i+1] inside the range
  double first = 0.0;
  double last = 0.0;
  Vector3 ends[2];
  Vector3 middle;

  const double* poles() const { return data.periodic ? unrolled.data() : data.poles.data(); }
  const double* weights() const {
    if (data.weights.empty()) return nullptr;
    return data.periodic ? unrolledWeights.data() : data.weights.data();
  }
  int poleCount() const {
    return static_cast<int>(data.periodic ? unrolled.cols() : data.poles.cols());
  }
  /// Flat knot and pole by number; int in, so that index arithmetic stays readable.
  double knot(int i) const { return flat[static_cast<std::size_t>(i)]; }
  NetPoint netPole(int i) const;
  /// Throws std::invalid_argument for a span that does not exist.
  int flatSpan(int span) const;
  Vector3 evaluate(double t) const;
};

/// Flat knots of a periodic curve, continued by whole periods to degree+1 knots at or before the
/// first and at or after the last (as BSplCLib::KnotSequence does). `turns` periods are laid out.
std::vector<double> periodicFlatKnots(const BSplineData& data, int turns);
/// The same curve as a not periodic one over `turns` periods from its first knot.
BSplineData unrollPeriods(const BSplineData& data, int turns);

/// The Bézier segment of the flat span i. See bspline_extraction.cpp.
BezierSegment extractSegment(const BSplineCurve::State& state, int flatSpan);
SpanExtraction extractionOf(const BSplineCurve::State& state, int flatSpan);
/// The blossom of the polynomial on the flat span i at `degree` arguments.
NetPoint blossom(const BSplineCurve::State& state, int flatSpan, std::span<const double> arguments);

}  // namespace osculate
