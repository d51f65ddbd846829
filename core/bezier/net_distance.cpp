#include "osculate/bezier/net_distance.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace osculate {

namespace {

/// The net of the difference of two curves: of rational ones it has twice their degree.
using Difference =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 4, 2 * kMaxDegree + 1>;

/// C(n, k) for n <= 2 kMaxDegree; all are below 2^53.
double choose(int n, int k) {
  static const auto table = [] {
    std::array<std::array<double, 2 * kMaxDegree + 1>, 2 * kMaxDegree + 1> rows{};
    for (std::size_t i = 0; i < rows.size(); ++i) {
      rows[i][0] = 1.0;
      for (std::size_t j = 1; j <= i; ++j)
        rows[i][j] = rows[i - 1][j - 1] + (j < i ? rows[i - 1][j] : 0.0);
    }
    return rows;
  }();
  return table[static_cast<std::size_t>(n)][static_cast<std::size_t>(k)];
}

/// B/w - A/v = (B v - A w) / (v w), by the product of Bernstein polynomials B_i^n B_j^n = C(n,i)
/// C(n,j) / C(2n,i+j) B_{i+j}^{2n} (Farin, CAGD).
Difference rationalDifference(const Net& a, const Net& b) {
  const int n = static_cast<int>(a.cols()) - 1;
  Difference result = Difference::Zero(4, 2 * n + 1);
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= n; ++j) {
      const double weight = choose(n, i) * choose(n, j) / choose(2 * n, i + j) * a(3, i) * b(3, j);
      result.col(i + j).head<3>() += weight * (project(b.col(j)) - project(a.col(i)));
      result(3, i + j) += weight;
    }
  }
  return result;
}

/// Equal weights stay those of the difference.
Difference differenceOf(const Net& a, const Net& b) {
  if (a.rows() == 3) return b - a;
  if (a.row(3) != b.row(3)) return rationalDifference(a, b);
  Difference result = b - a;
  result.row(3) = a.row(3);
  return result;
}

double norm(const Difference& net, Eigen::Index i) {
  const double length = net.col(i).head<3>().norm();
  return net.rows() == 3 ? length : length / net(3, i);
}

double hullBound(const Difference& net) {
  double largest = 0.0;
  for (Eigen::Index i = 0; i < net.cols(); ++i)
    largest = std::max(largest, norm(net, i));
  return largest;
}

/// De Casteljau at 1/2: returns the second half, the first stays.
Difference secondHalf(Difference& net) {
  const Eigen::Index n = net.cols() - 1;
  Difference rest = net;
  for (Eigen::Index r = 1; r <= n; ++r) {
    for (Eigen::Index i = 0; i <= n - r; ++i)
      rest.col(i) = 0.5 * (rest.col(i) + rest.col(i + 1));
    net.col(r) = rest.col(0);
  }
  return rest;
}

/// Over [first, first + 2^-depth].
struct Part {
  Difference net;
  int depth = 0;
  double first = 0.0;

  double length() const { return std::ldexp(1.0, -depth); }
};

}  // namespace

FarthestPoints farthestPoints(const Net& a, const Net& b) {
  constexpr int kMaxDepth = 30;
  constexpr double kMargin = 1.001;
  std::vector<Part> open{{differenceOf(a, b)}};
  FarthestPoints reached;
  const auto reach = [&](double distance, double t) {
    if (distance > reached.distanceMm) reached = {distance, t};
  };
  reach(norm(open.front().net, 0), 0.0);
  reach(norm(open.front().net, open.front().net.cols() - 1), 1.0);
  double result = 0.0;
  while (!open.empty()) {
    Part first = std::move(open.back());
    open.pop_back();
    const double bound = hullBound(first.net);
    if (bound <= kMargin * reached.distanceMm || first.depth == kMaxDepth) {
      result = std::max(result, bound);
      continue;
    }
    ++first.depth;
    const double middle = first.first + first.length();
    Part second{secondHalf(first.net), first.depth, middle};
    reach(norm(second.net, 0), middle);
    open.push_back(std::move(second));
    open.push_back(std::move(first));
  }
  return {std::max(result, reached.distanceMm), reached.t};
}

double largestDistance(const Net& a, const Net& b) { return farthestPoints(a, b).distanceMm; }

}  // namespace osculate
