#include "osculate/continuity/batch.h"

#include <vector>

#include "support/joins.h"

namespace osculate::test {
namespace {

/// Arrays for a batch; rows that are not written keep what they were filled with.
struct Arrays {
  std::vector<double> firstPoles, secondPoles, firstWeights, secondWeights;
  std::vector<std::int8_t> order, parametricOrder;
  std::vector<std::uint8_t> verdicts;
  std::vector<double> residuals, uncertainties;
  BatchInput input;
  BatchOutput output;

  static void append(const BezierCurve& curve, std::vector<double>& poles,
                     std::vector<double>& weights) {
    for (const Vector3& pole : polesOf(curve))
      poles.insert(poles.end(), pole.begin(), pole.end());
    for (const double weight : weightsOf(curve))
      weights.push_back(weight);
  }

  Arrays(const std::vector<JoinedPair>& joins, int order) {
    for (const JoinedPair& pair : joins) {
      append(pair.first, firstPoles, firstWeights);
      append(pair.second, secondPoles, secondWeights);
    }
    const std::size_t cells = joins.size() * (static_cast<std::size_t>(order) + 1);
    this->order.assign(joins.size(), 99);
    parametricOrder.assign(joins.size(), 99);
    verdicts.assign(cells, 99);
    residuals.assign(cells, -1.0);
    uncertainties.assign(cells, -1.0);
    input = {joins.size(),
             firstPoles.data(),
             secondPoles.data(),
             firstWeights.empty() ? nullptr : firstWeights.data(),
             secondWeights.empty() ? nullptr : secondWeights.data(),
             joins.front().first.degree(),
             joins.front().second.degree()};
    output = {this->order.data(), parametricOrder.data(), verdicts.data(), residuals.data(),
              uncertainties.data()};
  }
};

void expectSingles(const std::vector<JoinedPair>& joins, const AnalysisOptions& options) {
  Arrays arrays(joins, options.order);
  ASSERT_EQ(analyzeBatch(arrays.input, arrays.output, options), joins.size());
  const std::size_t columns = static_cast<std::size_t>(options.order) + 1;
  for (std::size_t row = 0; row < joins.size(); ++row) {
    const JoinReport single = join(joins[row].first, joins[row].second, options);
    EXPECT_EQ(arrays.order[row], single.order);
    EXPECT_EQ(arrays.parametricOrder[row], single.parametricOrder);
    for (std::size_t k = 0; k < columns; ++k) {
      EXPECT_EQ(arrays.verdicts[row * columns + k], static_cast<std::uint8_t>(single.verdicts[k]));
      EXPECT_EQ(arrays.residuals[row * columns + k], single.residuals[k]);
      EXPECT_EQ(arrays.uncertainties[row * columns + k], single.uncertainties[k]);
    }
  }
}

TEST(Batch, GivesWhatSingleAnalysesGiveOfPolynomialCurves) {
  Random random(270);
  std::vector<JoinedPair> joins;
  for (int row = 0; row < 50; ++row)
    joins.push_back(randomJoin(random, row % 6 - 1, 5));
  for (const int order : {0, 2, 4, kMaxOrder})
    expectSingles(joins, withPreset("osculate", order));
}

TEST(Batch, GivesWhatSingleAnalysesGiveOfRationalCurvesOfUnequalDegrees) {
  Random random(271);
  std::vector<JoinedPair> both;
  std::vector<JoinedPair> one;
  for (int row = 0; row < 30; ++row) {
    const auto [left, right] = randomBezier(random, 3, true).split(0.5);
    both.push_back({left.elevated(2), right});
    one.push_back({left, bezier({right.pole(0), right.pole(1), right.pole(3)})});
  }
  expectSingles(both, withPreset("exact"));
  expectSingles(one, withPreset("osculate"));
}

TEST(Batch, OfNothingDoesNothing) { EXPECT_EQ(analyzeBatch(BatchInput{}, BatchOutput{}), 0U); }

TEST(Batch, StopsWhereProgressSaysSoAndLeavesTheRestUntouched) {
  const BezierCurve line = bezier({{0, 0, 0}, {1, 0, 0}});
  const std::vector<JoinedPair> joins(150000, JoinedPair{line, line.segment(1, 2)});
  Arrays arrays(joins, 1);
  std::vector<double> shares;
  const std::size_t done =
      analyzeBatch(arrays.input, arrays.output, withPreset("osculate", 1), [&](double share) {
        shares.push_back(share);
        return shares.size() < 3;
      });
  EXPECT_GT(done, 0U);
  EXPECT_LT(done, joins.size());
  EXPECT_EQ(shares.size(), 3U);
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_EQ(arrays.order[done - 1], 1);
  EXPECT_EQ(arrays.order[done], 99);
  EXPECT_EQ(arrays.residuals[2 * done], -1.0);
}

TEST(Batch, ReportsProgressUpToOne) {
  const BezierCurve line = bezier({{0, 0, 0}, {1, 0, 0}});
  Arrays arrays(std::vector<JoinedPair>(100, JoinedPair{line, line.segment(1, 2)}), 4);
  std::vector<double> shares;
  analyzeBatch(arrays.input, arrays.output, {}, [&](double share) {
    shares.push_back(share);
    return true;
  });
  EXPECT_EQ(shares.front(), 0.0);
  EXPECT_EQ(shares.back(), 1.0);
}

}  // namespace
}  // namespace osculate::test
