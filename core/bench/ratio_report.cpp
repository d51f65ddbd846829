// Runs the benchmarks and prints, below Google Benchmark's table, each claim as a ratio to its
// peer.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace {

/// Our benchmark, the peer's, and the largest ratio ours/peer that is good enough: of the times for
/// an item where both say how many they did, else of the whole times.
struct Claim {
  const char* ours;
  const char* peer;
  double limit;
};

constexpr Claim kClaims[] = {
    {"reportOfBeziers/rational:0", "localAnalysisOfBeziers<GeomAbs_G2>/rational:0", 1.0},
    {"reportOfBeziers/rational:1", "localAnalysisOfBeziers<GeomAbs_G2>/rational:1", 1.0},
    {"reportOfBeziers/rational:0", "localAnalysisOfBeziersAllOrders/rational:0", 1.0},
    {"reportOfSplines/spans:50/rational:0", "localAnalysisOfSplines/spans:50/rational:0", 1.5},
    {"reportOfSplines/spans:50/rational:1", "localAnalysisOfSplines/spans:50/rational:1", 1.5},
    {"reportOfSplines/spans:5000/rational:0", "localAnalysisOfSplines/spans:50/rational:0", 1.5},
    {"reportOfSplines/spans:5000/rational:1", "localAnalysisOfSplines/spans:50/rational:1", 1.5},
    {"endSegment/spans:50/rational:0", "toBezier/spans:50/rational:0", 0.05},
    {"endSegment/spans:50/rational:1", "toBezier/spans:50/rational:1", 0.05},
    {"endSegment/spans:5000/rational:0", "endSegment/spans:50/rational:0", 1.2},
    {"givenBlend", "hermiteByOcct", 1.0},
    {"matchOfLongSpline/spans:1000/order:4", "matchOfLongSpline/spans:20/order:4", 1.5},
    {"solidGrid", "solidDeCasteljau", 0.2},
    {"auditImpeller", "readImpeller", 0.04},
    {"auditImpeller", "auditImpellerByOpenCascade", 1.0},
    {"auditImpeller", "localAnalysisOfImpeller", 1.0},
    {"auditChain/joins:1000000", "auditChain/joins:10000", 1.5},
};

/// Our benchmark and the most milliseconds of processor time that are good enough.
struct Limit {
  const char* ours;
  double milliseconds;
};

constexpr Limit kLimits[] = {
    {"combs/rational:0", 5.0}, {"combs/rational:1", 5.0},       {"showOctant", 20.0},
    {"showRandom", 20.0},      {"certifySolid/degree:3", 10.0},
};

constexpr double kBytesPerRow = 500.0;

/// Keeps the processor time of each benchmark; of repetitions the median.
class RatioReporter : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs) {
      const bool median = run.run_type == Run::RT_Aggregate && run.aggregate_name == "median";
      if (!median && (run.run_type == Run::RT_Aggregate || run.repetitions > 1)) continue;
      times_[run.run_name.str()] = run.GetAdjustedCPUTime();
      milliseconds_[run.run_name.str()] =
          1e3 * run.GetAdjustedCPUTime() / benchmark::GetTimeUnitMultiplier(run.time_unit);
      const auto rate = run.counters.find("items_per_second");
      if (rate != run.counters.end()) rates_[run.run_name.str()] = rate->second;
      const auto bytes = run.counters.find("bytes_per_row");
      if (bytes != run.counters.end()) bytes_[run.run_name.str()] = bytes->second;
    }
  }

  void printClaims() const {
    std::printf("\n%-38s %-48s %8s %8s\n", "ours", "peer, same run", "ratio", "at most");
    for (const Claim& claim : kClaims) {
      if (const auto ratio = ratioOf(claim))
        std::printf("%-38s %-48s %8.3f %8.2f\n", claim.ours, claim.peer, *ratio, claim.limit);
    }
    printLimits();
    printSpread("fairBlend/");
    for (const auto& [name, rate] : rates_)
      std::printf("%-38s %.2f million a second\n", name.c_str(), rate * 1e-6);
    for (const auto& [name, bytes] : bytes_)
      std::printf("%-38s %.0f bytes a row at most, of %.0f\n", name.c_str(), bytes, kBytesPerRow);
  }

 private:
  void printLimits() const {
    for (const Limit& limit : kLimits) {
      const auto ours = milliseconds_.find(limit.ours);
      if (ours == milliseconds_.end()) continue;
      std::printf("%-38s %-48s %8.3f %8.2f\n", limit.ours, "milliseconds", ours->second,
                  limit.milliseconds);
    }
  }

  /// The median and the worst time of a family of benchmarks.
  void printSpread(const std::string& family) const {
    std::vector<double> times;
    for (const auto& [name, time] : times_) {
      if (name.starts_with(family)) times.push_back(time);
    }
    if (times.empty()) return;
    std::sort(times.begin(), times.end());
    std::printf("%-38s median %.3f ms, worst %.3f ms of %zu\n", family.c_str(),
                1e-6 * times[times.size() / 2], 1e-6 * times.back(), times.size());
  }

  std::optional<double> ratioOf(const Claim& claim) const {
    const auto ours = times_.find(claim.ours);
    const auto peer = times_.find(claim.peer);
    if (ours == times_.end() || peer == times_.end()) return std::nullopt;
    const auto ourRate = rates_.find(claim.ours);
    const auto peerRate = rates_.find(claim.peer);
    if (ourRate != rates_.end() && peerRate != rates_.end())
      return peerRate->second / ourRate->second;
    return ours->second / peer->second;
  }

  std::map<std::string, double> times_;
  std::map<std::string, double> milliseconds_;
  std::map<std::string, double> bytes_;
  std::map<std::string, double> rates_;
};

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  RatioReporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  reporter.printClaims();
  benchmark::Shutdown();
  return 0;
}
