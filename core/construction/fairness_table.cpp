#include "osculate/construction/fairness_table.h"

#include <boost/math/quadrature/gauss.hpp>
#include <memory>
#include <mutex>

#include "osculate/bezier/bernstein.h"
#include "osculate/bezier/vector3.h"

namespace osculate {

namespace {

constexpr int kPanelNodes = 20;

/// Row `order` of derivatives: B_j^(r) = n!/(n-r)! sum_k (-1)^(r-k) C(r,k) B_{j-k}^{n-r} (Farin,
/// sec. 5.3).
Eigen::RowVectorXd derivativeOfBasis(int degree, int order, double t) {
  Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(degree + 1);
  if (order > degree) return row;
  double factor = 1.0;
  for (int r = 0; r < order; ++r)
    factor *= degree - r;
  const Eigen::VectorXd lower = bernstein(degree - order, t);
  for (int k = 0; k <= order; ++k) {
    const double sign = (order - k) % 2 == 0 ? 1.0 : -1.0;
    row.segment(k, lower.size()) += sign * factor * binomial(order, k) * lower.transpose();
  }
  return row;
}

template <int Nodes>
std::unique_ptr<const NodeTable<Nodes>> makeNodeTable(int degree) {
  using Rule =
      boost::math::quadrature::gauss<double, kPanelNodes>;  // lists the nodes x > 0 of [-1, 1]
  constexpr double kHalfPanel = 0.5 * kPanelNodes / Nodes;
  auto table = std::make_unique<NodeTable<Nodes>>();
  for (auto& matrix : table->basis)
    matrix.resize(Nodes, degree + 1);
  for (int i = 0; i < Nodes; ++i) {
    const int j = i % kPanelNodes;
    const auto k = static_cast<std::size_t>(j % (kPanelNodes / 2));
    const double x = (j < kPanelNodes / 2 ? -1.0 : 1.0) * Rule::abscissa()[k];
    const int panel = i / kPanelNodes;
    const double t = kHalfPanel * (2 * panel + 1 + x);
    table->weights[i] = kHalfPanel * Rule::weights()[k];
    for (int order = 1; order <= 3; ++order) {
      table->basis[static_cast<std::size_t>(order - 1)].row(i) =
          derivativeOfBasis(degree, order, t);
    }
  }
  return table;
}

}  // namespace

template <int Nodes>
const NodeTable<Nodes>& nodeTable(int degree) {
  static std::array<std::once_flag, kMaxDegree + 1> once;
  static std::array<std::unique_ptr<const NodeTable<Nodes>>, kMaxDegree + 1> tables;
  const auto i = static_cast<std::size_t>(degree);
  std::call_once(once[i], [&] { tables[i] = makeNodeTable<Nodes>(degree); });
  return *tables[i];
}

template const NodeTable<kCoarseNodes>& nodeTable<kCoarseNodes>(int degree);
template const NodeTable<kFineNodes>& nodeTable<kFineNodes>(int degree);

}  // namespace osculate
