#include "osculate/bezier/simplex_evaluator.h"

#include <algorithm>
#include <array>
#include <vector>

namespace osculate {

namespace {

/// Points that are worked on side by side, so that the compiler uses SIMD registers.
constexpr int kLanes = 4;
using Lane = Eigen::Array<double, kLanes, 1>;
constexpr std::size_t kPowers = kMaxSimplexDegree + 1;

/// Coordinates from accumulated rows, of which the last is the weight where there is one more than
/// the dimension; `count` of the lanes are used.
template <int Rows, int Dimension>
void store(const std::array<Lane, Rows>& sums, int count, double* out) {
  Lane factor = Lane::Ones();
  if constexpr (Rows > Dimension) factor = sums[Rows - 1].inverse();
  std::array<double, Dimension * kLanes> points;
  for (std::size_t row = 0; row < Dimension; ++row) {
    const Lane coordinate = sums[row] * factor;
    for (std::size_t lane = 0; lane < kLanes; ++lane)
      points[Dimension * lane + row] = coordinate[static_cast<Eigen::Index>(lane)];
  }
  if (count == kLanes) {  // a copy of known length is a few instructions
    std::copy(points.begin(), points.end(), out);
  } else {
    std::copy_n(points.begin(), Dimension * count, out);
  }
}

/// Powers 0..degree of the coordinates of kLanes points.
struct LanePowers {
  std::array<std::array<Lane, kPowers>, 4> of;

  LanePowers(const double* barycentric, int count, int degree) {
    for (std::size_t c = 0; c < 4; ++c) {
      Lane u;
      for (int lane = 0; lane < kLanes; ++lane)
        u[lane] = barycentric[4 * std::min(lane, count - 1) + static_cast<int>(c)];
      of[c][0].setOnes();
      for (std::size_t k = 1; k <= static_cast<std::size_t>(degree); ++k)
        of[c][k] = of[c][k - 1] * u;
    }
  }
};

/// Up to kLanes points.
template <int Rows, int Dimension>
void evaluateLanes(const LanePowers& powers, int degree, const double* scaled, std::size_t size,
                   int count, double* out) {
  std::array<Lane, Rows> sums;
  for (Lane& sum : sums)
    sum.setZero();
  const auto n = static_cast<std::size_t>(degree);
  std::size_t position = 0;
  for (std::size_t layer = 0; layer <= n; ++layer) {
    for (std::size_t rest = 0; rest <= layer; ++rest) {
      const Lane outer = powers.of[0][n - layer] * powers.of[1][layer - rest];
      for (std::size_t l = 0; l <= rest; ++l, ++position) {
        const Lane monomial = outer * powers.of[2][rest - l] * powers.of[3][l];
        for (std::size_t row = 0; row < Rows; ++row)
          sums[row] += scaled[row * size + position] * monomial;
      }
    }
  }
  store<Rows, Dimension>(sums, count, out);
}

/// (1-x)^(n-l) x^l at x = l'/count for l' = 0..count, a row for each l; rows are padded to kLanes.
class LineMonomials {
 public:
  LineMonomials(int degree, int count) : stride_((count + kLanes) / kLanes * kLanes) {
    values_.assign(static_cast<std::size_t>((degree + 1) * stride_), 0.0);
    for (int point = 0; point <= count; ++point) {
      const double x = count == 0 ? 0.0 : static_cast<double>(point) / count;
      double power = 1.0;
      for (int l = 0; l <= degree; ++l, power *= x)
        at(l)[point] = power;
      power = 1.0;
      for (int l = degree; l >= 0; --l, power *= 1.0 - x)
        at(l)[point] *= power;
    }
  }
  double* at(int l) { return values_.data() + l * stride_; }
  const double* at(int l) const { return values_.data() + l * stride_; }

 private:
  int stride_;
  std::vector<double> values_;
};

/// The coefficients of the lines u = const, v = const of the grid. All rows of a coefficient lie
/// side by side, for SIMD.
template <int Rows>
class GridLines {
 public:
  using Column = std::array<double, Rows>;

  /// scaled: rows x size, row by row.
  GridLines(int degree, const double* scaled, std::size_t size)
      : n_(degree), scaled_(size), atU_(size) {
    for (std::size_t row = 0; row < Rows; ++row) {
      for (std::size_t p = 0; p < size; ++p)
        scaled_[p][row] = scaled[row * size + p];
    }
  }

  /// sum over i of c_ijkl u^i, as coefficients of v^j w^k t^l with j + k + l <= n in the order of
  /// the net (which begins with the layer j + k + l = 0).
  void setU(double u) {
    const std::array<double, kPowers> powers = powersOf(u);
    std::size_t p = 0;
    for (int layer = 0; layer <= n_; ++layer) {
      const double power = powers[static_cast<std::size_t>(n_ - layer)];
      for (int i = netSize<3>(layer); i > 0; --i, ++p) {
        for (std::size_t row = 0; row < Rows; ++row)
          atU_[p][row] = scaled_[p][row] * power;
      }
    }
  }

