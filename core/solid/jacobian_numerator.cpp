// The numerator of the Jacobian by products of polynomials, with bounds of its rounding.
#include <stdexcept>

#include "osculate/solid/jacobian.h"

#include "osculate/bezier/index.h"

namespace osculate {

namespace {

/// A polynomial as coefficients of monomials, with the sums of the moduli of all that was added up.
struct Bounded {
  Eigen::RowVectorXd value;
  Eigen::RowVectorXd size;
  int degree = 0;
};

Bounded multiply(const Bounded& a, const Bounded& b) {
  return {multiplyMonomials<4>(a.value, a.degree, b.value, b.degree),
          multiplyMonomials<4>(a.size, a.degree, b.size, b.degree), a.degree + b.degree};
}

Bounded operator-(const Bounded& a, const Bounded& b) {
  return {a.value - b.value, a.size + b.size, a.degree};
}
Bounded operator+(const Bounded& a, const Bounded& b) {
  return {a.value + b.value, a.size + b.size, a.degree};
}

using Columns = std::array<std::vector<Bounded>, 4>;

Bounded minor2(const Columns& x, std::size_t a, std::size_t b, std::size_t row1, std::size_t row2) {
  return multiply(x[a][row1], x[b][row2]) - multiply(x[a][row2], x[b][row1]);
}

/// Rows (W, x, y, z) of the nets X_{e_0} and X_{e_c} - X_{e_0}: the determinant stays, the numbers
/// become as small as the distances of points.
Columns columnsOf(const SimplexNet& net, int degree) {
  const Eigen::RowVectorXd factors = multinomials<4>(degree - 1);
  Columns columns;
  const SimplexNet base = shiftedNet<4>(net, degree, 0);
  for (int c = 0; c < 4; ++c) {
    const SimplexNet shifted = shiftedNet<4>(net, degree, c);
    const SimplexNet value = c == 0 ? base : SimplexNet(shifted - base);
    const SimplexNet size =
        c == 0 ? SimplexNet(base.cwiseAbs()) : SimplexNet(shifted.cwiseAbs() + base.cwiseAbs());
    for (Eigen::Index row = 0; row < net.rows(); ++row)
      columns[index(c)].push_back(
          {value.row(row).cwiseProduct(factors), size.row(row).cwiseProduct(factors), degree - 1});
  }
  return columns;
}

/// Of the columns 1, 2, 3 and three rows.
Bounded determinant3(const Columns& x) {
  return multiply(x[1][0], minor2(x, 2, 3, 1, 2)) - multiply(x[1][1], minor2(x, 2, 3, 0, 2)) +
         multiply(x[1][2], minor2(x, 2, 3, 0, 1));
}

/// Laplace's expansion by the minors of columns 0, 1 and of columns 2, 3.
Bounded determinant4(const Columns& x) {
  const auto pair = [&](std::size_t p, std::size_t q, std::size_t r, std::size_t s) {
    return multiply(minor2(x, 0, 1, p, q), minor2(x, 2, 3, r, s));
  };
  return pair(0, 1, 2, 3) - pair(0, 2, 1, 3) + pair(0, 3, 1, 2) + pair(1, 2, 0, 3) -
         pair(1, 3, 0, 2) + pair(2, 3, 0, 1);
}

/// Homogeneous points moved so that the middle of the box is the origin, with the weight first.
SimplexNet centred(const BezierTetrahedron& solid) {
  const auto [low, high] = solid.box();
  SimplexNet net(4, solid.size());
  const Vector3 centre = 0.5 * (low + high);
  for (int i = 0; i < solid.size(); ++i) {
    const double w = solid.weight(i);
    net.col(i) << w, w * (solid.points().col(i) - centre);
  }
  return net;
}

}  // namespace

JacobianNumerator jacobianNumerator(const BezierTetrahedron& solid) {
  if (solid.dimension() != 3) {
    throw std::invalid_argument("jacobian: of a solid in E3; project it from E4 first");
  }
  const int n = solid.degree();
  const SimplexNet net = centred(solid);
  const bool rational = solid.isRational();
  const Bounded determinant =
      rational ? determinant4(columnsOf(net, n)) : determinant3(columnsOf(net.bottomRows<3>(), n));
  JacobianNumerator result;
  result.degree = determinant.degree;
  const Eigen::RowVectorXd factors = multinomials<4>(result.degree);
  const double power = static_cast<double>(n) * n * n;
  result.coefficients = power * determinant.value.cwiseQuotient(factors);
  // Each product and sum of at most netSize(n-1) + netSize(2n-2) terms, the multinomials and the
  // points themselves round by half a unit: gamma_k of Higham 2002, ch. 3, with k their number.
  const double operations =
      netSize<4>(n - 1) + netSize<4>(2 * (n - 1)) + 6.0 * result.degree + 32.0;
  const double gamma = operations * kUnitRoundoff / (1.0 - operations * kUnitRoundoff);
  result.errors = gamma * power * determinant.size.cwiseQuotient(factors);
  return result;
}

double jacobian(const BezierTetrahedron& solid, const Barycentric<4>& u) {
  if (solid.dimension() != 3)
    throw std::invalid_argument("jacobian: of a solid in E3; project it from E4 first");
  Eigen::Matrix3d columns;
  for (int c = 1; c < 4; ++c) {
    const std::array<Barycentric<4>, 1> direction{Barycentric<4>::Unit(c) -
                                                  Barycentric<4>::Unit(0)};
    columns.col(c - 1) = solid.derivative(u, direction);
  }
  return columns.determinant();
}

}  // namespace osculate
