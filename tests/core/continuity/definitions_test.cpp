#include "osculate/continuity/definitions.h"

#include <set>

#include "support/definition_joins.h"

namespace osculate::test {
namespace {

using enum Definition;
using enum Verdict;

const DefinitionResult& at(const JoinReport& report, Definition definition) {
  return report.definitions[static_cast<std::size_t>(definition)];
}

/// The verdicts of some definitions, one letter each: p(ass), f(ail), u(ndecided), - for none.
std::string verdicts(const JoinReport& report, std::initializer_list<Definition> definitions) {
  std::string letters;
  for (const Definition definition : definitions) {
    const auto& verdict = at(report, definition).verdict;
    letters += verdict ? name(*verdict)[0] : '-';
  }
  return letters;
}

std::string ofG2(const JoinReport& report) {
  return verdicts(report, {kG2Vector, kG2Maximum, kG2OpenNurbs, kG2Sum, kG2Mean, kG2GeometricMean});
}
std::string ofG3(const JoinReport& report) {
  return verdicts(report,
                  {kG3Vector, kG3FrenetFrame, kG3ScalarRate, kG3GraphAngle, kG3Torsion, kC3});
}

TEST(Definitions, HaveNamesOfTheirOwnAndSayWhoAndWhat) {
  std::set<std::string_view> names;
  for (int i = 0; i < kDefinitionCount; ++i) {
    const DefinitionInfo& about = info(static_cast<Definition>(i));
    names.insert(about.name);
    EXPECT_FALSE(about.who.empty() || about.meaning.empty()) << about.name;
  }
  EXPECT_EQ(names.size(), static_cast<std::size_t>(kDefinitionCount));
  EXPECT_EQ(info(kG3ScalarRate).name, "g3-scalar-rate");
  EXPECT_EQ(info(kG3GraphAngle).unit, "deg");
}

TEST(Definitions, VerdictsHaveTheNamesOfTheContract) {
  EXPECT_EQ(name(kPass), "pass");
  EXPECT_EQ(name(kFail), "fail");
  EXPECT_EQ(name(kUndecided), "undecided");
}

TEST(Definitions, PercentagesOfRadius100Against102AreThoseOfTheSystems) {
  const JoinReport report = circlesOf(100.0, 102.0);
  EXPECT_NEAR(at(report, kG2Maximum).value, 0.0196, 5e-5) << "CATIA, KOMPAS";
  EXPECT_NEAR(at(report, kG2OpenNurbs).value, 0.0196, 5e-5);
  EXPECT_NEAR(at(report, kG2Sum).value, 0.0099, 5e-5) << "Alias";
  EXPECT_NEAR(at(report, kG2Mean).value, 0.0198, 5e-5) << "tools with factor 2";
  EXPECT_NEAR(at(report, kG2GeometricMean).value, 0.0198, 5e-5) << "OpenCASCADE";
  EXPECT_NEAR(at(report, kG2Vector).value, 0.0196, 5e-5) << "in one plane the vector one is 1 - r";
  EXPECT_EQ(ofG2(report), "fffpff") << "only Alias' percentage is below 1 %";
}

TEST(Definitions, OfG2ByNumberPassAnSJoinThatVectorsAndAnglesFail) {
  EXPECT_EQ(ofG2(turnedCircles(180.0)), "fpfppf");
}

TEST(Definitions, OfG2ByNumberPassPlanesApartThatVectorsAndAnglesFail) {
  EXPECT_EQ(ofG2(turnedCircles(90.0)), "fpfppf");
  EXPECT_EQ(ofG2(turnedCircles(1.5)), "fppppf") << "openNURBS allows 2 degrees, 1.5 are 2.6 %";
  EXPECT_EQ(ofG2(turnedCircles(2.5)), "fpfppf");
  EXPECT_EQ(ofG2(turnedCircles(0.5)), "pppppf") << "OpenCASCADE wants 0.001 rad";
  EXPECT_EQ(ofG2(turnedCircles(0.0)), "pppppp");
}

TEST(Definitions, OfG2HaveNoVerdictOnStraightSides) {
  const JoinReport report = join(bezier({{0, 0, 0}, {1, 0, 0}}), bezier({{1, 0, 0}, {3, 0, 0}}));
  EXPECT_EQ(ofG2(report), "p-----");
  EXPECT_EQ(ofG3(report).substr(1, 4), "----");
}

TEST(Definitions, OfG2NearZeroCurvatureAreRatiosThatMeanNothing) {
  EXPECT_EQ(ofG2(joinOf({.curvature = 1e-4}, {.curvature = 2e-4})), "pfffff")
      << "1e-4 per mm over 4 mm is nothing, though the ratio is a half";
}

TEST(Definitions, OneCurveByTwoParametersIsG3ButNotC3) {
  EXPECT_EQ(ofG2(reparametrisedHalves()), "pppppp");
  EXPECT_EQ(ofG3(reparametrisedHalves()), "pppppf");
}

TEST(Definitions, CircleToHelixPassesByTheRateOfCurvatureOnly) {
  EXPECT_EQ(ofG3(joinOf({.curvature = 0.25}, {.curvature = 0.25, .torsion = 0.25})), "ffppff");
}

TEST(Definitions, ArcToClothoidPassesByFrameAndTorsionOnly) {
  EXPECT_EQ(ofG3(joinOf({.curvature = 0.25}, {.curvature = 0.25, .rate = 0.125})), "fpffpf");
}

TEST(Definitions, AGraphOfSmallSlopesPassesByItsAngle) {
  // scaled by 25: rates of 1e-4 and 5e-4 per mm^2, 0.02 degrees apart
  const JoinReport report =
      joinOf({.curvature = 0.25, .rate = 0.0625}, {.curvature = 0.25, .rate = 0.3125}, 25.0);
  EXPECT_EQ(ofG3(report), "fpfppf");
  EXPECT_NEAR(at(report, kG3GraphAngle).value, 4e-4 * 180.0 / std::numbers::pi, 1e-6);
  EXPECT_NEAR(at(report, kG3ScalarRate).value, 0.8, 1e-9);
}

TEST(Definitions, EqualTorsionAcrossTurnedPlanesPassesByNumbersOnly) {
  EXPECT_EQ(ofG3(turnedCircles(90.0)), "ffpppf");
}

TEST(Definitions, AngleOfSteepGraphsIsThatOfTheirArctangents) {
  const JoinReport report = joinOf({.curvature = 2.0}, {.curvature = 2.0, .rate = 1.0});
  EXPECT_NEAR(at(report, kG3GraphAngle).value, 45.0, 1e-8);
}

TEST(Definitions, AllFailWhereTheTangentsDiffer) {
  const JoinReport report = join(quarterCircle({{-5, 5, 0}, {-5, 0, 0}, {0, 0, 0}}),
                                 quarterCircle({{0, 0, 0}, {0, 5, 0}, {-5, 5, 0}}));
  ASSERT_EQ(report.order, 0);
  EXPECT_EQ(ofG2(report), "ffffff");
  EXPECT_EQ(ofG3(report), "ffffff");
}

TEST(Definitions, HaveNoVerdictAboveTheOrderAskedFor) {
  EXPECT_EQ(ofG2(circlesOf(10, 10, withPreset("osculate", 1))), "------");
  EXPECT_EQ(ofG2(circlesOf(10, 10, withPreset("osculate", 2))), "pppppp");
  EXPECT_EQ(ofG3(circlesOf(10, 10, withPreset("osculate", 2))), "------");
  EXPECT_EQ(ofG3(circlesOf(10, 10, withPreset("osculate", 3))), "pppppf");
}

TEST(Definitions, UseTheTolerancesOfThePreset) {
  EXPECT_EQ(ofG2(circlesOf(100, 102, withPreset("catia-v5"))), "pppppp");
  EXPECT_EQ(ofG2(circlesOf(100, 102, withPreset("class-a"))), "ffffff");
  EXPECT_EQ(at(circlesOf(100, 102, withPreset("catia-v5")), kG2Maximum).tolerance, 0.02);
}

TEST(Definitions, AreUndecidedWhereTheUncertaintySaysSo) {
  const JoinReport report = undecidedCircles(0.01);
  ASSERT_EQ(report.order, 1);
  EXPECT_EQ(ofG2(report), "uuuuuu");
  EXPECT_EQ(verdicts(report, {kG3Vector}), "f") << "without G2 there is no G3 to decide";
}

}  // namespace
}  // namespace osculate::test
