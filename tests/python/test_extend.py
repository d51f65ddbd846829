"""osculate.extend: what its curves meet, its freedoms, targets and continuations."""
import unittest

import numpy as np

from osculate import Construction, ContactError, Curve, analyze, extend
from blend_tasks import planar_task, spatial_task
from support import (FreeCAD, Part, assert_same_in_threads, count_wakes_during, cubic,
                     full_circle, needs_freecad, quarter_circle, spline)


def curves():
    return {"cubic": cubic(), "planar": planar_task()[0], "rational": spatial_task()[1],
            "circle": quarter_circle(), "spline": spline(6),
            "line": Curve.bezier([(-30, -10, 5), (0, 0, 0)])}


def end_of(construction):
    return construction.curve.poles[-1]


def direction_at_end(construction):
    return construction.curve.geometry(construction.curve.parameter_range[1], "left").tangent


def curvature_vector_at_end(construction):
    geometry = construction.curve.geometry(construction.curve.parameter_range[1], "left")
    return geometry.curvature * geometry.normal if geometry.normal is not None else np.zeros(3)


class ContactTest(unittest.TestCase):
    def test_all_orders_at_both_ends_of_every_curve(self):
        for name, curve in curves().items():
            for end in ("start", "end"):
                for order in range(5):
                    with self.subTest(curve=name, end=end, order=order):
                        result = extend(curve, end=end, order=order)
                        report, = result.reports
                        self.assertEqual(report.order, order)
                        self.assertEqual(report.preset, "exact")
                        self.assertEqual(report.ends, (end, "start"))
                        self.assertEqual(result.curve.degree, max(order, 1))
                        self.assertEqual(result.warnings, ())

    def test_the_default_is_g4_at_the_end_over_the_reach(self):
        result = extend(cubic())
        self.assertEqual(result.reports[0].ends, ("end", "start"))
        self.assertEqual(result.reports[0].order, 4)
        self.assertEqual(result.curve.parameter_range, (0, 1))
        self.assertAlmostEqual(result.curve.length(), 30, delta=1e-9)  # to (0, 0, 0)

    def test_the_report_is_that_of_analyze(self):
        result = extend(cubic(), order=3)
        own = analyze(cubic(), result.curve, order=3, ends=("end", "start"), tolerances="exact")
        self.assertEqual(result.reports[0].to_json(), own.to_json())

    def test_degrees_above_and_below_the_order(self):
        for degree in (3, 4, 5, 8):
            result = extend(cubic(), degree=degree)
            self.assertEqual(result.curve.degree, degree)
            self.assertNotIn("fail", result.reports[0].verdicts)
        self.assertEqual(extend(planar_task()[0], order=3, degree=2).reports[0].order, 3)
        with self.assertRaisesRegex(ContactError, "degree 3 can"):
            extend(cubic(), degree=2)

    def test_a_straight_line_is_continued_straight(self):
        result = extend(curves()["line"], order=4)
        along = result.curve.poles @ np.array([30, 10, -5]) / np.linalg.norm([30, 10, -5])
        np.testing.assert_allclose(np.linalg.norm(result.curve.poles, axis=1), along, atol=1e-9)
        np.testing.assert_allclose(np.diff(along), along[-1] / 4, rtol=1e-3)  # even


