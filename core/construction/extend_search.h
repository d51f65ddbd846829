// The fairest extension of one degree; private to this floor.
#pragma once

#include "osculate/construction/extend_request.h"

namespace osculate {

/// A curve of one degree that meets the request.
struct FoundExtension {
  BezierCurve curve;
  std::optional<double> objective{};
  int freeNumbers = 0;
};

/// The fairest curve of this degree that is found from several starts, one of them `lower`, a curve
/// of a lower degree, where given; nothing where none is found. Throws ContactError where numbers
/// are left free and the request has no fairness.
std::optional<FoundExtension> findExtension(const ExtendRequest& request, int degree,
                                            const FoundExtension* lower = nullptr);

}  // namespace osculate
