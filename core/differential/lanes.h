// Two doubles that undergo the same operations: the two sides of a join in one SIMD register.
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace osculate {

/// Arithmetic acts on both lanes; the compiler turns it into SSE2 or NEON instructions.
class Lanes {
 public:
  using Register = double __attribute__((vector_size(16)));

  Lanes() = default;
  // one number for both lanes, as Eigen and the series recurrences expect of a scalar
  Lanes(double value) : both_{value, value} {}  // NOLINT(google-explicit-constructor)
  Lanes(double first, double second) : both_{first, second} {}
  explicit Lanes(Register both) : both_(both) {}

  double operator[](int lane) const { return both_[lane]; }
  Register both() const { return both_; }

  Lanes& operator+=(Lanes other) {
    both_ += other.both_;
    return *this;
  }
  Lanes& operator-=(Lanes other) {
    both_ -= other.both_;
    return *this;
  }
  Lanes& operator*=(Lanes other) {
    both_ *= other.both_;
    return *this;
  }
  Lanes& operator/=(Lanes other) {
    both_ /= other.both_;
    return *this;
  }
  friend Lanes operator+(Lanes a, Lanes b) { return Lanes(a.both_ + b.both_); }
  friend Lanes operator-(Lanes a, Lanes b) { return Lanes(a.both_ - b.both_); }
  friend Lanes operator*(Lanes a, Lanes b) { return Lanes(a.both_ * b.both_); }
  friend Lanes operator/(Lanes a, Lanes b) { return Lanes(a.both_ / b.both_); }
  friend Lanes operator-(Lanes a) { return Lanes(-a.both_); }
  friend Lanes sqrt(Lanes a) { return {std::sqrt(a.both_[0]), std::sqrt(a.both_[1])}; }
  friend Lanes abs(Lanes a) { return {std::abs(a.both_[0]), std::abs(a.both_[1])}; }
  friend Lanes max(Lanes a, Lanes b) { return Lanes(a.both_ > b.both_ ? a.both_ : b.both_); }

 private:
  Register both_;
};

}  // namespace osculate

namespace Eigen {
template <>
struct NumTraits<osculate::Lanes> : GenericNumTraits<double> {
  using Real = osculate::Lanes;
  using NonInteger = osculate::Lanes;
  using Nested = osculate::Lanes;
  using Literal = osculate::Lanes;
  // NOLINTBEGIN(readability-identifier-naming): Eigen's names
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 0,
    ReadCost = 1,
    AddCost = 1,
    MulCost = 1
  };
  // NOLINTEND(readability-identifier-naming)
};
}  // namespace Eigen

namespace osculate {

/// A vector whose components hold both sides.
using LanesVector = Eigen::Matrix<Lanes, 3, 1>;

inline LanesVector zip(const Eigen::Vector3d& first, const Eigen::Vector3d& second) {
  return {Lanes(first.x(), second.x()), Lanes(first.y(), second.y()), Lanes(first.z(), second.z())};
}

inline Eigen::Vector3d lane(const LanesVector& v, int i) { return {v.x()[i], v.y()[i], v.z()[i]}; }
inline Eigen::Vector3d lane(const Eigen::Vector3d& v, int) { return v; }
inline double lane(Lanes v, int i) { return v[i]; }
inline double lane(double v, int) { return v; }

}  // namespace osculate
