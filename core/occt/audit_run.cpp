#include "osculate/occt/audit_run.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <string_view>

#include "osculate/continuity/curve_joins.h"
#include "osculate/occt/edge_curve.h"
#include "osculate/occt/parallel.h"

namespace osculate {

namespace {

// edges: a block is long enough for threads to share and short enough for its curves' ends to
// stay in the cache; a piece is as long as some hundred microseconds of work
constexpr std::size_t kBlock = 4096;
constexpr std::size_t kPiece = 64;
constexpr int kKnotsBetweenQuestions = 256;
constexpr std::chrono::milliseconds kBetweenReports{20};

int threadCount(int wanted) {
  if (wanted > 0) return wanted;
  return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

/// The sentence of curveFromEdge without the name of its argument.
std::string reason(std::string_view message) {
  constexpr std::string_view kPrefix = "edge: ";
  if (message.starts_with(kPrefix)) message.remove_prefix(kPrefix.size());
  return std::string(message);
}

}  // namespace

AuditRun::AuditRun(const EdgeGraph& graph, AuditReport& report, const Progress& progress)
    : graph_(graph),
      report_(report),
      progress_(progress),
      options_(report.options.analysis),
      threads_(threadCount(report.options.threads)),
      pairs_(graph.pairs(report.options.pairs)) {
  const auto edgeCount = static_cast<std::size_t>(graph.edgeCount());
  tips_.resize(edgeCount);
  pending_.assign(edgeCount, 0);
  firstPair_.assign(edgeCount + 1, 0);
  for (const EndPair& pair : pairs_) {
    const auto high = static_cast<std::size_t>(pair.high.edge());
    ++pending_[static_cast<std::size_t>(pair.low.edge())];
    ++pending_[high];
    ++firstPair_[high + 1];
  }
  for (std::size_t edge = 0; edge < edgeCount; ++edge)
    firstPair_[edge + 1] += firstPair_[edge];
}

void AuditRun::run() {
  const auto edgeCount = static_cast<std::size_t>(graph_.edgeCount());
  report_.edgeCount = graph_.edgeCount();
  report_.complete = tell(0.0);
  report_.rows.reserve(pairs_.size());
  for (std::size_t begin = 0; begin < edgeCount && report_.complete; begin += kBlock)
    report_.complete = runBlock(begin, std::min(begin + kBlock, edgeCount));
  if (report_.complete) tell(1.0);
}

template <class Visit>
bool AuditRun::overEdges(const Block& block, Visit visit) {
  const auto piece = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end && !cancelled_; ++i)
      visit(block.begin + i);
    done_ += end - begin;
  };
  parallelFor(block.end - block.begin, kPiece, threads_, piece, [this] { return isWanted(); });
  return !cancelled_;
}

bool AuditRun::runBlock(std::size_t begin, std::size_t end) {
  Block block{begin, end, std::vector<EdgeResult>(end - begin), {}};
  const std::size_t firstRow = report_.rows.size();
  if (!overEdges(block, [&](std::size_t edge) { convert(edge, block.results[edge - begin]); }))
    return false;
  layOut(block);
  if (!overEdges(block, [&](std::size_t edge) { analyzePairs(block, edge); })) {
    report_.rows.resize(firstRow);
    return false;
  }
  if (report_.options.pairs == JoinPairs::kTangent) dropCorners(firstRow);
  noteSkipped(block);
  releaseTips(block);
  return true;
}

void AuditRun::convert(std::size_t edge, EdgeResult& result) {
  try {
    const BSplineCurve curve = curveFromEdge(graph_.edge(static_cast<int>(edge))).curve;
    addInnerRows(edge, curve, result.rows);
    if (pending_[edge] > 0) {
      tips_[edge] = std::make_unique<Tips>(
          Tips{CurveTip(curve, CurveEnd::kStart), CurveTip(curve, CurveEnd::kEnd)});
    }
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    result.problem = reason(error.what());
  }
}

void AuditRun::addInnerRows(std::size_t edge, const BSplineCurve& curve,
                            std::vector<AuditRow>& rows) {
  const int number = static_cast<int>(edge) + 1;
  const auto add = [&](const JoinReport& report, JoinKind kind, double parameter) {
    AuditRow row = auditRow(report);
    row.edges = {number, number};
    row.kind = kind;
    row.parameter = parameter;
    rows.push_back(row);
  };
  visitInnerKnots(curve, options_, [&](const KnotJoin& knot) {
    add(knot.report, JoinKind::kKnot, knot.parameter);
    return rows.size() % kKnotsBetweenQuestions != 0 || isWanted();
  });
  if (isClosed(edge, curve)) add(analyzeClosing(curve, options_).report, JoinKind::kSeam, 0.0);
}

