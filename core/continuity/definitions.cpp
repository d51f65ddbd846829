#include "osculate/continuity/definitions.h"

#include <algorithm>
#include <cmath>

#include "osculate/continuity/join_definitions.h"
#include "osculate/continuity/join_kernel.h"

namespace osculate {

namespace {

constexpr std::array<DefinitionInfo, static_cast<std::size_t>(kDefinitionCount)> kInfos{{
    {"g2-vector", "theory, Osculate", "curvature vectors equal, relative to the larger", ""},
    {"g2-maximum", "CATIA V5, KOMPAS, Creo", "curvatures equal: 1 - r, r = kmin/kmax", ""},
    {"g2-opennurbs", "openNURBS", "1 - r, and curvature vectors within 2 degrees", ""},
    {"g2-sum", "Alias", "curvatures equal: (1 - r)/(1 + r)", ""},
    {"g2-mean", "tools with factor 2", "curvatures equal: 2 (1 - r)/(1 + r)", ""},
    {"g2-geometric-mean", "OpenCASCADE LocalAnalysis",
     "(1 - r)/sqrt(r), and normals within 0.001 rad", ""},
    {"g3-vector", "theory (contact of order 3), Osculate", "third derivatives by arc length equal",
     ""},
    {"g3-frenet-frame", "Farin, Boehm",
     "tangent, normal, binormal, curvature and torsion continuous", ""},
    {"g3-scalar-rate", "Creo, Rhino, Silk", "d(curvature)/ds equal", ""},
    {"g3-graph-angle", "CATIA V5", "angle between the curvature graphs, drawn in mm", "deg"},
    {"g3-torsion", "SolidWorks, CATIA ICEM", "torsion equal", ""},
    {"c3", "Rhino's help", "third derivatives by the curves' own parameters equal", ""},
}};

constexpr double kGraphAngleDegrees = 0.1;          // CATIA V5 Connect Checker, G3
constexpr double kOpenNurbsCosine = 0.99939082701;  // of 2 degrees
constexpr double kOpenNurbsZeroCurvature = 1e-8;    // 1/mm
constexpr double kOcctNormalRadians = 1e-3;

/// What the definitions read, gathered once.
struct Facts {
  const JoinReport& report;
  const Tolerances& tolerances;
  double smaller;  ///< curvature
  double larger;
  bool tangent;  ///< G0 and G1 pass

