"""The probe: points of curves by arc length, special points, both sides, without FreeCAD."""
import math
import unittest

import numpy as np

from osculate import Curve
from osculate.probing import SPECIAL_KINDS, CurveProbe
from support import (
    FreeCAD, Part, circle_then_line, cubic, full_circle, needs_freecad, quarter_circle, spline)


def arcs():
    """Quarters of circles of radius 10 and 20 with a common tangent as one curve."""
    root = 0.5 ** 0.5
    return Curve.bspline([(10, 0, 0), (10, 10, 0), (0, 10, 0), (-20, 10, 0), (-20, -10, 0)],
                         [0, 1, 2], [3, 2, 3], 2, [1, root, 1, root, 1])


def s_curve():
    return Curve.bezier([(0, 0, 0), (10, 20, 0), (20, -20, 0), (30, 0, 0)])


def kinds_of(probe):
    return [special.kind for special in probe.specials]


class ReadingTest(unittest.TestCase):
    def test_circle(self):
        probe = CurveProbe([quarter_circle(10.0)])
        self.assertAlmostEqual(probe.length, 5.0 * math.pi, delta=1e-11)
        for share in (0.1, 0.25, 0.5, 0.9):
            reading = probe.at(share * probe.length)
            angle = share * math.pi / 2
            np.testing.assert_allclose(reading.point, (10 * math.cos(angle), 10 * math.sin(angle),
                                                       0), atol=1e-9)
            self.assertAlmostEqual(reading.geometry.curvature, 0.1, delta=1e-12)
            centre = reading.point + reading.geometry.normal / reading.geometry.curvature
            np.testing.assert_allclose(centre, 0.0, atol=1e-10)
            self.assertEqual(len(reading.sides), 1)
            self.assertAlmostEqual(reading.share, share, delta=1e-12)

    @needs_freecad
    def test_helix(self):
        radius, pitch = 8.0, 10.0
        rise = pitch / (2 * math.pi)
        curve = Curve.from_edge(Part.makeHelix(pitch, 2 * pitch, radius).Edges[0])
        probe = CurveProbe([curve])
        geometry = probe.at(0.3 * probe.length).geometry
        square = radius ** 2 + rise ** 2
        # FreeCAD's helix is an approximation of one
        self.assertAlmostEqual(geometry.curvature, radius / square, delta=1e-3 * radius / square)
        self.assertAlmostEqual(geometry.torsion, rise / square, delta=1e-2 * rise / square)

    @needs_freecad
    def test_ellipse_has_its_vertices_at_its_axes(self):
        curve = Curve.from_edge(Part.Ellipse(FreeCAD.Vector(), 30, 10).toShape())
        probe = CurveProbe([curve])
        curvatures = {round(float(np.linalg.norm(probe.at(special.s).point)), 6):
                      probe.at(special.s).geometry.curvature for special in probe.specials
                      if special.kind == "vertex"}
        self.assertEqual(sorted(curvatures), [10.0, 30.0])
        self.assertAlmostEqual(curvatures[30.0], 30 / 10 ** 2, delta=1e-9)
        self.assertAlmostEqual(curvatures[10.0], 10 / 30 ** 2, delta=1e-9)

    def test_line_has_no_normal_and_no_torsion(self):
        reading = CurveProbe([Curve.bezier([(0, 0, 0), (0, 0, 5)])]).at(2.0)
        geometry = reading.geometry
        np.testing.assert_allclose(reading.point, (0, 0, 2), atol=1e-12)
        self.assertEqual((geometry.curvature, geometry.normal, geometry.torsion), (0.0, None, None))

    def test_beyond_the_ends_is_the_end(self):
        probe = CurveProbe([cubic()])
        np.testing.assert_allclose(probe.at(-3.0).point, cubic().poles[0], atol=1e-12)
        reading = probe.at(1e6)
        np.testing.assert_allclose(reading.point, cubic().poles[-1], atol=1e-12)
        self.assertEqual((reading.share, reading.kinds), (1.0, ("end",)))


class SpecialTest(unittest.TestCase):
    def test_of_an_s(self):
        probe = CurveProbe([s_curve()])
        self.assertEqual(kinds_of(probe), ["end", "vertex", "inflection", "vertex", "end"])
        reading = probe.at(probe.length * 0.5)
        self.assertEqual(reading.kinds, ("inflection",))
        np.testing.assert_allclose(reading.point, (15, 0, 0), atol=1e-9)
        self.assertIsNone(reading.geometry.normal)
        self.assertEqual(len(reading.sides), 1)

    def test_can_be_walked_both_ways(self):
        probe = CurveProbe([s_curve()])
        seen, special = [], probe.specials[0]
        while special is not None:
            seen.append(special.kind)
            special = probe.next_special(special.s, True)
        self.assertEqual(seen, kinds_of(probe))
        self.assertIsNone(probe.next_special(0.0, False))
        self.assertEqual(probe.next_special(probe.length, False).kind, "vertex")

    def test_all_kinds_are_named(self):
        probe = CurveProbe([arcs(), s_curve(), full_circle(3.0)])
        self.assertLessEqual(set(kinds_of(probe)), set(SPECIAL_KINDS))

    def test_periodic_curves(self):
        probe = CurveProbe([spline(6, periodic=True)])
        self.assertEqual(kinds_of(probe).count("closing"), 2)
        self.assertEqual(kinds_of(probe).count("knot"), 5)
        first, last = probe.at(0.0), probe.at(probe.length)
        np.testing.assert_allclose(first.point, last.point, atol=1e-10)
        self.assertEqual(len(first.sides), len(last.sides))


