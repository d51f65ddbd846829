#include "osculate/continuity/report_text.h"

#include <sstream>

#include "osculate/continuity/curve_joins.h"
#include "support/definition_joins.h"

namespace osculate::test {
namespace {

constexpr std::size_t kColumns = 100;

bool contains(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

void expectFits(const std::string& text) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    EXPECT_LE(line.size(), kColumns) << line;
  EXPECT_FALSE(text.ends_with('\n')) << "whoever prints it ends the line";
}

/// Joins of every order, of singular, flat, far and approximated curves.
std::vector<JoinReport> manyReports() {
  Random random(290);
  std::vector<JoinReport> reports;
  for (int order = -1; order <= 8; ++order) {
    const auto [first, second] = randomJoin(random, order, 8);
    for (const char* preset : {"osculate", "exact", "catia-v5"}) {
      for (const int requested : {0, 1, 2, 4, 8})
        reports.push_back(join(first, second, withPreset(preset, requested)));
    }
    const Eigen::Affine3d away = Eigen::Translation3d(-1e9, 1e9, 1e9) * Eigen::Scaling(1e-3);
    reports.push_back(
        join(first.transformed(away), second.transformed(away), withPreset("exact", 8)));
    const BSplineCurve approximated = BSplineCurve(second).withPoleError(1e-4);
    reports.push_back(analyzeCurves(BSplineCurve(first), approximated).report);
  }
  const BezierCurve line = bezier({{-1, 0, 0}, {0, 0, 0}});
  for (const BezierCurve& next :
       {bezier({{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {3, 1, 0}}), bezier({{0, 0, 0}, {-2, 0, 0}}),
        bezier({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 1, 0}}), bezier({{0, 0, 0}, {0, 0, 0}})}) {
    for (const int requested : {0, 4, 8})
      reports.push_back(join(line, next, withPreset("osculate", requested)));
  }
  for (const double degrees : {0.5, 1.5, 90.0, 180.0})
    reports.push_back(turnedCircles(degrees));
  reports.push_back(circlesOf(100, 102));
  reports.push_back(joinOf({.curvature = 0.25}, {.curvature = 0.25, .torsion = 0.25}));
  reports.push_back(joinOf({.curvature = 1e-4}, {.curvature = 2e-4}));
  reports.push_back(reparametrisedHalves());
  return reports;
}

TEST(ReportTable, FitsIntoAHundredColumns) {
  for (const JoinReport& report : manyReports())
    expectFits(reportTable(report));
}

TEST(ReportTable, BeginsWithTheHeadlineAndHasARowForEachOrder) {
  for (const JoinReport& report : manyReports()) {
    const std::string table = reportTable(report);
    EXPECT_TRUE(table.starts_with(headline(report) + "\n"));
    for (int k = 0; k <= 8; ++k) {
      EXPECT_EQ(contains(table, "\n  G" + std::to_string(k) + " "), k <= report.requestedOrder)
          << table;
    }
  }
}

TEST(ReportTable, ColumnsOfTheOrdersStandUnderTheirHeadings) {
  const BezierCurve line = bezier({{-1, 0, 0}, {0, 0, 0}});
  const std::string table =
      reportTable(join(line, bezier({{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {3, 1, 0}})));
  std::istringstream lines(table);
  std::size_t tolerance = std::string::npos;
  int rows = 0;
  for (std::string row; std::getline(lines, row);) {
    if (contains(row, "residual      ")) tolerance = row.find("tolerance");
    if (!row.starts_with("  G")) continue;
    ASSERT_NE(tolerance, std::string::npos);
    EXPECT_EQ(row[tolerance - 1], ' ') << row;
    EXPECT_TRUE(std::isdigit(static_cast<unsigned char>(row[tolerance]))) << row;
    ++rows;
  }
  EXPECT_EQ(rows, 5);
}

TEST(ReportTable, CarriesTheNumbersOfBothSidesBetasWarningsAndTheReason) {
  const JoinReport report = joinOf({.curvature = 0.25}, {.curvature = 0.25, .torsion = 0.125});
  const std::string table = reportTable(report);
  for (const char* part :
       {"its end", "its start", "curvature", "0.25", "radius", "torsion", "0.125", "beta",
        "g3-scalar-rate", "tolerances: osculate", "frame: frenet", "G3 only by part"}) {
    EXPECT_TRUE(contains(table, part)) << part << " is not in\n" << table;
  }
  const BezierCurve line = bezier({{-1, 0, 0}, {0, 0, 0}});
  const std::string cusp = reportTable(join(line, bezier({{0, 0, 0}, {-2, 0, 0}})));
  EXPECT_TRUE(contains(cusp, "cusp: The tangents are opposite"));
  EXPECT_FALSE(contains(cusp, "nan") || contains(cusp, "inf"));
}

TEST(ReportTable, NeverPrintsNumbersThatAreNone) {
  for (const JoinReport& report : manyReports()) {
    const std::string table = reportTable(report);
    EXPECT_FALSE(contains(table, "nan")) << table;
    EXPECT_FALSE(contains(table, " inf")) << table;
  }
}

TEST(Headline, IsTheOrderWhereNothingMisses) { EXPECT_EQ(headline(reparametrisedHalves()), "G4"); }

TEST(Headline, SaysByHowMuchTheNextOrderMisses) {
  EXPECT_EQ(headline(circlesOf(100, 102)), "G1, misses G2 by 0.0196 (tolerance 0.01)");
  const BezierCurve line = bezier({{-1, 0, 0}, {0, 0, 0}});
  EXPECT_EQ(headline(join(line, bezier({{0, 0, 0}, {0, 1, 0}}))),
            "G0, misses G1 by 90 deg (tolerance 0.1 deg)");
}

TEST(Headline, SaysTheGap) {
  const BezierCurve line = bezier({{-1, 0, 0}, {0, 0, 0}});
  EXPECT_EQ(headline(join(line, bezier({{0, 0.25, 0}, {1, 0.25, 0}}))),
            "gap of 0.25 mm (tolerance 0.001 mm)");
}

TEST(Headline, SaysWhatIsUndecided) {
  EXPECT_TRUE(headline(undecidedCircles(0.01)).starts_with("G1, G2 undecided: "));
  EXPECT_EQ(headline(undecidedCircles(0.125)), "G0 undecided: 0 mm +- 0.125 mm");
}

TEST(Headline, SaysWhereASingularEndHasNoSuchDerivative) {
  const BezierCurve line = bezier({{-1, 0, 0}, {0, 0, 0}});
  EXPECT_EQ(headline(join(line, bezier({{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {3, 1, 0}}))),
            "G1, G2 does not exist at a singular end");
}

TEST(Disagreement, IsNoneWhereTheDefinitionsAgree) {
  EXPECT_EQ(disagreement(circlesOf(10, 20)), "") << "none passes";
  const BezierCurve line = bezier({{-1, 0, 0}, {0, 0, 0}});
  EXPECT_EQ(disagreement(join(line, line.segment(1, 2))), "") << "all that apply pass";
}

TEST(Disagreement, TellsWhyNumbersPassAndVectorsDoNot) {
  EXPECT_TRUE(contains(disagreement(turnedCircles(180.0)), "bend to opposite sides"));
  EXPECT_TRUE(contains(disagreement(turnedCircles(60.0)), "their planes differ by 60 deg"));
  EXPECT_TRUE(contains(disagreement(circlesOf(100, 102)), "G2 by a milder metric (Alias)"));
  EXPECT_TRUE(contains(disagreement(joinOf({.curvature = 1e-4}, {.curvature = 2e-4})),
                       "meaningless near zero curvature"));
}

TEST(Disagreement, TellsWhichPartOfG3IsMissing) {
  EXPECT_TRUE(
      contains(disagreement(joinOf({.curvature = 0.25}, {.curvature = 0.25, .torsion = 0.25})),
               "the curvature's rate is equal, but the torsion is not"));
  EXPECT_TRUE(
      contains(disagreement(joinOf({.curvature = 0.25}, {.curvature = 0.25, .rate = 0.125})),
               "the torsion is equal, but the curvature's rate is not"));
  const Bends first{.curvature = 0.25, .rate = 0.0625};
  EXPECT_TRUE(contains(
      disagreement(joinOf(first, {.curvature = 0.25, .rate = 0.3125, .torsion = 0.25}, 25.0)),
      "a slope of the curvature graph below 0.1 deg hides the difference"));
  EXPECT_TRUE(contains(disagreement(turnedCircles(90.0)), "the curvature vectors already differ"));
  EXPECT_TRUE(contains(disagreement(reparametrisedHalves()), "Not C3 (Rhino's help)"));
}

}  // namespace
}  // namespace osculate::test
