// A line on a terminal that says how far long work is; nothing anywhere else.
#pragma once

#include <chrono>
#include <cstddef>
#include <vector>

namespace osculate::cli {

class ProgressLine {
 public:
  /// Shows nothing where `wanted` is false or standard error is no terminal.
  ProgressLine(std::size_t files, bool wanted);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void show(std::size_t done, const std::vector<double>& underWay);

 private:
  std::size_t files_;
  bool shown_;
  std::chrono::steady_clock::time_point last_;
};

}  // namespace osculate::cli
