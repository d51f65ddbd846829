// Curves of other libraries' test suites, evaluated and cut as they are there.
#include <gtest/gtest.h>

#include "support/errors.h"
#include "support/peer_cases.h"

namespace osculate::test {
namespace {

void expectPoles(const nlohmann::json& expected, const BezierCurve& found, const PeerCase& peer) {
  ASSERT_EQ(expected.size(), static_cast<std::size_t>(found.degree()) + 1);
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const Vector3 pole = vectorFrom(expected[i]);
    EXPECT_LE((found.pole(static_cast<int>(i)) - pole).norm(), toleranceOf(peer, pole.norm()))
        << "pole " << i;
  }
}

void expectDerivatives(const nlohmann::json& expected, const std::vector<Vector3>& found,
                       const PeerCase& peer) {
  for (const auto& [order, value] : expected.items()) {
    const Vector3 derivative = vectorFrom(value);
    EXPECT_LE((found[std::stoul(order)] - derivative).norm(), toleranceOf(peer, derivative.norm()))
        << "derivative " << order;
  }
}

TEST(PeerCases, BezierPoints) {
  FOR_PEER_CASES("bezier_eval") {
    SCOPED_TRACE(peer.id);
    const Vector3 expected = vectorFrom(peer.expect.at("point"));
    const Vector3 found = bezierFrom(peer.input.at("curve")).evaluate(peer.input.at("t"));
    EXPECT_LE((found - expected).norm(), toleranceOf(peer, expected.norm()));
  }
}

TEST(PeerCases, BezierDerivativesAndCleanErrorsForPolesAtInfinity) {
  FOR_PEER_CASES("bezier_deriv") {
    SCOPED_TRACE(peer.id);
    const auto& curve = peer.input.at("curve");
    if (curve.value("homogeneous", false)) {  // inner weights are zero
      EXPECT_ERROR(bezierFrom(curve), "must be finite");
      continue;
    }
    expectDerivatives(peer.expect.at("derivs"),
                      bezierFrom(curve).derivatives(peer.input.at("t"), 3), peer);
  }
}

TEST(PeerCases, BSplinePoints) {
  FOR_PEER_CASES("bspline_eval") {
    SCOPED_TRACE(peer.id);
    const Vector3 expected = vectorFrom(peer.expect.at("point"));
    const Vector3 found =
        BSplineCurve(splineDataFrom(peer.input.at("curve"))).evaluate(peer.input.at("u"));
    EXPECT_LE((found - expected).norm(), toleranceOf(peer, expected.norm()));
  }
}

TEST(PeerCases, BSplineDerivatives) {
  FOR_PEER_CASES("bspline_deriv") {
    SCOPED_TRACE(peer.id);
    const BSplineCurve curve(splineDataFrom(peer.input.at("curve")));
    expectDerivatives(peer.expect.at("derivs"), curve.derivatives(peer.input.at("u"), 3), peer);
  }
}

TEST(PeerCases, BezierSplits) {
  FOR_PEER_CASES("bezier_split") {
    SCOPED_TRACE(peer.id);
    const auto [left, right] = bezierFrom(peer.input.at("curve")).split(peer.input.at("t"));
    expectPoles(peer.expect.at("left"), left, peer);
    expectPoles(peer.expect.at("right"), right, peer);
  }
}

TEST(PeerCases, BezierElevations) {
  FOR_PEER_CASES("bezier_elevate") {
    SCOPED_TRACE(peer.id);
    expectPoles(peer.expect.at("poles"),
                bezierFrom(peer.input.at("curve")).elevated(peer.input.at("by")), peer);
  }
}

TEST(PeerCases, BezierSegments) {
  FOR_PEER_CASES("bezier_segment") {
    SCOPED_TRACE(peer.id);
    const BezierCurve curve = bezierFrom(peer.input.at("curve"));
    expectPoles(peer.expect.at("poles"), curve.segment(peer.input.at("a"), peer.input.at("b")),
                peer);
  }
}

TEST(PeerCases, BSplinesToBezierSegments) {
  FOR_PEER_CASES("to_bezier") {
    SCOPED_TRACE(peer.id);
    const BSplineCurve curve(splineDataFrom(peer.input.at("curve")));
    const bool own = peer.expect.contains("breaks");
    const std::vector<double> breaks = peer.expect.at(own ? "breaks" : "qa_breaks");
    ASSERT_EQ(static_cast<std::size_t>(curve.spanCount()) + 1, breaks.size());
    for (int i = 0; i < curve.spanCount(); ++i) {
      const BezierSegment segment = curve.segment(i);
      const double size = std::max(1.0, curve.data().poles.colwise().norm().maxCoeff());
      EXPECT_NEAR(segment.first, breaks[static_cast<std::size_t>(i)], 1e-15);
      EXPECT_NEAR(segment.last, breaks[static_cast<std::size_t>(i) + 1], 1e-15);
      EXPECT_LE((segment.curve.pole(0) - curve.evaluate(segment.first)).norm(), 1e-15 * size);
    }
  }
}

TEST(PeerCases, PeriodicBSplinesCutOpen) {
  FOR_PEER_CASES("periodic_to_bezier") {
    SCOPED_TRACE(peer.id);
    const auto& curve = peer.input.at("curve");
    BSplineData data = splineDataFrom(curve);
    // the source continues the knots by `degree` on both sides; ours are those of one period
    auto& knots = data.knots;
    knots.knots = {knots.knots.begin() + data.degree, knots.knots.end() - data.degree};
    knots.multiplicities.assign(knots.knots.size(), 1);
    data.periodic = true;
    const BSplineCurve closed(data);
    EXPECT_EQ(closed.data().poles.cols(), peer.expect.at("n_poles").get<int>());
    EXPECT_EQ(closed.trimmed(1.0, 8.0).data().poles.cols(),
              peer.expect.at("poles_after_split_at_knot_1").get<int>());
    EXPECT_EQ(closed.trimmed(6.5, 13.5).data().poles.cols(),
              peer.expect.at("poles_after_split_at_6_5").get<int>());
  }
}

}  // namespace
}  // namespace osculate::test
