// Work in a process of its own, so that its crash, its hang and its chatter stay there.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <functional>
#include <optional>
#include <string>

namespace osculate::cli {

using Clock = std::chrono::steady_clock;

/// A child of this process; killed, if it still runs, when this goes.
class ChildProcess {
 public:
  /// Runs `work` with the write end of a pipe; the child ends with what it returns. `work` must not
  /// throw. Throws std::runtime_error where the system makes no process. To be called by a process
  /// of one thread only.
  explicit ChildProcess(const std::function<int(int pipe)>& work, double timeLimit);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// The read end of the pipe, which is not blocking.
  int pipe() const { return pipe_; }
  /// When the time limit ends; empty: never.
  std::optional<Clock::time_point> deadline() const { return deadline_; }
  void kill();
  /// Waits for its end and returns what waitpid said.
  int wait();

 private:
  pid_t id_ = -1;
  int pipe_ = -1;
  std::optional<Clock::time_point> deadline_;
};

/// "signal 11 (Segmentation fault)", "status 3"; empty for a child that ended with 0.
std::string describeEnd(int waitStatus);

/// Runs a whole command in a child that shares this process's standard streams, and returns its
/// exit status; kFailure with a message on standard error where the child crashed or took longer
/// than `timeLimit` seconds (0: no limit). `file` is what the message speaks of.
int runContained(const std::string& file, double timeLimit, const std::function<int()>& command);

/// Nothing that is printed reaches standard output as long as this lives: OpenCASCADE prints there.
class SilentOutput {
 public:
  SilentOutput();
  ~SilentOutput();
  SilentOutput(const SilentOutput&) = delete;
  SilentOutput& operator=(const SilentOutput&) = delete;

 private:
  int kept_;
};

}  // namespace osculate::cli
