#include "osculate/continuity/audit_report.h"

#include <limits>

#include "support/errors.h"
#include "support/joins.h"

namespace osculate::test {
namespace {

AuditRow rowOf(int order, double nextResidual) {
  AuditRow row;
  row.order = static_cast<std::int8_t>(order);
  row.residuals[static_cast<std::size_t>(std::min(order + 1, 4))] = nextResidual;
  return row;
}

TEST(AuditRow, KeepsEveryDeviation) {
  Deviation deviation;
  deviation.gapMm = 0.25;
  deviation.tangentAngleDegrees = 3.0;
  deviation.curvatureVectorPerMm = 0.125;
  deviation.torsionPerMm = 0.0;
  deviation.curvatureRate2PerMm3 = 7.0;
  AuditRow row;
  row.residuals[0] = 0.25;
  row.residuals[1] = 3.0;
  row.setDeviation(deviation);
  const Deviation kept = row.deviation();
  EXPECT_EQ(kept.gapMm, 0.25);
  EXPECT_EQ(kept.tangentAngleDegrees, 3.0);
  EXPECT_EQ(kept.curvatureVectorPerMm, 0.125);
  EXPECT_EQ(kept.curvatureRelative, std::nullopt);
  EXPECT_EQ(kept.osculatingPlaneAngleDegrees, std::nullopt);
  EXPECT_EQ(kept.torsionPerMm, 0.0);
  EXPECT_EQ(kept.curvatureRatePerMm2, std::nullopt);
  EXPECT_EQ(kept.torsionRatePerMm2, std::nullopt);
  EXPECT_EQ(kept.curvatureRate2PerMm3, 7.0);
}

TEST(AuditRow, OfAReport) {
  Random random(1);
  for (int order = -1; order < 5; ++order) {
    const auto [first, second] = randomJoin(random, order, 6);
    const JoinReport report = join(first, second, withPreset("osculate", 4));
    const AuditRow row = auditRow(report);
    EXPECT_EQ(row.order, report.order);
    EXPECT_EQ(row.residuals, report.residuals);
    EXPECT_EQ(row.verdicts, report.verdicts);
    EXPECT_EQ(row.deviation().torsionPerMm, report.deviation.torsionPerMm);
  }
}

TEST(AuditRow, WithoutATangentHasNoAngle) {
  AuditRow row;
  row.residuals[1] = std::numeric_limits<double>::infinity();
  row.setDeviation({});
  EXPECT_EQ(row.deviation().tangentAngleDegrees, std::nullopt);
}

TEST(Worst, LowerOrdersFirstThenByTolerances) {
  const AnalysisOptions options;
  const std::vector<AuditRow> rows{rowOf(2, 0.03), rowOf(0, 0.2),  rowOf(-1, 0.002), rowOf(4, 0.01),
                                   rowOf(0, 90.0), rowOf(-1, 0.1), rowOf(2, 0.03)};
  EXPECT_EQ(worstRows(rows, 10, options), (std::vector<std::size_t>{5, 2, 4, 1, 0, 6, 3}));
  EXPECT_EQ(worstRows(rows, 2, options), (std::vector<std::size_t>{5, 2}));
  EXPECT_TRUE(worstRows(rows, 0, options).empty());
  EXPECT_TRUE(worstRows({}, 3, options).empty());
}

TEST(Worst, WhatDoesNotExistIsWorst) {
  const std::vector<AuditRow> rows{rowOf(1, 5.0),
                                   rowOf(1, std::numeric_limits<double>::infinity())};
  EXPECT_EQ(worstRows(rows, 1, {}), std::vector<std::size_t>{1});
}

TEST(Summary, CountsKindsOrdersAndUndecided) {
  std::vector<AuditRow> rows{rowOf(-1, 1), rowOf(2, 1), rowOf(2, 1), rowOf(4, 0)};
  rows[1].kind = JoinKind::kKnot;
  rows[3].kind = JoinKind::kSeam;
  rows[2].warnings.add(Warning::kUndecided);
  rows[3].warnings.add(Warning::kCusp);
  AuditSummary summary = summarize(rows);
  EXPECT_EQ(summary.joins, 4U);
  EXPECT_EQ(summary.kinds, (std::array<std::size_t, 3>{2, 1, 1}));
  EXPECT_EQ(summary.orders, (std::array<std::size_t, 10>{1, 0, 0, 2, 0, 1, 0, 0, 0, 0}));
  EXPECT_EQ(summary.undecided, 1U);
  EXPECT_EQ(countBelow(summary, 0), 1U);
  EXPECT_EQ(countBelow(summary, 2), 1U);
  EXPECT_EQ(countBelow(summary, 3), 3U);
  EXPECT_EQ(countBelow(summary, 5), 4U);
  add(summarize(rows), summary);
  EXPECT_EQ(summary.joins, 8U);
  EXPECT_EQ(summary.orders[3], 4U);
  EXPECT_EQ(summary.undecided, 2U);
}

TEST(JoinPairsNames, ThereAndBack) {
  for (const JoinPairs pairs : {JoinPairs::kAll, JoinPairs::kWire, JoinPairs::kTangent})
    EXPECT_EQ(joinPairs(name(pairs)), pairs);
  EXPECT_ERROR(joinPairs("some"), "pairs: must be one of all, wire, tangent, got some");
}

}  // namespace
}  // namespace osculate::test
