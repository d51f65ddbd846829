#include "osculate/construction/least_change.h"

#include <Eigen/LU>

#include "osculate/bezier/index.h"
#include "osculate/construction/contact_error.h"
#include "osculate/construction/span_basis.h"
#include "osculate/differential/arc_jet.h"
#include "osculate/differential/series.h"

namespace osculate {

namespace {

/// Column i of a span's table belongs to pole first + i, if that is in the window.
template <class Columns>
void addColumns(const SpanBasis& basis, const Columns& columns, Eigen::MatrixXd& rows) {
  const Eigen::Index count = std::min(columns.cols(), rows.cols() - basis.first());
  if (count > 0) rows.middleCols(basis.first(), count) += columns.leftCols(count);
}

/// The quadratic form int (sum_i R_i x_i)^2 ds over the window, by Gauss-Legendre quadrature on
/// each span. A span that is a single point weighs a little, so that its poles are not
/// undetermined.
struct Gram {
  Eigen::MatrixXd matrix;
  double lengthMm;
};

Gram gramOf(const std::vector<SpanBasis>& spans, int degree, int poles) {
  constexpr double kWeightOfPoint = 1e-6;
  const BernsteinTable table = bernsteinTable(degree);
  std::vector<Eigen::VectorXd> weights;
  weights.reserve(spans.size());
  double length = 0.0;
  for (const SpanBasis& span : spans) {
    weights.emplace_back(table.weights.cwiseProduct(span.speeds(table)));
    length += weights.back().sum();
  }
  Gram gram{Eigen::MatrixXd::Zero(poles, poles), length};
  for (std::size_t s = 0; s < spans.size(); ++s) {
    if (weights[s].sum() == 0.0) weights[s] = kWeightOfPoint * length * table.weights;
    const int from = spans[s].first();
    const int count = std::min(degree + 1, poles - from);
    if (count <= 0) continue;
    const Eigen::MatrixXd values = spans[s].values(table).leftCols(count);
    gram.matrix.block(from, from, count, count) +=
        values.transpose() * weights[s].asDiagonal() * values;
  }
  return gram;
}

/// The coefficients of t^j in phi(t)^i, phi(t) = sum_k beta_k t^k / k!.
Eigen::MatrixXd powersOf(const KnotContact& contact) {
  const int m = std::max(contact.order, 0);
  detail::PowerTable<double, kMaxOrder> power{};
  for (int k = 1; k <= m; ++k)
    power[1][index(k)] = contact.beta[index(k - 1)] / detail::kFactorials[index(k)];
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(m + 1, m + 1);
  result(0, 0) = 1.0;
  for (int i = 1; i <= m; ++i) {
    for (int j = i; j <= m; ++j) {
      if (i > 1) {
        power[index(i)][index(j)] =
            series::nextPower(power[1].data(), power[index(i - 1)].data(), i, j);
      }
      result(i, j) = power[index(i)][index(j)];
    }
  }
  return result;
}

/// The rows that keep the contact at the knot between two spans, for the orders that the
/// multiplicity does not ensure; `after` null at the end of the window, beyond which nothing moves.
Eigen::MatrixXd contactRows(const KnotContact& contact, int degree, int poles,
                            const SpanBasis& before, const SpanBasis* after) {
  const int ensured = degree - contact.multiplicity;
  const int count = contact.order - ensured;
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(std::max(count, 0), poles);
  if (count <= 0) return rows;
  Eigen::MatrixXd left = before.taylor(CurveEnd::kEnd, contact.order);
  if (after != nullptr) {
    left = -(left * powersOf(contact)).eval();
    addColumns(*after, after->taylor(CurveEnd::kStart, contact.order).rightCols(count).transpose(),
               rows);
  }
  addColumns(before, left.rightCols(count).transpose(), rows);
  return rows;
}

Eigen::MatrixXd constraintsOf(const std::vector<SpanBasis>& spans,
                              const std::vector<KnotContact>& contacts, int degree,
                              const ChangeWindow& window) {
  Eigen::MatrixXd all(0, window.poles);
  for (int j = 1; j <= window.spans - (window.wholeCurve ? 1 : 0); ++j) {
    const SpanBasis* after = j < window.spans ? &spans[index(j)] : nullptr;
    Eigen::MatrixXd rows =
        contactRows(contacts[index(j - 1)], degree, window.poles, spans[index(j - 1)], after);
    rows.rowwise().normalize();
    const Eigen::Index before = all.rows();
    all.conservativeResize(before + rows.rows(), Eigen::NoChange);
    all.bottomRows(rows.rows()) = rows;
  }
  return all;
}

/// min x' G x with C x = 0 and the first entries of x given: the Karush-Kuhn-Tucker equations
/// G_ff x_f + C_f' y = -G_f0 x_0,  C_f x_f = -C_0 x_0.
Eigen::MatrixXd responseOf(const Eigen::MatrixXd& gram, const Eigen::MatrixXd& constraints,
                           Eigen::Index first) {
  const Eigen::Index count = gram.rows();
  const Eigen::Index free = count - first;
  const Eigen::Index rows = constraints.rows();
  Eigen::MatrixXd response = Eigen::MatrixXd::Identity(count, first);
  if (free == 0) return response;
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(free + rows, free + rows);
  system.topLeftCorner(free, free) = gram.bottomRightCorner(free, free);
  system.topRightCorner(free, rows) = constraints.rightCols(free).transpose();
  system.bottomLeftCorner(rows, free) = constraints.rightCols(free);
  Eigen::MatrixXd right(free + rows, first);
  right.topRows(free) = -gram.bottomLeftCorner(free, first);
  right.bottomRows(rows) = -constraints.leftCols(first);
  response.bottomRows(free) = system.partialPivLu().solve(right).topRows(free);
  return response;
}

}  // namespace

LeastChange leastChange(const BSplineCurve& head, const std::vector<KnotContact>& contacts,
                        const ChangeWindow& window, int first) {
  constexpr double kMissed = 1e-6;
  std::vector<SpanBasis> spans;
  spans.reserve(static_cast<std::size_t>(window.spans));
  for (int span = 0; span < window.spans; ++span)
    spans.emplace_back(head, span);
  const Gram gram = gramOf(spans, head.degree(), window.poles);
  const Eigen::MatrixXd constraints = constraintsOf(spans, contacts, head.degree(), window);
  LeastChange result;
  result.response = responseOf(gram.matrix / gram.lengthMm, constraints, first);
  const double missed = (constraints * result.response).norm();
  if (!(missed <= kMissed * result.response.norm())) {
    throw ContactError("b: its inner knots near the join leave no freedom to change it there");
  }
  result.cost = result.response.transpose() * gram.matrix * result.response;
  result.cost = 0.5 * (result.cost + result.cost.transpose()).eval();
  result.lengthMm = gram.lengthMm;
  return result;
}

}  // namespace osculate
