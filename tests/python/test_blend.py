"""osculate.blend: orders, freedoms, fairness, invariance and the record."""
import threading
import time
import unittest
from collections import Counter

import numpy as np

from osculate import Construction, Curve, JoinReport, analyze, blend
from blend_tasks import mirrored_task, pieces_task, planar_task, spatial_task
from support import FreeCAD, Part, assert_same_in_threads, needs_freecad, quarter_circle

END_TO_START = ("end", "start")


def transformed(curve, matrix, offset):
    return Curve.bezier(curve.poles @ np.transpose(matrix) + offset, curve.weights)


def traced(curve, count=200):
    """(count, 3): points at equal shares of the length."""
    shares = np.linspace(0, curve.length() * (1 - 1e-12), count)
    return np.array([curve.evaluate(curve.parameter_at_length(s))[0] for s in shares])


class OrdersTest(unittest.TestCase):
    def assert_meets(self, construction, orders):
        self.assertEqual(construction.warnings, ())
        for report, order in zip(construction.reports, orders, strict=True):
            self.assertIsInstance(report, JoinReport)
            self.assertEqual((report.order, report.requested_order), (order, order))
            self.assertEqual(report.preset, "exact")

    def test_equal_orders(self):
        for task in (pieces_task(), mirrored_task()):
            for order in range(5):
                result = blend(*task, order=order)
                self.assert_meets(result, (order, order))
                self.assertEqual(result.curve.degree, 2 * order + 1)

    def test_equal_orders_of_plain_blends(self):
        for task in (planar_task(), spatial_task()):
            for order in range(5):
                self.assert_meets(blend(*task, order=order, fairness=None), (order, order))

    def test_rounding_that_leaves_an_order_open_is_said(self):
        """At the highest orders double poles cannot carry the tolerances of `exact`."""
        result = blend(*planar_task(), order=8)
        ends = [name for name, report in zip(("first", "second"), result.reports)
                if report.order < 8]
        self.assertTrue(ends)
        self.assertEqual([warning.split(" end ")[0] for warning in result.warnings
                          if warning.startswith("rounding: ")],
                         [f"rounding: at the {name}" for name in ends])

    def test_mixed_orders(self):
        for orders in ((0, 3), (3, 1), (2, 3), [4, 2], (4, 0)):
            result = blend(*pieces_task(), order=orders)
            self.assert_meets(result, orders)
            self.assertEqual(result.curve.degree, sum(orders) + 1)
            self.assertEqual(tuple(map(len, result.beta)), tuple(orders))

    def test_the_default_is_g3(self):
        self.assert_meets(blend(*planar_task()), (3, 3))

    def test_the_reports_are_those_of_analyze(self):
        first, second = spatial_task()
        result = blend(first, second, order=(2, 3))
        for report, curves, order in ((result.reports[0], (first, result.curve), 2),
                                      (result.reports[1], (result.curve, second), 3)):
            own = analyze(*curves, order=order, ends=END_TO_START, tolerances="exact")
            self.assertEqual(report.to_json(), own.to_json())


class EndsTest(unittest.TestCase):
    def ends(self, construction):
        return construction.reports[0].ends[0], construction.reports[1].ends[1]

    def test_the_nearest_ends_whatever_the_directions(self):
        first, second = planar_task()
        for a, end_a in ((first, "end"), (first.reversed(), "start")):
            for b, end_b in ((second, "start"), (second.reversed(), "end")):
                result = blend(a, b, order=2)
                self.assertEqual(self.ends(result), (end_a, end_b))
                self.assertEqual([report.order for report in result.reports], [2, 2])

    def test_given_ends(self):
        first, second = planar_task()
        result = blend(first, second, order=1, ends=["start", "end"])
        np.testing.assert_array_equal(result.curve.poles[[0, -1]],
                                      [first.poles[0], second.poles[-1]])
        self.assertEqual(self.ends(result), ("start", "end"))
        self.assertEqual([report.order for report in result.reports], [1, 1])

    def test_parameters_inside_in_either_direction(self):
        """The kept parts and the blend are what blending the split curves gives."""
        first, second = planar_task()
        result = blend(first, second, order=2, ends=((0.6, "forward"), (0.3, "backward")))
        split = blend(first.split(0.6)[0], second.split(0.3)[1], order=2, ends=END_TO_START)
        np.testing.assert_allclose(result.curve.poles, split.curve.poles, atol=1e-3)
        back = blend(first, second, order=2, ends=((0.6, "backward"), "start"))
        start, tangent = back.curve.evaluate(0, 1)
        point, derivative = first.evaluate(0.6, 1)
        np.testing.assert_allclose(start, point, atol=1e-12)
        self.assertAlmostEqual(tangent @ derivative / np.linalg.norm(tangent)
                               / np.linalg.norm(derivative), -1, delta=1e-12)
        self.assertEqual([report.order for report in back.reports], [2, 2])

    def test_one_open_curve_is_closed(self):
        curve = Curve.bezier([(0, 0, 0), (30, -10, 0), (40, 40, 0), (0, 30, 0)])
        for twice in ((curve, curve), (curve, Curve.bezier(curve.poles))):
            result = blend(*twice, order=2)
            self.assertEqual(self.ends(result), END_TO_START)
            np.testing.assert_array_equal(result.curve.poles[[0, -1]], curve.poles[[-1, 0]])
            self.assertEqual([report.order for report in result.reports], [2, 2])


