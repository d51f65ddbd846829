#include "osculate/cli/audit_message.h"

#include <cstring>
#include <stdexcept>
#include <type_traits>

namespace osculate::cli {

namespace {

static_assert(std::is_trivially_copyable_v<AuditRow>, "rows go as they are in memory");

class Packer {
 public:
  template <class Value>
  void add(const Value& value) {
    static_assert(std::is_trivially_copyable_v<Value>);
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void add(const std::string& text) {
    add(text.size());
    bytes_ += text;
  }
  void addRows(const std::vector<AuditRow>& rows) {
    add(rows.size());
    bytes_.append(reinterpret_cast<const char*>(rows.data()), rows.size() * sizeof(AuditRow));
  }
  /// The message: its kind and its length go first.
  std::string message(char kind) && {
    std::string head(1, kind);
    const std::size_t length = bytes_.size();
    head.append(reinterpret_cast<const char*>(&length), sizeof length);
    return bytes_.insert(0, head);
  }

 private:
  std::string bytes_;
};

class Unpacker {
 public:
  explicit Unpacker(std::string_view bytes) : bytes_(bytes) {}

  template <class Value>
  Value take() {
    Value value;
    std::memcpy(&value, next(sizeof value), sizeof value);
    return value;
  }
  std::string takeText() {
    const auto length = take<std::size_t>();
    return {next(length), length};
  }
  std::vector<AuditRow> takeRows() {
    const auto count = take<std::size_t>();
    const char* from = next(count * sizeof(AuditRow));
    std::vector<AuditRow> rows(count);
    if (count > 0) std::memcpy(static_cast<void*>(rows.data()), from, count * sizeof(AuditRow));
    return rows;
  }

 private:
  const char* next(std::size_t length) {
    if (length > bytes_.size()) throw std::runtime_error("a child process sent half a message");
    const char* from = bytes_.data();
    bytes_.remove_prefix(length);
    return from;
  }

  std::string_view bytes_;
};

constexpr char kProgress = 'p';
constexpr char kResult = 'r';
constexpr std::size_t kHead = 1 + sizeof(std::size_t);

AuditedFile unpackResult(Unpacker from) {
  AuditedFile file;
  file.status = from.take<FileStatus>();
  file.message = from.takeText();
  file.notes.resize(from.take<std::size_t>());
  for (std::string& note : file.notes)
    note = from.takeText();
  AuditReport& report = file.report;
  report.edgeCount = from.take<int>();
  report.corners = from.take<std::size_t>();
  report.skipped.resize(from.take<std::size_t>());
  for (SkippedEdge& edge : report.skipped) {
    edge.edge = from.take<int>();
    edge.degenerated = from.take<bool>();
    edge.reason = from.takeText();
  }
  report.rows = from.takeRows();
  return file;
}

}  // namespace

std::string packProgress(double share) {
  Packer packer;
  packer.add(share);
  return std::move(packer).message(kProgress);
}

std::string packResult(const AuditedFile& file) {
  Packer packer;
  packer.add(file.status);
  packer.add(file.message);
  packer.add(file.notes.size());
  for (const std::string& note : file.notes)
    packer.add(note);
  packer.add(file.report.edgeCount);
  packer.add(file.report.corners);
  packer.add(file.report.skipped.size());
  for (const SkippedEdge& edge : file.report.skipped) {
    packer.add(edge.edge);
    packer.add(edge.degenerated);
    packer.add(edge.reason);
  }
  packer.addRows(file.report.rows);
  return std::move(packer).message(kResult);
}

std::optional<AuditMessage> takeMessage(std::string& bytes) {
  if (bytes.size() < kHead) return std::nullopt;
  std::size_t length = 0;
  std::memcpy(&length, bytes.data() + 1, sizeof length);
  if (bytes[0] != kProgress && bytes[0] != kResult)
    throw std::runtime_error("a child process sent no message");
  if (bytes.size() - kHead < length) return std::nullopt;
  AuditMessage message;
  Unpacker content(std::string_view(bytes).substr(kHead, length));
  if (bytes[0] == kProgress) {
    message.share = content.take<double>();
  } else {
    message.share = 1.0;
    message.result = unpackResult(content);
  }
  bytes.erase(0, kHead + length);
  return message;
}

}  // namespace osculate::cli
