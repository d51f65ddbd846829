#include "osculate/construction/join.h"

#include <algorithm>
#include <sstream>
#include <string>

#include "osculate/construction/contact_error.h"
#include "osculate/construction/curve_chain.h"
#include "osculate/construction/join_warnings.h"
#include "osculate/construction/joined_net.h"

namespace osculate {

namespace {

AnalysisOptions exactly() { return {.tolerances = Tolerances::preset("exact")}; }

/// The parameters where a clamped curve is torn: inner knots of multiplicity degree + 1.
std::vector<double> tears(const BSplineCurve& curve) {
  std::vector<double> result;
  for (const BSplineCurve::InnerKnot& knot : curve.innerKnots()) {
    if (knot.multiplicity > curve.degree()) result.push_back(knot.parameter);
  }
  return result;
}

void checkTear(const BSplineCurve& before, const BSplineCurve& after, std::size_t index,
               double toleranceMm) {
  const double gap = (before.endPoint(CurveEnd::kEnd) - after.endPoint(CurveEnd::kStart)).norm();
  if (gap <= std::max(2.0 * toleranceMm, roundingMm(before, after))) return;
  std::ostringstream text;
  text << "curves: curves[" << index << "] is torn by " << gap << " mm at its parameter "
       << before.last() << ", beyond rounding" << (toleranceMm > 0.0 ? " and tolerance" : "");
  throw ContactError(text.str());
}

/// The curves in the direction of travel, clamped, and cut where they are torn.
std::vector<ChainPart> partsOf(std::span<const BSplineCurve> curves, const CurveChain& chain,
                               double toleranceMm) {
  std::vector<ChainPart> parts;
  for (const ChainLink& link : chain.links) {
    const BSplineCurve& own = curves[link.index];
    BSplineCurve rest = own.trimmed(own.first(), own.last());
    if (link.reversed) rest = rest.reversed();
    for (const double t : tears(rest)) {
      const auto [before, after] = rest.split(t);
      checkTear(before, after, link.index, toleranceMm);
      parts.push_back({before, link.index});
      rest = after;
    }
    parts.push_back({rest, link.index});
  }
  return parts;
}

std::vector<BSplineCurve> curvesOf(const std::vector<ChainPart>& parts) {
  std::vector<BSplineCurve> curves;
  curves.reserve(parts.size());
  for (const ChainPart& part : parts)
    curves.push_back(part.curve);
  return curves;
}

CurveEnd exitOf(const ChainLink& link) { return link.reversed ? CurveEnd::kStart : CurveEnd::kEnd; }

std::vector<CurveJoin> inputJoins(std::span<const BSplineCurve> curves, const CurveChain& chain) {
  std::vector<CurveJoin> joins;
  const std::size_t count = chain.links.size();
  if (count == 1 && chain.closed) return {analyzeClosing(curves[0], exactly())};
  for (std::size_t i = 0; i < (chain.closed ? count : count - 1); ++i) {
    const ChainLink& first = chain.links[i];
    const ChainLink& second = chain.links[(i + 1) % count];
    joins.push_back(analyzeCurves(curves[first.index], curves[second.index], exactly(),
                                  JoinEnds{exitOf(first), opposite(exitOf(second))}));
  }
  return joins;
}

std::vector<CurveJoin> resultJoins(const BSplineCurve& curve, const std::vector<ChainPart>& parts,
                                   const std::vector<double>& knots, bool closed) {
  std::vector<CurveJoin> joins;
  for (std::size_t i = 0; i < knots.size(); ++i) {
    if (parts[i].index != parts[i + 1].index)
      joins.push_back(analyzeAt(curve, knots[i], exactly()));
  }
  if (closed) joins.push_back(analyzeClosing(curve, exactly()));
  return joins;
}

double largestPoleError(std::span<const BSplineCurve> curves) {
  double largest = 0.0;
  for (const BSplineCurve& curve : curves)
    largest = std::max(largest, curve.poleError());
  return largest;
}

}  // namespace

Construction joinCurves(std::span<const BSplineCurve> curves, double toleranceMm) {
  const CurveChain chain = orderChain(curves, toleranceMm);
  const std::vector<ChainPart> parts = partsOf(curves, chain, toleranceMm);
  const JoinScales scales = joinScales(curvesOf(parts), chain.closed, toleranceMm);
  const JoinedNet joined = joinParts(parts, scales, chain.closed, toleranceMm);
  Construction result{.curve = curveOf(joined.net, largestPoleError(curves))};
  result.maxDisplacementMm = displacementMm(joined);
  result.joins = resultJoins(result.curve, parts, joined.knots, chain.closed);
  result.inputJoins = inputJoins(curves, chain);
  result.warnings = joinWarnings(curves, chain, result);
  return result;
}

}  // namespace osculate
