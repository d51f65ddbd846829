// What each command is asked for; the defaults are those of the command line.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "osculate/continuity/audit_report.h"

namespace osculate::cli {

/// Order and tolerances, the same for every command that analyses.
struct AnalysisChoice {
  int order = 4;
  std::string preset = "osculate";
  std::optional<double> gapMm;
  std::optional<double> angleDegrees;
  std::optional<double> curvature;
  std::optional<double> third;
  std::optional<double> fourth;

  /// Throws std::invalid_argument.
  AnalysisOptions options() const;
};

/// "G2", "g2" or "2", from G0 to the order asked for; nothing for an empty text. Throws
/// std::invalid_argument, which ends in what would be right (followed by the order's number).
std::optional<int> orderBelow(const std::string& text, int order,
                              const std::string& remedy = "ask for --order ");

struct AnalyzeChoice {
  std::string file;
  std::vector<int> edges;         ///< one: the joins within it; two: their join
  std::vector<std::string> ends;  ///< empty, or two of "start" and "end"
  AnalysisChoice analysis;
  bool json = false;
  std::string failBelow;
  double timeLimit = 0.0;  ///< seconds; 0: none
};

struct AuditChoice {
  std::vector<std::string> files;
  std::string filesFrom;  ///< a file with a path a line; "-": standard input
  AnalysisChoice analysis;
  std::string pairs = "all";
  std::optional<double> cornerDegrees;  ///< for the pairs "tangent" alone
  double touchMm = 0.01;
  std::string csv;  ///< a path, or "-" for standard output
  std::string json;
  std::optional<int> worst;  ///< empty: 10 of one file, 3 of each of several
  int jobs = 0;              ///< 0: as many as the machine runs at once
  std::string failBelow;
  double timeLimit = 0.0;
  bool strict = false;
  bool quiet = false;
};

struct BlendChoice {
  std::string file;
  std::vector<int> edges;
  std::vector<std::string> ends;
  std::vector<int> order{3};  ///< of both ends, or of each
  std::optional<int> degree;
  std::string fairness = "mvc";
  bool symmetric = false;
  std::vector<double> betaFirst;
  std::vector<double> betaSecond;
  std::string output;
  bool json = false;
  double timeLimit = 0.0;
};

struct MergeChoice {
  std::vector<std::string> reports;
  std::string csv;
  std::string json;
  std::optional<int> worst;
  std::string failBelow;
  bool strict = false;
  bool latest = false;  ///< of a file in several reports the last one counts
  bool quiet = false;
};

}  // namespace osculate::cli
