#include "osculate/cli/file_audits.h"

#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <memory>
#include <new>
#include <thread>

#include "osculate/cli/audit_message.h"
#include "osculate/cli/child_process.h"
#include "osculate/cli/exit_status.h"
#include "osculate/occt/audit.h"
#include "osculate/occt/model_file.h"

namespace osculate::cli {

namespace {

/// The sentence of readModel without its argument and the path, which stand beside it anyway.
std::string reason(std::string message, const std::string& path) {
  const std::string prefix = "file: " + path + " ";
  if (message.rfind(prefix, 0) == 0) message.erase(0, prefix.size());
  return message;
}

bool sendAll(int pipe, const std::string& bytes) {
  std::size_t sent = 0;
  while (sent < bytes.size()) {
    const ssize_t written = ::write(pipe, bytes.data() + sent, bytes.size() - sent);
    if (written < 0 && errno != EINTR) return false;
    if (written > 0) sent += static_cast<std::size_t>(written);
  }
  return true;
}

AuditedFile auditFile(const std::string& path, const AuditOptions& options, int pipe) {
  AuditedFile file;
  try {
    Model model = readModel(path);
    ShapeAudit audit(model.shape, options,
                     [&](double share) { return sendAll(pipe, packProgress(share)); });
    file.notes = std::move(model.notes);
    file.report = audit.takeReport();
  } catch (const std::bad_alloc&) {
    file.status = FileStatus::kCrashed;
    file.message = "out of memory";
  } catch (const std::exception& error) {
    file.status = FileStatus::kUnreadable;
    file.message = reason(error.what(), path);
  }
  return file;
}

/// One file on its way.
class Job {
 public:
  Job(std::size_t index, const std::string& path, const FileAuditOptions& options)
      : index_(index),
        timeLimit_(options.timeLimit),
        child_([&](int pipe) { return work(pipe, path, options.audit); }, options.timeLimit) {}

  std::size_t index() const { return index_; }
  double share() const { return share_; }
  int pipe() const { return child_.pipe(); }
  std::optional<Clock::time_point> deadline() const { return child_.deadline(); }

  /// Reads what has come. The result, once the child is done, one way or the other.
  std::optional<AuditedFile> advance() {
    const bool isOpen = read();
    try {
      while (auto message = takeMessage(bytes_)) {
        share_ = message->share;
        if (message->result) return std::move(message->result);
      }
    } catch (const std::exception& error) {
      return failed(FileStatus::kCrashed, error.what());
    }
    if (!isOpen)
      return failed(FileStatus::kCrashed, "OpenCASCADE broke down: " + describeEnd(child_.wait()));
    const auto end = child_.deadline();
    if (!end || Clock::now() < *end) return std::nullopt;
    child_.kill();
    return failed(FileStatus::kTimedOut, "took longer than " + seconds(timeLimit_));
  }

 private:
  static int work(int pipe, const std::string& path, const AuditOptions& options) {
    const SilentOutput silent;
    return sendAll(pipe, packResult(auditFile(path, options, pipe))) ? kFine : kFailure;
  }

  static std::string seconds(double value) {
    std::string text = std::to_string(value);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text + " s";
  }

  static AuditedFile failed(FileStatus status, std::string message) {
    AuditedFile file;
    file.status = status;
    file.message = std::move(message);
    return file;
  }

  /// False once the child has closed its end.
  bool read() {
    constexpr std::size_t kPiece = 1 << 16;
    for (;;) {
      const std::size_t had = bytes_.size();
      bytes_.resize(had + kPiece);
      const ssize_t got = ::read(child_.pipe(), bytes_.data() + had, kPiece);
      bytes_.resize(had + static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
      if (got == 0) return false;
      if (got < 0 && errno != EINTR) return errno == EAGAIN;
    }
  }

  std::size_t index_;
  double timeLimit_;
  double share_ = 0.0;
  std::string bytes_;
  ChildProcess child_;
};

/// Waits for news of any job, at most until the first deadline and a tenth of a second.
void waitForNews(const std::vector<std::unique_ptr<Job>>& jobs) {
  std::vector<pollfd> pipes;
  auto until = Clock::now() + std::chrono::milliseconds(100);
  for (const auto& job : jobs) {
    pipes.push_back({job->pipe(), POLLIN, 0});
    if (const auto deadline = job->deadline()) until = std::min(until, *deadline);
  }
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(until - Clock::now());
  ::poll(pipes.data(), pipes.size(), static_cast<int>(std::max<std::int64_t>(left.count(), 0)));
}

}  // namespace

std::vector<AuditedFile> auditFiles(const std::vector<std::string>& files,
                                    const FileAuditOptions& options,
                                    const FilesProgress& progress) {
  const int processors = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  const int jobs = std::min(options.jobs > 0 ? options.jobs : processors,
                            static_cast<int>(std::max<std::size_t>(files.size(), 1)));
  FileAuditOptions each = options;
  if (each.audit.threads == 0) each.audit.threads = std::max(1, processors / jobs);

  std::vector<AuditedFile> results(files.size());
  std::vector<std::unique_ptr<Job>> underWay;
  std::size_t started = 0;
  while (started < files.size() || !underWay.empty()) {
    while (started < files.size() && underWay.size() < static_cast<std::size_t>(jobs)) {
      underWay.push_back(std::make_unique<Job>(started, files[started], each));
      ++started;
    }
    waitForNews(underWay);
    std::erase_if(underWay, [&](const std::unique_ptr<Job>& job) {
      std::optional<AuditedFile> result = job->advance();
      if (result) results[job->index()] = std::move(*result);
      return result.has_value();
    });
    std::vector<double> shares;
    shares.reserve(underWay.size());
    for (const auto& job : underWay)
      shares.push_back(job->share());
    progress(started - underWay.size(), shares);
  }
  for (std::size_t i = 0; i < files.size(); ++i) {
    results[i].file = files[i];
    results[i].report.options = options.audit;
  }
  return results;
}

}  // namespace osculate::cli
