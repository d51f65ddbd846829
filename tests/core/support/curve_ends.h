// Checks at both ends of random curves.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <initializer_list>
#include <string>

#include "support/random_curves.h"

namespace osculate::test {

/// Low degrees, the highest and some between.
inline constexpr auto kEndDegrees = {1, 2, 3, 4, 5, 7, 8, 9, 12, 18, kMaxDegree};

/// Calls check(random, curve, end) for polynomial and rational curves of each degree.
template <class Check>
void forEnds(std::uint64_t seed, std::initializer_list<int> degrees, Check check) {
  Random random(seed);
  for (const int degree : degrees) {
    for (const bool rational : {false, true}) {
      for (const CurveEnd end : {CurveEnd::kStart, CurveEnd::kEnd}) {
        SCOPED_TRACE("degree " + std::to_string(degree) + (rational ? " rational" : " polynomial") +
                     (end == CurveEnd::kStart ? " at its start" : " at its end"));
        check(random, randomBezier(random, degree, rational), end);
      }
    }
  }
}

}  // namespace osculate::test