  const Invariants& first() const { return report.sides[0].invariants; }
  const Invariants& second() const { return report.sides[1].invariants; }
};

DefinitionResult result(const Facts& facts, double value, double tolerance, std::size_t order,
                        bool condition) {
  const Verdict own = kernel::judge(value, facts.report.uncertainties[order], tolerance);
  return {condition ? own : Verdict::kFail, value, tolerance};
}

void setCurvatureDefinitions(const Facts& facts, DefinitionResults& all) {
  const auto& [report, tolerances, smaller, larger, tangent] = facts;
  const auto set = [&, tolerance = tolerances.curvature](Definition definition, double value,
                                                         bool condition) {
    all[static_cast<std::size_t>(definition)] = result(facts, value, tolerance, 2, condition);
  };
  const double flat = kFlatness / report.scaleMm;
  if (larger <= flat) return;  // ratios of curvatures mean nothing on straight sides
  const double r = smaller / larger;
  set(Definition::kG2Maximum, 1.0 - r, tangent);
  set(Definition::kG2Sum, (1.0 - r) / (1.0 + r), tangent);
  set(Definition::kG2Mean, 2.0 * (1.0 - r) / (1.0 + r), tangent);
  const auto& n1 = report.sides[0].frame.normal;
  const auto& n2 = report.sides[1].frame.normal;
  const double cosine = n1 && n2 ? n1->dot(*n2) : 0.0;
  const bool parallel = smaller <= kOpenNurbsZeroCurvature || cosine >= kOpenNurbsCosine;
  set(Definition::kG2OpenNurbs, 1.0 - r, tangent && parallel);
  if (smaller > flat) {
    const bool normals = n1 && n2 && (*n1 - *n2).norm() <= kOcctNormalRadians;
    set(Definition::kG2GeometricMean, (1.0 - r) / std::sqrt(r), tangent && normals);
  }
}

double relative(double a, double b, double least) {
  return std::abs(a - b) / std::max({std::abs(a), std::abs(b), least});
}

/// atan(a) - atan(b) in degrees.
double graphAngle(double a, double b) {
  const double tangent = std::abs((a - b) / (1.0 + a * b));
  const double squared = tangent * tangent;
  // rates in 1/mm^2 are small as a rule: three terms of the series are exact below 1e-3
  if (squared < 1e-6)
    return kernel::kDegrees * tangent * (1.0 - squared * (1.0 / 3 - squared * (1.0 / 5)));
  return kernel::kDegrees * std::abs(std::atan2(a - b, 1.0 + a * b));
}

void setThirdOrderDefinitions(const Facts& facts, DefinitionResults& all) {
  const auto& [report, tolerances, smaller, larger, tangent] = facts;
  const Invariants& a = facts.first();
  const Invariants& b = facts.second();
  if (!a.curvatureRate || !b.curvatureRate) return;
  const double third = tolerances.third;
  const bool curvature = tangent && larger - smaller <= tolerances.curvature * larger;
  const double perScale = 1.0 / report.scaleMm;
  const double rate = relative(*a.curvatureRate, *b.curvatureRate, perScale * perScale);
  const double torsion = relative(*a.torsion, *b.torsion, perScale);
  const auto& plane = report.deviation.osculatingPlaneAngleDegrees;
  const bool frame = curvature && plane && *plane <= tolerances.angleDegrees;
  all[static_cast<std::size_t>(Definition::kG3FrenetFrame)] =
      result(facts, torsion, third, 3, frame);
  all[static_cast<std::size_t>(Definition::kG3ScalarRate)] =
      result(facts, rate, third, 3, curvature);
  all[static_cast<std::size_t>(Definition::kG3Torsion)] =
      result(facts, torsion, third, 3, curvature);
  const double angle = graphAngle(*a.curvatureRate, *b.curvatureRate);
  all[static_cast<std::size_t>(Definition::kG3GraphAngle)] = {
      curvature && angle <= kGraphAngleDegrees ? Verdict::kPass : Verdict::kFail, angle,
      kGraphAngleDegrees};
}

}  // namespace

std::string_view name(Verdict verdict) {
  switch (verdict) {
    case Verdict::kPass:
      return "pass";
    case Verdict::kFail:
      return "fail";
    case Verdict::kUndecided:
      return "undecided";
  }
  return "";
}

const DefinitionInfo& info(Definition definition) {
  return kInfos[static_cast<std::size_t>(definition)];
}

void setDefinitions(const Tolerances& tolerances, JoinReport& report) {
  const double first = report.sides[0].invariants.curvature.value_or(0.0);
  const double second = report.sides[1].invariants.curvature.value_or(0.0);
  const Facts facts{report, tolerances, std::min(first, second), std::max(first, second),
                    report.order >= 1};
  DefinitionResults& all = report.definitions;
  const auto vector = [&](Definition definition, int order) {
    if (order > report.requestedOrder) return;
    const auto k = static_cast<std::size_t>(order);
    all[static_cast<std::size_t>(definition)] = {report.verdicts[k], report.residuals[k],
                                                 report.tolerances[k]};
    if (report.order < order - 1)
      all[static_cast<std::size_t>(definition)].verdict = Verdict::kFail;
  };
  vector(Definition::kG2Vector, 2);
  vector(Definition::kG3Vector, 3);
  if (report.requestedOrder >= 2) setCurvatureDefinitions(facts, all);
  if (report.requestedOrder < 3) return;
  setThirdOrderDefinitions(facts, all);
  // C^3 or the first lower order that fails
  const auto order = static_cast<std::size_t>(std::min(report.parametricOrder + 1, 3));
  all[static_cast<std::size_t>(Definition::kC3)] = {
      report.parametricOrder >= 3 ? Verdict::kPass : Verdict::kFail,
      report.parametricResiduals[order], tolerances.third};
}

}  // namespace osculate
