#include "osculate/construction/joined_net.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "osculate/bezier/knot_removal.h"
#include "osculate/bezier/net_distance.h"
#include "osculate/bezier/raised_net.h"
#include "osculate/construction/contact_error.h"
#include "osculate/construction/curve_chain.h"

namespace osculate {

namespace {

/// From the parameter of a part to that of the joined net; the identity keeps every bit.
struct KnotMap {
  double from;
  double to;
  double scale;
  double operator()(double u) const {
    return scale == 1.0 && from == to ? u : to + scale * (u - from);
  }
};

/// A net around a removal, and that after it: of a clamped net a part of it.
struct Change {
  SplineNet before;
  SplineNet after;
  double low;  ///< the interval that the removal changes; of a periodic net it may leave the period
  double high;

  Change(const SplineNet& net, KnotRemoval removal)
      : before(net),
        low(net.knot(removal.firstPole)),
        high(net.knot(removal.firstPole + removal.oldPoles + net.degree)) {
    if (!net.isPeriodic()) {
      const int p = net.degree;
      const int first = std::max(removal.firstPole - p - 1, 0);
      const int last = std::min(removal.firstPole + removal.oldPoles + p, net.poleCount() - 1);
      before.poles.assign(net.poles.begin() + first, net.poles.begin() + last + 1);
      before.flat.assign(net.flat.begin() + first, net.flat.begin() + last + p + 2);
      removal.firstKnot -= first;
      removal.firstPole -= first;
    }
    after = before;
    apply(removal, after);
  }
};

/// The largest distance of the nets before and after a removal, in mm. Much less at high degrees
/// than the bound by the poles: rounding there moves poles far more than the curve.
double changeMm(const SplineNet& net, const KnotRemoval& removal) {
  const Change change(net, removal);
  std::vector<double> knots = compress(change.before.flat).knots;
  if (net.isPeriodic()) knots.push_back(knots.front() + net.period);
  double largest = 0.0;
  for (std::size_t i = 1; i < knots.size(); ++i) {
    const bool same = knots[i] <= change.low || knots[i - 1] >= change.high;
    if (same && !net.isPeriodic()) continue;
    largest = std::max(largest, largestDistance(bezierNet(change.before, knots[i - 1], knots[i]),
                                                bezierNet(change.after, knots[i - 1], knots[i])));
  }
  return largest;
}

/// Removes as many copies of a knot as leave the curve within the limit; at least `least` stay.
void lowerExactly(SplineNet& net, double u, double limitMm, int least) {
  const SplineNet::Occurrence knot = net.find(u);
  const int most = removableTimes(net, knot, least);
  const double worthMeasuring = std::ldexp(limitMm, net.degree);
  std::vector<KnotRemoval> proposals;
  int exact = 0;           // so many copies go within the limit
  int inexact = most + 1;  // so many do not
  for (int times = 1; times < inexact; ++times) {
    proposals.push_back(proposeRemoval(net, knot, times));
    const double bound = proposals.back().deviationMm;
    if (bound <= limitMm && exact == times - 1) exact = times;
    if (!(bound <= worthMeasuring)) inexact = times;
  }
  while (inexact - exact > 1) {
    const int times = inexact > most ? most : (exact + inexact) / 2;
    const KnotRemoval& removal = proposals[static_cast<std::size_t>(times) - 1];
    (changeMm(net, removal) <= limitMm ? exact : inexact) = times;
  }
  if (exact > 0) apply(proposals[static_cast<std::size_t>(exact) - 1], net);
}

/// The net of one part, of the given degree and kind, over its interval of the joined net.
SplineNet partNet(const ChainPart& part, int degree, bool rational, const KnotMap& map,
                  double weight) {
  SplineNet net = raisedNet(part.curve, degree - part.curve.degree());
  const std::vector<double> own = net.flat;
  for (double& knot : net.flat)
    knot = map(knot);
  for (std::size_t i = 1; i < own.size(); ++i) {
    const bool lost = own[i - 1] < own[i] && !(net.flat[i - 1] < net.flat[i]);
    if (lost || !std::isfinite(net.flat[i])) {
      throw ContactError("curves: the knots of curves[" + std::to_string(part.index) +
                         "] cannot be told apart beside the others in double precision; join "
                         "fewer curves");
    }
  }
  net.rational = rational;
  if (weight != 1.0) {
    for (Eigen::Vector4d& pole : net.poles)
      pole *= weight;
  }
  return net;
}

void lowerInnerKnots(SplineNet& net, double limitMm) {
  const KnotVector knots = compress(net.flat);
  for (std::size_t i = 1; i + 1 < knots.knots.size(); ++i)
    lowerExactly(net, knots.knots[i], limitMm, 0);
}

void addReferences(const BSplineCurve& curve, const KnotMap& map, int degree, bool rational,
                   std::vector<Reference>& references) {
  for (int span = 0; span < curve.spanCount(); ++span) {
    const BezierSegment segment = curve.segment(span);
    const Net own = toNet(segment.curve.elevated(degree - curve.degree()).view());
    Net net = Net::Ones(rational ? 4 : 3, own.cols());
    net.topRows(own.rows()) = own;
    references.push_back({map(segment.first), map(segment.last), net});
  }
}

/// The point half way between two ends, with the weight of the first.
Eigen::Vector4d between(const Eigen::Vector4d& first, const Eigen::Vector4d& second) {
  const Vector3 a = project(first);
  const Vector3 b = project(second);
  if (a == b) return first;
  Eigen::Vector4d result;
  result << first[3] * 0.5 * (a + b), first[3];
  return result;
}

/// Puts a net behind another one; the knot between them gets the multiplicity `degree`.
void append(const SplineNet& next, SplineNet& net) {
  net.flat.pop_back();
  net.flat.insert(net.flat.end(), next.flat.begin() + next.degree + 1, next.flat.end());
  net.poles.back() = between(net.poles.back(), next.poles.front());
  net.poles.insert(net.poles.end(), next.poles.begin() + 1, next.poles.end());
}

void checkWeights(const JoinScales& scales) {
  for (const double weight : scales.weights) {
    if (!(weight > 1e-100 && weight < 1e100)) {
      throw ContactError(
          "curves: the weights, made to agree at every join, would leave the range "
          "of 1e-100 to 1e100; join fewer curves");
    }
  }
}

/// What is merged: the nets of the parts, each over its interval of the joined one.
struct PartNets {
  std::vector<SplineNet> nets;
  std::vector<double> roundings;  ///< what is rounding at the end of each part but the last
};

/// Halves of the parts are merged first, and so on: the rounding of a removal is thus carried on as
/// often as the number of parts can be halved, not as often as there are parts.
SplineNet merged(PartNets& parts, std::size_t begin, std::size_t end) {
  if (end - begin == 1) return std::move(parts.nets[begin]);
  const std::size_t middle = begin + (end - begin) / 2;
  SplineNet net = merged(parts, begin, middle);
  const SplineNet next = merged(parts, middle, end);
  const double u = net.flat.back();
  append(next, net);
  lowerExactly(net, u, parts.roundings[middle - 1], 0);
  return net;
}

JoinedNet joinedExactly(const std::vector<ChainPart>& parts, const JoinScales& scales) {
  checkWeights(scales);
  int degree = 0;
  bool rational = false;
  for (const ChainPart& part : parts) {
    degree = std::max(degree, part.curve.degree());
    rational = rational || part.curve.isRational();
  }
  JoinedNet joined;
  PartNets all;
  double start = parts.front().curve.first();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const BSplineCurve& curve = parts[i].curve;
    const KnotMap map{curve.first(), start, scales.scales[i]};
    all.nets.push_back(partNet(parts[i], degree, rational, map, scales.weights[i]));
    lowerInnerKnots(all.nets.back(), roundingMm(curve, curve));
    addReferences(curve, map, degree, rational, joined.references);
    start = all.nets.back().flat.back();
    if (i + 1 == parts.size()) break;
    joined.knots.push_back(start);
    all.roundings.push_back(roundingMm(curve, parts[i + 1].curve));
  }
  joined.net = merged(all, 0, parts.size());
  return joined;
}

/// Where the weights allow it: the last pole becomes the first one and the net periodic.
void close(const std::vector<ChainPart>& parts, JoinedNet& joined) {
  SplineNet& net = joined.net;
  const Eigen::Vector4d first = net.poles.front();
  const Eigen::Vector4d last = net.poles.back();
  net.poles.front() = between(first, last);
  net.poles.back() = between(last, first);
  if (!(std::abs(first[3] - last[3]) <= kJoinRounding * first[3])) return;
  net.poles.back() = net.poles.front();
  net = periodicNet(net);
  lowerExactly(net, net.flat.front(), roundingMm(parts.back().curve, parts.front().curve), 1);
}

/// Whether the net is within the tolerance of the references that overlap [low, high].
bool isNear(const SplineNet& net, const std::vector<Reference>& references, double low, double high,
            double toleranceMm) {
  const auto endsBefore = [](double value, const Reference& item) { return value < item.last; };
  auto item = std::upper_bound(references.begin(), references.end(), low, endsBefore);
  for (; item != references.end() && item->first < high; ++item) {
    if (largestDistance(item->net, bezierNet(net, item->first, item->last)) > toleranceMm) {
      return false;
    }
  }
  return true;
}

/// Takes one copy of the knot out if the curve stays within the tolerance of its references.
void tryToLower(JoinedNet& joined, double u, double toleranceMm) {
  const SplineNet& net = joined.net;
  const KnotRemoval removal = proposeRemoval(net, net.find(u), 1);
  if (!std::isfinite(removal.deviationMm)) return;
  const Change change(net, removal);
  for (const double turn : {0.0, -1.0, 1.0}) {
    const double shift = turn * net.period;
    if (!isNear(change.after, joined.references, change.low + shift, change.high + shift,
                toleranceMm)) {
      return;
    }
    if (!net.isPeriodic()) break;
  }
  apply(removal, joined.net);
}

/// The joins whose knots have this multiplicity and may lose a copy, the smallest change first.
std::vector<double> candidates(const JoinedNet& joined, int multiplicity) {
  std::vector<std::pair<double, double>> found;
  const auto add = [&](double u, int least) {
    const SplineNet::Occurrence knot = joined.net.find(u);
    if (knot.multiplicity != multiplicity || removableTimes(joined.net, knot, least) < 1) return;
    found.emplace_back(proposeRemoval(joined.net, knot, 1).deviationMm, u);
  };
  for (const double u : joined.knots)
    add(u, 0);
  if (joined.net.isPeriodic()) add(joined.net.flat.front(), 1);
  std::sort(found.begin(), found.end());
  std::vector<double> knots;
  knots.reserve(found.size());
  for (const auto& [deviation, u] : found)
    knots.push_back(u);
  return knots;
}

}  // namespace

JoinedNet joinParts(const std::vector<ChainPart>& parts, const JoinScales& scales, bool closed,
                    double toleranceMm) {
  JoinedNet joined = joinedExactly(parts, scales);
  if (closed) close(parts, joined);
  const int degree = joined.net.degree;
  for (int multiplicity = degree; toleranceMm > 0.0 && multiplicity > 0; --multiplicity) {
    for (const double u : candidates(joined, multiplicity))
      tryToLower(joined, u, toleranceMm);
  }
  const bool isCorner = joined.net.find(joined.net.flat.front()).multiplicity == degree;
  if (joined.net.isPeriodic() && isCorner) joined.net = openedNet(joined.net);
  return joined;
}

double displacementMm(const JoinedNet& joined) {
  double largest = 0.0;
  for (const Reference& reference : joined.references) {
    const Net own = bezierNet(joined.net, reference.first, reference.last);
    largest = std::max(largest, largestDistance(reference.net, own));
  }
  return largest;
}

}  // namespace osculate
