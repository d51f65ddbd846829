"""osculate.match: what it meets, what it leaves alone, and how far it moves the curve."""
import unittest

import numpy as np

from osculate import Construction, Curve, analyze, match
from blend_tasks import planar_task, spatial_task
from support import (FreeCAD, Part, assert_same_in_threads, count_wakes_during, cubic,
                     full_circle, needs_freecad, quarter_circle, shared_file, spline)


def arrival():
    """A twisted arm that ends at the origin."""
    return spatial_task()[0]


def long_spline(spans=40, seed=3):
    """Begins 2 mm beside the end of `arrival`, and leaves it."""
    own = spline(spans, seed)
    knots = [0] + list(range(1, spans)) + [spans]
    return Curve.bspline(own.poles * 10 - own.poles[0] * 10 + (2, 0, 0), knots,
                         [4] + [1] * (spans - 1) + [4], 3)


def distances(before, after, count=2000):
    t = np.linspace(*before.parameter_range, count)
    return np.linalg.norm(after.evaluate(t)[:, 0] - before.evaluate(t)[:, 0], axis=1)


class ContactTest(unittest.TestCase):
    def test_all_orders_on_every_curve(self):
        curves = {"planar": planar_task()[1], "rational": spatial_task()[1],
                  "spline": long_spline(), "line": Curve.bezier([(2, 1, 0), (30, 10, 5)])}
        for name, curve in curves.items():
            for order in range(5):
                with self.subTest(curve=name, order=order):
                    result = match(arrival(), curve, order=order, ends=("end", "start"))
                    report, = result.reports
                    self.assertEqual(report.order, order)
                    self.assertEqual(report.preset, "exact")
                    self.assertEqual(report.ends, ("end", "start"))
                    self.assertEqual(len(result.beta[0]), order)
                    self.assertEqual(result.beta[1], ())

    def test_the_report_is_that_of_analyze(self):
        result = match(arrival(), long_spline(), order=3)
        own = analyze(arrival(), result.curve, order=3, tolerances="exact",
                      ends=result.reports[0].ends)
        self.assertEqual(result.reports[0].to_json(), own.to_json())

    def test_ends_are_the_nearest_or_those_given(self):
        turned = long_spline().reversed()
        near = match(arrival(), turned)
        self.assertEqual(near.reports[0].ends, ("end", "end"))
        self.assertEqual(near.change["end"], "end")
        far = match(arrival(), turned, ends=("end", "start"))
        self.assertEqual(far.change["end"], "start")

    def test_leaves_from_inside_the_first_curve(self):
        a = cubic()
        result = match(a, long_spline(), order=2, ends=((0.5, "forward"), "start"))
        np.testing.assert_allclose(result.curve.poles[0], a.evaluate(0.5)[0], atol=1e-12)
        self.assertEqual(result.reports[0].order, 2)

    def test_the_closing_join_of_one_curve(self):
        poles = np.array([(0, 0, 0), (40, -20, 0), (60, 30, 0), (0, 60, 0), (-50, 20, 0),
                          (-30, -10, 0), (0, 0, 0)])
        drop = Curve.bspline(poles, [0, 1, 2, 3, 4], [4, 1, 1, 1, 4], 3)
        for ends in (None, ("end", "start"), ("start", "end")):
            result = match(drop, drop, order=2, keep=0, ends=ends)
            self.assertEqual(result.reports[0].order, 2)
            self.assertEqual(result.change["end"], "end" if ends == ("start", "end") else "start")