class FreedomsTest(unittest.TestCase):
    def test_given_numbers_are_kept(self):
        given = ((0.9, None, -2.0), (None, 0.5))
        result = blend(*planar_task(), beta=given)
        self.assertAlmostEqual(result.beta[0][0], 0.9, delta=1e-12)
        self.assertAlmostEqual(result.beta[0][2], -2.0, delta=1e-10)
        self.assertAlmostEqual(result.beta[1][1], 0.5, delta=1e-11)

    def test_beta_is_the_speed_by_the_chord(self):
        """From the finished poles: s' = |Q'|, s'' = Q'.Q''/|Q'| at each end, into the curve."""
        result = blend(*spatial_task(), order=3)
        chord = np.linalg.norm(result.curve.poles[-1] - result.curve.poles[0])
        for curve, beta in zip((result.curve, result.curve.reversed()), result.beta):
            first, second = curve.evaluate(0, 2)[1:]
            speed = np.linalg.norm(first)
            self.assertAlmostEqual(speed / chord, beta[0], delta=1e-10)
            self.assertAlmostEqual(first @ second / speed / chord, beta[1], delta=1e-9)

    def test_all_given_numbers_leave_no_choice(self):
        given = ((1.1, 0.3), (0.8, -0.4))
        results = [blend(*planar_task(), order=2, beta=given, fairness=fairness)
                   for fairness in ("mvc", "bending", None)]
        for result in results[1:]:
            np.testing.assert_array_equal(result.curve.poles, results[0].curve.poles)
        for result in results:  # nothing was free
            self.assertIsNone(result.energy["objective"])

    def test_an_end_without_given_numbers(self):
        result = blend(*planar_task(), order=2, beta=(None, (0.7,)))
        self.assertAlmostEqual(result.beta[1][0], 0.7, delta=1e-12)

    def test_no_fairness_takes_the_plain_numbers(self):
        result = blend(*spatial_task(), order=(3, 2), fairness=None)
        np.testing.assert_allclose(result.beta[0], (1, 0, 0), atol=1e-12)
        np.testing.assert_allclose(result.beta[1], (1, 0), atol=1e-12)
        self.assertIsNone(result.energy["objective"])

    def test_symmetric_numbers(self):
        result = blend(*spatial_task(), order=(3, 2), symmetric=True)
        np.testing.assert_allclose(result.beta[0][:2], result.beta[1], rtol=1e-9)
        free = blend(*spatial_task(), order=(3, 2))
        self.assertGreater(abs(free.beta[0][0] - free.beta[1][0]), 1e-3)
        self.assertLessEqual(free.energy["objective"], result.energy["objective"] + 1e-5)

    def test_a_symmetric_task_has_equal_numbers(self):
        result = blend(*mirrored_task(), order=2)
        np.testing.assert_allclose(result.beta[0], result.beta[1], rtol=0.02, atol=0.02)

    def test_a_higher_degree_is_never_worse(self):
        for task in (planar_task(), spatial_task()):
            objectives = [blend(*task, order=2, degree=degree).energy["objective"]
                          for degree in (None, 5, 6, 8)]
            self.assertEqual(objectives[0], objectives[1])
            self.assertLessEqual(objectives[2], objectives[0] + 1e-6)
            self.assertLessEqual(objectives[3], objectives[0] + 1e-6)

    def test_a_higher_degree_keeps_the_orders(self):
        result = blend(*spatial_task(), order=3, degree=9)
        self.assertEqual(result.curve.degree, 9)
        self.assertEqual([report.order for report in result.reports], [3, 3])

    def test_raising_the_degree_alone_keeps_the_curve(self):
        task = spatial_task()
        low, high = (blend(*task, order=2, degree=n, fairness=None).curve for n in (5, 8))
        np.testing.assert_allclose(high.poles, low.elevated(3).poles, atol=1e-10)