  /// The line at this v over w + t = rho: coefficients of (1-x)^(n-l) x^l, w = rho (1-x), t = rho
  /// x. Terms w^k t^l with s = k + l < n are raised to degree n by ((1-x) + x)^(n-s).
  void setV(double v, double rho) {
    const std::array<double, kPowers> powers = powersOf(v);
    double scale = 1.0;
    for (int s = 0; s <= n_; ++s, scale *= rho) {
      line[static_cast<std::size_t>(s)].fill(0.0);
      for (int l = s; l > 0; --l)
        add(line[static_cast<std::size_t>(l)], 1.0, line[static_cast<std::size_t>(l - 1)]);
      for (int layer = s; layer <= n_; ++layer) {
        const double power = scale * powers[static_cast<std::size_t>(layer - s)];
        const Column* const from =
            atU_.data() + layer * (layer + 1) * (layer + 2) / 6 + s * (s + 1) / 2;
        for (int l = 0; l <= s; ++l)
          add(line[static_cast<std::size_t>(l)], power, from[l]);
      }
    }
  }

  std::array<Column, kPowers> line;

 private:
  static void add(Column& to, double factor, const Column& column) {
    for (std::size_t row = 0; row < Rows; ++row)
      to[row] += factor * column[row];
  }

  std::array<double, kPowers> powersOf(double x) const {
    std::array<double, kPowers> powers;
    powers[0] = 1.0;
    for (std::size_t k = 1; k <= static_cast<std::size_t>(n_); ++k)
      powers[k] = powers[k - 1] * x;
    return powers;
  }

  int n_;
  std::vector<Column> scaled_;
  std::vector<Column> atU_;
};

/// The points of one line of the grid.
template <int Rows, int Dimension>
void evaluateLine(const GridLines<Rows>& lines, const LineMonomials& monomials, int degree,
                  int count, double* out) {
  for (int first = 0; first <= count; first += kLanes) {
    std::array<Lane, Rows> sums;
    for (Lane& sum : sums)
      sum.setZero();
    for (int l = 0; l <= degree; ++l) {
      const Lane monomial = Eigen::Map<const Lane>(monomials.at(l) + first);
      const auto& coefficients = lines.line[static_cast<std::size_t>(l)];
      for (std::size_t row = 0; row < Rows; ++row)
        sums[row] += coefficients[row] * monomial;
    }
    store<Rows, Dimension>(sums, std::min(kLanes, count + 1 - first), out + first * Dimension);
  }
}

/// Calls f<Rows, Dimension>() for 3 or 4 coordinates, with or without a weight.
template <class F>
void withRows(int dimension, bool rational, F f) {
  if (dimension == 3)
    return rational ? f.template operator()<4, 3>() : f.template operator()<3, 3>();
  return rational ? f.template operator()<5, 4>() : f.template operator()<4, 4>();
}

}  // namespace

TetrahedronEvaluator::TetrahedronEvaluator(const BezierTetrahedron& solid)
    : degree_(solid.degree()),
      dimension_(solid.dimension()),
      rational_(solid.isRational()),
      scaled_(solid.homogeneous().array().rowwise() * multinomials<4>(solid.degree()).array()) {}

std::size_t TetrahedronEvaluator::gridSize(int m) {
  const auto size = static_cast<std::size_t>(m);
  return (size + 1) * (size + 2) * (size + 3) / 6;
}

void TetrahedronEvaluator::points(std::span<const double> barycentric,
                                  std::span<double> out) const {
  const std::size_t count = barycentric.size() / 4;
  const auto size = static_cast<std::size_t>(scaled_.cols());
  withRows(dimension_, rational_, [&]<int Rows, int Dimension>() {
    for (std::size_t first = 0; first < count; first += kLanes) {
      const int used = static_cast<int>(std::min<std::size_t>(kLanes, count - first));
      const LanePowers powers(barycentric.data() + 4 * first, used, degree_);
      evaluateLanes<Rows, Dimension>(powers, degree_, scaled_.data(), size, used,
                                     out.data() + first * Dimension);
    }
  });
}

void TetrahedronEvaluator::grid(int m, std::span<double> out) const {
  const auto size = static_cast<std::size_t>(scaled_.cols());
  std::vector<LineMonomials> monomials;
  for (int count = 0; count <= m; ++count)
    monomials.emplace_back(degree_, count);
  withRows(dimension_, rational_, [&]<int Rows, int Dimension>() {
    GridLines<Rows> lines(degree_, scaled_.data(), size);
    double* to = out.data();
    for (int layer = 0; layer <= m; ++layer) {
      lines.setU(static_cast<double>(m - layer) / m);
      for (int rest = 0; rest <= layer; ++rest) {
        lines.setV(static_cast<double>(layer - rest) / m, static_cast<double>(rest) / m);
        evaluateLine<Rows, Dimension>(lines, monomials[static_cast<std::size_t>(rest)], degree_,
                                      rest, to);
        to += (rest + 1) * Dimension;
      }
    }
  });
}

}  // namespace osculate
