// What of a curve was changed, and by how much.
#pragma once

#include <optional>

#include "osculate/bezier/bezier_curve.h"

namespace osculate {

struct CurveChange {
  CurveEnd end = CurveEnd::kEnd;  ///< the end that meets the other curve now
  int raised = 0;                 ///< by how much the degree was raised
  int spans = 0;                  ///< that differ, from that end
  int poles = 0;                  ///< likewise; all others are the curve's own, bit for bit, if the
                                  ///< degree was not raised
  double first = 0.0;             ///< the range of parameters over which the curve differs
  double last = 0.0;
  double largestMm = 0.0;           ///< no point moved farther from that of the same parameter
  double parameter = 0.0;           ///< where that is
  Vector3 point = Vector3::Zero();  ///< on the curve as it was, mm
  Vector3 moved = Vector3::Zero();  ///< where it is now, mm
  double rootMeanSquareMm = 0.0;    ///< over the arc length of the changed spans as they were
  /// Derivatives at the far end that stay; nothing: all, its segment is the same.
  std::optional<int> kept{};
};

}  // namespace osculate
