// B-splines of every kind that the core must take: a list of named samples, and points of periodic
// ones as OpenCASCADE evaluates them.
#pragma once

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "support/random_curves.h"

namespace osculate::test {

struct SplineSample {
  std::string name;
  BSplineData data;

  /// An inner knot has a higher multiplicity than the degree: there the curve may jump.
  bool isTorn() const {
    const std::vector<int>& all = data.knots.multiplicities;
    return std::any_of(all.begin() + 1, all.end() - 1,
                       [&](int multiplicity) { return multiplicity > data.degree; });
  }
};

/// degree+2 knots around each side of three spans, all of multiplicity 1.
inline KnotVector unclampedKnots(int degree) {
  KnotVector knots;
  for (int i = 0; i < 2 * degree + 4; ++i) {
    knots.knots.push_back(i + 0.25 * (i % 3));
    knots.multiplicities.push_back(1);
  }
  return knots;
}

inline std::vector<SplineSample> splineSamples(std::uint64_t seed) {
  struct Kind {
    const char* name;
    int degree;
    KnotVector knots;
    bool periodic = false;
  };
  const std::vector<Kind> kinds{
      {"degree 1", 1, {{0, 1, 3}, {2, 1, 2}}},
      {"clamped cubic", 3, {{0, 1, 2, 2.5, 7}, {4, 1, 1, 1, 4}}},
      {"unclamped quadratic", 2, unclampedKnots(2)},
      {"unclamped quintic", 5, unclampedKnots(5)},
      {"half clamped cubic", 3, {{-1, 0, 1, 2, 3}, {2, 3, 1, 2, 2}}},
      {"every inner multiplicity", 4, {{0, 1, 2, 3, 4, 5, 6}, {5, 1, 2, 3, 4, 5, 5}}},
      {"spans a millionth of the range", 3, {{0, 0.5, 0.500001, 0.500002, 1}, {4, 1, 2, 1, 4}}},
      {"end spans a millionth of the range", 5, {{0, 1e-6, 0.5, 0.999999, 1}, {6, 1, 1, 1, 6}}},
      {"knots far from zero", 3, {{1e5, 1e5 + 1, 1e5 + 2, 1e5 + 3}, {4, 2, 1, 4}}},
      {"degree 25, clamped", 25, {{0, 1, 2}, {26, 2, 26}}},
      {"degree 25, unclamped", 25, unclampedKnots(25)},
      {"periodic line", 1, {{0, 1, 2, 4}, {1, 1, 1, 1}}, true},
      {"periodic cubic, first multiplicity 1", 3, {{0, 1, 2, 2.5, 4}, {1, 1, 2, 1, 1}}, true},
      {"periodic cubic, first multiplicity 2", 3, {{0, 1, 2, 2.5, 4}, {2, 1, 3, 1, 2}}, true},
      {"periodic cubic, first multiplicity 3", 3, {{-2, 1, 2, 2.5, 4}, {3, 1, 1, 1, 3}}, true},
      {"periodic quintic of three poles", 5, {{0, 1, 2, 4}, {1, 1, 1, 1}}, true},
  };
  Random random(seed);
  std::vector<SplineSample> samples;
  for (const Kind& kind : kinds) {
    for (const bool rational : {false, true}) {
      samples.push_back(
          {kind.name + std::string(rational ? ", rational" : ", polynomial"),
           randomSplineData(random, kind.degree, kind.knots, rational, kind.periodic)});
    }
  }
  return samples;
}

/// A periodic B-spline with points that OpenCASCADE computed (tests/data/periodic_bsplines.json).
struct PeriodicReference {
  std::string name;
  BSplineData data;
  std::vector<std::pair<double, Vector3>> points;
};

inline Vector3 vectorFrom(const nlohmann::json& numbers) {
  return {numbers.at(0).get<double>(), numbers.at(1).get<double>(),
          numbers.size() > 2 ? numbers[2].get<double>() : 0.0};
}

inline std::vector<PeriodicReference> periodicReferences() {
  const auto file =
      nlohmann::json::parse(std::ifstream(OSCULATE_TEST_DATA_DIR "/periodic_bsplines.json"));
  std::vector<PeriodicReference> references;
  for (const auto& entry : file.at("cases")) {
    PeriodicReference reference;
    reference.data.degree = entry.at("degree");
    reference.data.knots = {entry.at("knots").get<std::vector<double>>(),
                            entry.at("multiplicities").get<std::vector<int>>()};
    std::vector<Vector3> poles;
    for (const auto& pole : entry.at("poles"))
      poles.push_back(vectorFrom(pole));
    reference.data.poles = columns(poles);
    if (!entry.at("weights").is_null())
      reference.data.weights = entry.at("weights").get<std::vector<double>>();
    reference.data.periodic = true;
    for (const auto& point : entry.at("points"))
      reference.points.emplace_back(point.at(0), vectorFrom(point.at(1)));
    reference.name = "degree " + std::to_string(reference.data.degree) + ", first multiplicity " +
                     std::to_string(reference.data.knots.multiplicities.front());
    references.push_back(std::move(reference));
  }
  return references;
}

/// Rounding of a point of a curve.
inline double tolerance(const BSplineCurve& curve) {
  return 64.0 * (curve.degree() + 1) * kUnitRoundoff *
         curve.data().poles.colwise().norm().maxCoeff();
}

}  // namespace osculate::test
