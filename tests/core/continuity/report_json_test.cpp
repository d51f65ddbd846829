#include "osculate/continuity/report_json.h"

#include <nlohmann/json.hpp>

#include "support/definition_joins.h"
#include "support/spline_samples.h"

namespace osculate::test {
namespace {

using Ordered = nlohmann::ordered_json;

CurveJoin joinOfCurves(const BezierCurve& first, const BezierCurve& second, int order = 4) {
  return analyzeCurves(BSplineCurve(first), BSplineCurve(second), withPreset("osculate", order),
                       JoinEnds{});
}

std::vector<CurveJoin> manyJoins() {
  Random random(300);
  std::vector<CurveJoin> joins;
  for (int order = -1; order <= 8; ++order) {
    const auto [first, second] = randomJoin(random, order, 8);
    for (const int requested : {0, 1, 2, 4, 8})
      joins.push_back(joinOfCurves(first, second, requested));
  }
  const BezierCurve line = bezier({{-1, 0, 0}, {0, 0, 0}});
  joins.push_back(joinOfCurves(line, bezier({{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {3, 1, 0}})));
  joins.push_back(joinOfCurves(line, bezier({{0, 0, 0}, {-2, 0, 0}})));
  joins.push_back(joinOfCurves(line, bezier({{0, 0, 0}, {2, 0, 0}})));
  const BSplineCurve knotted(randomSplineData(random, 3, {{0, 1, 2}, {4, 2, 4}}, true));
  for (const CurveJoin& inner : analyzeInnerJoins(knotted))
    joins.push_back(inner);
  return joins;
}

/// Numbers from JSON, which has no NaN and no infinity: those are null.
void expectNumbers(const Ordered& found, const PerOrder& expected, std::size_t count) {
  ASSERT_EQ(found.size(), count);
  for (std::size_t k = 0; k < count; ++k) {
    if (std::isfinite(expected[k])) {
      EXPECT_EQ(found[k].get<double>(), expected[k]);
    } else {
      EXPECT_TRUE(found[k].is_null());
    }
  }
}

TEST(ReportJson, CarriesTheDecisionToTheLastBit) {
  for (const CurveJoin& join : manyJoins()) {
    const JoinReport& report = join.report;
    const Ordered json = Ordered::parse(toJson(join).dump());
    const auto count = static_cast<std::size_t>(report.requestedOrder) + 1;
    EXPECT_EQ(json.at("schema"), "osculate.join/1");
    EXPECT_EQ(json.at("order"), report.order);
    EXPECT_EQ(json.at("parametric_order"), report.parametricOrder);
    EXPECT_EQ(json.at("requested_order"), report.requestedOrder);
    EXPECT_EQ(json.at("preset"), report.preset);
    EXPECT_EQ(json.at("scale_mm").get<double>(), report.scaleMm);
    expectNumbers(json.at("residuals"), report.residuals, count);
    expectNumbers(json.at("tolerances"), report.tolerances, count);
    expectNumbers(json.at("uncertainties"), report.uncertainties, count);
    ASSERT_EQ(json.at("verdicts").size(), count);
    for (std::size_t k = 0; k < count; ++k)
      EXPECT_EQ(json["verdicts"][k], name(report.verdicts[k]));
    ASSERT_EQ(json.at("beta").size(), count - 1);
    for (std::size_t k = 0; k + 1 < count; ++k) {
      EXPECT_EQ(json["beta"][k].is_null(), static_cast<int>(k) >= report.betaCount);
    }
  }
}

/// Every number of the document is finite, by walking through it.
void expectNoNaN(const Ordered& value, const std::string& path) {
  if (value.is_number_float()) {
    EXPECT_TRUE(std::isfinite(value.get<double>())) << path;
  }
  if (value.is_structured()) {
    for (const auto& [key, child] : value.items())
      expectNoNaN(child, path + "/" + key);
  }
}

TEST(ReportJson, HasNoNumberThatIsNone) {
  for (const CurveJoin& join : manyJoins()) {
    const Ordered json = toJson(join);
    expectNoNaN(json, "");
    const std::string text = json.dump();
    EXPECT_EQ(text.find("nan"), std::string::npos);
    EXPECT_EQ(Ordered::parse(text).dump(), text) << "the round trip changes nothing";
  }
}

std::vector<std::string> keys(const Ordered& object) {
  std::vector<std::string> list;
  for (const auto& item : object.items())
    list.push_back(item.key());
  return list;
}

TEST(ReportJson, HasTheKeysOfTheContractAtEveryJoin) {
  const std::vector<std::string> top{
      "schema",     "order",       "parametric_order", "requested_order", "preset",
      "verdicts",   "residuals",   "tolerances",       "uncertainties",   "parametric_residuals",
      "beta",       "scale_mm",    "deviation",        "sides",           "frame",
      "frame_kind", "definitions", "warnings",         "parameter"};
  const std::vector<std::string> deviation{"gap_mm",
                                           "tangent_angle_deg",
                                           "curvature_vector_per_mm",
                                           "curvature_relative",
                                           "osculating_plane_angle_deg",
                                           "torsion_per_mm",
                                           "curvature_rate_per_mm2",
                                           "torsion_rate_per_mm2",
                                           "curvature_rate2_per_mm3"};
  const std::vector<std::string> side{"end",
                                      "point",
                                      "tangent",
                                      "normal",
                                      "binormal",
                                      "curvature",
                                      "torsion",
                                      "curvature_rate",
                                      "curvature_rate2",
                                      "torsion_rate",
                                      "linearity",
                                      "multiplicity",
                                      "segment",
                                      "derivatives_in_frame"};
  for (const CurveJoin& join : manyJoins()) {
    const Ordered json = toJson(join);
    EXPECT_EQ(keys(json), top);
    EXPECT_EQ(keys(json.at("deviation")), deviation);
    ASSERT_EQ(json.at("sides").size(), 2U);
    for (const Ordered& one : json.at("sides")) {
      EXPECT_EQ(keys(one), side);
      EXPECT_EQ(one.at("derivatives_in_frame").size(), 5U);
      EXPECT_EQ(one.at("derivatives_in_frame")[4].size(), 3U);
    }
    EXPECT_EQ(json.at("definitions").size(), static_cast<std::size_t>(kDefinitionCount));
  }
}

TEST(ReportJson, CarriesSidesSegmentsAndParameter) {
  Random random(301);
  const BSplineCurve curve(randomSplineData(random, 3, {{0, 1, 2}, {4, 2, 4}}, true));
  const CurveJoin join = analyzeInnerJoins(curve).at(0);
  const Ordered json = toJson(join);
  EXPECT_EQ(json.at("parameter"), 1.0);
  const Ordered& side = json.at("sides").at(1);
  EXPECT_EQ(side.at("end"), "start");
  EXPECT_EQ(side.at("curvature").get<double>(), join.report.sides[1].invariants.curvature);
  EXPECT_EQ(side.at("segment").at("degree"), 3);
  EXPECT_EQ(side.at("segment").at("parameters"), Ordered({1.0, 2.0}));
  EXPECT_EQ(side.at("segment").at("weights")[2].get<double>(), join.secondSegment.curve.weight(2));
  EXPECT_EQ(side.at("segment").at("poles")[3][1].get<double>(),
            join.secondSegment.curve.pole(3).y());
  EXPECT_EQ(side.at("tangent")[0].get<double>(), join.report.sides[1].frame.tangent.x());
}

TEST(ReportJson, WhatDoesNotExistIsNull) {
  const BezierCurve line = bezier({{-1, 0, 0}, {0, 0, 0}});
  const Ordered straight = toJson(joinOfCurves(line, line.segment(1, 2)));
  EXPECT_TRUE(straight.at("sides")[0].at("torsion").is_null());
  EXPECT_TRUE(straight.at("sides")[0].at("normal").is_null());
  EXPECT_TRUE(straight.at("sides")[0].at("segment").at("weights").is_null());
  EXPECT_TRUE(straight.at("definitions").at("g3-torsion").at("verdict").is_null());
  EXPECT_TRUE(straight.at("parameter").is_null());
  const Ordered cusp =
      toJson(joinOfCurves(line, bezier({{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {3, 1, 0}})));
  EXPECT_TRUE(cusp.at("residuals")[2].is_null());
  EXPECT_TRUE(cusp.at("sides")[1].at("curvature").is_null());
  EXPECT_EQ(cusp.at("warnings")[0].at("code"), "degenerate-tangent");
  EXPECT_FALSE(cusp.at("warnings")[0].at("sentence").get<std::string>().empty());
}

}  // namespace
}  // namespace osculate::test
