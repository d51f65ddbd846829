"""osculate.nu_spline: interpolation, tension, ends, peers and bad input."""
import math
import unittest

import numpy as np

import osculate
from osculate import nu_spline
from support import needs_freecad

try:
    import FreeCAD
    import Part
except ImportError:
    FreeCAD = Part = None

POINTS = np.array([(0, 0, 0), (4, 1, 0), (5, 4, 2), (9, 5, 2), (12, 1, 0), (13, 0, -1)], float)
NAN, INFINITE = float("nan"), float("inf")


def jump(curve, t):
    """P''(t+) - P''(t-)."""
    return curve.evaluate(t, 2, side="right")[2] - curve.evaluate(t, 2, side="left")[2]


class NuSplineTest(unittest.TestCase):
    def test_interpolates_and_is_g2(self):
        curve = nu_spline(POINTS, tension=[0, 3, 0, 8, 2, 0])
        self.assertEqual(curve.multiplicities.tolist(), [4, 2, 1, 2, 2, 4])
        np.testing.assert_allclose(curve.evaluate(curve.knots)[:, 0], POINTS, atol=1e-13)
        for report in osculate.analyze_edge(curve, order=2, tolerances="exact"):
            self.assertEqual(report.order, 2)

    def test_second_derivative_jumps_by_nu(self):
        parameters = [0, 1, 3, 3.5, 5, 9]
        tension = np.array([0, 3, 1, 8, 2, 0])
        curve = nu_spline(POINTS, tension=tension, parameters=parameters)
        steps = np.diff(parameters)
        nu = tension[1:-1] * 0.5 * (1 / steps[:-1] + 1 / steps[1:])
        for t, expected in zip(parameters[1:-1], nu):
            np.testing.assert_allclose(jump(curve, t), expected * curve.evaluate(t, 1)[1],
                                       atol=1e-11)

    def test_unit_steps_take_the_tension_for_nu(self):
        curve = nu_spline(POINTS, tension=2.5, parameters=range(6))
        np.testing.assert_allclose(jump(curve, 3), 2.5 * curve.evaluate(3, 1)[1], atol=1e-12)
        start = curve.evaluate(0, 2)
        np.testing.assert_allclose(start[2], 2.5 * start[1], atol=1e-12)

    def test_tension_shortens_towards_the_polygon(self):
        polygon = np.linalg.norm(np.diff(POINTS, axis=0), axis=1).sum()
        lengths = [nu_spline(POINTS, tension=tension).length() for tension in (0, 5, 100, 1e6)]
        self.assertEqual(lengths, sorted(lengths, reverse=True))
        self.assertGreater(lengths[0], polygon + 0.1)
        self.assertAlmostEqual(lengths[-1], polygon, delta=1e-6)

    def test_scaling_the_model_scales_the_curve(self):
        for parameters in (None, "chordal", "uniform", range(6)):
            curve = nu_spline(POINTS, tension=4, parameters=parameters)
            large = nu_spline(1000 * POINTS, tension=4, parameters=parameters)
            np.testing.assert_allclose(large.poles, 1000 * curve.poles, rtol=1e-12, atol=1e-9)

    def test_closed(self):
        curve = nu_spline(POINTS, tension=[0, 1, 0, 0, 2, 0], closed=True)
        self.assertTrue(curve.is_periodic)
        self.assertEqual(curve.multiplicities.tolist(), [1, 2, 1, 1, 2, 1, 1])
        np.testing.assert_allclose(curve.evaluate(curve.knots[:-1])[:, 0], POINTS, atol=1e-13)
        reports = osculate.analyze_edge(curve, order=2, tolerances="exact")
        self.assertEqual([report.order for report in reports], [2] * 6)

    def test_ends(self):
        curve = nu_spline(POINTS, parameters=range(6), ends=((0, 0, 2), "bessel"))
        speed = np.linalg.norm(POINTS[1] - POINTS[0])
        np.testing.assert_allclose(curve.evaluate(0, 1)[1], (0, 0, 2 * speed), atol=1e-12)
        derivative = 1.5 * POINTS[5] - 2 * POINTS[4] + 0.5 * POINTS[3]
        np.testing.assert_allclose(curve.evaluate(5, 1)[1], derivative, atol=1e-12)
        natural = nu_spline(POINTS)
        self.assertAlmostEqual(natural.geometry(0).curvature, 0, delta=1e-14)
        self.assertEqual(nu_spline(POINTS, ends=("natural", "natural")), natural)

    def test_spacing(self):
        points = [(0, 0, 0), (4, 0, 0), (4, 9, 0), (5, 9, 0)]
        np.testing.assert_allclose(nu_spline(points).knots, np.array([0, 2, 5, 6]) * 14 / 6)
        self.assertEqual(nu_spline(points, parameters="chordal").knots.tolist(), [0, 4, 13, 14])
        self.assertEqual(nu_spline(points, parameters="centripetal"), nu_spline(points))

    def test_a_hundred_thousand_points(self):
        angle = np.linspace(0, 400, 100_000)
        points = np.column_stack((angle * np.cos(angle), angle * np.sin(angle), angle))
        curve = nu_spline(points, tension=1)
        np.testing.assert_allclose(curve.evaluate(curve.knots[::999])[:, 0], points[::999],
                                   atol=1e-9)

    def test_bad_input(self):
        def assert_error(kind, pattern, points=POINTS, **keywords):
            with self.assertRaisesRegex(kind, pattern):
                nu_spline(points, **keywords)

        assert_error(ValueError, r"^points: must have the shape", [(0, 0), (1, 1)])
        assert_error(TypeError, "^points: ", "points")
        assert_error(ValueError, "^points: at least 2 are needed", POINTS[:1])
        assert_error(ValueError, "^points: at least 3 .* closed", POINTS[:2], closed=True)
        assert_error(ValueError, "^points: every coordinate", [(0, 0, 0), (NAN, 0, 0)])
        assert_error(ValueError, r"^points: points\[1\] and points\[2\] are one point",
                     [(0, 0, 0), (1, 0, 0), (1, 0, 0)])
        assert_error(ValueError, "returns to its first point by itself",
                     [*POINTS, POINTS[0]], closed=True)
        for bad in (-1, NAN, INFINITE, [0, 1, 2, -3, 4, 5]):
            assert_error(ValueError, "^tension: must be finite and >= 0", tension=bad)
        assert_error(ValueError, "^tension: one number, or one for each of the 6", tension=[1, 2])
        assert_error(ValueError, "^tension: ", tension=[[1, 2]])
        assert_error(TypeError, "^tension: ", tension="tight")
        assert_error(ValueError, "^parameters: 6 are needed", parameters=[0, 1])
        assert_error(ValueError, "^parameters: 7 are needed", parameters=range(6), closed=True)
        assert_error(ValueError, "^parameters: .*increase", parameters=[0, 1, 1, 2, 3, 4])
        assert_error(ValueError, "^parameters: there are none", parameters=np.zeros(0))
        assert_error(ValueError, "^parameters: must be 'centripetal'", parameters="chord")
        assert_error(ValueError, "^ends: each must be 'natural', 'bessel'", ends="clamped")
        assert_error(ValueError, "^ends: a tangent must be finite and not zero",
                     ends=((0, 0, 0), "natural"))
        assert_error(ValueError, "^ends: a tangent has three", ends=((1, 0), "natural"))
        assert_error(ValueError, "^ends: must be a pair", ends=("natural",))
        assert_error(TypeError, "^ends: must be 'natural'", ends=None)
        assert_error(TypeError, "^ends: ", ends=(None, "natural"))
        assert_error(ValueError, "^ends: a closed curve has none", ends="bessel", closed=True)
        assert_error(TypeError, "^closed: must be True or False", closed=1)


