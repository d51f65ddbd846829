// Pairs of curves with known order, invariants and residuals: our own selection, and all of them
// where the reference data lie beside the checkout.
#include <fstream>
#include <nlohmann/json.hpp>

#include "support/joins.h"

namespace osculate::test {
namespace {

using Json = nlohmann::json;

double number(const Json& text) { return std::stod(text.get<std::string>()); }
Vector3 vector(const Json& texts) {
  return {number(texts.at(0)), number(texts.at(1)), number(texts.at(2))};
}

BezierCurve curveFrom(const Json& data) {
  std::vector<Vector3> poles;
  std::vector<double> weights;
  for (const Json& point : data.at("points"))
    poles.push_back(vector(point));
  if (!data.at("weights").is_null()) {
    for (const Json& weight : data.at("weights"))
      weights.push_back(number(weight));
  }
  return BezierCurve(poles, weights);
}

Json pairsIn(const std::string& path) {
  std::ifstream file(path);
  return file ? Json::parse(file).at("pairs") : Json::array();
}

Json ownPairs() { return pairsIn(OSCULATE_TEST_DATA_DIR "/joins.json"); }
Json sharedPairs() { return pairsIn(OSCULATE_SHARED_DIR "/oracle/joins.json"); }

template <class Check>
void forPairs(const Json& pairs, Check check) {
  for (const Json& pair : pairs) {
    SCOPED_TRACE(pair.at("id").get<std::string>() + ": " +
                 pair.at("description").get<std::string>());
    check(pair, curveFrom(pair.at("P")), curveFrom(pair.at("Q")));
  }
}

int orderOf(const Json& pair, int requested) {
  const Json& order = pair.at("order");
  return order.is_string() ? requested : std::min(order.get<int>(), requested);
}

void checkOrder(const Json& pair, const BezierCurve& p, const BezierCurve& q) {
  const JoinReport report = join(p, q, withPreset("exact"));
  EXPECT_EQ(report.order, orderOf(pair, 4));
  EXPECT_FALSE(report.warnings.has(Warning::kUndecided));
}

/// Above order 4 doubles do not always carry 1e-8: then the next order is undecided, never wrong.
void checkHighOrder(const Json& pair, const BezierCurve& p, const BezierCurve& q) {
  const JoinReport report = join(p, q, withPreset("exact", 6));
  const int expected = orderOf(pair, 6);
  EXPECT_LE(report.order, expected);
  for (int k = std::max(0, report.order + 1); k <= expected; ++k) {
    const auto i = static_cast<std::size_t>(k);
    EXPECT_GT(k, 4);
    EXPECT_EQ(report.verdicts[i], Verdict::kUndecided) << "order " << k;
    EXPECT_GT(report.uncertainties[i], report.tolerances[i]) << "order " << k;
  }
}

/// Relative error 1e-9, of values below 1e-6 (zeros, and what rounded weights leave of zeros)
/// absolute.
void expectInvariant(const std::optional<double>& found, const Json& expected, const char* name) {
  if (expected.is_null()) {
    EXPECT_FALSE(found) << name << " does not exist here";
    return;
  }
  ASSERT_TRUE(found) << name;
  const double value = number(expected);
  EXPECT_NEAR(*found, value, 1e-9 * std::max(std::abs(value), 1e-6)) << name;
}

void checkInvariants(const Json& pair, const BezierCurve& p, const BezierCurve& q) {
  const JoinReport report = join(p, q, withPreset("exact"));
  for (const std::size_t i : {0U, 1U}) {
    const Json& expected = pair.at("invariants").at(i == 0 ? "P" : "Q");
    const Invariants& found = report.sides[i].invariants;
    SCOPED_TRACE(i == 0 ? "P" : "Q");
    expectInvariant(found.curvature, expected.at("kappa"), "curvature");
    expectInvariant(found.torsion, expected.at("tau"), "torsion");
    expectInvariant(found.curvatureRate, expected.at("dkappa_ds"), "curvature rate");
    expectInvariant(found.curvatureRate2, expected.at("d2kappa_ds2"), "second curvature rate");
    expectInvariant(found.torsionRate, expected.at("dtau_ds"), "torsion rate");
  }
}

/// The file has |r_k - r_k'| and the r_k; the report divides by the largest, or by L^(1-k).
void checkResiduals(const Json& pair, const BezierCurve& p, const BezierCurve& q) {
  const JoinReport report = join(p, q, withPreset("exact", 6));
  const Json& derivatives = pair.at("arc_derivatives");
  EXPECT_NEAR(report.residuals[0], number(pair.at("residuals").at(0)), report.uncertainties[0]);
  for (std::size_t k = 1; k <= 6; ++k) {
    const double difference = number(pair.at("residuals").at(k));
    double expected = 2.0 * std::asin(std::min(1.0, 0.5 * difference)) * 180.0 / std::numbers::pi;
    if (k > 1) {
      expected = difference / std::max({vector(derivatives.at("P").at(k - 1)).norm(),
                                        vector(derivatives.at("Q").at(k - 1)).norm(),
                                        std::pow(report.scaleMm, 1.0 - static_cast<double>(k))});
    }
    EXPECT_NEAR(report.residuals[k], expected, report.uncertainties[k] + 1e-13 * expected)
        << "order " << k;
    if (k <= 4) {
      EXPECT_LE(report.uncertainties[k], 1e-9) << "order " << k;
    }
  }
}

TEST(ReferenceJoins, OrdersOfOurSelection) { forPairs(ownPairs(), checkOrder); }
TEST(ReferenceJoins, OrdersUpToSixOfOurSelection) { forPairs(ownPairs(), checkHighOrder); }
TEST(ReferenceJoins, InvariantsOfOurSelection) { forPairs(ownPairs(), checkInvariants); }
TEST(ReferenceJoins, ResidualsOfOurSelection) { forPairs(ownPairs(), checkResiduals); }

TEST(ReferenceJoins, OursAreThere) { EXPECT_EQ(ownPairs().size(), 14U); }

class SharedReferenceJoins : public testing::Test {
 protected:
  void SetUp() override {
    if (sharedPairs().empty()) GTEST_SKIP() << "needs oracle/joins.json in ../shared";
  }
};

TEST_F(SharedReferenceJoins, Orders) { forPairs(sharedPairs(), checkOrder); }
TEST_F(SharedReferenceJoins, OrdersUpToSix) { forPairs(sharedPairs(), checkHighOrder); }
TEST_F(SharedReferenceJoins, Invariants) { forPairs(sharedPairs(), checkInvariants); }
TEST_F(SharedReferenceJoins, Residuals) { forPairs(sharedPairs(), checkResiduals); }

}  // namespace
}  // namespace osculate::test
