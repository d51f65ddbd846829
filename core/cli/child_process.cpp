#include "osculate/cli/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <stdexcept>

#include "osculate/cli/exit_status.h"

namespace osculate::cli {

namespace {

[[noreturn]] void fail(const char* what) {
  throw std::runtime_error(std::string(what) + ": " + std::strerror(errno));
}

/// It ends with its parent, and leaves no core file behind.
void settleChild(pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(kFailure);
  const rlimit none{0, 0};
  ::setrlimit(RLIMIT_CORE, &none);
}

}  // namespace

ChildProcess::ChildProcess(const std::function<int(int pipe)>& work, double timeLimit) {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) fail("no pipe to a child process");
  std::fflush(nullptr);
  std::cout.flush();
  const pid_t parent = ::getpid();
  id_ = ::fork();
  if (id_ < 0) {
    ::close(ends[0]);
    ::close(ends[1]);
    fail("no child process");
  }
  if (id_ == 0) {
    ::close(ends[0]);
    settleChild(parent);
    const int status = work(ends[1]);
    std::cout.flush();
    std::fflush(nullptr);
    ::_exit(status);
  }
  ::close(ends[1]);
  pipe_ = ends[0];
  ::fcntl(pipe_, F_SETFL, O_NONBLOCK);
  if (timeLimit > 0.0) {
    deadline_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                   std::chrono::duration<double>(timeLimit));
  }
}

ChildProcess::~ChildProcess() {
  kill();
  wait();
  ::close(pipe_);
}

void ChildProcess::kill() {
  if (id_ > 0) ::kill(id_, SIGKILL);
}

int ChildProcess::wait() {
  int status = 0;
  if (id_ > 0) {
    while (::waitpid(id_, &status, 0) < 0 && errno == EINTR) {
    }
    id_ = -1;
  }
  return status;
}

std::string describeEnd(int waitStatus) {
  if (WIFSIGNALED(waitStatus)) {
    const int number = WTERMSIG(waitStatus);
    return "signal " + std::to_string(number) + " (" + ::strsignal(number) + ")";
  }
  const int status = WEXITSTATUS(waitStatus);
  return status == 0 ? "" : "status " + std::to_string(status);
}

int runContained(const std::string& file, double timeLimit, const std::function<int()>& command) {
  ChildProcess child([&](int) { return command(); }, timeLimit);
  pollfd end{child.pipe(), POLLIN, 0};
  bool timedOut = false;
  for (;;) {
    int wait = -1;
    if (const auto deadline = child.deadline()) {
      const auto left = std::chrono::ceil<std::chrono::milliseconds>(*deadline - Clock::now());
      timedOut = left.count() <= 0;
      wait = timedOut ? 0 : static_cast<int>(std::min<std::int64_t>(left.count(), 60'000));
    }
    if (timedOut || ::poll(&end, 1, wait) > 0) break;
  }
  if (timedOut) child.kill();
  const int status = child.wait();
  if (timedOut) {
    std::cerr << "osculate: " << file << " took longer than " << timeLimit << " s\n";
    return kFailure;
  }
  if (WIFSIGNALED(status)) {
    std::cerr << "osculate: " << file << " made OpenCASCADE break down: " << describeEnd(status)
              << "\n";
    return kFailure;
  }
  return WEXITSTATUS(status);
}

SilentOutput::SilentOutput() {
  std::cout.flush();
  std::fflush(stdout);
  kept_ = ::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 3);
  const int nothing = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nothing >= 0) {
    ::dup2(nothing, STDOUT_FILENO);
    ::close(nothing);
  }
}

SilentOutput::~SilentOutput() {
  std::cout.flush();
  std::fflush(stdout);
  if (kept_ < 0) {
    ::close(STDOUT_FILENO);
    return;
  }
  ::dup2(kept_, STDOUT_FILENO);
  ::close(kept_);
}

}  // namespace osculate::cli
