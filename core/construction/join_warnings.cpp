#include "osculate/construction/join_warnings.h"

#include <algorithm>
#include <sstream>

namespace osculate {

namespace {

/// The worst of the joins that have some fault, and how many have it.
struct Worst {
  int count = 0;
  double value = 0.0;
  std::size_t join = 0;

  void add(double candidate, std::size_t i) {
    if (count++ > 0 && candidate <= value) return;
    value = candidate;
    join = i;
  }
};

/// Of the speeds by the curve's parameter on both sides, >= 1; beta is by those of the segments.
double speedRatio(const CurveJoin& join) {
  const double ratio =
      join.report.beta[0] * join.firstSegment.length() / join.secondSegment.length();
  return std::max(ratio, 1.0 / ratio);
}

/// "2 joins (the sharpest, 90 degrees, between curves[0] and curves[1])"
std::string described(const Worst& worst, const CurveChain& chain, const std::string& superlative,
                      const std::string& unit) {
  std::ostringstream text;
  text.precision(3);
  const std::size_t first = chain.links[worst.join].index;
  const std::size_t second = chain.links[(worst.join + 1) % chain.links.size()].index;
  text << worst.count << (worst.count == 1 ? " join (" : " joins (the ")
       << (worst.count == 1 ? "" : superlative + ", ") << worst.value << unit << ", between curves["
       << first << "] and curves[" << second << "])";
  return text.str();
}

}  // namespace

std::vector<std::string> joinWarnings(std::span<const BSplineCurve> curves, const CurveChain& chain,
                                      const Construction& result) {
  Worst gap;
  Worst corner;
  Worst speed;
  for (std::size_t i = 0; i < result.joins.size(); ++i) {
    const BSplineCurve& first = curves[chain.links[i].index];
    const BSplineCurve& second = curves[chain.links[(i + 1) % chain.links.size()].index];
    const double apart = result.inputJoins[i].report.deviation.gapMm;
    if (apart > roundingMm(first, second)) gap.add(apart, i);
    const JoinReport& report = result.joins[i].report;
    if (report.verdicts[1] == Verdict::kFail)
      corner.add(report.deviation.tangentAngleDegrees.value_or(0.0), i);
    if (report.order > 0 && report.parametricOrder == 0) speed.add(speedRatio(result.joins[i]), i);
  }
  std::vector<std::string> warnings;
  if (chain.sorted)
    warnings.emplace_back("order: the curves were no chain in the order given and were sorted");
  if (gap.count > 0) warnings.push_back("gap: closed at " + described(gap, chain, "widest", " mm"));
  if (corner.count > 0) {
    warnings.push_back("corner: G0 only at " + described(corner, chain, "sharpest", " degrees"));
  }
  if (speed.count > 0) {
    warnings.push_back(
        "speed: smooth but at two speeds, so that the knot keeps its full "
        "multiplicity, at " +
        described(speed, chain, "largest ratio", " times"));
  }
  return warnings;
}

}  // namespace osculate
