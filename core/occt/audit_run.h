// One audit while it runs; private to this floor.
#pragma once

#include <atomic>
#include <chrono>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "osculate/continuity/curve_tip.h"
#include "osculate/occt/edge_graph.h"

namespace osculate {

/// Goes through the edges in blocks. Of a block first every edge is converted, its inner joins
/// analysed and its ends kept; then every pair whose higher edge is in the block is analysed, and
/// ends that no later pair needs are dropped. So neither the curves nor all ends are held at once.
class AuditRun {
 public:
  /// Fills in everything of the report but its options.
  AuditRun(const EdgeGraph& graph, AuditReport& report, const Progress& progress);
  void run();

 private:
  /// What an edge leaves for its pairs.
  struct Tips {
    CurveTip start;
    CurveTip end;
    const CurveTip& at(CurveEnd which) const { return which == CurveEnd::kStart ? start : end; }
  };
  /// What the first pass finds on one edge.
  struct EdgeResult {
    std::vector<AuditRow> rows;
    std::string problem;  ///< why it cannot be converted
  };
  struct Block {
    std::size_t begin;
    std::size_t end;
    std::vector<EdgeResult> results;
    std::vector<std::size_t> firstRow;  ///< of each edge in the report
  };

  /// False where it was stopped: then nothing of the block is in the report.
  bool runBlock(std::size_t begin, std::size_t end);
  void convert(std::size_t edge, EdgeResult& result);
  void addInnerRows(std::size_t edge, const BSplineCurve& curve, std::vector<AuditRow>& rows);
  bool isClosed(std::size_t edge, const BSplineCurve& curve) const;
  void layOut(Block& block);
  void analyzePairs(Block& block, std::size_t edge);
  void dropCorners(std::size_t firstRow);
  void noteSkipped(const Block& block);
  void releaseTips(const Block& block);
  bool hasTips(const EndPair& pair) const;
  template <class Visit>
  bool overEdges(const Block& block, Visit visit);
  /// Counts work and reports progress where it is time; whether to go on.
  bool isWanted();
  bool tell(double share);

  const EdgeGraph& graph_;
  AuditReport& report_;
  const Progress& progress_;
  const AnalysisOptions& options_;
  int threads_;
  std::vector<EndPair> pairs_;
  std::vector<std::size_t> firstPair_;  ///< of each edge as the higher one, and one past the last
  std::vector<int> pending_;            ///< pairs that each edge's tips are still needed for
  std::vector<std::unique_ptr<Tips>> tips_;
  std::thread::id caller_ = std::this_thread::get_id();
  std::chrono::steady_clock::time_point told_;
  std::atomic<std::size_t> done_ = 0;
  std::atomic<bool> cancelled_ = false;
};

}  // namespace osculate
