// Random triangles and tetrahedra from fixed seeds, and their evaluation by the definition in exact
// arithmetic.
#pragma once

#include "osculate/bezier/bezier_tetrahedron.h"
#include "support/exact.h"
#include "support/random_curves.h"

namespace osculate::test {

template <int Corners, class S>
using ExactBary = std::array<S, static_cast<std::size_t>(Corners)>;

/// A net near the lattice of a simplex of this size, shaken by `noise` of the distance of its
/// points.
template <int Corners>
BezierSimplex<Corners> randomSimplex(Random& random, int degree, bool rational, int dimension = 3,
                                     double noise = 0.3, double size = 10.0) {
  Eigen::MatrixXd corners = Eigen::MatrixXd::Zero(dimension, Corners);
  for (int c = 1; c < Corners; ++c)
    corners(c - 1, c) = size;
  Eigen::MatrixXd points(dimension, netSize<Corners>(degree));
  std::vector<double> weights;
  Eigen::Index position = 0;
  for (const MultiIndex<Corners>& index : multiIndices<Corners>(degree)) {
    points.col(position).setZero();
    for (int c = 0; c < Corners; ++c)
      points.col(position) += index[static_cast<std::size_t>(c)] * corners.col(c) / degree;
    for (int row = 0; row < dimension; ++row)
      points(row, position) += random.uniform(-noise, noise) * size / degree;
    if (rational) weights.push_back(random.uniform(0.5, 2.0));
    ++position;
  }
  return BezierSimplex<Corners>(degree, points, weights);
}

inline BezierTetrahedron randomSolid(Random& random, int degree, bool rational, int dimension = 3,
                                     double noise = 0.3) {
  return randomSimplex<4>(random, degree, rational, dimension, noise);
}

/// Inside the simplex, with the sum 1 but for rounding.
template <int Corners>
Barycentric<Corners> randomBary(Random& random) {
  Barycentric<Corners> u;
  for (int c = 0; c < Corners; ++c)
    u[c] = random.uniform(0.01, 1.0);
  return u / u.sum();
}

template <int Corners>
Barycentric<Corners> randomDirection(Random& random) {
  const Barycentric<Corners> d = randomBary<Corners>(random) - randomBary<Corners>(random);
  return d - Barycentric<Corners>::Constant(d.sum() / Corners);
}

template <int Corners, class S>
ExactBary<Corners, S> exactBary(const Barycentric<Corners>& u) {
  ExactBary<Corners, S> result;
  for (int c = 0; c < Corners; ++c)
    result[static_cast<std::size_t>(c)] = S(u[c]);
  return result;
}

/// n!/(i! j! ..) u^i v^j ...
template <int Corners, class S>
S exactBernstein(const MultiIndex<Corners>& index, const ExactBary<Corners, S>& u) {
  S value(multinomial<Corners>(index));
  for (std::size_t c = 0; c < index.size(); ++c) {
    for (int i = 0; i < index[c]; ++i)
      value *= u[c];
  }
  return value;
}

/// The point by the sum of Bernstein polynomials (theorems 1.2.2 and 1.6.1 of the thesis).
template <int Corners, class S>
std::vector<S> exactPoint(const BezierSimplex<Corners>& simplex, const ExactBary<Corners, S>& u) {
  std::vector<S> sum(static_cast<std::size_t>(simplex.dimension()), S(0));
  S weightSum(0);
  int position = 0;
  for (const MultiIndex<Corners>& index : multiIndices<Corners>(simplex.degree())) {
    const S factor = S(simplex.weight(position)) * exactBernstein<Corners, S>(index, u);
    weightSum += factor;
    for (std::size_t row = 0; row < sum.size(); ++row)
      sum[row] += factor * S(simplex.points()(static_cast<Eigen::Index>(row), position));
    ++position;
  }
  // a polynomial net is the sum itself, also where u does not sum to 1
  for (S& coordinate : sum) {
    if (simplex.isRational()) coordinate /= weightSum;
  }
  return sum;
}

template <class S>
double distance(const std::vector<S>& a, const SpacePoint& b) {
  double sum = 0.0;
  for (std::size_t row = 0; row < a.size(); ++row) {
    const double d = toDouble(S(a[row] - S(b[static_cast<Eigen::Index>(row)])));
    sum += d * d;
  }
  return std::sqrt(sum);
}

/// Rounding of convex combinations of points of this size, with weights of ratio 4.
template <int Corners>
double roundingOf(const BezierSimplex<Corners>& simplex) {
  const double largest = simplex.points().colwise().norm().maxCoeff();
  return 16.0 * (simplex.degree() + 1) * kUnitRoundoff * largest *
         (simplex.isRational() ? 4.0 : 1.0);
}

/// Degrees 1 to 12, polynomial and rational, in E3 and E4.
template <int Corners, class Check>
void forSimplices(std::uint64_t seed, Check check) {
  Random random(seed);
  for (const int degree : {1, 2, 3, 4, 5, 8, kMaxSimplexDegree}) {
    for (const bool rational : {false, true}) {
      for (const int dimension : {3, 4}) {
        SCOPED_TRACE("degree " + std::to_string(degree) + (rational ? " rational" : " polynomial") +
                     " E" + std::to_string(dimension));
        check(random, randomSimplex<Corners>(random, degree, rational, dimension));
      }
    }
  }
}

}  // namespace osculate::test
