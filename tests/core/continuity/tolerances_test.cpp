#include "osculate/continuity/tolerances.h"

#include <algorithm>
#include <limits>
#include <string>

#include "support/errors.h"

namespace osculate::test {
namespace {

TEST(Tolerances, DefaultIsThePresetOsculateOfTheContract) {
  const Tolerances tolerances;
  EXPECT_EQ(tolerances.name, "osculate");
  EXPECT_EQ(tolerances.gapMm, 1e-3);
  EXPECT_EQ(tolerances.angleDegrees, 0.1);
  EXPECT_EQ(tolerances.curvature, 0.01);
  EXPECT_EQ(tolerances.third, 0.02);
  EXPECT_EQ(tolerances.fourth, 0.05);
  EXPECT_EQ(Tolerances::preset("osculate").fourth, 0.05);
}

TEST(Tolerances, ExactIsThatOfTheContract) {
  const Tolerances exact = Tolerances::preset("exact");
  EXPECT_EQ(exact.gapMm, 1e-7);
  EXPECT_EQ(exact.angleDegrees, 1e-6);
  EXPECT_EQ(exact.curvature, 1e-8);
  EXPECT_EQ(exact.third, 1e-8);
  EXPECT_EQ(exact.fourth, 1e-8);
}

struct Vendor {
  const char* name;
  double gapMm, angleDegrees, curvature;
  CurvatureMetric metric;
};

TEST(Tolerances, PresetsHaveTheNumbersAndMetricsOfTheirSystems) {
  const Vendor vendors[] = {
      {"rhino", 1e-3, 1.0, 0.01, CurvatureMetric::kVector},
      {"opennurbs", 1e-3, 1.0, 0.05, CurvatureMetric::kOpenNurbs},
      {"catia-v5", 1e-3, 0.01, 0.02, CurvatureMetric::kMaximum},
      {"icem", 5e-3, 0.5, 0.05, CurvatureMetric::kMaximum},
      {"creo", 2e-2, 0.1, 0.1, CurvatureMetric::kMaximum},
      {"occt", 1e-3, 0.0572957795130823, 0.01, CurvatureMetric::kGeometricMean},
      {"class-a", 1e-3, 0.016, 0.005, CurvatureMetric::kMaximum}};
  for (const Vendor& vendor : vendors) {
    const Tolerances tolerances = Tolerances::preset(vendor.name);
    EXPECT_EQ(tolerances.name, vendor.name);
    EXPECT_EQ(tolerances.gapMm, vendor.gapMm) << vendor.name;
    EXPECT_DOUBLE_EQ(tolerances.angleDegrees, vendor.angleDegrees) << vendor.name;
    EXPECT_EQ(tolerances.curvature, vendor.curvature) << vendor.name;
    EXPECT_EQ(tolerances.metric, vendor.metric) << vendor.name;
  }
}

TEST(Tolerances, EveryPresetPassesItsOwnCheckAndStatesItsSourceAndWhatItBorrows) {
  ASSERT_EQ(tolerancePresets().size(), 9U);
  for (const TolerancePreset& about : tolerancePresets()) {
    const Tolerances preset = Tolerances::preset(about.name);
    EXPECT_NO_THROW(preset.check());
    EXPECT_FALSE(about.source.empty()) << about.name;
    const bool borrows = about.name != "osculate" && about.name != "exact";
    EXPECT_EQ(about.borrowed.empty(), !borrows) << about.name;
    if (borrows) {
      EXPECT_EQ(preset.fourth, Tolerances{}.fourth) << about.name;
    }
  }
}

TEST(Tolerances, OfAnOrderAboveFourIsTheFourth) {
  const Tolerances tolerances{
      .gapMm = 1, .angleDegrees = 2, .curvature = 3, .third = 4, .fourth = 5};
  const double expected[] = {1, 2, 3, 4, 5, 5, 5, 5, 5};
  for (int k = 0; k <= kMaxOrder; ++k)
    EXPECT_EQ(tolerances.ofOrder(k), expected[k]);
}

TEST(Tolerances, NamesAnUnknownPresetAndListsThoseThereAre) {
  EXPECT_ERROR(Tolerances::preset("alias"),
               "preset: must be one of osculate, exact, rhino, opennurbs");
  EXPECT_ERROR(Tolerances::preset("alias"), "got alias");
}

TEST(Tolerances, NamesTheToleranceThatIsNone) {
  const auto checked = [](double Tolerances::*member, double value) {
    Tolerances tolerances;
    tolerances.*member = value;
    tolerances.check();
  };
  EXPECT_ERROR(checked(&Tolerances::gapMm, 0.0), "gap_mm: a tolerance must be finite and > 0");
  EXPECT_ERROR(checked(&Tolerances::angleDegrees, -1.0),
               "angle_deg: a tolerance must be finite and > 0");
  EXPECT_ERROR(checked(&Tolerances::curvature, std::numeric_limits<double>::infinity()),
               "curvature:");
  EXPECT_ERROR(checked(&Tolerances::third, std::numeric_limits<double>::quiet_NaN()), "third:");
  EXPECT_ERROR(checked(&Tolerances::fourth, 0.0), "fourth:");
}

}  // namespace
}  // namespace osculate::test