class FairnessTest(unittest.TestCase):
    def test_a_straight_gap_is_the_straight_line(self):
        first = Curve.bezier([(0, 0, 0), (10, 10, 5)])
        second = Curve.bezier([(30, 30, 15), (50, 50, 25)])
        for order in range(5):
            result = blend(first, second, order=order)
            self.assertEqual([report.order for report in result.reports], [order, order])
            points = result.curve.evaluate(np.linspace(0, 1, 50))[:, 0]
            np.testing.assert_allclose(points - np.outer(points[:, 0], (1, 1, 0.5)), 0, atol=1e-9)
            self.assertTrue(np.all(np.diff(points[:, 0]) > 0))
            self.assertAlmostEqual(result.energy["length_mm"], 30, delta=1e-9)

    def test_a_quarter_circle_is_completed(self):
        """Closed forms of the arc: bending (pi/2)^2, mvc (pi/2)^4, as kappa is constant."""
        first = quarter_circle()
        second = Curve.bezier([(-10, 0, 0), (-10, -10, 0), (0, -10, 0)], first.weights)
        result = blend(first, second, order=4, ends=END_TO_START)
        points = result.curve.evaluate(np.linspace(0, 1, 50))[:, 0]
        np.testing.assert_allclose(np.linalg.norm(points, axis=1), 10, atol=1e-4)
        energy = result.energy
        self.assertAlmostEqual(energy["length_mm"], 5 * np.pi, delta=1e-4)
        self.assertAlmostEqual(energy["bending"], (np.pi / 2) ** 2, delta=1e-4)
        self.assertAlmostEqual(energy["mvc"], (np.pi / 2) ** 4, delta=1e-2)

    def test_energy_names_and_what_was_minimised(self):
        for fairness, name in (("mvc", "mvc"), ("bending", "bending")):
            energy = blend(*planar_task(), order=2, fairness=fairness).energy
            self.assertEqual(list(energy), ["bending", "mvc", "speed", "objective", "length_mm"])
            self.assertAlmostEqual(energy["objective"],
                                   np.log(energy[name] + 1e-12) + 0.3 * energy["speed"], delta=0.01)

    def test_each_fairness_is_best_by_its_own_measure(self):
        mvc, bending, plain = (blend(*planar_task(), order=3, fairness=fairness).energy
                               for fairness in ("mvc", "bending", None))

        def objective(energy, name):
            return np.log(energy[name]) + 0.3 * energy["speed"]

        for other in (bending, plain):
            self.assertLess(objective(mvc, "mvc"), objective(other, "mvc"))
        for other in (mvc, plain):
            self.assertLess(objective(bending, "bending"), objective(other, "bending"))

    def test_cramped_ends_are_named(self):
        result = blend(*planar_task(), order=2, beta=((0.05,), ()))
        self.assertEqual(len(result.warnings), 1)
        self.assertRegex(result.warnings[0], "^cramped: at the first end")