@needs_freecad
class PeerTest(unittest.TestCase):
    """Without tension: GeomAPI_Interpolate of OpenCASCADE, which is a C2 cubic too."""

    def test_given_tangents(self):
        parameters = [0, 1, 3, 3.5, 5, 9]
        first, last = FreeCAD.Vector(1, 2, 0), FreeCAD.Vector(2, -1, 1)
        peer = Part.BSplineCurve()
        peer.interpolate(Points=[FreeCAD.Vector(*p) for p in POINTS], Parameters=parameters,
                         InitialTangent=first, FinalTangent=last, Scale=False)
        speeds = [np.linalg.norm(POINTS[1] - POINTS[0]) / 1,
                  np.linalg.norm(POINTS[5] - POINTS[4]) / 4]
        curve = nu_spline(POINTS, parameters=parameters,
                          ends=(np.array(first) / speeds[0], np.array(last) / speeds[1]))
        np.testing.assert_allclose(curve.poles, [tuple(p) for p in peer.getPoles()], atol=1e-12)

    def test_closed(self):
        """The middle of nine turns: OpenCASCADE's own periodic interpolation closes only C1."""
        parameters = np.array([0, 1, 3, 3.5, 5, 9, 10])
        turns = [parameters[:-1] + 10 * turn for turn in range(9)]
        peer = Part.BSplineCurve()
        peer.interpolate(Points=[FreeCAD.Vector(*p) for p in np.tile(POINTS, (9, 1))],
                         Parameters=np.concatenate(turns).tolist(),
                         InitialTangent=FreeCAD.Vector(1, 0, 0),
                         FinalTangent=FreeCAD.Vector(1, 0, 0), Scale=False)
        curve = nu_spline(POINTS, parameters=parameters, closed=True)
        for t in np.linspace(0, 10, 101):
            np.testing.assert_allclose(curve.evaluate(t)[0], tuple(peer.value(t + 40)), atol=1e-10)

    def test_vectors_and_edges(self):
        vectors = [FreeCAD.Vector(*p) for p in POINTS]
        self.assertEqual(nu_spline(vectors), nu_spline(POINTS))
        edge = nu_spline(vectors, tension=3, closed=True).to_edge()
        self.assertTrue(edge.isValid() and edge.isClosed())
        for vector in vectors:
            self.assertLess(edge.distToShape(Part.Vertex(vector))[0], 1e-9)
        self.assertTrue(math.isfinite(edge.Length))


if __name__ == "__main__":
    unittest.main()
