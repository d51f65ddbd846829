// Curves from fixed seeds, the same on every machine.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "osculate/bezier/bspline_curve.h"

namespace osculate::test {

/// Uniform numbers from a seed; std::uniform_real_distribution differs between standard libraries.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  /// In [low, high).
  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11U) * 0x1p-53;
  }
  int integer(int low, int high) {
    return low + static_cast<int>(engine_() % static_cast<std::uint64_t>(high - low + 1));
  }
  bool coin() { return integer(0, 1) == 1; }
  Vector3 vector(double size) {
    return {uniform(-size, size), uniform(-size, size), uniform(-size, size)};
  }
  Vector3 direction() {
    for (;;) {
      const Vector3 v = vector(1.0);
      if (v.norm() > 0.1 && v.norm() <= 1.0) return v.normalized();
    }
  }

 private:
  std::mt19937_64 engine_;
};

/// Poles that advance along a random direction with random offsets, so that ends are regular.
inline std::vector<Vector3> randomPoles(Random& random, int count, double size = 10.0) {
  const Vector3 ahead = random.direction();
  const Vector3 origin = random.vector(size);
  std::vector<Vector3> poles;
  for (int i = 0; i < count; ++i) {
    poles.emplace_back(origin + size * (i + 0.5) / count * ahead + random.vector(0.2 * size));
  }
  return poles;
}

inline std::vector<double> randomWeights(Random& random, int count, double ratio = 4.0) {
  std::vector<double> weights;
  for (int i = 0; i < count; ++i)
    weights.push_back(random.uniform(1.0, ratio));
  return weights;
}

inline BezierCurve randomBezier(Random& random, int degree, bool rational, double size = 10.0) {
  const std::vector<Vector3> poles = randomPoles(random, degree + 1, size);
  if (!rational) return BezierCurve(poles);
  return BezierCurve(poles, randomWeights(random, degree + 1));
}

inline Poles columns(const std::vector<Vector3>& points) {
  Poles poles(3, static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
    poles.col(static_cast<Eigen::Index>(i)) = points[i];
  return poles;
}

/// A B-spline with random poles over the given knots.
inline BSplineData randomSplineData(Random& random, int degree, const KnotVector& knots,
                                    bool rational, bool periodic = false) {
  int count = 0;
  for (const int multiplicity : knots.multiplicities)
    count += multiplicity;
  count -= periodic ? knots.multiplicities.back() : degree + 1;
  BSplineData data;
  data.poles = columns(randomPoles(random, count));
  if (rational) data.weights = randomWeights(random, count);
  data.knots = knots;
  data.degree = degree;
  data.periodic = periodic;
  return data;
}

inline std::vector<Vector3> polesOf(const BezierCurve& curve) {
  std::vector<Vector3> poles;
  for (int i = 0; i <= curve.degree(); ++i)
    poles.emplace_back(curve.pole(i));
  return poles;
}

inline std::vector<double> weightsOf(const BezierCurve& curve) {
  std::vector<double> weights;
  for (int i = 0; curve.isRational() && i <= curve.degree(); ++i)
    weights.push_back(curve.weight(i));
  return weights;
}

/// The same poles and weights, bit for bit.
inline bool identical(const BezierCurve& a, const BezierCurve& b) {
  return a.degree() == b.degree() && polesOf(a) == polesOf(b) && weightsOf(a) == weightsOf(b);
}

}  // namespace osculate::test
