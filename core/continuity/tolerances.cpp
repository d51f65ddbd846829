#include "osculate/continuity/tolerances.h"

#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

namespace osculate {

namespace {

struct Preset {
  TolerancePreset about;
  Tolerances values;
};

constexpr double kMilliradian = 1e-3 * 180.0 / 3.14159265358979323846;

const std::array<Preset, 9> kPresets{{
    {{"osculate", "Osculate's default: visible quality with the digits that STEP keeps", ""},
     {1e-3, 0.1, 0.01, 0.02, 0.05, CurvatureMetric::kVector, "osculate"}},
    {{"exact", "Osculate: constructed joins, limited by double coordinates only", ""},
     {1e-7, 1e-6, 1e-8, 1e-8, 1e-8, CurvatureMetric::kVector, "exact"}},
    {{"rhino", "Rhino 7 help, GCon: 0.001 mm, 1 degree",
      "curvature (Rhino takes it from the document), third, fourth"},
     {1e-3, 1.0, 0.01, 0.02, 0.05, CurvatureMetric::kVector, "rhino"}},
    {{"opennurbs",
      "openNURBS ON_IsG2CurvatureContinuous: 1 degree, 5 % with 2 degrees between curvature "
      "vectors",
      "gap (a document setting there), third, fourth"},
     {1e-3, 1.0, 0.05, 0.02, 0.05, CurvatureMetric::kOpenNurbs, "opennurbs"}},
    {{"catia-v5",
      "CATIA V5 Connect Checker: 0.001 mm, 0.01 degrees, 2 %, G3 by 0.1 degrees of the curvature "
      "graphs",
      "third and fourth of the vector verdict"},
     {1e-3, 0.01, 0.02, 0.02, 0.05, CurvatureMetric::kMaximum, "catia-v5"}},
    {{"icem", "CATIA ICEM 'Topology': 0.005 mm, 0.5 degrees, 5 %, torsion 15 degrees",
      "third (how the torsion is turned into degrees is not published), fourth"},
     {5e-3, 0.5, 0.05, 0.02, 0.05, CurvatureMetric::kMaximum, "icem"}},
    {{"creo", "Creo ModelCHECK after VDA 4955: 0.020 mm, 0.1 degrees, 10 % of the radius",
      "third, fourth"},
     {2e-2, 0.1, 0.1, 0.02, 0.05, CurvatureMetric::kMaximum, "creo"}},
    {{"occt", "OpenCASCADE LocalAnalysis_CurveContinuity: 0.001 mm, 0.001 rad, 1 %",
      "third, fourth"},
     {1e-3, kMilliradian, 0.01, 0.02, 0.05, CurvatureMetric::kGeometricMean, "occt"}},
    {{"class-a",
      "suppliers' notes on class A: 0.001 to 0.01 mm, 0.016 to 0.1 degrees, 0.5 %; the strict ends",
      "third, fourth"},
     {1e-3, 0.016, 0.005, 0.02, 0.05, CurvatureMetric::kMaximum, "class-a"}},
}};

void checkPositive(double value, const char* argument) {
  if (!(std::isfinite(value) && value > 0.0)) {
    throw std::invalid_argument(std::string(argument) +
                                ": a tolerance must be finite and > 0, got " +
                                std::to_string(value));
  }
}

}  // namespace

Tolerances Tolerances::preset(std::string_view name) {
  std::string known;
  for (const Preset& preset : kPresets) {
    if (preset.about.name == name) return preset.values;
    known += known.empty() ? "" : ", ";
    known += preset.about.name;
  }
  throw std::invalid_argument("preset: must be one of " + known + ", got " + std::string(name));
}

void Tolerances::check() const {
  checkPositive(gapMm, "gap_mm");
  checkPositive(angleDegrees, "angle_deg");
  checkPositive(curvature, "curvature");
  checkPositive(third, "third");
  checkPositive(fourth, "fourth");
}

std::span<const TolerancePreset> tolerancePresets() {
  static const auto about = [] {
    std::array<TolerancePreset, kPresets.size()> list;
    for (std::size_t i = 0; i < list.size(); ++i)
      list[i] = kPresets[i].about;
    return list;
  }();
  return about;
}

}  // namespace osculate
