// The joins of a whole model: one small row a join, what was left out, how it was done.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "osculate/continuity/curve_joins.h"

namespace osculate {

/// Where a join is.
enum class JoinKind : unsigned char {
  kVertex,  ///< two edges at a vertex that both have
  kKnot,    ///< an inner knot of one edge
  kSeam     ///< the end of a closed edge against its start
};
inline constexpr int kJoinKindCount = 3;
std::string_view name(JoinKind kind);

/// Which pairs of edge ends at a vertex are joins.
enum class JoinPairs : unsigned char {
  kAll,     ///< every pair
  kWire,    ///< neighbours in a wire; edges in no wire pair with each other
  kTangent  ///< every pair but corners: where the tangents turn by more than `cornerDegrees`
};
std::string_view name(JoinPairs pairs);
/// Throws std::invalid_argument that lists the names.
JoinPairs joinPairs(std::string_view name);

struct AuditOptions {
  AnalysisOptions analysis;
  JoinPairs pairs = JoinPairs::kAll;
  double cornerDegrees = 15.0;  ///< for kTangent; a pair with a gap counts at any angle
  double touchMm = 0.01;        ///< how far ends of edges in no wire may be apart to be a join; 0:
                                ///< such edges too join at shared vertices only
  int threads = 0;              ///< 0: as many as the machine runs at once. No result depends on it
};
/// Throws std::invalid_argument: what checkOptions refuses, an angle outside 0..180, a
/// distance or a number of threads < 0.
void checkAuditOptions(const AuditOptions& options);

/// One join. Everything but the betas, frames, sides and definitions of its report.
struct AuditRow {
  std::array<int, 2> edges{};  ///< numbered from 1, the lower first; equal for knot and seam
  JoinKind kind = JoinKind::kVertex;
  JoinEnds ends;  ///< which end of the first and of the second edge; not for a knot
  std::int8_t order = -1;
  std::int8_t parametricOrder = -1;
  std::array<Verdict, kMaxOrder + 1> verdicts{};
  WarningSet warnings;
  double parameter = 0.0;          ///< of a knot, in the first edge's direction of travel
  std::array<double, 3> point{};   ///< the first edge's end, mm
  PerOrder residuals{};            ///< as in JoinDecision
  std::array<double, 7> physical;  ///< the members of Deviation after the tangent angle
  std::uint8_t hasPhysical = 0;    ///< bit i: physical[i] exists

  Deviation deviation() const;
  void setDeviation(const Deviation& deviation);
};
static_assert(sizeof(AuditRow) <= 200, "a million rows must stay below 200 MB");

/// The row of a report; `kind`, `edges`, `ends` and `parameter` are left to the caller.
AuditRow auditRow(const JoinReport& report);

/// An edge without joins of its own, and why.
struct SkippedEdge {
  int edge;
  bool degenerated;  ///< a point of a surface, as the pole of a sphere: nothing is amiss
  std::string reason;
};

struct AuditReport {
  AuditOptions options;
  int edgeCount = 0;
  std::size_t corners = 0;  ///< pairs that JoinPairs::kTangent left out
  bool complete = true;     ///< false where the progress function stopped it
  /// In the order of the higher edge; of one edge its knots, its seam, its vertex joins.
  std::vector<AuditRow> rows;
  std::vector<SkippedEdge> skipped;
};

/// How many joins of each kind and order.
struct AuditSummary {
  std::size_t joins = 0;
  std::array<std::size_t, kJoinKindCount> kinds{};  ///< by JoinKind
  std::array<std::size_t, kMaxOrder + 2> orders{};  ///< by order + 1: [0] gaps, [1] G0, ...
  std::size_t undecided = 0;                        ///< rows with an undecided order
};
AuditSummary summarize(const std::vector<AuditRow>& rows);
void add(const AuditSummary& more, AuditSummary& sum);
/// Joins of an order of contact below this one.
std::size_t countBelow(const AuditSummary& summary, int order);

/// Whether `a` is worse: of lower order, or of the same order and farther from the next one in
/// units of its tolerance.
bool isWorse(const AuditRow& a, const AuditRow& b, const AnalysisOptions& options);
/// Indices of the worst rows, worst first; the order of the rows decides between equals.
std::vector<std::size_t> worstRows(const std::vector<AuditRow>& rows, std::size_t count,
                                   const AnalysisOptions& options);

}  // namespace osculate
