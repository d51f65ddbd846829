// The order of a triangular or tetrahedral net: indices that sum to the degree, lexicographic from
// (n, 0, ..., 0) to (0, ..., 0, n).
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace osculate {

/// The largest degree of a Bézier triangle or tetrahedron that is a value of its own.
inline constexpr int kMaxSimplexDegree = 12;

/// Exponents or differences for each corner: (i, j, k) of a triangle, (i, j, k, l) of a
/// tetrahedron.
template <int Corners>
using MultiIndex = std::array<int, static_cast<std::size_t>(Corners)>;

/// The number of points of a net of this degree: n+1, (n+1)(n+2)/2, (n+1)(n+2)(n+3)/6 for 2, 3, 4
/// corners.
template <int Corners>
constexpr int netSize(int degree) {
  int size = 1;
  for (int c = 1; c < Corners; ++c)
    size = size * (degree + c) / c;
  return size;
}

/// The position of a point in its net. It does not depend on the first entry, and so not on the
/// degree: a net of degree n-1 takes the first positions of a net of degree n.
template <int Corners>
constexpr int netIndex(const MultiIndex<Corners>& index) {
  int position = index[Corners - 1];
  int rest = position;
  if constexpr (Corners >= 3) {
    rest += index[Corners - 2];
    position += rest * (rest + 1) / 2;
  }
  if constexpr (Corners >= 4) {
    rest += index[Corners - 3];
    position += rest * (rest + 1) * (rest + 2) / 6;
  }
  return position;
}

/// All indices of a net in its order.
template <int Corners>
std::vector<MultiIndex<Corners>> multiIndices(int degree) {
  std::vector<MultiIndex<Corners>> indices;
  indices.reserve(static_cast<std::size_t>(netSize<Corners>(degree)));
  MultiIndex<Corners> index{};
  const auto descend = [&](const auto& self, std::size_t corner, int rest) -> void {
    if (corner + 1 == index.size()) {
      index[corner] = rest;
      indices.push_back(index);
      return;
    }
    for (int count = rest; count >= 0; --count) {
      index[corner] = count;
      self(self, corner + 1, rest - count);
    }
  };
  descend(descend, 0, degree);
  return indices;
}

/// The index with `change` added at one corner.
template <int Corners>
constexpr MultiIndex<Corners> shifted(MultiIndex<Corners> index, int corner, int change = 1) {
  index[static_cast<std::size_t>(corner)] += change;
  return index;
}

/// n! / (i! j! ...): the factor of a Bernstein polynomial; exact below 2^53.
template <int Corners>
constexpr double multinomial(const MultiIndex<Corners>& index) {
  double factor = 1.0;
  int total = 0;
  for (const int count : index) {
    for (int i = 1; i <= count; ++i)
      factor = factor * ++total / i;
  }
  return factor;
}

}  // namespace osculate
