// Conics as rational arcs: the same shape as OpenCASCADE's conics up to the fourth derivative.
#include "osculate/occt/conic_arc.h"

#include <numbers>

#include <gtest/gtest.h>
#include <Geom_Circle.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_Hyperbola.hxx>
#include <Geom_Line.hxx>
#include <Geom_Parabola.hxx>

#include "occt/edge_samples.h"
#include "support/errors.h"
#include "support/exact.h"

namespace osculate::test {
namespace {

gp_Ax2 randomPosition(Random& random, double size) {
  const Vector3 origin = random.vector(size);
  const Vector3 axis = random.direction();
  return {gp_Pnt(origin.x(), origin.y(), origin.z()), gp_Dir(axis.x(), axis.y(), axis.z())};
}

/// Tangent, curvature vector and so on agree at the same points, relative to their own size.
void expectSameShape(const Handle(Geom_Curve) & conic, double first, double last) {
  const EdgeCurve converted = curveFromEdge(edgeOf(conic, first, last));
  EXPECT_EQ(converted.errorMm, 0.0);
  const BSplineCurve& curve = converted.curve;
  for (int i = 0; i <= 16; ++i) {
    const double t = first + i * (last - first) / 16;
    const double u = edgeParameter(converted, false, t);
    const auto ours = arcLengthDerivatives(curve.derivatives(t, 4));
    const auto theirs = arcLengthDerivatives(occtDerivatives(*conic, u));
    EXPECT_LE((curve.evaluate(t) - toVector(conic->Value(u).XYZ())).norm(),
              4.0 * curve.poleError());
    for (std::size_t k = 1; k <= 4; ++k) {
      const double size = std::pow(theirs[2].norm(), static_cast<double>(k) - 1.0);
      EXPECT_LE((ours[k] - theirs[k]).norm(), 1e-12 * std::max(size, theirs[k].norm()))
          << "derivative " << k << " at " << t;
    }
  }
}

TEST(ConicArc, CircleHasTheShapeOfOcct) {
  Random random(1);
  for (int i = 0; i < 20; ++i) {
    const Handle(Geom_Circle) circle =
        new Geom_Circle(randomPosition(random, 1.0), random.uniform(1.0, 100.0));
    const double first = random.uniform(0.0, 2.0 * kPi);
    expectSameShape(circle, first, first + random.uniform(1.0, 2.0 * kPi));
  }
}

TEST(ConicArc, EllipseHasTheShapeOfOcct) {
  Random random(2);
  for (int i = 0; i < 20; ++i) {
    const double major = random.uniform(2.0, 5.0);
    const Handle(Geom_Ellipse) ellipse =
        new Geom_Ellipse(randomPosition(random, 1.0), major, random.uniform(1.0, major));
    const double first = random.uniform(0.0, 2.0 * kPi);
    expectSameShape(ellipse, first, first + random.uniform(1.0, 2.0 * kPi));
  }
}

TEST(ConicArc, HyperbolaHasTheShapeOfOcct) {
  Random random(3);
  for (int i = 0; i < 20; ++i) {
    const Handle(Geom_Hyperbola) hyperbola = new Geom_Hyperbola(
        randomPosition(random, 1.0), random.uniform(1.0, 5.0), random.uniform(1.0, 5.0));
    expectSameShape(hyperbola, random.uniform(-1.5, -0.5), random.uniform(0.5, 1.5));
  }
}

TEST(ConicArc, ParabolaAndLineHaveTheParameterOfOcctToo) {
  Random random(4);
  for (int i = 0; i < 20; ++i) {
    const gp_Ax2 position = randomPosition(random, 1.0);
    const Handle(Geom_Curve) curves[] = {new Geom_Parabola(position, random.uniform(0.2, 2.0)),
                                         new Geom_Line(position.Axis())};
    for (const auto& conic : curves) {
      const EdgeCurve converted = curveFromEdge(edgeOf(conic, -1.5, 2.5));
      EXPECT_EQ(converted.curve.first(), -1.5);
      EXPECT_EQ(converted.curve.last(), 2.5);
      for (const double t : {-1.5, -0.3, 1.0, 2.5}) {
        const auto theirs = occtDerivatives(*conic, t);
        const auto ours = converted.curve.derivatives(t, 4);
        for (std::size_t k = 0; k <= 4; ++k)
          EXPECT_LE((ours[k] - theirs[k]).norm(), 1e-13) << k;
      }
    }
  }
}

TEST(ConicArc, FullCircleIsFourQuartersThatCloseInTheSameBits) {
  const ConicAxes axes{{1.0, 2.0, 3.0}, {2.0, 0.0, 0.0}, {0.0, 2.0, 0.0}};
  for (const double first : {0.0, 1.0, -2.5, 5.0}) {
    const BSplineCurve circle = ellipticArc(axes, first, first + 2.0 * kPi);
    ASSERT_EQ(circle.spanCount(), 4);
    EXPECT_EQ(circle.endPoint(CurveEnd::kStart), circle.endPoint(CurveEnd::kEnd));
    EXPECT_EQ(circle.first(), first);
    EXPECT_EQ(circle.last(), first + 2.0 * kPi);
    for (int span = 0; span < 4; ++span) {
      EXPECT_NEAR(circle.segment(span).length(), 0.5 * kPi, 1e-15 * 8);
      EXPECT_NEAR(circle.segment(span).curve.weight(1), std::sqrt(0.5), 1e-15);
    }
  }
}

TEST(ConicArc, HasTheLeastNumberOfEqualPieces) {
  const ConicAxes axes{Vector3::Zero(), Vector3::UnitX(), Vector3::UnitY()};
  EXPECT_EQ(ellipticArc(axes, 0.0, 0.5 * kPi).spanCount(), 1);
  EXPECT_EQ(ellipticArc(axes, 1.0, 1.0 + 0.5 * kPi + 1e-6).spanCount(), 2);
  EXPECT_EQ(ellipticArc(axes, -1.0, -1.0 + 1e-3).spanCount(), 1);
  EXPECT_EQ(ellipticArc(axes, 0.0, 1.25 * kPi).spanCount(), 3);
  EXPECT_EQ(hyperbolicArc(axes, -1.0, 1.0).spanCount(), 2);
  EXPECT_EQ(parabolicArc(axes, -100.0, 100.0).spanCount(), 1);
}

TEST(ConicArc, ArcLongerThanATurnWindsOn) {
  const ConicAxes axes{Vector3::Zero(), Vector3::UnitX(), Vector3::UnitY()};
  const BSplineCurve arc = ellipticArc(axes, 0.0, 2.5 * kPi);
  EXPECT_EQ(arc.spanCount(), 5);
  EXPECT_LE((arc.endPoint(CurveEnd::kEnd) - Vector3::UnitY()).norm(), 1e-15);
}

TEST(ConicArc, RangeWithoutMeaningIsRefused) {
  const ConicAxes axes{Vector3::Zero(), Vector3::UnitX(), Vector3::UnitY()};
  EXPECT_ERROR(ellipticArc(axes, 0.0, 1e9), "edge: its range on a conic is too long");
  EXPECT_ERROR(hyperbolicArc(axes, -1e99, 1e99), "edge: its range on a conic is too long");
  EXPECT_ERROR(hyperbolicArc(axes, 0.0, 800.0), "poles: every coordinate must be finite");
}

/// u^first/first! - u^(first+2)/(first+2)! + ...: cosine for 0, sine for 1, to some 90 digits for
/// the angles here.
Real alternatingSeries(const Real& u, int first) {
  Real term = first == 0 ? Real(1) : u;
  Real sum(0);
  for (int k = first; k < 200; k += 2) {
    sum += term;
    term *= -u * u / Real((k + 1) * (k + 2));
  }
  return sum;
}
Real cosine(const Real& u) { return alternatingSeries(u, 0); }
Real sine(const Real& u) { return alternatingSeries(u, 1); }

/// The poles of an arc in 100 digits from its knots.
std::vector<Point<Real>> exactPoles(const ConicAxes& axes, const BSplineCurve& arc) {
  const auto at = [&](const Real& u, const Real& scale) -> Point<Real> {
    return exact<Real>(axes.centre) +
           (exact<Real>(axes.x) * cosine(u) + exact<Real>(axes.y) * sine(u)) / scale;
  };
  const std::vector<double>& knots = arc.data().knots.knots;
  std::vector<Point<Real>> poles{at(Real(knots[0]), Real(1))};
  for (std::size_t i = 1; i < knots.size(); ++i) {
    const Real a(knots[i - 1]);
    const Real b(knots[i]);
    poles.push_back(at((a + b) / 2, cosine((b - a) / 2)));
    poles.push_back(at(b, Real(1)));
  }
  return poles;
}

TEST(ConicArc, PoleErrorBoundsTheRoundingFarFromTheOriginToo) {
  Random random(5);
  double worst = 0.0;
  for (int i = 0; i < 200; ++i) {
    const double size = std::pow(10.0, random.uniform(-3.0, 5.0));
    const ConicAxes axes{random.vector(1e3), size * random.direction(), size * random.direction()};
    const double first = random.uniform(-7.0, 7.0);
    const BSplineCurve arc = ellipticArc(axes, first, first + random.uniform(0.01, 6.0));
    const auto poles = exactPoles(axes, arc);
    for (std::size_t k = 0; k < poles.size(); ++k) {
      const Vector3 pole = arc.data().poles.col(static_cast<Eigen::Index>(k));
      worst = std::max(worst, distance(poles[k], pole) / arc.poleError());
    }
    EXPECT_LE(arc.poleError(), 1e-13 * (axes.centre.norm() + size));
  }
  EXPECT_LE(worst, 1.0);
  EXPECT_GE(worst, 0.05) << "the bound says nothing";
}

}  // namespace
}  // namespace osculate::test
