// An order, degree or position, an int in the formulas, as the index of a container.
#pragma once

#include <cstddef>

namespace osculate {

constexpr std::size_t index(int i) { return static_cast<std::size_t>(i); }

}  // namespace osculate
