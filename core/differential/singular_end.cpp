#include "osculate/differential/singular_end.h"

#include <vector>

#include "osculate/bezier/index.h"

namespace osculate {

namespace {

/// Enough coefficients for the highest order at an end of the highest multiplicity.
constexpr int kLongest = kMaxArcOrder * kMaxDegree + kMaxDegree - 1;
using LongJet = Jet<kLongest>;
using Row = std::vector<double>;

/// The first derivative that is not to be told from zero by its error; degree+1 where none is.
int firstDerivative(const LongJet& jet, int degree) {
  for (int k = 1; k <= degree; ++k) {
    if (jet.c[index(k)].norm() > jet.error[index(k)]) return k;
  }
  return degree + 1;
}

/// The curve by a parameter that makes the first coefficient a unit vector: p_k = c_k /
/// |c_m|^(k/m).
struct UnitCurve {
  int m;
  int length;  ///< coefficients m .. length
  std::vector<Vector3> p;
  Row epsilon;  ///< error bounds of p
};

UnitCurve unitCurve(const LongJet& jet, int m, int length) {
  UnitCurve curve{m, length, std::vector<Vector3>(index(length) + 1, Vector3::Zero()),
                  Row(index(length) + 1, 0.0)};
  const double speed = std::pow(jet.c[index(m)].norm(), 1.0 / m);
  for (int k = m; k <= length; ++k) {
    const double scale = std::pow(speed, -k);
    curve.p[index(k)] = scale * jet.c[index(k)];
    curve.epsilon[index(k)] =
        scale * jet.error[index(k)] + 16.0 * kUnitRoundoff * curve.p[index(k)].norm();
  }
  return curve;
}

/// v(t) with s^(1/m) = t v(t): |P'| = t^(m-1) sqrt(g), s = t^m h, h_j = [sqrt g]_j / (j+m) * m, v =
/// h^(1/m).
Row rootOfArcLength(const UnitCurve& curve) {
  const int n = curve.length - curve.m;
  Row g(index(n) + 1, 0.0);
  for (int k = 0; k <= n; ++k) {
    for (int i = 0; i <= k; ++i) {
      const double factor =
          static_cast<double>((curve.m + i) * (curve.m + k - i)) / (curve.m * curve.m);
      g[index(k)] += factor * curve.p[index(curve.m + i)].dot(curve.p[index(curve.m + k - i)]);
    }
  }
  g[0] = 1.0;
  Row h(g.size(), 1.0);
  series::power(g.data(), 0.5, h.data(), n);
  for (int k = 0; k <= n; ++k)
    h[index(k)] *= static_cast<double>(curve.m) / (k + curve.m);
  Row v(g.size(), 1.0);
  series::power(h.data(), 1.0 / curve.m, v.data(), n);
  return v;
}

/// t(sigma) for sigma = t v(t): [sigma^k] t = (1/k) [t^(k-1)] v^(-k) (Lagrange inversion).
Row invert(const Row& v, int length) {
  Row t(index(length) + 1, 0.0);
  Row power(v.size());
  for (int k = 1; k <= length; ++k) {
    power[0] = 1.0;
    const int available = std::min(k - 1, static_cast<int>(v.size()) - 1);
    series::power(v.data(), -static_cast<double>(k), power.data(), available);
    t[index(k)] = available == k - 1 ? power[index(k - 1)] / k : 0.0;
  }
  return t;
}

/// Rows j = 1 .. length of the coefficients of x(sigma)^j.
std::vector<Row> powers(const Row& x, int length) {
  std::vector<Row> table(index(length) + 1, Row(index(length) + 1, 0.0));
  table[1] = x;
  for (int j = 2; j <= length; ++j) {
    for (int k = j; k <= length; ++k) {
      table[index(j)][index(k)] = series::nextPower(x.data(), table[index(j - 1)].data(), j, k);
    }
  }
  return table;
}

/// P as a series in sigma = s^(1/m), with error bounds (see detail::propagateErrors).
struct RootSeries {
  std::vector<Vector3> p;
  Row error;
};

RootSeries composeWith(const UnitCurve& curve, const Row& t) {
  const int n = curve.length;
  RootSeries result{std::vector<Vector3>(index(n) + 1, Vector3::Zero()), Row(index(n) + 1, 0.0)};
  const std::vector<Row> power = powers(t, n);
  Row d(index(n) + 1, 0.0);
  for (int k = curve.m; k <= n; ++k) {
    for (int j = curve.m; j <= k; ++j) {
      result.p[index(k)] += power[index(j)][index(k)] * curve.p[index(j)];
      d[index(k)] += std::abs(power[index(j)][index(k)]) * curve.epsilon[index(j)];
    }
  }
  // dR/ds as a series in sigma, and the change of arc length
  const auto tangent = [&](int a) {
    return result.p[index(a + curve.m)].norm() * (a + curve.m) / curve.m;
  };
  Row arc(index(n) + 1, 0.0);
  for (int k = curve.m; k <= n; ++k) {
    for (int a = 0; a <= k - curve.m; ++a)
      arc[index(k)] += tangent(a) * (k - a) * d[index(k - a)] / k;
    result.error[index(k)] = d[index(k)];
    for (int a = 0; a <= k - curve.m; ++a)
      result.error[index(k)] += tangent(a) * arc[index(k - a)];
  }
  return result;
}

int smoothnessOf(const RootSeries& series, int m, int order) {
  for (int j = m + 1; j < static_cast<int>(series.p.size()); ++j) {
    if (j % m != 0 && series.p[index(j)].norm() > series.error[index(j)])
      return std::min(order, j / m);
  }
  return order;
}

}  // namespace

SingularEnd singularEnd(BezierView segment, CurveEnd end, double poleError, int order) {
  const auto jet = endJet<kLongest>(segment, end, poleError);
  SingularEnd arc;
  arc.r.fill(Vector3::Zero());
  arc.error.fill(0.0);
  const int m = firstDerivative(jet, segment.degree);
  arc.multiplicity = m;
  if (m > segment.degree) return arc;

  const UnitCurve curve = unitCurve(jet, m, m * order + m - 1);
  const RootSeries series = composeWith(curve, invert(rootOfArcLength(curve), curve.length));
  arc.smoothness = smoothnessOf(series, m, order);
  const double growth = detail::nonlinearity(curve.epsilon[index(m)]);
  for (int k = 1; k <= arc.smoothness; ++k) {
    arc.r[index(k)] = detail::kFactorials[index(k)] * series.p[index(m * k)];
    arc.error[index(k)] = growth * detail::kFactorials[index(k)] * series.error[index(m * k)];
  }
  return arc;
}

}  // namespace osculate