bool AuditRun::isClosed(std::size_t edge, const BSplineCurve& curve) const {
  if (graph_.isClosed(static_cast<int>(edge))) return true;
  // not a short edge: one that goes farther from its start than the tolerance that closes it
  const double gap = options_.tolerances.gapMm;
  const Vector3& start = curve.endPoint(CurveEnd::kStart);
  return curve.isClosed(gap) && (curve.middlePoint() - start).norm() > gap;
}

bool AuditRun::hasTips(const EndPair& pair) const {
  return tips_[static_cast<std::size_t>(pair.low.edge())] != nullptr &&
         tips_[static_cast<std::size_t>(pair.high.edge())] != nullptr;
}

void AuditRun::layOut(Block& block) {
  std::size_t row = report_.rows.size();
  for (std::size_t edge = block.begin; edge < block.end; ++edge) {
    block.firstRow.push_back(row);
    row += block.results[edge - block.begin].rows.size();
    for (std::size_t i = firstPair_[edge]; i < firstPair_[edge + 1]; ++i)
      row += hasTips(pairs_[i]) ? 1 : 0;
  }
  report_.rows.resize(row);
}

void AuditRun::analyzePairs(Block& block, std::size_t edge) {
  const std::vector<AuditRow>& inner = block.results[edge - block.begin].rows;
  AuditRow* row = report_.rows.data() + block.firstRow[edge - block.begin];
  row = std::copy(inner.begin(), inner.end(), row);
  for (std::size_t i = firstPair_[edge]; i < firstPair_[edge + 1]; ++i) {
    const auto& [low, high] = pairs_[i];
    if (!hasTips(pairs_[i])) continue;
    const Tips& first = *tips_[static_cast<std::size_t>(low.edge())];
    const Tips& second = *tips_[static_cast<std::size_t>(high.edge())];
    *row = auditRow(analyzeTips(first.at(low.end()), second.at(high.end()), options_));
    row->edges = {low.edge() + 1, high.edge() + 1};
    row->kind = JoinKind::kVertex;
    row->ends = {low.end(), high.end()};
    ++row;
  }
}

void AuditRun::dropCorners(std::size_t firstRow) {
  const double largest = report_.options.cornerDegrees;
  const auto begin = report_.rows.begin() + static_cast<std::ptrdiff_t>(firstRow);
  const auto kept = std::remove_if(begin, report_.rows.end(), [&](const AuditRow& row) {
    const bool turns = std::isfinite(row.residuals[1]) && row.residuals[1] > largest;
    return row.kind == JoinKind::kVertex && turns && row.verdicts[0] != Verdict::kFail;
  });
  report_.corners += static_cast<std::size_t>(report_.rows.end() - kept);
  report_.rows.erase(kept, report_.rows.end());
}

void AuditRun::noteSkipped(const Block& block) {
  for (std::size_t edge = block.begin; edge < block.end; ++edge) {
    const std::string& problem = block.results[edge - block.begin].problem;
    if (problem.empty()) continue;
    const int index = static_cast<int>(edge);
    report_.skipped.push_back({index + 1, graph_.isDegenerated(index), problem});
  }
}

void AuditRun::releaseTips(const Block& block) {
  const auto release = [&](int edge) {
    const auto i = static_cast<std::size_t>(edge);
    if (--pending_[i] == 0) tips_[i].reset();
  };
  for (std::size_t i = firstPair_[block.begin]; i < firstPair_[block.end]; ++i) {
    release(pairs_[i].low.edge());
    release(pairs_[i].high.edge());
  }
}

bool AuditRun::isWanted() {
  if (std::this_thread::get_id() != caller_) return !cancelled_;
  const auto now = std::chrono::steady_clock::now();
  if (cancelled_ || now - told_ < kBetweenReports) return !cancelled_;
  const double passes = 2.0 * static_cast<double>(graph_.edgeCount());
  return tell(std::min(static_cast<double>(done_) / passes, 1.0));
}

bool AuditRun::tell(double share) {
  if (progress_ && !progress_(share)) cancelled_ = true;
  told_ = std::chrono::steady_clock::now();
  return !cancelled_;
}

}  // namespace osculate