class FreedomsTest(unittest.TestCase):
    def test_beta_is_the_speed_by_the_chord(self):
        result = extend(cubic(), order=3, beta=(1.2, None, -0.5))
        self.assertAlmostEqual(result.beta[0][0], 1.2, delta=1e-9)
        self.assertAlmostEqual(result.beta[0][2], -0.5, delta=1e-8)
        self.assertEqual(result.beta[1], ())
        first, second = result.curve.evaluate(0, 2)[1:]
        chord = np.linalg.norm(result.curve.poles[-1] - result.curve.poles[0])
        speed = np.linalg.norm(first)
        self.assertAlmostEqual(speed / chord, 1.2, delta=1e-9)
        self.assertAlmostEqual(first @ second / speed / chord, result.beta[0][1], delta=1e-8)

    def test_all_beta_fix_the_curve(self):
        for curve in (cubic(), planar_task()[0], quarter_circle()):
            free = extend(curve)
            self.assertEqual(free.free_numbers, 3)
            fixed = extend(curve, beta=free.beta[0])
            self.assertEqual(fixed.free_numbers, 0)
            np.testing.assert_allclose(fixed.curve.poles, free.curve.poles, atol=1e-6)

    def test_beta_scale_with_the_model(self):
        small = extend(cubic(), order=2, beta=(1.1, 0.3), degree=4)
        large = extend(Curve.bezier(1000 * cubic().poles), order=2, beta=(1.1, 0.3), degree=4)
        np.testing.assert_allclose(large.curve.poles, 1000 * small.curve.poles, atol=1e-2)

    def test_tangential_coordinates_of_the_poles(self):
        result = extend(cubic(), tangential=(5, 9, 14, 20))
        tangent = np.array([0, 1, 1]) / 2 ** 0.5
        np.testing.assert_allclose((result.curve.poles - cubic().poles[-1]) @ tangent,
                                   (0, 5, 9, 14, 20), atol=1e-11)
        self.assertEqual(result.free_numbers, 0)
        self.assertIsNone(result.energy["objective"])

    def test_tangential_coordinates_in_part(self):
        result = extend(cubic(), tangential=(5, None, 14))
        tangent = np.array([0, 1, 1]) / 2 ** 0.5
        along = (result.curve.poles - cubic().poles[-1]) @ tangent
        np.testing.assert_allclose(along[[1, 3]], (5, 14), atol=1e-11)

    def test_length(self):
        for name, curve in curves().items():
            for degree in (4, 6):
                result = extend(curve, length=12.5, degree=degree)
                self.assertAlmostEqual(result.curve.length(), 12.5, delta=1e-8, msg=name)

    def test_parametric_continuity(self):
        for name, curve in curves().items():
            for end in ("start", "end"):
                result = extend(curve, end=end, order=3, parametric=True)
                self.assertEqual(result.reports[0].parametric_order, 3, name)
        # the end segment of a B-spline with knots 0, 1, .. 6 is one unit long
        self.assertEqual(extend(spline(6), parametric=True).curve.parameter_range, (0, 1))

    def test_parameter_cuts_the_parametric_curve(self):
        whole = extend(cubic(), order=4, parametric=True).curve
        part = extend(cubic(), order=4, parameter=0.4)
        np.testing.assert_allclose(part.curve.poles, whole.split(0.4)[0].poles, atol=1e-10)
        self.assertEqual(part.reports[0].order, 4)

    def test_fairness(self):
        mvc, bending = (extend(cubic(), order=3, degree=5, fairness=name).energy
                        for name in ("mvc", "bending"))
        self.assertLess(mvc["mvc"], bending["mvc"])
        self.assertLess(bending["bending"], mvc["bending"])
        self.assertAlmostEqual(mvc["objective"], np.log(mvc["mvc"]) + 0.3 * mvc["speed"],
                               delta=1e-3)

    def test_no_fairness_needs_all_numbers(self):
        with self.assertRaisesRegex(ContactError, "under-determined: 3 numbers"):
            extend(cubic(), fairness=None)
        result = extend(cubic(), order=1, fairness=None)
        self.assertEqual(result.free_numbers, 0)

    def test_free_numbers_are_counted(self):
        self.assertEqual(extend(cubic(), degree=6).free_numbers, 4 + 6 - 1)
        self.assertEqual(extend(cubic(), to_point=(30, 40, 20)).free_numbers, 1)


class TargetsTest(unittest.TestCase):
    def test_point_and_direction(self):
        point = extend(cubic(), to_point=(30, 40, 20))
        self.assertEqual(point.curve.degree, 4)
        np.testing.assert_allclose(end_of(point), (30, 40, 20), atol=1e-9)
        both = extend(cubic(), to_point=(30, 40, 20), to_direction=(0, 3, 0))
        self.assertEqual(both.curve.degree, 5)
        np.testing.assert_allclose(end_of(both), (30, 40, 20), atol=1e-9)
        np.testing.assert_allclose(direction_at_end(both), (0, 1, 0), atol=1e-9)

    def test_end_curvature(self):
        number = extend(cubic(), to_curvature=0.05, degree=6)
        self.assertAlmostEqual(np.linalg.norm(curvature_vector_at_end(number)), 0.05, delta=1e-9)
        straight = extend(cubic(), to_curvature=0, degree=6)
        self.assertAlmostEqual(np.linalg.norm(curvature_vector_at_end(straight)), 0, delta=1e-9)
        vector = extend(cubic(), to_direction=(0, 1, 0), to_curvature=(0.02, 0, -0.03), degree=6)
        np.testing.assert_allclose(curvature_vector_at_end(vector), (0.02, 0, -0.03), atol=1e-9)

    def test_all_targets_at_once_in_numpy(self):
        result = extend(cubic(), to_point=np.array([30, 40, 20]), to_direction=[0, 1, 0.5],
                        to_curvature=np.float64(0.01), length=28, degree=8)
        np.testing.assert_allclose(end_of(result), (30, 40, 20), atol=1e-9)
        self.assertAlmostEqual(result.curve.length(), 28, delta=1e-8)
        self.assertAlmostEqual(np.linalg.norm(curvature_vector_at_end(result)), 0.01, delta=1e-9)
        self.assertNotIn("fail", result.reports[0].verdicts)

    def test_what_is_over_determined_is_said(self):
        with self.assertRaisesRegex(ContactError, r"over-determined: degree 4 has 4 free numbers "
                                    r"for 5 conditions: to_point \(3\), to_direction \(2\).*"
                                    "degree 5 can"):
            extend(cubic(), to_point=(30, 40, 20), to_direction=(0, 1, 0), degree=4)

    def test_a_sharp_bend_is_named(self):
        result = extend(cubic(), to_point=(30, 40, 20), to_direction=(0, 1, 0))
        self.assertRegex(result.warnings[0], "^sharp: .*degree 6")


