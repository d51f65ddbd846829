#include "osculate/construction/graph_jet.h"

#include "osculate/bezier/index.h"
#include "osculate/differential/arc_jet.h"
#include "osculate/differential/series.h"

namespace osculate {

namespace {

using Table = detail::PowerTable<double, kMaxOrder>;

/// power[j][k], j <= k: the coefficient of x^k in s(x)^j, up to the row or column `last` that has
/// become known.
void extendPowers(int last, Table& power) {
  for (int j = 2; j <= last; ++j) {
    power[index(j)][index(last)] =
        series::nextPower(power[1].data(), power[index(j - 1)].data(), j, last);
  }
}

}  // namespace

GraphJet graphJet(const ContactJet& contact) {
  const int m = contact.order;
  const Vector3 tangent = contact.r[1];
  std::array<double, kMaxOrder + 1> along{};  // u(s)
  std::array<Vector3, kMaxOrder + 1> across;
  for (int k = 1; k <= m; ++k) {
    const Vector3 rho = contact.r[index(k)] / detail::kFactorials[index(k)];
    along[index(k)] = tangent.dot(rho);
    across[index(k)] = rho - along[index(k)] * tangent;
  }
  Table power{};  // of s(u): the inverse series, a coefficient after the other
  power[1][1] = 1.0;
  GraphJet graph;
  graph.overTangent.order = m;
  graph.overTangent.r[0] = contact.r[0];
  graph.overTangent.r[1] = tangent;
  for (int k = 2; k <= m; ++k) {
    extendPowers(k, power);  // s_k itself enters the first power only
    double sum = 0.0;
    for (int j = 2; j <= k; ++j)
      sum += along[index(j)] * power[index(j)][index(k)];
    power[1][index(k)] = -sum;
    Vector3 g = Vector3::Zero();
    for (int j = 2; j <= k; ++j)
      g += power[index(j)][index(k)] * across[index(j)];
    graph.overTangent.r[index(k)] = detail::kFactorials[index(k)] * g;
  }
  graph.arcLength = power[1];
  return graph;
}

ArcLengthSeries arcLengthOf(const GraphJet& graph, const ArcLengthSeries& u) {
  const int m = graph.overTangent.order;
  Table power{};
  ArcLengthSeries sigma{};
  for (int k = 1; k <= m; ++k) {
    power[1][index(k)] = u[index(k - 1)];
    extendPowers(k, power);
    for (int j = 1; j <= k; ++j)
      sigma[index(k - 1)] += graph.arcLength[index(j)] * power[index(j)][index(k)];
  }
  return sigma;
}

SeriesDerivatives arcLengthDerivatives(const GraphJet& graph, const ArcLengthSeries& u) {
  const int m = graph.overTangent.order;
  Table power{};
  ArcLengthSeries rate{};  // s'(u(t)): rate[k] is the coefficient of t^k
  rate[0] = graph.arcLength[1];
  for (int k = 1; k < m; ++k) {
    power[1][index(k)] = u[index(k - 1)];
    extendPowers(k, power);
    for (int j = 1; j <= k; ++j)
      rate[index(k)] += (j + 1) * graph.arcLength[index(j + 1)] * power[index(j)][index(k)];
  }
  SeriesDerivatives derivative{};
  for (int l = 1; l <= m; ++l) {
    for (int k = l; k <= m; ++k)
      derivative[index(l - 1)][index(k - 1)] = rate[index(k - l)];
  }
  return derivative;
}

ArcLengthSeries tangentialOf(const ContactJet& contact, const ArcLengthSeries& sigma) {
  const BoundedPoles taylor = attachedTaylor(contact, sigma);
  ArcLengthSeries u{};
  for (int k = 1; k <= contact.order; ++k)
    u[index(k - 1)] = contact.r[1].dot(taylor.col(k));
  return u;
}

}  // namespace osculate
