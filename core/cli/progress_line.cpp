#include "osculate/cli/progress_line.h"

#include <unistd.h>

#include <cstdio>
#include <numeric>

namespace osculate::cli {

namespace {
constexpr const char* kClear = "\r\033[K";
}

ProgressLine::ProgressLine(std::size_t files, bool wanted)
    : files_(files), shown_(wanted && ::isatty(STDERR_FILENO) == 1) {}

ProgressLine::~ProgressLine() {
  if (shown_) std::fputs(kClear, stderr);
}

void ProgressLine::show(std::size_t done, const std::vector<double>& underWay) {
  constexpr std::chrono::milliseconds kBetween{100};
  const auto now = std::chrono::steady_clock::now();
  if (!shown_ || now - last_ < kBetween) return;
  last_ = now;
  const double sum = std::accumulate(underWay.begin(), underWay.end(), static_cast<double>(done));
  std::fprintf(stderr, "%s%zu of %zu files, %.0f %%", kClear, done, files_,
               100.0 * sum / static_cast<double>(files_));
  std::fflush(stderr);
}

}  // namespace osculate::cli