class NaturalTest(unittest.TestCase):
    def test_a_circle_goes_on_as_the_same_circle(self):
        for length in (3, 5 * np.pi, 15 * np.pi, 50 * np.pi):
            result = extend(quarter_circle(), natural=True, length=length)
            points = result.curve.evaluate(np.linspace(0, 1, 99))[:, 0]
            np.testing.assert_allclose(np.linalg.norm(points, axis=1), 10, atol=1e-11)
            self.assertAlmostEqual(result.curve.length(), length, delta=1e-8)
            self.assertTrue(np.all(result.curve.weights > 0))
            self.assertEqual(result.reports[0].order, 4)
            self.assertEqual(result.free_numbers, 0)

    def test_of_the_other_end_of_a_full_circle(self):
        result = extend(full_circle(), natural=True, end="start", length=5 * np.pi)
        np.testing.assert_allclose(end_of(result), (0, -10, 0), atol=1e-9)

    def test_a_polynomial_goes_on(self):
        result = extend(cubic(), natural=True, length=25, order=8)
        self.assertEqual(result.curve.degree, 3)
        self.assertEqual(result.reports[0].order, 8)
        ratio = np.linalg.norm(result.curve.evaluate(0, 1)[1]) / np.linalg.norm(
            cubic().evaluate(1, 1)[1])
        parts = result.curve.poles[0], cubic().poles  # the same cubic by another parameter
        np.testing.assert_allclose(parts[0], parts[1][-1])
        np.testing.assert_allclose(result.curve.evaluate(0, 3)[3],
                                   cubic().evaluate(1, 3)[3] * ratio ** 3, rtol=1e-9)

    def test_nothing_else_can_be_given(self):
        for given in ({"degree": 3}, {"beta": (1,)}, {"tangential": (1,)}, {"parameter": 0.5},
                      {"to_point": (0, 0, 0)}, {"to_direction": (1, 0, 0)}, {"to_curvature": 0},
                      {"parametric": True}):
            with self.assertRaisesRegex(ContactError, f"natural: .* got {list(given)[0]}"):
                extend(cubic(), natural=True, **given)


class InvarianceTest(unittest.TestCase):
    def test_direction_and_elevation_of_the_input(self):
        for name, curve in curves().items():
            own = extend(curve).curve.poles
            for same in (extend(curve.reversed(), end="start"), extend(curve.elevated(2))):
                np.testing.assert_allclose(same.curve.poles, own, atol=1e-4, err_msg=name)

    def test_the_same_call_gives_the_same_curve_in_every_thread(self):
        assert_same_in_threads(self, lambda: extend(cubic(), degree=6).curve)

    def test_other_threads_run_meanwhile(self):
        def extends():
            for _ in range(10):
                extend(cubic(), order=8, degree=12)

        self.assertGreater(count_wakes_during(extends), 10)


class RecordTest(unittest.TestCase):
    def test_kinds(self):
        result = extend(cubic(), order=2)
        self.assertIsInstance(result, Construction)
        self.assertFalse(result.curve.is_rational)
        self.assertEqual([len(numbers) for numbers in result.beta], [2, 0])
        self.assertIsNone(result.max_displacement_mm)
        self.assertEqual(repr(result), "<osculate.Construction: degree 2, G2>")


@needs_freecad
class EdgeTest(unittest.TestCase):
    def test_an_edge_in_and_an_edge_out(self):
        arc = Part.Arc(FreeCAD.Vector(10, 0, 0), FreeCAD.Vector(6, 8, 0),
                       FreeCAD.Vector(0, 10, 0)).toShape()
        result = extend(arc, to_point=FreeCAD.Vector(-20, 0, 0))
        self.assertIsInstance(result.edge, Part.Edge)
        self.assertEqual(analyze(arc, result.edge, order=4, tolerances="exact").order, 4)
        circle = extend(arc, natural=True, length=15 * np.pi).edge
        self.assertAlmostEqual(circle.Length, 15 * np.pi, delta=1e-7)
        for edge in (arc, arc.reversed()):
            end = edge.lastVertex(True).Point
            np.testing.assert_allclose(extend(edge).curve.poles[0], tuple(end), atol=1e-9)


if __name__ == "__main__":
    unittest.main()
