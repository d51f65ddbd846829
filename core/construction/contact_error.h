// The error of a construction whose request cannot be met.
#pragma once

#include <stdexcept>

namespace osculate {

/// Says what cannot be met and what can.
class ContactError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

}  // namespace osculate
