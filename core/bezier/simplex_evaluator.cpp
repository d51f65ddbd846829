#include "osculate/bezier/simplex_evaluator.h"

#include <algorithm>

namespace osculate {

namespace {

/// Points that are worked on side by side, so that the compiler uses SIMD registers.
constexpr int kLanes = 4;
using Lane = std::array<double, kLanes>;
constexpr int kMaxRows = 5;  // four coordinates and the weight
constexpr std::size_t kPowers = kMaxSimplexDegree + 1;

/// Coordinates from accumulated rows; `count` of the lanes are used.
void store(const Lane* sums, int dimension, bool rational, int count, double* out) {
  Lane factor;
  factor.fill(1.0);
  if (rational) {
    for (std::size_t lane = 0; lane < kLanes; ++lane)
      factor[lane] = 1.0 / sums[dimension][lane];
  }
  for (std::size_t lane = 0; lane < static_cast<std::size_t>(count); ++lane) {
    for (int row = 0; row < dimension; ++row)
      *out++ = sums[row][lane] * factor[lane];
  }
}

/// Powers 0..degree of the coordinates of kLanes points.
struct LanePowers {
  std::array<std::array<Lane, kPowers>, 4> of;

  LanePowers(const double* barycentric, int count, int degree) {
    for (std::size_t c = 0; c < 4; ++c) {
      of[c][0].fill(1.0);
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        const int point = std::min(static_cast<int>(lane), count - 1);
        const double u = barycentric[4 * point + static_cast<int>(c)];
        for (std::size_t k = 1; k <= static_cast<std::size_t>(degree); ++k)
          of[c][k][lane] = of[c][k - 1][lane] * u;
      }
    }
  }
};

template <int Rows>
void evaluateLanes(const LanePowers& powers, int degree, const double* scaled, std::size_t size,
                   Lane* sums) {
  for (int row = 0; row < Rows; ++row)
    sums[row].fill(0.0);
  const auto n = static_cast<std::size_t>(degree);
  std::size_t position = 0;
  for (std::size_t layer = 0; layer <= n; ++layer) {
    for (std::size_t rest = 0; rest <= layer; ++rest) {
      Lane outer;
      for (std::size_t lane = 0; lane < kLanes; ++lane)
        outer[lane] = powers.of[0][n - layer][lane] * powers.of[1][layer - rest][lane];
      for (std::size_t l = 0; l <= rest; ++l, ++position) {
        Lane monomial;
        for (std::size_t lane = 0; lane < kLanes; ++lane)
          monomial[lane] = outer[lane] * powers.of[2][rest - l][lane] * powers.of[3][l][lane];
        for (int row = 0; row < Rows; ++row) {
          const double coefficient = scaled[static_cast<std::size_t>(row) * size + position];
          for (std::size_t lane = 0; lane < kLanes; ++lane)
            sums[row][lane] += coefficient * monomial[lane];
        }
      }
    }
  }
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

/// The coefficients of the lines u = const of the grid.
class GridLines {
 public:
  GridLines(int degree, int rows, const double* scaled, std::size_t size)
      : n_(degree), rows_(rows), scaled_(scaled), size_(size) {}

  /// sum over i of c_ijkl u^i, as coefficients of v^j w^k t^l with j + k + l <= n in the order of
  /// the net (which begins with the layer j + k + l = 0).
  void setU(double u) {
    std::array<double, kPowers> powers;
    powers[0] = 1.0;
    for (std::size_t k = 1; k < kPowers; ++k)
      powers[k] = powers[k - 1] * u;
    atU_.resize(static_cast<std::size_t>(rows_) * size_);
    for (int row = 0; row < rows_; ++row) {
      std::size_t p = static_cast<std::size_t>(row) * size_;
      for (int layer = 0; layer <= n_; ++layer) {
        const double power = powers[static_cast<std::size_t>(n_ - layer)];
        for (int i = netSize<3>(layer); i > 0; --i, ++p)
          atU_[p] = scaled_[p] * power;
      }
    }
  }

  /// The line at this v over w + t = rho: coefficients of (1-x)^(n-l) x^l, w = rho (1-x), t = rho
  /// x. Terms w^k t^l with s = k + l < n are raised to degree n by ((1-x) + x)^(n-s).
  void setV(double v, double rho) {
    std::array<double, kPowers> powers;
    powers[0] = 1.0;
    for (std::size_t k = 1; k < kPowers; ++k)
      powers[k] = powers[k - 1] * v;
    for (int row = 0; row < rows_; ++row)
      setRow(atU_.data() + static_cast<std::size_t>(row) * size_, powers, rho,
             line[static_cast<std::size_t>(row)]);
  }

  std::array<std::array<double, kPowers>, kMaxRows> line;

 private:
  void setRow(const double* atU, const std::array<double, kPowers>& powers, double rho,
              std::array<double, kPowers>& h) const {
    double scale = 1.0;
    for (int s = 0; s <= n_; ++s, scale *= rho) {
      h[static_cast<std::size_t>(s)] = 0.0;
      for (int l = s; l > 0; --l)
        h[static_cast<std::size_t>(l)] += h[static_cast<std::size_t>(l - 1)];
      for (int layer = s; layer <= n_; ++layer) {
        const double power = scale * powers[static_cast<std::size_t>(layer - s)];
        const double* const from = atU + layer * (layer + 1) * (layer + 2) / 6 + s * (s + 1) / 2;
        for (int l = 0; l <= s; ++l)
          h[static_cast<std::size_t>(l)] += power * from[l];
      }
    }
  }

  int n_;
  int rows_;
  const double* scaled_;
  std::size_t size_;
  std::vector<double> atU_;
};

/// The points of one line of the grid.
template <int Rows>
void evaluateLine(const GridLines& lines, const LineMonomials& monomials, int degree, int count,
                  int dimension, double* out) {
  for (int first = 0; first <= count; first += kLanes) {
    std::array<Lane, Rows> sums;
    for (Lane& sum : sums)
      sum.fill(0.0);
    for (int l = 0; l <= degree; ++l) {
      const double* const monomial = monomials.at(l) + first;
      for (std::size_t row = 0; row < Rows; ++row) {
        const double coefficient = lines.line[row][static_cast<std::size_t>(l)];
        for (std::size_t lane = 0; lane < kLanes; ++lane)
          sums[row][lane] += coefficient * monomial[lane];
      }
    }
    store(sums.data(), dimension, Rows > dimension, std::min(kLanes, count + 1 - first),
          out + first * dimension);
  }
}

/// Calls f<Rows>() for 3, 4 or 5 rows.
template <class F>
void withRows(int rows, F f) {
  if (rows == 3) return f.template operator()<3>();
  if (rows == 4) return f.template operator()<4>();
  return f.template operator()<5>();
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
  withRows(static_cast<int>(scaled_.rows()), [&]<int Rows>() {
    std::array<Lane, Rows> sums;
    for (std::size_t first = 0; first < count; first += kLanes) {
      const int used = static_cast<int>(std::min<std::size_t>(kLanes, count - first));
      const LanePowers powers(barycentric.data() + 4 * first, used, degree_);
      evaluateLanes<Rows>(powers, degree_, scaled_.data(), size, sums.data());
      store(sums.data(), dimension_, rational_, used,
            out.data() + first * static_cast<std::size_t>(dimension_));
    }
  });
}

void TetrahedronEvaluator::grid(int m, std::span<double> out) const {
  const auto size = static_cast<std::size_t>(scaled_.cols());
  std::vector<LineMonomials> monomials;
  for (int count = 0; count <= m; ++count)
    monomials.emplace_back(degree_, count);
  withRows(static_cast<int>(scaled_.rows()), [&]<int Rows>() {
    GridLines lines(degree_, Rows, scaled_.data(), size);
    double* to = out.data();
    for (int layer = 0; layer <= m; ++layer) {
      lines.setU(static_cast<double>(m - layer) / m);
      for (int rest = 0; rest <= layer; ++rest) {
        lines.setV(static_cast<double>(layer - rest) / m, static_cast<double>(rest) / m);
        evaluateLine<Rows>(lines, monomials[static_cast<std::size_t>(rest)], degree_, rest,
                           dimension_, to);
        to += (rest + 1) * dimension_;
      }
    }
  });
}

}  // namespace osculate
