// Gathers a long text into pieces for a sink; private to this floor.
#pragma once

#include <string>
#include <string_view>

#include "osculate/continuity/audit_document.h"

namespace osculate {

class TextPieces {
 public:
  explicit TextPieces(const TextSink& sink) : sink_(sink) {}

  TextPieces& operator<<(std::string_view text) {
    piece_ += text;
    if (piece_.size() >= kSize) flush();
    return *this;
  }
  /// Hands over what is left; to be called at the end.
  void flush() {
    sink_(piece_);
    piece_.clear();
  }

 private:
  static constexpr std::size_t kSize = 1 << 16;
  const TextSink& sink_;
  std::string piece_;
};

}  // namespace osculate
