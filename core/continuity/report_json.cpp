#include "osculate/continuity/report_json.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace osculate {

namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }
Json number(const std::optional<double>& value) { return value ? number(*value) : Json(nullptr); }
Json vector(const Vector3& v) { return {v.x(), v.y(), v.z()}; }
Json vector(const std::optional<Vector3>& v) { return v ? vector(*v) : Json(nullptr); }

Json perOrder(const PerOrder& values, int order) {
  Json list = Json::array();
  for (int k = 0; k <= order; ++k)
    list.push_back(number(values[static_cast<std::size_t>(k)]));
  return list;
}

Json verdicts(const JoinReport& report) {
  Json list = Json::array();
  for (int k = 0; k <= report.requestedOrder; ++k)
    list.push_back(name(report.verdicts[static_cast<std::size_t>(k)]));
  return list;
}

Json betas(const JoinReport& report) {
  Json list = Json::array();
  for (int k = 1; k <= report.requestedOrder; ++k) {
    list.push_back(k <= report.betaCount ? number(report.beta[static_cast<std::size_t>(k - 1)])
                                         : Json(nullptr));
  }
  return list;
}

Json deviation(const Deviation& d) {
  return {{"gap_mm", d.gapMm},
          {"tangent_angle_deg", number(d.tangentAngleDegrees)},
          {"curvature_vector_per_mm", number(d.curvatureVectorPerMm)},
          {"curvature_relative", number(d.curvatureRelative)},
          {"osculating_plane_angle_deg", number(d.osculatingPlaneAngleDegrees)},
          {"torsion_per_mm", number(d.torsionPerMm)},
          {"curvature_rate_per_mm2", number(d.curvatureRatePerMm2)},
          {"torsion_rate_per_mm2", number(d.torsionRatePerMm2)},
          {"curvature_rate2_per_mm3", number(d.curvatureRate2PerMm3)}};
}

Json segment(const BezierSegment& s) {
  Json poles = Json::array();
  Json weights = Json::array();
  for (int i = 0; i <= s.curve.degree(); ++i) {
    poles.push_back(vector(Vector3(s.curve.pole(i))));
    weights.push_back(s.curve.weight(i));
  }
  return {{"degree", s.curve.degree()},
          {"poles", poles},
          {"weights", s.curve.isRational() ? weights : Json(nullptr)},
          {"parameters", {s.first, s.last}}};
}

Json rows(const Eigen::Matrix<double, 5, 3>& matrix) {
  Json list = Json::array();
  for (int k = 0; k < 5; ++k)
    list.push_back({matrix(k, 0), matrix(k, 1), matrix(k, 2)});
  return list;
}

Json side(const SideReport& s, const BezierSegment& bezier,
          const Eigen::Matrix<double, 5, 3>& derivatives) {
  const bool hasTangent = s.smoothness >= 1;
  return {{"end", s.end == CurveEnd::kStart ? "start" : "end"},
          {"point", vector(s.point)},
          {"tangent", hasTangent ? vector(s.frame.tangent) : Json(nullptr)},
          {"normal", vector(s.frame.normal)},
          {"binormal", vector(s.frame.binormal)},
          {"curvature", number(s.invariants.curvature)},
          {"torsion", number(s.invariants.torsion)},
          {"curvature_rate", number(s.invariants.curvatureRate)},
          {"curvature_rate2", number(s.invariants.curvatureRate2)},
          {"torsion_rate", number(s.invariants.torsionRate)},
          {"linearity", s.linearity},
          {"multiplicity", s.multiplicity},
          {"segment", segment(bezier)},
          {"derivatives_in_frame", rows(derivatives)}};
}

Json definitions(const JoinReport& report) {
  Json all = Json::object();
  for (int i = 0; i < kDefinitionCount; ++i) {
    const DefinitionResult& result = report.definitions[static_cast<std::size_t>(i)];
    const DefinitionInfo& about = info(static_cast<Definition>(i));
    all[std::string(about.name)] = {
        {"verdict", result.verdict ? Json(name(*result.verdict)) : Json(nullptr)},
        {"value", result.verdict ? number(result.value) : Json(nullptr)},
        {"tolerance", result.verdict ? number(result.tolerance) : Json(nullptr)},
        {"unit", about.unit},
        {"who", about.who},
        {"meaning", about.meaning}};
  }
  return all;
}

Json warnings(const WarningSet& set) {
  Json list = Json::array();
  for (const Warning warning : set.list()) {
    list.push_back({{"code", code(warning)}, {"sentence", sentence(warning)}});
  }
  return list;
}

}  // namespace

nlohmann::ordered_json toJson(const CurveJoin& join) {
  const JoinReport& report = join.report;
  const int order = report.requestedOrder;
  return {{"schema", "osculate.join/1"},
          {"order", report.order},
          {"parametric_order", report.parametricOrder},
          {"requested_order", order},
          {"preset", report.preset},
          {"verdicts", verdicts(report)},
          {"residuals", perOrder(report.residuals, order)},
          {"tolerances", perOrder(report.tolerances, order)},
          {"uncertainties", perOrder(report.uncertainties, order)},
          {"parametric_residuals",
           perOrder(report.parametricResiduals, std::min(report.parametricOrder + 1, order))},
          {"beta", betas(report)},
          {"scale_mm", report.scaleMm},
          {"deviation", deviation(report.deviation)},
          {"sides",
           {side(report.sides[0], join.firstSegment, report.derivativesInFrame[0]),
            side(report.sides[1], join.secondSegment, report.derivativesInFrame[1])}},
          {"frame",
           {{"tangent", vector(report.frame.tangent)},
            {"normal", vector(report.frame.normal)},
            {"binormal", vector(report.frame.binormal)}}},
          {"frame_kind", name(report.frameKind)},
          {"definitions", definitions(report)},
          {"warnings", warnings(report.warnings)},
          {"parameter", number(join.parameter)}};
}

}  // namespace osculate
