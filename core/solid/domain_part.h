// A part of the domain of a solid with the Bernstein coefficients of functions over it; private to
// this floor.
#pragma once

#include "osculate/bezier/simplex_net.h"

namespace osculate {

/// A tetrahedron of the domain, and over it a function (row 0) with bounds of its error (row 1).
class DomainPart {
 public:
  DomainPart(const Eigen::RowVectorXd& values, const Eigen::RowVectorXd& errors, int degree)
      : degree_(degree), net_(2, values.size()), corners_(unitCorners<4>()) {
    net_ << values, errors;
  }

  double value(Eigen::Index i) const { return net_(0, i); }
  double error(Eigen::Index i) const { return net_(1, i); }
  const Barycentric<4>& corner(int c) const { return corners_[static_cast<std::size_t>(c)]; }
  double cornerValue(int c) const { return net_(0, cornerIndex(c)); }
  double cornerError(int c) const { return net_(1, cornerIndex(c)); }
  bool allAboveMinusErrors() const { return (net_.row(0).array() >= -net_.row(1).array()).all(); }
  bool hasNegative() const { return (net_.row(0).array() < -net_.row(1).array()).any(); }
  /// Lower and upper bound of the function on the part.
  double low() const { return (net_.row(0) - net_.row(1)).minCoeff(); }
  double high() const { return (net_.row(0) + net_.row(1)).maxCoeff(); }
  bool allBelowErrors() const { return (net_.row(0).array() <= net_.row(1).array()).all(); }

  /// Keeps one half, returns the other; cut at the middle of the longest edge (in the regular
  /// tetrahedron), so that the parts do not become thin.
  DomainPart bisect() {
    int a = 0;
    int b = 1;
    for (int p = 0; p < 4; ++p) {
      for (int q = p + 1; q < 4; ++q) {
        if ((corner(p) - corner(q)).squaredNorm() > (corner(a) - corner(b)).squaredNorm()) {
          a = p;
          b = q;
        }
      }
    }
    DomainPart other = *this;
    other.net_ = bisectNet<4>(net_, degree_, a, b);
    const Barycentric<4> middle = 0.5 * (corner(a) + corner(b));
    corners_[static_cast<std::size_t>(b)] = middle;
    other.corners_[static_cast<std::size_t>(a)] = middle;
    addRounding();
    other.addRounding();
    return other;
  }

 private:
  Eigen::Index cornerIndex(int c) const {
    MultiIndex<4> index{};
    index[static_cast<std::size_t>(c)] = degree_;
    return netIndex<4>(index);
  }

  /// Each of at most `degree` averages rounds by half a unit of the largest coefficient around.
  void addRounding() {
    net_.row(1).array() += degree_ * kHalfUnit * net_.row(0).cwiseAbs().maxCoeff();
  }

  static constexpr double kHalfUnit = 0x1p-53;

  int degree_;
  SimplexNet net_;
  PartCornersOf<4> corners_;
};

}  // namespace osculate
