#include "osculate/bezier/simplex_net.h"

#include <algorithm>
#include <array>

namespace osculate {

namespace {

/// Calls f(position, step) for a net of this degree, step the distance to V_{i+e_2} in the net one
/// degree higher; V_{i+e_1} is at the same position, V_{i+e_3}.. follow from the rest sums.
template <int Corners, class F>
void forPositions(int degree, F f) {
  int position = 0;
  if constexpr (Corners == 3) {
    for (int rest = 0; rest <= degree; ++rest) {
      for (int last = 0; last <= rest; ++last)
        f(position++, rest + 1, 0);
    }
  } else {
    for (int layer = 0; layer <= degree; ++layer) {
      for (int rest = 0; rest <= layer; ++rest) {
        for (int last = 0; last <= rest; ++last)
          f(position++, (layer + 1) * (layer + 2) / 2, rest + 1);
      }
    }
  }
}

template <int Corners, int PartCorners>
struct PartFiller {
  const PartCornersOf<Corners, PartCorners>& corners;
  SimplexNet& part;
  MultiIndex<PartCorners> index{};

  /// All points whose remaining arguments are the corners 0 .. corner.
  void fill(SimplexNet net, int degree, int corner) {
    const auto c = static_cast<std::size_t>(corner);
    if (corner == 0) {
      for (int d = degree; d > 0; --d)
        reduceNet<Corners>(net, d, corners[c]);
      index[c] = degree;
      part.col(netIndex<PartCorners>(index)) = net.col(0);
      return;
    }
    for (int count = 0;; ++count) {
      index[c] = count;
      fill(net, degree - count, corner - 1);
      if (count == degree) break;
      reduceNet<Corners>(net, degree - count, corners[c]);
    }
  }
};

/// The positions of the points on one line of the net parallel to the edge a-b, from a to b.
template <int Corners>
std::vector<int> linePositions(MultiIndex<Corners> start, int a, int b) {
  std::vector<int> positions;
  const auto ia = static_cast<std::size_t>(a);
  const auto ib = static_cast<std::size_t>(b);
  for (const int length = start[ia]; start[ib] <= length; --start[ia], ++start[ib])
    positions.push_back(netIndex<Corners>(start));
  return positions;
}

/// One step of de Casteljau for columns of a fixed length: of points, homogeneous or not.
template <int Corners, int Rows>
void reduceRows(double* data, int degree, const Barycentric<Corners>& at) {
  forPositions<Corners>(degree - 1, [&](int position, int step, int inner) {
    double* const to = data + Rows * position;
    const double* const second = to + Rows * step;
    const double* const third = second + Rows * (Corners == 3 ? 1 : inner);
    std::array<double, Rows> sums;
    for (std::size_t row = 0; row < Rows; ++row) {
      sums[row] = at[0] * to[row] + at[1] * second[row];
      if constexpr (Corners >= 3) sums[row] += at[2] * third[row];
      if constexpr (Corners >= 4) sums[row] += at[3] * third[Rows + row];
    }
    std::copy(sums.begin(), sums.end(), to);
  });
}

template <int Corners>
void reduceAnyRows(SimplexNet& net, int degree, const Barycentric<Corners>& at) {
  const Eigen::Index rows = net.rows();
  double* const data = net.data();
  forPositions<Corners>(degree - 1, [&](int position, int step, int inner) {
    double* const to = data + rows * position;
    const double* const second = to + rows * step;
    const double* const third = second + rows * (Corners == 3 ? 1 : inner);
    for (Eigen::Index row = 0; row < rows; ++row) {
      double sum = at[0] * to[row] + at[1] * second[row];
      if constexpr (Corners >= 3) sum += at[2] * third[row];
      if constexpr (Corners >= 4) sum += at[3] * third[rows + row];
      to[row] = sum;
    }
  });
}

}  // namespace

template <int Corners>
void reduceNet(SimplexNet& net, int degree, const Barycentric<Corners>& at) {
  switch (net.rows()) {
    case 3:
      return reduceRows<Corners, 3>(net.data(), degree, at);
    case 4:
      return reduceRows<Corners, 4>(net.data(), degree, at);
    case 5:
      return reduceRows<Corners, 5>(net.data(), degree, at);
    default:
      return reduceAnyRows<Corners>(net, degree, at);
  }
}

template <int Corners>
void blossomNet(SimplexNet& net, int degree, std::span<const Barycentric<Corners>> arguments) {
  for (const Barycentric<Corners>& argument : arguments)
    reduceNet<Corners>(net, degree--, argument);
}

template <int Corners, int PartCorners>
SimplexNet partNet(const SimplexNet& net, int degree,
                   const PartCornersOf<Corners, PartCorners>& corners) {
  SimplexNet part(net.rows(), netSize<PartCorners>(degree));
  PartFiller<Corners, PartCorners>{corners, part}.fill(net, degree, PartCorners - 1);
  return part;
}

template <int Corners>
SimplexNet bisectNet(SimplexNet& net, int degree, int a, int b) {
  SimplexNet other = net;
  for (const MultiIndex<Corners>& start : multiIndices<Corners>(degree)) {
    if (start[static_cast<std::size_t>(b)] != 0) continue;
    // the univariate de Casteljau at 1/2 along each line parallel to the edge
    const std::vector<int> line = linePositions<Corners>(start, a, b);
    for (std::size_t r = 1; r < line.size(); ++r) {
      for (std::size_t i = 0; i + r < line.size(); ++i)
        other.col(line[i]) = 0.5 * (other.col(line[i]) + other.col(line[i + 1]));
      net.col(line[r]) = other.col(line[0]);
    }
  }
  return other;
}

template <int Corners>
SimplexNet elevateNet(const SimplexNet& net, int degree) {
  SimplexNet raised = SimplexNet::Zero(net.rows(), netSize<Corners>(degree + 1));
  int position = 0;
  for (const MultiIndex<Corners>& index : multiIndices<Corners>(degree + 1)) {
    for (int c = 0; c < Corners; ++c) {
      const int count = index[static_cast<std::size_t>(c)];
      if (count == degree + 1) {
        raised.col(position) = net.col(netIndex<Corners>(shifted<Corners>(index, c, -1)));
      } else if (count > 0) {
        raised.col(position) += static_cast<double>(count) / (degree + 1) *
                                net.col(netIndex<Corners>(shifted<Corners>(index, c, -1)));
      }
    }
    ++position;
  }
  return raised;
}

template <int Corners>
SimplexNet shiftedNet(const SimplexNet& net, int degree, int corner) {
  SimplexNet result(net.rows(), netSize<Corners>(degree - 1));
  int position = 0;
  for (const MultiIndex<Corners>& index : multiIndices<Corners>(degree - 1))
    result.col(position++) = net.col(netIndex<Corners>(shifted<Corners>(index, corner)));
  return result;
}

template <int Corners>
SimplexNet faceNet(const SimplexNet& net, int degree, int oppositeCorner) {
  SimplexNet face(net.rows(), netSize<Corners - 1>(degree));
  Eigen::Index from = 0;
  Eigen::Index to = 0;
  for (const MultiIndex<Corners>& index : multiIndices<Corners>(degree)) {
    if (index[static_cast<std::size_t>(oppositeCorner)] == 0) face.col(to++) = net.col(from);
    ++from;
  }
  return face;
}

template <int Corners>
Eigen::RowVectorXd multinomials(int degree) {
  Eigen::RowVectorXd factors(netSize<Corners>(degree));
  Eigen::Index position = 0;
  for (const MultiIndex<Corners>& index : multiIndices<Corners>(degree))
    factors[position++] = multinomial<Corners>(index);
  return factors;
}

template <int Corners>
Eigen::RowVectorXd multiplyMonomials(const Eigen::RowVectorXd& a, int degreeA,
                                     const Eigen::RowVectorXd& b, int degreeB) {
  Eigen::RowVectorXd product = Eigen::RowVectorXd::Zero(netSize<Corners>(degreeA + degreeB));
  const std::vector<MultiIndex<Corners>> indicesA = multiIndices<Corners>(degreeA);
  const std::vector<MultiIndex<Corners>> indicesB = multiIndices<Corners>(degreeB);
  for (std::size_t i = 0; i < indicesA.size(); ++i) {
    const double factor = a[static_cast<Eigen::Index>(i)];
    for (std::size_t j = 0; j < indicesB.size(); ++j) {
      MultiIndex<Corners> sum = indicesA[i];
      for (std::size_t c = 0; c < sum.size(); ++c)
        sum[c] += indicesB[j][c];
      product[netIndex<Corners>(sum)] += factor * b[static_cast<Eigen::Index>(j)];
    }
  }
  return product;
}

#define OSCULATE_SIMPLEX_NET(C)                                                          \
  template void reduceNet<C>(SimplexNet&, int, const Barycentric<C>&);                   \
  template void blossomNet<C>(SimplexNet&, int, std::span<const Barycentric<C>>);        \
  template SimplexNet partNet<C, C>(const SimplexNet&, int, const PartCornersOf<C, C>&); \
  template SimplexNet partNet<C, 2>(const SimplexNet&, int, const PartCornersOf<C, 2>&); \
  template SimplexNet bisectNet<C>(SimplexNet&, int, int, int);                          \
  template SimplexNet elevateNet<C>(const SimplexNet&, int);                             \
  template SimplexNet shiftedNet<C>(const SimplexNet&, int, int);                        \
  template SimplexNet faceNet<C>(const SimplexNet&, int, int);                           \
  template Eigen::RowVectorXd multinomials<C>(int);                                      \
  template Eigen::RowVectorXd multiplyMonomials<C>(const Eigen::RowVectorXd&, int,       \
                                                   const Eigen::RowVectorXd&, int);
OSCULATE_SIMPLEX_NET(3)
OSCULATE_SIMPLEX_NET(4)
#undef OSCULATE_SIMPLEX_NET
template SimplexNet partNet<4, 3>(const SimplexNet&, int, const PartCornersOf<4, 3>&);

}  // namespace osculate
