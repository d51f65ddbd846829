#include "osculate/construction/curve_chain.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <tuple>

#include "osculate/construction/contact_error.h"

namespace osculate {

namespace {

std::string name(std::size_t index) { return "curves[" + std::to_string(index) + "]"; }

double size(const BSplineCurve& curve) { return curve.data().poles.colwise().norm().maxCoeff(); }

double roundingMm(double firstSize, double secondSize, double poleError) {
  return kJoinRounding * std::max(firstSize, secondSize) + poleError;
}

/// The ends of the curves, numbered 2 index (start) and 2 index + 1 (end).
class Ends {
 public:
  Ends(std::span<const BSplineCurve> curves, double toleranceMm)
      : curves_(curves), toleranceMm_(toleranceMm) {
    for (const BSplineCurve& curve : curves)
      sizes_.push_back(size(curve));
  }

  std::size_t count() const { return 2 * curves_.size(); }
  const Vector3& point(std::size_t end) const {
    return curves_[end / 2].endPoint(end % 2 == 0 ? CurveEnd::kStart : CurveEnd::kEnd);
  }
  double distance(std::size_t a, std::size_t b) const { return (point(a) - point(b)).norm(); }
  double rounding(std::size_t a, std::size_t b) const {
    return roundingMm(sizes_[a / 2], sizes_[b / 2],
                      curves_[a / 2].poleError() + curves_[b / 2].poleError());
  }
  /// The widest gap that is closed.
  double limit(std::size_t a, std::size_t b) const {
    return std::max(2.0 * toleranceMm_, rounding(a, b));
  }
  bool meet(std::size_t a, std::size_t b) const { return distance(a, b) <= limit(a, b); }
  /// No two ends of the list are farther apart than this and meet.
  double widestLimit() const {
    double poleError = 0.0;
    for (const BSplineCurve& curve : curves_)
      poleError = std::max(poleError, curve.poleError());
    const double largest = *std::max_element(sizes_.begin(), sizes_.end());
    return std::max(2.0 * toleranceMm_, roundingMm(largest, largest, 2.0 * poleError));
  }
  double tolerance() const { return toleranceMm_; }

 private:
  std::span<const BSplineCurve> curves_;
  double toleranceMm_;
  std::vector<double> sizes_;
};

/// The end by which a link is entered or left.
std::size_t entry(const ChainLink& link) { return 2 * link.index + (link.reversed ? 1 : 0); }
std::size_t exit(const ChainLink& link) { return 2 * link.index + (link.reversed ? 0 : 1); }

/// Sum of the gaps, then how many curves are reversed, the first counting more.
struct Cost {
  double gaps = 0.0;
  int reversals = 0;
  bool operator<(const Cost& other) const {
    return std::tie(gaps, reversals) < std::tie(other.gaps, other.reversals);
  }
};

/// The directions with the least cost, curve by curve (dynamic programming over the direction of
/// the last curve).
std::vector<ChainLink> directedInOrder(const Ends& ends) {
  const std::size_t count = ends.count() / 2;
  std::array<Cost, 2> cost{Cost{0.0, 0}, Cost{0.0, 2}};
  std::vector<std::array<bool, 2>> before(count);
  for (std::size_t i = 1; i < count; ++i) {
    std::array<Cost, 2> next;
    for (const bool reversed : {false, true}) {
      std::array<Cost, 2> by = cost;
      for (const bool previous : {false, true}) {
        const std::size_t from = exit({i - 1, previous});
        const std::size_t to = entry({i, reversed});
        const double gap = ends.distance(from, to);
        by[previous].gaps += gap <= ends.rounding(from, to) ? 0.0 : gap;
        by[previous].reversals += reversed ? 1 : 0;
      }
      before[i][reversed] = by[1] < by[0];
      next[reversed] = by[before[i][reversed]];
    }
    cost = next;
  }
  std::vector<ChainLink> links(count);
  bool reversed = cost[1] < cost[0];
  for (std::size_t i = count; i-- > 0; reversed = before[i][reversed])
    links[i] = {i, reversed};
  return links;
}

bool isChain(const std::vector<ChainLink>& links, const Ends& ends) {
  for (std::size_t i = 1; i < links.size(); ++i) {
    if (!ends.meet(exit(links[i - 1]), entry(links[i]))) return false;
  }
  return true;
}

struct Meeting {
  double distance;
  std::size_t a;
  std::size_t b;
};

/// Every pair of ends of different curves that meet, the nearest first.
std::vector<Meeting> meetings(const Ends& ends) {
  std::vector<std::size_t> order(ends.count());
  for (std::size_t i = 0; i < order.size(); ++i)
    order[i] = i;
  Eigen::AlignedBox3d box;
  for (const std::size_t end : order)
    box.extend(ends.point(end));
  Eigen::Index axis = 0;  // a sweep along the longest side
  box.sizes().maxCoeff(&axis);
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(ends.point(a)[axis], a) < std::pair(ends.point(b)[axis], b);
  });
  const double reach = ends.widestLimit();
  std::vector<Meeting> result;
  for (auto a = order.begin(); a != order.end(); ++a) {
    for (auto b = a + 1; b != order.end(); ++b) {
      if (ends.point(*b)[axis] - ends.point(*a)[axis] > reach) break;
      if (*a / 2 != *b / 2 && ends.meet(*a, *b)) {
        result.push_back({ends.distance(*a, *b), std::min(*a, *b), std::max(*a, *b)});
      }
    }
  }
  std::sort(result.begin(), result.end(), [](const Meeting& x, const Meeting& y) {
    return std::tie(x.distance, x.a, x.b) < std::tie(y.distance, y.a, y.b);
  });
  return result;
}

