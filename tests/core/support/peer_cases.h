// Numeric cases of other libraries' test suites, read from reference data beside the checkout. Each
// names its source and licence; nothing of them is stored here.
#pragma once

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/spline_samples.h"

namespace osculate::test {

struct PeerCase {
  std::string id;
  nlohmann::json input;
  nlohmann::json expect;
  double tolerance;
};

/// All cases of one kind; none where the file is absent.
inline std::vector<PeerCase> peerCases(const std::string& kind) {
  std::ifstream file(OSCULATE_SHARED_DIR "/oracle/peer_cases.json");
  std::vector<PeerCase> cases;
  if (!file) return cases;
  for (const auto& entry : nlohmann::json::parse(file)) {
    if (entry.at("kind") != kind) continue;
    cases.push_back({entry.at("id"), entry.at("input"), entry.at("expect"), entry.at("tol")});
  }
  return cases;
}

/// The tolerance of a case, at least the rounding of numbers of this size.
inline double toleranceOf(const PeerCase& peer, double size) {
  return std::max(peer.tolerance, 16.0 * kUnitRoundoff) * std::max(1.0, size);
}

/// {degree, poles (2 or 3 numbers each), weights?, knots? (flat), homogeneous?}
inline BSplineData splineDataFrom(const nlohmann::json& curve) {
  BSplineData data;
  data.degree = curve.at("degree");
  std::vector<Vector3> poles;
  if (curve.contains("weights") && !curve["weights"].is_null())
    data.weights = curve["weights"].get<std::vector<double>>();
  const bool homogeneous = curve.value("homogeneous", false);
  for (const auto& pole : curve.at("poles")) {
    if (!homogeneous) {
      poles.push_back(vectorFrom(pole));
      continue;
    }
    const double weight = pole.back();
    data.weights.push_back(weight);
    poles.emplace_back(Vector3(pole.at(0), pole.at(1), 0.0) / weight);
  }
  data.poles = columns(poles);
  if (curve.contains("knots")) {
    data.knots = compress(curve["knots"].get<std::vector<double>>());
  } else {
    data.knots = {{0.0, 1.0}, {data.degree + 1, data.degree + 1}};
  }
  return data;
}

inline BezierCurve bezierFrom(const nlohmann::json& curve) {
  const BSplineData data = splineDataFrom(curve);
  std::vector<Vector3> poles;
  for (Eigen::Index i = 0; i < data.poles.cols(); ++i)
    poles.emplace_back(data.poles.col(i));
  return BezierCurve(poles, data.weights);
}

}  // namespace osculate::test

/// Runs the body for every peer case of the kind, as `peer`; skips the test where there are none.
#define FOR_PEER_CASES(kind)                                                                \
  const auto peerCasesOfKind = osculate::test::peerCases(kind);                             \
  if (peerCasesOfKind.empty()) GTEST_SKIP() << "needs oracle/peer_cases.json in ../shared"; \
  for (const auto& peer : peerCasesOfKind)
