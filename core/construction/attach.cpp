#include "osculate/construction/attach.h"

#include <algorithm>

#include "osculate/bezier/bernstein.h"
#include "osculate/bezier/index.h"
#include "osculate/differential/arc_jet.h"
#include "osculate/differential/series.h"

namespace osculate {

namespace {

using Table = detail::PowerTable<double, kMaxOrder>;

/// power[j][k] is the coefficient of t^k in s(t)^j, for j <= k <= m.
void setPowers(const ArcLengthSeries& sigma, int m, Table& power) {
  power[0].fill(0.0);
  power[0][0] = 1.0;
  for (int k = 1; k <= m; ++k)
    power[1][index(k)] = sigma[index(k - 1)];
  for (int j = 2; j <= m; ++j) {
    for (int k = j; k <= m; ++k) {
      power[index(j)][index(k)] =
          series::nextPower(power[1].data(), power[index(j - 1)].data(), j, k);
    }
  }
}

Vector3 rho(const ContactJet& target, int j) {
  return target.r[index(j)] / detail::kFactorials[index(j)];
}

}  // namespace

BoundedPoles attachedTaylor(const ContactJet& target, const ArcLengthSeries& sigma) {
  const int m = target.order;
  Table power;
  setPowers(sigma, m, power);
  BoundedPoles q = BoundedPoles::Zero(3, m + 1);
  q.col(0) = target.r[0];
  for (int j = 1; j <= m; ++j) {
    const Vector3 coefficient = rho(target, j);
    for (int k = j; k <= m; ++k)
      q.col(k) += power[index(j)][index(k)] * coefficient;
  }
  return q;
}

void attachedTaylorDerivatives(const ContactJet& target, const ArcLengthSeries& sigma,
                               std::array<BoundedPoles, kMaxOrder>& derivative) {
  const int m = target.order;
  Table power;
  setPowers(sigma, m, power);
  BoundedPoles tangent = BoundedPoles::Zero(3, m);  // R'(s(t)): d q_k / d sigma_l = tangent_{k-l}
  for (int j = 1; j <= m; ++j) {
    const Vector3 coefficient = j * rho(target, j);
    for (int k = j - 1; k < m; ++k)
      tangent.col(k) += power[index(j - 1)][index(k)] * coefficient;
  }
  for (int l = 1; l <= m; ++l) {
    BoundedPoles& change = derivative[index(l - 1)];
    change = BoundedPoles::Zero(3, m + 1);
    change.rightCols(m + 1 - l) = tangent.leftCols(m + 1 - l);
  }
}

BoundedPoles attachedTaylorCurvature(const ContactJet& target, const ArcLengthSeries& sigma) {
  const int m = target.order;
  Table power;
  setPowers(sigma, m, power);
  BoundedPoles curvature = BoundedPoles::Zero(3, std::max(m - 1, 0));
  for (int j = 2; j <= m; ++j) {
    const Vector3 coefficient = j * (j - 1) * rho(target, j);
    for (int k = j - 2; k <= m - 2; ++k)
      curvature.col(k) += power[index(j - 2)][index(k)] * coefficient;
  }
  return curvature;
}

BoundedPoles polesOfTaylor(const BoundedPoles& taylor, int degree) {
  const int m = static_cast<int>(taylor.cols()) - 1;
  BoundedPoles poles = BoundedPoles::Zero(3, m + 1);
  for (int k = 0; k <= m; ++k) {
    const Vector3 term = taylor.col(k) / binomial(degree, k);
    for (int i = k; i <= m; ++i)
      poles.col(i) += binomial(i, k) * term;
  }
  return poles;
}

BoundedPoles attach(const ContactJet& target, const ArcLengthSeries& sigma, int degree) {
  return polesOfTaylor(attachedTaylor(target, sigma), degree);
}

void attachDerivatives(const ContactJet& target, const ArcLengthSeries& sigma, int degree,
                       std::array<BoundedPoles, kMaxOrder>& derivative) {
  attachedTaylorDerivatives(target, sigma, derivative);
  for (int l = 1; l <= target.order; ++l)
    derivative[index(l - 1)] = polesOfTaylor(derivative[index(l - 1)], degree);
}

}  // namespace osculate
