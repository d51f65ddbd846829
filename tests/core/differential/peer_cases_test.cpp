// Curvatures, frames and lengths of other libraries' test suites.
#include <gtest/gtest.h>

#include "osculate/differential/arc_length.h"
#include "osculate/differential/point_geometry.h"
#include "support/peer_cases.h"

namespace osculate::test {
namespace {

TEST(PeerCases, CurvaturesOfBezierCurves) {
  FOR_PEER_CASES("curvature") {
    SCOPED_TRACE(peer.id);
    const BSplineCurve curve(bezierFrom(peer.input.at("curve")));
    const PointGeometry found = geometryAt(curve, peer.input.at("t"));
    const double expected = peer.expect.at("curvature");
    EXPECT_NEAR(found.invariants.curvature.value(), expected, toleranceOf(peer, expected));
  }
}

TEST(PeerCases, CurvaturesOfBSplines) {
  FOR_PEER_CASES("curvature_bspline") {
    SCOPED_TRACE(peer.id);
    const BSplineCurve curve(splineDataFrom(peer.input.at("curve")));
    const double expected = peer.expect.at("curvature");
    EXPECT_NEAR(geometryAt(curve, peer.input.at("u")).invariants.curvature.value(), expected,
                toleranceOf(peer, expected));
  }
}

TEST(PeerCases, FrenetFrames) {
  FOR_PEER_CASES("frenet") {
    SCOPED_TRACE(peer.id);
    const BSplineCurve curve(splineDataFrom(peer.input.at("curve")));
    const FrenetFrame frame = geometryAt(curve, peer.input.at("u")).frame;
    EXPECT_LE((frame.tangent - vectorFrom(peer.expect.at("T"))).norm(), peer.tolerance);
    EXPECT_LE((frame.normal.value() - vectorFrom(peer.expect.at("N"))).norm(), peer.tolerance);
    EXPECT_LE((frame.binormal.value() - vectorFrom(peer.expect.at("B"))).norm(), peer.tolerance);
  }
}

TEST(PeerCases, Lengths) {
  FOR_PEER_CASES("length") {
    SCOPED_TRACE(peer.id);
    const BSplineCurve curve(splineDataFrom(peer.input.at("curve")));
    const double expected = peer.expect.at("length");
    EXPECT_NEAR(length(curve), expected, toleranceOf(peer, expected));
  }
}

}  // namespace
}  // namespace osculate::test
