// Joins and contacts of other libraries' test suites.
#include "support/peer_cases.h"
#include "osculate/continuity/curve_joins.h"
#include "support/joins.h"

namespace osculate::test {
namespace {

TEST(PeerCases, JoinsOfPartsOfOneCurve) {
  FOR_PEER_CASES("join_continuity") {
    SCOPED_TRACE(peer.id);
    const BezierCurve first = bezierFrom(peer.input.at("first"));
    const BezierCurve second = bezierFrom(peer.input.at("second"));
    ASSERT_EQ(peer.input.at("first_param"), 1);
    ASSERT_EQ(peer.input.at("second_param"), 0);
    EXPECT_GE(join(first, second, withPreset("exact")).order, peer.expect.at("min_G").get<int>());
  }
}

TEST(PeerCases, ChainsOfCurves) {
  FOR_PEER_CASES("chain_continuity") {
    SCOPED_TRACE(peer.id);
    std::vector<BSplineCurve> halves;
    double reached = 0.0;
    for (std::size_t i = 0; i < peer.input.at("segments").size(); ++i) {
      const double last = reached + peer.input.at("dt")[i].get<double>();
      const BSplineCurve segment(bezierFrom(peer.input.at("segments")[i]), reached, last);
      const auto [left, right] = segment.split(0.5 * (reached + last));
      halves.insert(halves.end(), {left, right});
      reached = last;
    }
    ASSERT_EQ(halves.size(), peer.expect.at("n_segments_after_split").get<std::size_t>());
    std::vector<double> notC1;
    std::vector<int> originalJoins;
    for (std::size_t i = 0; i + 1 < halves.size(); ++i) {
      const JoinReport report = analyzeCurves(halves[i], halves[i + 1], withPreset("exact")).report;
      if (report.parametricOrder < 1) notC1.push_back(halves[i].last());
      if (i % 2 == 1) {
        originalJoins.push_back(report.order);
      } else {
        EXPECT_EQ(report.order, 4) << "halves of one segment";
      }
    }
    EXPECT_EQ(notC1, peer.expect.at("c1_discontinuous_at").get<std::vector<double>>());
    EXPECT_EQ(originalJoins, peer.expect.at("qa_G_at_original_joins").get<std::vector<int>>());
  }
}

TEST(PeerCases, ContactsInsideOfCurves) {
  FOR_PEER_CASES("contact") {
    SCOPED_TRACE(peer.id);
    ASSERT_TRUE(peer.input.at("reverse_second").get<bool>());
    const BezierCurve first = bezierFrom(peer.input.at("first"));
    const BezierCurve second = bezierFrom(peer.input.at("second")).reversed();
    const BezierCurve before = first.split(peer.input.at("t1")).first;
    const BezierCurve after = second.split(1.0 - peer.input.at("t2").get<double>()).second;
    const JoinReport report = join(before, after, withPreset("exact"));
    EXPECT_EQ(report.order, peer.expect.at("qa_contact_order").get<int>());
    EXPECT_NEAR(*report.sides[0].invariants.curvature, peer.expect.at("k1").get<double>(),
                peer.tolerance);
    EXPECT_NEAR(*report.sides[1].invariants.curvature, peer.expect.at("k2").get<double>(),
                peer.tolerance);
  }
}

}  // namespace
}  // namespace osculate::test
