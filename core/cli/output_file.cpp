#include "osculate/cli/output_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <stdexcept>

namespace osculate::cli {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const std::string& path, int error) {
  throw std::runtime_error("cannot write " + path + ": " + std::strerror(error));
}

/// A draft that vanishes unless it is put in place.
class Draft {
 public:
  explicit Draft(const std::string& target) : target_(followed(target)) {
    if (fs::is_directory(target_)) fail(target_, EISDIR);
    const fs::path path(target_);
    const std::string ending = path.extension();
    name_ = (path.parent_path() / ".osculate-XXXXXX").string() + ending;
    descriptor_ = ::mkstemps(name_.data(), static_cast<int>(ending.size()));
    if (descriptor_ < 0) fail(target_, errno);
  }
  ~Draft() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!name_.empty()) ::unlink(name_.c_str());
  }
  Draft(const Draft&) = delete;
  Draft& operator=(const Draft&) = delete;

  const std::string& name() const { return name_; }
  int descriptor() const { return descriptor_; }

  void putInPlace() {
    if (::chmod(name_.c_str(), permissions()) != 0 || ::fsync(descriptor_) != 0 ||
        ::rename(name_.c_str(), target_.c_str()) != 0)
      fail(target_, errno);
    name_.clear();
  }

 private:
  /// A link is written through, not replaced.
  static std::string followed(const std::string& path) {
    std::error_code error;
    const fs::path real = fs::weakly_canonical(path, error);
    return error ? path : real.string();
  }
  /// Those of the file that is replaced, or of a new file.
  mode_t permissions() const {
    struct stat existing {};
    if (::stat(target_.c_str(), &existing) == 0) return existing.st_mode & 0777U;
    const mode_t mask = ::umask(0);
    ::umask(mask);
    return 0666U & ~mask;
  }

  std::string target_;
  std::string name_;
  int descriptor_ = -1;
};

void writeAll(int descriptor, std::string_view text, const std::string& path) {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(path, errno);
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

}  // namespace

void writeOutput(const std::string& path, const std::function<void(const TextSink&)>& write) {
  if (isStandardOutput(path)) {
    std::fflush(stdout);
    write([](std::string_view piece) { writeAll(STDOUT_FILENO, piece, "to standard output"); });
    return;
  }
  // what is no regular file (/dev/null, a pipe) is written in place
  if (fs::exists(path) && !fs::is_regular_file(path) && !fs::is_directory(path)) {
    const int descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor < 0) fail(path, errno);
    write([&](std::string_view piece) { writeAll(descriptor, piece, path); });
    ::close(descriptor);
    return;
  }
  Draft draft(path);
  write([&](std::string_view piece) { writeAll(draft.descriptor(), piece, path); });
  draft.putInPlace();
}

void checkWritable(const std::string& path) {
  if (isStandardOutput(path)) return;
  if (fs::exists(path) && !fs::is_regular_file(path) && !fs::is_directory(path)) return;
  const Draft draft(path);
}

void replaceFile(const std::string& path, const std::function<void(const std::string&)>& make) {
  Draft draft(path);
  make(draft.name());
  draft.putInPlace();
}

}  // namespace osculate::cli