class InvarianceTest(unittest.TestCase):
    def assert_same_trace(self, curve, expected):
        np.testing.assert_allclose(traced(curve), expected, rtol=0,
                                   atol=1e-2 * np.linalg.norm(expected[-1] - expected[0]))

    def test_scaling_and_rigid_motion(self):
        first, second = spatial_task()
        own = blend(first, second)
        c, s = np.cos(0.7), np.sin(0.7)
        turn = np.array([(c, -s, 0), (s, c, 0), (0, 0, 1)])[:, [1, 2, 0]]
        for factor in (1e-2, 1, 1e3):
            offset = factor * np.array([30, -50, 70])
            moved = blend(*(transformed(curve, factor * turn, offset) for curve in (first, second)))
            self.assert_same_trace(moved.curve, traced(own.curve) @ (factor * turn.T) + offset)
            self.assertAlmostEqual(moved.energy["objective"], own.energy["objective"], delta=1e-4)

    def test_swapped_curves_trace_the_reversed_curve(self):
        first, second = spatial_task()
        own, back = blend(first, second), blend(second, first)
        self.assert_same_trace(back.curve.reversed(), traced(own.curve))
        for number, other in zip(own.beta, reversed(back.beta)):
            self.assertAlmostEqual(number[0], other[0], delta=1e-2)

    def test_elevation_and_direction_of_the_inputs(self):
        first, second = spatial_task()
        expected = traced(blend(first, second).curve)
        self.assert_same_trace(blend(first.elevated(2), second.elevated()).curve, expected)
        self.assert_same_trace(blend(first.reversed(), second.reversed()).curve, expected)

    def test_the_same_call_gives_the_same_curve_in_every_thread(self):
        assert_same_in_threads(self, lambda: blend(*planar_task(), order=2).curve)

    def test_other_threads_run_during_a_blend(self):
        """A blend of tens of ms: this thread wakes up many times within one call."""
        begun, done = [], []

        def blends():
            for i in range(20):
                begun.append(i)
                blend(*spatial_task(), order=8, degree=25)
                done.append(i)

        thread = threading.Thread(target=blends)
        thread.start()
        wakes = Counter()
        while thread.is_alive():
            time.sleep(1e-4)
            if len(begun) > len(done):
                wakes[len(begun)] += 1
        self.assertGreaterEqual(max(wakes.values(), default=0), 10)


class RecordTest(unittest.TestCase):
    def test_it_is_read_only(self):
        result = blend(*planar_task(), order=1)
        for name in ("curve", "reports", "beta", "energy", "warnings", "max_displacement_mm"):
            with self.assertRaises(AttributeError):
                setattr(result, name, None)
        result.energy["bending"] = -1
        self.assertGreater(result.energy["bending"], 0)

    def test_kinds_of_the_attributes(self):
        result = blend(*planar_task(), order=(2, 1))
        self.assertIsInstance(result, Construction)
        self.assertIsInstance(result.curve, Curve)
        self.assertEqual(result.curve.parameter_range, (0, 1))
        self.assertFalse(result.curve.is_rational)
        self.assertIsInstance(result.beta, tuple)
        self.assertEqual([type(numbers) for numbers in result.beta], [tuple, tuple])
        self.assertIsNone(result.max_displacement_mm)
        self.assertEqual(repr(result), "<osculate.Construction: degree 4, G2, G1>")

    def test_a_report_outlives_its_construction(self):
        report = blend(*planar_task(), order=2).reports[1]
        self.assertEqual((report.order, report.ends), (2, END_TO_START))


@needs_freecad
class EdgeTest(unittest.TestCase):
    def test_edges_in_and_an_edge_out(self):
        arc = Part.Arc(FreeCAD.Vector(10, 0, 0), FreeCAD.Vector(6, 8, 0),
                       FreeCAD.Vector(0, 10, 0)).toShape()
        line = Part.makeLine(FreeCAD.Vector(-20, 0, 5), FreeCAD.Vector(-20, -30, 5))
        result = blend(arc, line, order=3)
        self.assertEqual([report.order for report in result.reports], [3, 3])
        self.assertIsInstance(result.edge, Part.Edge)
        self.assertEqual(Curve.from_edge(result.edge), result.curve)
        self.assertAlmostEqual(result.edge.Length, result.energy["length_mm"], delta=1e-6)
        self.assertEqual(analyze(arc, result.edge, order=3).order, 3)
        self.assertEqual(analyze(result.edge, line, order=3).order, 3)

    def test_parameters_are_those_of_the_edge(self):
        arc = Part.Arc(Part.Circle(FreeCAD.Vector(), FreeCAD.Vector(0, 0, 1), 10), 0.5, 2).toShape()
        line = Part.makeLine(FreeCAD.Vector(-20, 0, 0), FreeCAD.Vector(-20, -30, 0))
        result = blend(arc, line, order=2, ends=((1.25, "forward"), "start"))
        start = arc.valueAt(1.25)
        np.testing.assert_allclose(result.curve.poles[0], tuple(start), atol=1e-3)

    def test_an_open_edge_twice_is_closed_even_if_one_is_reversed(self):
        arc = Part.Arc(Part.Circle(FreeCAD.Vector(), FreeCAD.Vector(0, 0, 1), 10), 0, 4).toShape()
        for other in (arc, arc.reversed()):
            result = blend(arc, other, order=3)
            self.assertEqual([report.order for report in result.reports], [3, 3])
            np.testing.assert_allclose(np.linalg.norm(result.curve.evaluate(0.5)[0]), 10, atol=0.2)


if __name__ == "__main__":
    unittest.main()
