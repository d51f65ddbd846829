#include "osculate/continuity/audit_report.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "osculate/continuity/deviation_fields.h"

namespace osculate {

namespace {

/// The member of Deviation that a row keeps as physical[i].
constexpr std::optional<double> Deviation::*physicalMember(std::size_t i) {
  return kDeviationFields[i + 1].member;
}

constexpr std::array<std::string_view, 3> kPairNames{"all", "wire", "tangent"};

/// By how many tolerances the first order that does not pass is missed; of a join that has all
/// orders asked for, what it uses of the last one's tolerance.
double missedBy(const AuditRow& row, const AnalysisOptions& options) {
  const int next = std::min(row.order + 1, options.order);
  return row.residuals[static_cast<std::size_t>(next)] / options.tolerances.ofOrder(next);
}

}  // namespace

std::string_view name(JoinKind kind) {
  static constexpr std::array<std::string_view, kJoinKindCount> kNames{"vertex", "knot", "seam"};
  return kNames[static_cast<std::size_t>(kind)];
}

std::string_view name(JoinPairs pairs) { return kPairNames[static_cast<std::size_t>(pairs)]; }

JoinPairs joinPairs(std::string_view name) {
  const auto found = std::find(kPairNames.begin(), kPairNames.end(), name);
  if (found == kPairNames.end()) {
    throw std::invalid_argument("pairs: must be one of all, wire, tangent, got " +
                                std::string(name));
  }
  return static_cast<JoinPairs>(found - kPairNames.begin());
}

void checkAuditOptions(const AuditOptions& options) {
  checkOptions(options.analysis);
  if (!(options.cornerDegrees >= 0.0 && options.cornerDegrees <= 180.0)) {
    throw std::invalid_argument("corner_deg: must be from 0 to 180, got " +
                                std::to_string(options.cornerDegrees));
  }
  if (!(std::isfinite(options.touchMm) && options.touchMm >= 0.0)) {
    throw std::invalid_argument("touch_mm: must be finite and 0 or more, got " +
                                std::to_string(options.touchMm));
  }
  if (options.threads < 0) {
    throw std::invalid_argument("threads: must be 0 (as many as the machine runs) or more, got " +
                                std::to_string(options.threads));
  }
}

Deviation AuditRow::deviation() const {
  Deviation result;
  result.gapMm = residuals[0];
  if (std::isfinite(residuals[1])) result.tangentAngleDegrees = residuals[1];
  for (std::size_t i = 0; i < physical.size(); ++i) {
    if ((hasPhysical >> i & 1U) != 0) result.*physicalMember(i) = physical[i];
  }
  return result;
}

void AuditRow::setDeviation(const Deviation& deviation) {
  physical.fill(0.0);
  hasPhysical = 0;
  for (std::size_t i = 0; i < physical.size(); ++i) {
    const std::optional<double>& value = deviation.*physicalMember(i);
    if (!value) continue;
    physical[i] = *value;
    hasPhysical = static_cast<std::uint8_t>(hasPhysical | 1U << i);
  }
}

AuditRow auditRow(const JoinReport& report) {
  AuditRow row;
  row.order = static_cast<std::int8_t>(report.order);
  row.parametricOrder = static_cast<std::int8_t>(report.parametricOrder);
  row.verdicts = report.verdicts;
  row.warnings = report.warnings;
  const Vector3& point = report.sides[0].point;
  row.point = {point.x(), point.y(), point.z()};
  row.residuals = report.residuals;
  row.setDeviation(report.deviation);
  return row;
}

AuditSummary summarize(const std::vector<AuditRow>& rows) {
  AuditSummary summary;
  summary.joins = rows.size();
  for (const AuditRow& row : rows) {
    ++summary.kinds[static_cast<std::size_t>(row.kind)];
    ++summary.orders[static_cast<std::size_t>(row.order + 1)];
    if (row.warnings.has(Warning::kUndecided)) ++summary.undecided;
  }
  return summary;
}

void add(const AuditSummary& more, AuditSummary& sum) {
  sum.joins += more.joins;
  sum.undecided += more.undecided;
  std::transform(sum.kinds.begin(), sum.kinds.end(), more.kinds.begin(), sum.kinds.begin(),
                 std::plus());
  std::transform(sum.orders.begin(), sum.orders.end(), more.orders.begin(), sum.orders.begin(),
                 std::plus());
}

std::size_t countBelow(const AuditSummary& summary, int order) {
  return std::accumulate(summary.orders.begin(), summary.orders.begin() + (order + 1),
                         std::size_t{0});
}

bool isWorse(const AuditRow& a, const AuditRow& b, const AnalysisOptions& options) {
  if (a.order != b.order) return a.order < b.order;
  return missedBy(a, options) > missedBy(b, options);
}

std::vector<std::size_t> worstRows(const std::vector<AuditRow>& rows, std::size_t count,
                                   const AnalysisOptions& options) {
  std::vector<std::size_t> indices(rows.size());
  std::iota(indices.begin(), indices.end(), std::size_t{0});
  const std::size_t kept = std::min(count, rows.size());
  std::partial_sort(indices.begin(), indices.begin() + static_cast<std::ptrdiff_t>(kept),
                    indices.end(), [&](std::size_t a, std::size_t b) {
                      if (isWorse(rows[a], rows[b], options)) return true;
                      return !isWorse(rows[b], rows[a], options) && a < b;
                    });
  indices.resize(kept);
  return indices;
}

}  // namespace osculate