class LeastChangeTest(unittest.TestCase):
    def test_far_poles_and_knots_keep_their_bits(self):
        before = long_spline(60)
        result = match(arrival(), before, order=3)
        changed = result.change["poles"]
        self.assertLess(changed, len(before.poles) // 2)
        np.testing.assert_array_equal(result.curve.poles[changed:], before.poles[changed:])
        np.testing.assert_array_equal(result.curve.knots, before.knots)
        self.assertTrue(np.any(result.curve.poles[changed - 1] != before.poles[changed - 1]))
        self.assertIsNone(result.change["kept"])

    def test_max_displacement_bounds_the_samples(self):
        for before in (long_spline(), spatial_task()[1]):
            for order in (0, 2, 4):
                result = match(arrival(), before, order=order, ends=("end", "start"))
                sampled = distances(before, result.curve).max()
                self.assertGreaterEqual(result.max_displacement_mm, sampled * (1 - 1e-9))
                self.assertLessEqual(result.max_displacement_mm, sampled * 1.01)

    def test_the_change_it_tells_of(self):
        before = long_spline()
        result = match(arrival(), before, order=2)
        change = result.change
        self.assertEqual(list(change), ["end", "poles", "spans", "range", "raised", "kept",
                                        "rms_mm", "parameter", "point", "moved"])
        self.assertEqual(change["range"], (0, change["spans"]))
        np.testing.assert_allclose(before.evaluate(change["parameter"])[0], change["point"],
                                   atol=1e-9)
        np.testing.assert_allclose(result.curve.evaluate(change["parameter"])[0], change["moved"],
                                   atol=1e-9)
        self.assertLess(change["rms_mm"], result.max_displacement_mm)
        beyond = np.linspace(change["range"][1], 40, 50)
        np.testing.assert_array_equal(result.curve.evaluate(beyond), before.evaluate(beyond))

    def test_given_numbers_are_met_and_cost_more(self):
        best = match(arrival(), long_spline(), order=3)
        for beta in ((1.3,), (None, 0.4), (0.9, 0.1, -0.2)):
            given = match(arrival(), long_spline(), order=3, beta=beta)
            for number, found in zip(beta, given.beta[0]):
                if number is not None:
                    self.assertAlmostEqual(found, number, delta=1e-9)
            self.assertEqual(given.reports[0].order, 3)
            self.assertGreaterEqual(given.change["rms_mm"], best.change["rms_mm"] * (1 - 1e-9))

    def test_more_freedom_never_costs_more(self):
        before = spatial_task()[1]
        costs = [match(arrival(), before, order=2, degree=degree,
                       ends=("end", "start")).change["rms_mm"] for degree in (7, 8, 10)]
        self.assertGreaterEqual(costs[0], costs[1] * (1 - 1e-9))
        self.assertGreaterEqual(costs[1], costs[2] * (1 - 1e-9))

    def test_keep_and_spans(self):
        before = spatial_task()[1]
        for keep in (0, 2, 4):
            result = match(arrival(), before, order=1, keep=keep, ends=("end", "start"))
            first, second = (curve.geometry(1, "left") for curve in (before, result.curve))
            np.testing.assert_allclose(second.point, first.point, atol=1e-12)
            if keep >= 2:
                self.assertAlmostEqual(second.curvature, first.curvature, delta=1e-12)
            self.assertEqual(result.change["kept"], keep)
        few = match(arrival(), long_spline(), order=2, spans=4)
        self.assertEqual(few.change["spans"], 4)
        self.assertGreater(few.change["rms_mm"] * 4,
                           match(arrival(), long_spline(), order=2).change["rms_mm"])

    def test_a_curve_that_meets_already_is_returned(self):
        a, b = cubic().split(0.4)
        result = match(a, b, order=4)
        np.testing.assert_array_equal(result.curve.poles, b.poles)
        self.assertEqual(result.max_displacement_mm, 0)
        self.assertEqual(result.change["spans"], 0)


class InvarianceTest(unittest.TestCase):
    def setUp(self):
        self.own = match(arrival(), long_spline(), order=3)

    def test_rigid_motion_and_scaling(self):
        turn = np.array([(0.36, 0.48, -0.8), (-0.8, 0.6, 0), (0.48, 0.64, 0.6)])
        for scale, shift in ((1, (5, -7, 11)), (1e-2, (0, 0, 0)), (1e3, (0, 0, 0))):
            def moved(curve):
                poles = scale * curve.poles @ turn.T + shift
                return Curve.bspline(poles, curve.knots, curve.multiplicities, curve.degree)
            result = match(moved(arrival()), moved(long_spline()), order=3)
            np.testing.assert_allclose(result.curve.poles, moved(self.own.curve).poles,
                                       atol=1e-6 * scale)
            self.assertAlmostEqual(result.max_displacement_mm,
                                   self.own.max_displacement_mm * scale, delta=1e-6 * scale)

    def test_direction_and_elevation_of_the_first_curve(self):
        for a in (arrival().reversed(), arrival().elevated(2)):
            result = match(a, long_spline(), order=3)
            np.testing.assert_allclose(result.curve.poles, self.own.curve.poles, atol=1e-7)

    def test_direction_of_the_second_curve(self):
        result = match(arrival(), long_spline().reversed(), order=3)
        np.testing.assert_allclose(result.curve.poles[::-1], self.own.curve.poles, atol=1e-7)

    def test_the_same_call_gives_the_same_curve_in_every_thread(self):
        assert_same_in_threads(self, lambda: match(arrival(), long_spline(), order=3).curve)

    def test_other_threads_run_meanwhile(self):
        def matches():
            for _ in range(20):
                match(arrival(), long_spline(), order=8)

        self.assertGreater(count_wakes_during(matches), 10)


class RecordTest(unittest.TestCase):
    def test_kinds(self):
        result = match(arrival(), long_spline())
        self.assertIsInstance(result, Construction)
        self.assertIsInstance(result.curve, Curve)
        self.assertEqual(result.curve.parameter_range, long_spline().parameter_range)
        self.assertGreater(result.max_displacement_mm, 0)

    def test_conics_and_periodic_curves(self):
        arc = match(arrival(), quarter_circle(), order=2, keep=2)
        self.assertEqual(arc.reports[0].order, 2)
        self.assertTrue(arc.curve.is_rational)
        full = match(arrival(), full_circle(), order=1, keep=0)
        self.assertEqual(full.reports[0].order, 1)
        ring = match(arrival(), spline(8, periodic=True), order=2)
        self.assertRegex(ring.warnings[0], "^opened: ")
        self.assertFalse(ring.curve.is_periodic)

    @needs_freecad
    def test_edges_of_freecad(self):
        line = Part.makeLine(FreeCAD.Vector(-30, 0, 0), FreeCAD.Vector(0, 0, 0))
        circle = Part.Edge(Part.Arc(FreeCAD.Vector(1, 0, 0), FreeCAD.Vector(10, 8, 0),
                                    FreeCAD.Vector(25, 12, 0)))
        result = match(line, circle, order=2)
        self.assertIsInstance(result.edge, Part.Edge)
        self.assertTrue(result.edge.isValid())
        start = result.edge.Curve.getD2(result.edge.FirstParameter)
        self.assertLess(start[0].Length, 1e-9)
        self.assertLess(start[2].cross(start[1]).Length / start[1].Length ** 3, 1e-9)

    @needs_freecad
    def test_edges_of_a_real_part(self):
        shape = Part.Shape()
        shape.read(str(shared_file("data/Fuselage_guides.brep")))
        edges = shape.Edges
        self.assertGreater(len(edges), 3)
        for first, second in zip(edges[:6], edges[1:7]):
            result = match(first, second, order=2)
            self.assertGreaterEqual(result.reports[0].order, 2)


if __name__ == "__main__":
    unittest.main()
