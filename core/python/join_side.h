// One side of a join as Python sees it; private to this floor.
#pragma once

#include <memory>

#include "osculate/continuity/curve_joins.h"

namespace osculate::python {

using JoinPointer = std::shared_ptr<CurveJoin>;

/// A side, which keeps its report alive.
struct JoinSideView {
  JoinPointer join;
  std::size_t index;

  const SideReport& report() const { return join->report.sides[index]; }
  const BezierSegment& segment() const {
    return index == 0 ? join->firstSegment : join->secondSegment;
  }
};

}  // namespace osculate::python
