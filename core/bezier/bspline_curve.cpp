#include "osculate/bezier/bspline_curve.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "osculate/bezier/bspline_state.h"
#include "osculate/bezier/checks.h"

namespace osculate {

namespace {

void checkData(const BSplineData& data) {
  checkKnots(data.knots, data.degree, static_cast<int>(data.poles.cols()), data.periodic);
  for (Eigen::Index i = 0; i < data.poles.cols(); ++i)
    checkFinite(data.poles.col(i));
  checkWeights(data.weights, static_cast<std::size_t>(data.poles.cols()));
  if (!(std::isfinite(data.poleError) && data.poleError >= 0.0)) {
    throw std::invalid_argument("pole error: must be finite and >= 0");
  }
  if ((data.poles.colwise() - data.poles.col(0)).isZero(0.0)) {
    throw std::invalid_argument(
        "poles: all are one point; a curve of zero length has no direction");
  }
}

/// Spans of positive length between the knots `degree` and `poles` of the flat sequence.
std::vector<int> positiveSpans(const std::vector<double>& flat, int degree) {
  std::vector<int> spans;
  const int end = static_cast<int>(flat.size()) - degree - 1;
  for (int i = degree; i < end; ++i) {
    if (flat[static_cast<std::size_t>(i)] < flat[static_cast<std::size_t>(i) + 1])
      spans.push_back(i);
  }
  return spans;
}

}  // namespace

std::vector<double> periodicFlatKnots(const BSplineData& data, int turns) {
  const std::vector<double> once = flatten(data.knots);
  const int multiplicity = data.knots.multiplicities.front();
  const int perTurn = static_cast<int>(once.size()) - multiplicity;  // flat knots of one period
  const double period = data.knots.knots.back() - data.knots.knots.front();
  const int before = data.degree + 1 - multiplicity;
  const int count = perTurn * turns + multiplicity + 2 * before;
  std::vector<double> flat;
  for (int i = -before; i < count - before; ++i) {
    const int turn = (i >= 0 ? i : i - perTurn + 1) / perTurn;
    flat.push_back(once[static_cast<std::size_t>(i - turn * perTurn)] + turn * period);
  }
  return flat;
}

BSplineData unrollPeriods(const BSplineData& data, int turns) {
  const std::vector<double> flat = periodicFlatKnots(data, turns);
  BSplineData open{.poles = {},
                   .weights = {},
                   .knots = compress(flat),
                   .degree = data.degree,
                   .periodic = false,
                   .poleError = data.poleError};
  const auto count = static_cast<Eigen::Index>(flat.size()) - data.degree - 1;
  const Eigen::Index own = data.poles.cols();
  open.poles.resize(3, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    open.poles.col(i) = data.poles.col(i % own);
    if (!data.weights.empty())
      open.weights.push_back(data.weights[static_cast<std::size_t>(i % own)]);
  }
  return open;
}

NetPoint BSplineCurve::State::netPole(int i) const {
  const Eigen::Map<const Vector3> pole(poles() + 3 * i);
  if (weights() == nullptr) return pole;
  NetPoint point(4);
  point << weights()[i] * pole, weights()[i];
  return point;
}

BSplineCurve::BSplineCurve(std::shared_ptr<const State> state) : state_(std::move(state)) {}

BSplineCurve::BSplineCurve(BSplineData data) {
  checkData(data);
  auto state = std::make_shared<State>();
  if (data.periodic) {
    BSplineData open = unrollPeriods(data, 1);
    state->flat = periodicFlatKnots(data, 1);
    state->unrolled = std::move(open.poles);
    state->unrolledWeights = std::move(open.weights);
  } else {
    state->flat = flatten(data.knots);
  }
  state->data = std::move(data);
  const int degree = state->data.degree;
  state->spans = positiveSpans(state->flat, degree);
  if (state->spans.empty()) {
    throw std::invalid_argument("knots: no span of positive length between the knots " +
                                std::to_string(degree + 1) + " and " +
                                std::to_string(state->poleCount() + 1) + " of the flat sequence");
  }
  state->first = state->knot(degree);
  state->last = state->knot(state->poleCount());
  state_ = state;
  state->ends[0] = segment(0).curve.pole(0);
  state->ends[1] = segment(spanCount() - 1).curve.pole(degree);
  state->middle = evaluate(0.5 * (state->first + state->last));
}

BSplineCurve::BSplineCurve(const BezierCurve& curve, double first, double last, double poleError)
    : BSplineCurve([&] {
        const int n = curve.degree();
        BSplineData data{.poles = Eigen::Map<const Poles>(curve.view().poles, 3, n + 1),
                         .weights = {},
                         .knots = {{first, last}, {n + 1, n + 1}},
                         .degree = n,
                         .periodic = false,
                         .poleError = poleError};
        for (int i = 0; curve.isRational() && i <= n; ++i)
          data.weights.push_back(curve.weight(i));
        return data;
      }()) {}

int BSplineCurve::degree() const { return state_->data.degree; }
bool BSplineCurve::isRational() const { return !state_->data.weights.empty(); }
bool BSplineCurve::isPeriodic() const { return state_->data.periodic; }
const BSplineData& BSplineCurve::data() const { return state_->data; }
double BSplineCurve::poleError() const { return state_->data.poleError; }
double BSplineCurve::first() const { return state_->first; }
double BSplineCurve::last() const { return state_->last; }

const Vector3& BSplineCurve::endPoint(CurveEnd end) const {
  return state_->ends[end == CurveEnd::kStart ? 0 : 1];
}

const Vector3& BSplineCurve::middlePoint() const { return state_->middle; }

bool BSplineCurve::isClosed(double tolerance) const {
  return isPeriodic() || (state_->ends[0] - state_->ends[1]).norm() <= tolerance;
}

int BSplineCurve::spanCount() const { return static_cast<int>(state_->spans.size()); }

int BSplineCurve::spanAt(double t, Side side) const {
  const auto& spans = state_->spans;
  // the last span that begins at or before t (from the left: before t)
  const auto after = std::partition_point(spans.begin(), spans.end(), [&](int i) {
    const double begin = state_->knot(i);
    return side == Side::kRight ? begin <= t : begin < t;
  });
  return std::max(0, static_cast<int>(after - spans.begin()) - 1);
}

int BSplineCurve::State::flatSpan(int span) const {
  const auto count = static_cast<int>(spans.size());
  if (span < 0 || span >= count) {
    throw std::invalid_argument("span: must be from 0 to " + std::to_string(count - 1) + ", got " +
                                std::to_string(span));
  }
  return spans[static_cast<std::size_t>(span)];
}

BezierSegment BSplineCurve::segment(int span) const {
  return extractSegment(*state_, state_->flatSpan(span));
}

SpanExtraction BSplineCurve::extraction(int span) const {
  return extractionOf(*state_, state_->flatSpan(span));
}

BezierSegment BSplineCurve::endSegment(CurveEnd end) const {
  const int step = end == CurveEnd::kStart ? 1 : -1;
  int span = end == CurveEnd::kStart ? 0 : spanCount() - 1;
  for (;; span += step) {
    BezierSegment segment = this->segment(span);
    const auto poles = Eigen::Map<const Poles>(segment.curve.view().poles, 3, degree() + 1);
    const bool isPoint = (poles.colwise() - poles.col(0)).isZero(0.0);
    const bool isLast = span + step < 0 || span + step >= spanCount();
    if (!isPoint || isLast) return segment;
  }
}

std::vector<BSplineCurve::InnerKnot> BSplineCurve::innerKnots() const {
  std::vector<InnerKnot> result;
  const auto& flat = state_->flat;
  for (int span = 1; span < spanCount(); ++span) {
    const double t = state_->knot(state_->spans[static_cast<std::size_t>(span)]);
    const auto range = std::equal_range(flat.begin(), flat.end(), t);
    result.push_back({t, static_cast<int>(range.second - range.first), span});
  }
  return result;
}

std::vector<Vector3> BSplineCurve::derivatives(double t, int count, Side side) const {
  const BezierSegment part = segment(spanAt(t, side));
  std::vector<Vector3> result = part.curve.derivatives((t - part.first) / part.length(), count);
  double factor = 1.0;
  for (Vector3& derivative : result) {
    derivative *= factor;
    factor /= part.length();
  }
  return result;
}

Vector3 BSplineCurve::evaluate(double t) const { return derivatives(t, 0).front(); }

}  // namespace osculate