using Partners = std::vector<std::optional<std::size_t>>;

[[noreturn]] void failBranch(std::size_t a, std::size_t b, std::size_t c) {
  throw ContactError("curves: the chain branches where ends of " + name(a / 2) + ", " +
                     name(b / 2) + " and " + name(c / 2) +
                     " meet; give the curves in the order of travel, without those that branch "
                     "off");
}

/// The partner of each end: nearest ends first, each once.
Partners partners(const Ends& ends) {
  Partners result(ends.count());
  for (const Meeting& meeting : meetings(ends)) {
    for (const auto& [mine, other] :
         {std::pair(meeting.a, meeting.b), std::pair(meeting.b, meeting.a)}) {
      if (!result[mine]) continue;
      const bool asNear =
          meeting.distance <= ends.distance(mine, *result[mine]) + ends.rounding(mine, other);
      if (asNear) failBranch(mine, *result[mine], other);
    }
    if (result[meeting.a] || result[meeting.b]) continue;
    result[meeting.a] = meeting.b;
    result[meeting.b] = meeting.a;
  }
  return result;
}

/// From this link on, to a free end or back to it.
std::vector<ChainLink> walk(ChainLink link, const Partners& partners) {
  std::vector<ChainLink> links{link};
  for (;;) {
    const std::optional<std::size_t> next = partners[exit(links.back())];
    if (!next || *next / 2 == link.index) return links;
    links.push_back({*next / 2, *next % 2 == 1});
  }
}

/// The curves that hang together with the first one.
std::vector<ChainLink> linkedToFirst(const Partners& partners) {
  std::vector<ChainLink> ahead = walk({0, false}, partners);
  if (partners[exit(ahead.back())]) return ahead;  // closed
  std::vector<ChainLink> links = walk({0, true}, partners);
  std::reverse(links.begin(), links.end());
  for (ChainLink& link : links)
    link.reversed = !link.reversed;
  links.insert(links.end(), ahead.begin() + 1, ahead.end());
  return links;
}

/// The nearest ends of a curve that is linked with the first and one that is not. Of an open chain
/// only its free ends count.
Meeting nearestGap(const std::vector<ChainLink>& linked, const Partners& partners,
                   const Ends& ends) {
  std::vector<bool> isLinked(ends.count() / 2, false);
  for (const ChainLink& link : linked)
    isLinked[link.index] = true;
  const bool closed = partners[exit(linked.back())].has_value();
  Meeting nearest{std::numeric_limits<double>::infinity(), 0, 0};
  for (std::size_t a = 0; a < ends.count(); ++a) {
    if (!isLinked[a / 2] || (partners[a] && !closed)) continue;
    for (std::size_t b = 0; b < ends.count(); ++b) {
      const double distance = ends.distance(a, b);
      if (!isLinked[b / 2] && distance < nearest.distance) nearest = {distance, a, b};
    }
  }
  return nearest;
}

