// The derivatives of Bézier triangles and tetrahedra.
#include <cmath>
#include <stdexcept>
#include <string>

#include "osculate/bezier/bezier_simplex.h"

namespace osculate {

namespace {

constexpr std::size_t kMaxDifferentDirections = 12;

/// Directions and how often each occurs.
template <int Corners>
struct Directions {
  std::vector<Barycentric<Corners>> different;
  std::vector<int> counts;

  void add(const Barycentric<Corners>& direction, int times) {
    for (std::size_t i = 0; i < different.size(); ++i) {
      if (different[i] == direction) {
        counts[i] += times;
        return;
      }
    }
    if (different.size() == kMaxDifferentDirections) {
      throw std::invalid_argument("directions: at most 12 different ones, got more");
    }
    different.push_back(direction);
    counts.push_back(times);
  }
};

/// The numbers 0 .. counts of every direction, as positions in a table.
class OrderTable {
 public:
  explicit OrderTable(const std::vector<int>& counts) : counts_(counts) {
    for (const int count : counts) {
      strides_.push_back(size_);
      size_ *= static_cast<std::size_t>(count) + 1;
    }
  }
  std::size_t size() const { return size_; }
  int order(std::size_t position, std::size_t direction) const {
    return static_cast<int>(position / strides_[direction] %
                            (static_cast<std::size_t>(counts_[direction]) + 1));
  }
  /// Product of C(whole, part) over the directions; 0 unless every part <= whole.
  double choose(std::size_t whole, std::size_t part) const {
    double product = 1.0;
    for (std::size_t d = 0; d < counts_.size(); ++d) {
      const int n = order(whole, d);
      const int k = order(part, d);
      if (k > n) return 0.0;
      for (int i = 1; i <= k; ++i)
        product = product * (n - k + i) / i;
    }
    return product;
  }

 private:
  std::vector<int> counts_;
  std::vector<std::size_t> strides_;
  std::size_t size_ = 1;
};

/// n!/(n-r)! X[d_1, .., d_r, u^(n-r)] (thesis theorem 1.4.4 in its blossom form), for the orders at
/// one position of the table.
template <int Corners>
SpacePoint homogeneousDerivative(SimplexNet net, int degree, const Barycentric<Corners>& u,
                                 const Directions<Corners>& directions, const OrderTable& table,
                                 std::size_t position) {
  double factor = 1.0;
  int rest = degree;
  for (std::size_t d = 0; d < directions.different.size(); ++d) {
    for (int i = table.order(position, d); i > 0; --i) {
      if (rest == 0) return SpacePoint::Zero(net.rows());
      factor *= rest;
      reduceNet<Corners>(net, rest--, directions.different[d]);
    }
  }
  for (; rest > 0; --rest)
    reduceNet<Corners>(net, rest, u);
  return factor * net.col(0);
}

/// R_m = (A_m - sum_{0 != k <= m} C(m,k) w_k R_{m-k}) / w: Leibniz' rule for A = w R.
template <int Corners>
SpacePoint mixedDerivative(const BezierSimplex<Corners>& simplex, const Barycentric<Corners>& u,
                           const Directions<Corners>& directions) {
  const OrderTable table(directions.counts);
  const SimplexNet net = simplex.homogeneous();
  const auto at = [&](std::size_t position) {
    return homogeneousDerivative<Corners>(net, simplex.degree(), u, directions, table, position);
  };
  if (!simplex.isRational()) return at(table.size() - 1);
  const Eigen::Index dimension = simplex.dimension();
  std::vector<double> weights;
  std::vector<SpacePoint> results;
  for (std::size_t m = 0; m < table.size(); ++m) {
    const SpacePoint homogeneous = at(m);
    weights.push_back(homogeneous[dimension]);
    SpacePoint numerator = homogeneous.head(dimension);
    for (std::size_t k = 1; k <= m; ++k) {
      const double factor = table.choose(m, k);
      if (factor != 0.0) numerator -= factor * weights[k] * results[m - k];
    }
    results.emplace_back(numerator / weights[0]);
  }
  return results.back();
}

}  // namespace

template <int Corners>
SpacePoint BezierSimplex<Corners>::derivative(const Bary& u,
                                              std::span<const Bary> directions) const {
  Directions<Corners> collected;
  for (const Bary& direction : directions) {
    if (!direction.allFinite() || std::abs(direction.sum()) > 1e-9 * direction.cwiseAbs().sum()) {
      throw std::invalid_argument(
          "directions: the barycentric coordinates of a direction must be finite with the sum 0, "
          "got the sum " +
          std::to_string(direction.sum()));
    }
    collected.add(direction, 1);
  }
  return mixedDerivative<Corners>(*this, u, collected);
}

template <int Corners>
SpacePoint BezierSimplex<Corners>::partial(const Bary& u, const Index& orders) const {
  Directions<Corners> collected;
  for (int c = 0; c < Corners; ++c) {
    const int order = orders[static_cast<std::size_t>(c)];
    if (order < 0)
      throw std::invalid_argument("orders: must be >= 0, got " + std::to_string(order));
    collected.add(Bary::Unit(c), order);
  }
  return mixedDerivative<Corners>(*this, u, collected);
}

template SpacePoint BezierSimplex<3>::derivative(const Bary&, std::span<const Bary>) const;
template SpacePoint BezierSimplex<4>::derivative(const Bary&, std::span<const Bary>) const;
template SpacePoint BezierSimplex<3>::partial(const Bary&, const Index&) const;
template SpacePoint BezierSimplex<4>::partial(const Bary&, const Index&) const;

}  // namespace osculate
