// What the program ends with.
#pragma once

namespace osculate::cli {

enum ExitStatus : int {
  kFine = 0,
  kBelow = 1,   ///< a join is below --fail-below
  kFailure = 2  ///< bad use, a file that cannot be read or written
};

}  // namespace osculate::cli
