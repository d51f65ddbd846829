#include "osculate/continuity/audit_document.h"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "support/errors.h"

namespace osculate::test {
namespace {

using Json = nlohmann::json;

AuditRow vertexRow() {
  AuditRow row;
  row.edges = {3, 17};
  row.ends = {CurveEnd::kEnd, CurveEnd::kEnd};
  row.order = 1;
  row.parametricOrder = 0;
  row.verdicts = {Verdict::kPass, Verdict::kPass, Verdict::kFail, Verdict::kUndecided,
                  Verdict::kFail};
  row.point = {0.1, -1e-300, 12345.678901234567};
  row.residuals = {1e-17, 0.05, 0.7, 1.0 / 3.0, 2.0};
  Deviation deviation;
  deviation.gapMm = 1e-17;
  deviation.tangentAngleDegrees = 0.05;
  deviation.curvatureVectorPerMm = 5e-324;
  deviation.torsionRatePerMm2 = 0.1;
  row.setDeviation(deviation);
  row.warnings.add(Warning::kUndecided);
  row.warnings.add(Warning::kNearFlat);
  return row;
}

AuditRow knotRow() {
  AuditRow row;
  row.kind = JoinKind::kKnot;
  row.edges = {4, 4};
  row.parameter = 0.1 + 0.2;
  row.order = 0;
  row.residuals[1] = row.residuals[2] = row.residuals[3] = row.residuals[4] =
      std::numeric_limits<double>::infinity();
  row.setDeviation({});
  return row;
}

AuditDocument document() {
  AuditDocument result;
  result.options.pairs = JoinPairs::kTangent;
  result.options.cornerDegrees = 20.0;
  result.options.analysis.tolerances = Tolerances::preset("catia-v5");
  AuditReport report;
  report.options = result.options;
  report.edgeCount = 20;
  report.corners = 5;
  report.rows = {vertexRow(), knotRow()};
  report.skipped = {{9, true, "is degenerated"}, {11, false, "has no geometry"}};
  AuditReport none;
  none.options = result.options;
  result.files = {{"a \"b\", c.stp", FileStatus::kAudited, "", {"2 parts gave no shape"}, report},
                  {"lost.igs", FileStatus::kCrashed, "signal 11", {}, none}};
  return result;
}

std::string jsonOf(const AuditDocument& document) {
  std::string text;
  writeAuditJson(document, [&](std::string_view piece) { text += piece; });
  return text;
}

std::string csvOf(const AuditDocument& document) {
  std::string text;
  writeAuditCsv(document, [&](std::string_view piece) { text += piece; });
  return text;
}

AuditDocument read(const std::string& text) {
  std::istringstream stream(text);
  return readAuditJson(stream);
}

TEST(AuditJson, HasTheFieldsOfTheSchema) {
  const Json json = Json::parse(jsonOf(document()));
  EXPECT_EQ(json["schema"], "osculate.audit/1");
  EXPECT_EQ(json["options"]["pairs"], "tangent");
  EXPECT_EQ(json["options"]["corner_deg"], 20.0);
  EXPECT_EQ(json["options"]["preset"], "catia-v5");
  EXPECT_EQ(json["options"]["tolerances"]["angle_deg"], 0.01);
  EXPECT_EQ(json["summary"]["joins"], 2);
  EXPECT_EQ(json["summary"]["kinds"], (Json{{"vertex", 1}, {"knot", 1}, {"seam", 0}}));
  EXPECT_EQ(json["summary"]["orders"],
            (Json{{"gap", 0}, {"G0", 1}, {"G1", 1}, {"G2", 0}, {"G3", 0}, {"G4", 0}}));
  EXPECT_EQ(json["files"][0]["status"], "audited");
  EXPECT_EQ(json["files"][0]["message"], nullptr);
  EXPECT_EQ(json["files"][0]["skipped"][1],
            (Json{{"edge", 11}, {"degenerated", false}, {"reason", "has no geometry"}}));
  EXPECT_EQ(json["files"][1]["status"], "crashed");
  EXPECT_EQ(json["files"][1]["message"], "signal 11");
}

TEST(AuditJson, HasTheFieldsOfARow) {
  const Json json = Json::parse(jsonOf(document()));
  const Json& vertex = json["rows"][0];
  EXPECT_EQ(vertex["file"], "a \"b\", c.stp");
  EXPECT_EQ(vertex["kind"], "vertex");
  EXPECT_EQ(vertex["edges"], (Json{3, 17}));
  EXPECT_EQ(vertex["ends"], (Json{"end", "end"}));
  EXPECT_EQ(vertex["parameter"], nullptr);
  EXPECT_EQ(vertex["order"], 1);
  EXPECT_EQ(vertex["parametric_order"], 0);
  EXPECT_EQ(vertex["verdicts"], (Json{"pass", "pass", "fail", "undecided", "fail"}));
  EXPECT_EQ(vertex["residuals"][3], 1.0 / 3.0);
  EXPECT_EQ(vertex["deviation"]["curvature_vector_per_mm"], 5e-324);
  EXPECT_EQ(vertex["deviation"]["torsion_per_mm"], nullptr);
  EXPECT_EQ(vertex["warnings"], (Json{"undecided", "near-flat"}));
  const Json& knot = json["rows"][1];
  EXPECT_EQ(knot["ends"], nullptr);
  EXPECT_EQ(knot["parameter"], 0.1 + 0.2);
  EXPECT_EQ(knot["residuals"][1], nullptr);
  EXPECT_EQ(knot["deviation"]["tangent_angle_deg"], nullptr);
}

TEST(AuditJson, ReadsWhatItWrote) {
  const std::string text = jsonOf(document());
  const AuditDocument back = read(text);
  EXPECT_EQ(jsonOf(back), text);
  ASSERT_EQ(back.files.size(), 2U);
  EXPECT_EQ(back.options.analysis.tolerances.metric, CurvatureMetric::kMaximum);
  EXPECT_EQ(back.options.analysis.tolerances.name, "catia-v5");
  const AuditRow& row = back.files[0].report.rows.at(0);
  EXPECT_EQ(row.residuals, vertexRow().residuals);
  EXPECT_EQ(row.point, vertexRow().point);
  EXPECT_EQ(row.physical, vertexRow().physical);
}

TEST(AuditJson, ReadsOrdersZeroAndEight) {
  for (const int order : {0, 8}) {
    AuditDocument few = document();
    few.options.analysis.order = order;
    const std::string text = jsonOf(few);
    EXPECT_EQ(jsonOf(read(text)), text);
  }
}

TEST(AuditJson, KeepsOwnTolerancesApartFromPresets) {
  AuditDocument own = document();
  own.options.analysis.tolerances.gapMm = 0.5;
  EXPECT_EQ(read(jsonOf(own)).options.analysis.tolerances.name, "custom");
  EXPECT_EQ(read(jsonOf(own)).options.analysis.tolerances.gapMm, 0.5);
}

TEST(AuditJson, NamesThatAreNotUtf8) {
  AuditDocument odd = document();
  odd.files[0].file = "caf\xe9.stp";
  EXPECT_EQ(Json::parse(jsonOf(odd))["rows"][0]["file"], "caf\xef\xbf\xbd.stp");
}

TEST(AuditJson, NoFilesAndNoRows) {
  const std::string text = jsonOf(AuditDocument{});
  EXPECT_EQ(Json::parse(text)["rows"], Json::array());
  EXPECT_TRUE(read(text).files.empty());
}

TEST(AuditJson, RefusesWhatIsNoReport) {
  const std::string whole = jsonOf(document());
  EXPECT_ERROR(read(""), "no audit report (schema osculate.audit/1): ");
  EXPECT_ERROR(read("[1, 2]"), "it has another schema");
  EXPECT_ERROR(read(R"({"schema": "osculate.join/1"})"), "it has another schema");
  for (std::size_t length = 0; length < whole.size() - 3; length += 97)
    EXPECT_ERROR(read(whole.substr(0, length)), "no audit report");
}

/// The document with one text in place of another.
std::string altered(const std::string& from, const std::string& to) {
  std::string text = jsonOf(document());
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::logic_error("no " + from);
  return text.replace(at, from.size(), to);
}

TEST(AuditJson, RefusesImpossibleValues) {
  EXPECT_ERROR(read(altered(R"("kind":"knot")", R"("kind":"hole")")), "kind 'hole' is unknown");
  EXPECT_ERROR(read(altered(R"("ends":["end")", R"("ends":["top")")), "end 'top' is unknown");
  EXPECT_ERROR(read(altered(R"(["pass","pass")", R"(["pass","good")")), "verdict 'good'");
  EXPECT_ERROR(read(altered(R"("order":1,)", R"("order":99,)")), "order 99 is impossible");
  EXPECT_ERROR(read(altered(R"(["pass","pass",)", R"(["pass",)")), "wrong number of orders");
  EXPECT_ERROR(read(altered(R"("edges":[3,17])", R"("edges":"3")")), "no audit report");
  EXPECT_ERROR(read(altered(R"("status":"crashed")", R"("status":"lost")")), "status 'lost'");
  EXPECT_ERROR(read(altered(R"("file":"a \"b\", c.stp","kind")", R"("file":"x","kind")")),
               "rows of the file 'x', which it does not list");
  EXPECT_ERROR(read(altered(R"("pairs":"tangent")", R"("pairs":"any")")), "pairs: must be one of");
  EXPECT_ERROR(read(altered(R"("gap_mm":0.001,"angle)", R"("gap_mm":-1,"angle)")), "gap_mm");
}

TEST(AuditCsv, IsOneRowAJoin) {
  std::istringstream lines(csvOf(document()));
  std::string header;
  std::string vertex;
  std::string knot;
  std::string rest;
  std::getline(lines, header);
  std::getline(lines, vertex);
  std::getline(lines, knot);
  EXPECT_FALSE(std::getline(lines, rest));
  EXPECT_EQ(header.substr(0, 72),
            "file,kind,edge1,edge2,end1,end2,parameter,x,y,z,order,parametric_order,g");
  EXPECT_EQ(
      vertex,
      "\"a \"\"b\"\", c.stp\",vertex,3,17,end,end,,0.1,-1e-300,12345.678901234567,1,0,pass,1e-17,"
      "pass,0.05,fail,0.7,undecided,0.3333333333333333,fail,2,1e-17,0.05,5e-324,,,,,0.1,,"
      "undecided near-flat");
  EXPECT_EQ(
      knot,
      "\"a \"\"b\"\", c.stp\",knot,4,4,,,0.30000000000000004,0,0,0,0,-1,pass,0,pass,,pass,,pass,,"
      "pass,,0,,,,,,,,,");
  EXPECT_EQ(std::count(header.begin(), header.end(), ','), 12 + 2 * 5 + 9 + 1 - 1);
}

TEST(AuditText, SaysWhatAPersonWantsToKnow) {
  const std::string text = auditText(document(), 10);
  for (const char* expected :
       {"a \"b\", c.stp: 20 edges, 2 joins: 1 at vertices, 1 at inner knots, 0 at seams\n",
        "  G0 1   G1 1\n", "  1 join undecided\n", "  5 corners of more than 20 deg left out\n",
        "  note: 2 parts gave no shape\n", "  1 degenerated edge left out\n",
        "  1 edge could not be analysed:\n    edge 11: has no geometry\n",
        "  4 at 0.3                    G0, G1 does not exist at a singular end",
        "  3 end + 17 end              G1, misses G2 by 0.7 (tolerance 0.02)", "near-flat\n",
        "lost.igs: crashed: signal 11\n", "all 2 files: 2 joins"}) {
    EXPECT_NE(text.find(expected), std::string::npos) << expected << "in\n" << text;
  }
  EXPECT_EQ(auditText(document(), 0).find("misses"), std::string::npos);
}

TEST(AuditText, OfAShapeWithoutAFile) {
  AuditDocument shape = document();
  shape.files.pop_back();
  shape.files[0].file.clear();
  EXPECT_EQ(auditText(shape, 1).substr(0, 20), "20 edges, 2 joins: 1");
}

TEST(AuditText, AnUndecidedOrder) {
  AuditDocument undecided = document();
  AuditRow& row = undecided.files[0].report.rows[0];
  row.verdicts[2] = Verdict::kUndecided;
  EXPECT_NE(auditText(undecided, 2).find("G1, G2 undecided: 0.7 (tolerance 0.02)"),
            std::string::npos);
}

}  // namespace
}  // namespace osculate::test