class SidesTest(unittest.TestCase):
    def test_both_of_a_knot_where_the_curvature_jumps(self):
        probe = CurveProbe([arcs()])
        knot = next(special for special in probe.specials if special.kind == "knot")
        before, after = probe.at(knot.s).sides
        self.assertAlmostEqual(before.geometry.curvature, 0.1, delta=1e-12)
        self.assertAlmostEqual(after.geometry.curvature, 0.05, delta=1e-12)
        self.assertEqual((before.t, after.t), (1.0, 0.0))
        # as a share of the length too, which is what a document keeps
        self.assertEqual(len(probe.at(knot.s / probe.length * probe.length).sides), 2)

    def test_one_of_a_knot_where_nothing_changes(self):
        probe = CurveProbe([full_circle(10.0)])
        for special in probe.specials:
            self.assertEqual(len(probe.at(special.s).sides), 1, special)

    def test_simple_knots_of_cubics_differ_in_the_torsion(self):
        probe = CurveProbe([spline(4)])
        for special in probe.specials:
            if special.kind == "knot":
                before, after = (side.geometry for side in probe.at(special.s).sides)
                self.assertAlmostEqual(before.curvature, after.curvature, delta=1e-9)
                self.assertGreater(abs(before.torsion - after.torsion), 1e-6)

    def test_of_a_join_of_two_curves(self):
        circle, line = circle_then_line()
        probe = CurveProbe([line.reversed(), circle])  # the first gives the direction
        self.assertEqual(kinds_of(probe), ["end", "join", "end"])
        reading = probe.at(probe.specials[1].s)
        before, after = reading.sides
        self.assertEqual((before.curve, after.curve), (0, 1))
        self.assertEqual(before.geometry.curvature, 0.0)
        self.assertAlmostEqual(after.geometry.curvature, 0.1, delta=1e-12)
        self.assertAlmostEqual(after.parameter, 1.0)  # the circle is travelled backwards
        np.testing.assert_allclose(after.geometry.tangent, (1, 0, 0), atol=1e-12)

    def test_of_a_closing_join_are_those_of_the_start(self):
        corner = [Curve.bezier([a, b]) for a, b in (
            ((0, 0, 0), (4, 0, 0)), ((4, 0, 0), (0, 3, 0)), ((0, 3, 0), (0, 0, 0)))]
        probe = CurveProbe(corner)
        for s in (0.0, probe.length):
            before, after = probe.at(s).sides
            np.testing.assert_allclose(before.geometry.tangent, (0, -1, 0), atol=1e-12)
            np.testing.assert_allclose(after.geometry.tangent, (1, 0, 0), atol=1e-12)

    def test_curves_apart_are_no_join(self):
        far = Curve.bezier([(100, 0, 0), (110, 0, 0)])
        probe = CurveProbe([quarter_circle(), far])
        self.assertEqual(kinds_of(probe), ["end"] * 4)
        reading = probe.at(probe.starts[1])
        self.assertEqual((len(reading.sides), reading.sides[0].curve), (1, 1))


class SegmentTest(unittest.TestCase):
    def test_construction_ends_at_the_point(self):
        for curve in (cubic(), arcs(), spline(5), spline(5, periodic=True), full_circle(2.0)):
            probe = CurveProbe([curve])
            for s in [*np.linspace(0, probe.length, 11), *(x.s for x in probe.specials)]:
                reading = probe.at(s)
                for side in reading.sides:
                    np.testing.assert_allclose(side.polygons()[-1][0], reading.point, atol=1e-9)
                    self.assertTrue(-1e-12 <= side.t <= 1.0 + 1e-12)

    def test_parameters_and_arc_lengths_belong_together(self):
        curves = [spline(5), spline(5, seed=2).reversed()]
        probe = CurveProbe(curves)
        for s in np.linspace(0.03, 0.97, 9) * probe.length:
            side = probe.at(s).sides[-1]
            self.assertAlmostEqual(probe.arc_length_of(side.curve, side.parameter), s, delta=1e-9)
            np.testing.assert_allclose(curves[side.curve].evaluate(side.parameter)[0],
                                       side.geometry.point, atol=1e-9)
        self.assertEqual(probe.arc_length_of(0, -5.0), probe.starts[0])


if __name__ == "__main__":
    unittest.main()