[[noreturn]] void failGap(const Meeting& nearest, const Ends& ends) {
  std::ostringstream text;
  text << "curves: " << name(nearest.a / 2) << " and " << name(nearest.b / 2)
       << " are no chain: their nearest free ends are " << nearest.distance
       << " mm apart, beyond rounding";
  if (ends.tolerance() > 0.0) text << " and twice the tolerance of " << ends.tolerance() << " mm";
  text << "; a tolerance of at least " << 0.5 * nearest.distance << " mm would close the gap";
  throw ContactError(text.str());
}

CurveChain sortedChain(const Ends& ends) {
  const Partners found = partners(ends);
  CurveChain chain{.links = linkedToFirst(found), .closed = false, .sorted = true};
  if (2 * chain.links.size() < ends.count()) failGap(nearestGap(chain.links, found, ends), ends);
  return chain;
}

/// The same poles, weights and relative knots.
bool areEqual(const BSplineData& a, const BSplineData& b) {
  if (a.knots.multiplicities != b.knots.multiplicities || a.poles.cols() != b.poles.cols() ||
      a.degree != b.degree || a.periodic != b.periodic || a.poles != b.poles ||
      a.weights != b.weights) {
    return false;
  }
  const auto share = [](const std::vector<double>& knots, std::size_t i) {
    return (knots[i] - knots.front()) / (knots.back() - knots.front());
  };
  for (std::size_t i = 0; i < a.knots.knots.size(); ++i) {
    if (std::abs(share(a.knots.knots, i) - share(b.knots.knots, i)) > 1e-9) return false;
  }
  return true;
}

/// Equal curves, and a curve and its reverse, have equal keys.
auto key(const BSplineCurve& curve) {
  const Vector3 sum = curve.endPoint(CurveEnd::kStart) + curve.endPoint(CurveEnd::kEnd);
  return std::tuple(curve.data().poles.cols(), sum.x(), sum.y(), sum.z());
}

void checkNoneTwice(std::span<const BSplineCurve> curves) {
  std::vector<std::size_t> order(curves.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    order[i] = i;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return key(curves[a]) < key(curves[b]); });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const BSplineCurve& mine = curves[order[i]];
    for (std::size_t j = i + 1; j < order.size() && key(curves[order[j]]) == key(mine); ++j) {
      const BSplineCurve& other = curves[order[j]];
      if (areEqual(mine.data(), other.data()) || areEqual(mine.data(), other.reversed().data())) {
        throw std::invalid_argument("curves: " + name(order[i]) + " and " + name(order[j]) +
                                    " are the same curve");
      }
    }
  }
}

/// A chain that is hardly longer than its opening is not closed by a wide tolerance.
bool closes(const std::vector<ChainLink>& links, std::span<const BSplineCurve> curves,
            const Ends& ends) {
  const std::size_t last = exit(links.back());
  const std::size_t first = entry(links.front());
  const double gap = ends.distance(last, first);
  if (gap <= ends.rounding(last, first)) return true;
  double length = 0.0;
  for (const BSplineCurve& curve : curves)
    length += polygonLength(curve);
  return ends.meet(last, first) && 4.0 * gap <= length;
}

}  // namespace

double polygonLength(const BSplineCurve& curve) {
  const Poles& poles = curve.data().poles;
  const Eigen::Index count = poles.cols() - 1;
  return (poles.rightCols(count) - poles.leftCols(count)).colwise().norm().sum();
}

double roundingMm(const BSplineCurve& first, const BSplineCurve& second) {
  return roundingMm(size(first), size(second), first.poleError() + second.poleError());
}

CurveChain orderChain(std::span<const BSplineCurve> curves, double toleranceMm) {
  if (curves.empty()) throw std::invalid_argument("curves: at least one is needed");
  if (!(std::isfinite(toleranceMm) && toleranceMm >= 0.0)) {
    throw std::invalid_argument("tolerance: must be finite and >= 0, got " +
                                std::to_string(toleranceMm));
  }
  checkNoneTwice(curves);
  const Ends ends(curves, toleranceMm);
  CurveChain chain{.links = directedInOrder(ends), .closed = false, .sorted = false};
  if (!isChain(chain.links, ends)) chain = sortedChain(ends);
  chain.closed = closes(chain.links, curves, ends);
  return chain;
}

}  // namespace osculate
