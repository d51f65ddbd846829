"""Control polygons, their differences and the construction of de Casteljau, without FreeCAD."""
import unittest

import numpy as np

from osculate import Curve
from osculate.polygons import control_polygons, de_casteljau, derivatives, differences
from support import cubic, full_circle, quarter_circle, spline


def random_segment(degree, is_rational, seed=3):
    random = np.random.default_rng(seed + degree)
    weights = random.uniform(0.3, 3.0, degree + 1) if is_rational else None
    return Curve.bezier(random.uniform(-10, 10, (degree + 1, 3)), weights)


class PolygonsTest(unittest.TestCase):
    def test_of_each_segment(self):
        found = control_polygons([cubic(), full_circle(10.0), spline(5)])
        self.assertEqual(found.counts.tolist(), [4] + 4 * [3] + 5 * [4])
        self.assertEqual(found.curves.tolist(), [0] + 4 * [1] + 5 * [2])
        self.assertEqual(found.is_rational.tolist(), [False] + 4 * [True] + 5 * [False])
        np.testing.assert_array_equal(found.poles[:4], cubic().poles)
        np.testing.assert_allclose(found.poles[found.ends][2:10:2],
                                   [(10, 0, 0), (0, 10, 0), (-10, 0, 0), (0, -10, 0)], atol=1e-12)
        self.assertEqual(int(found.ends.sum()), 20)

    def test_weights_of_a_circle_are_known(self):
        found = control_polygons([full_circle(10.0)])
        weights = found.weights.reshape(4, 3)
        np.testing.assert_allclose(weights[:, 1] / weights[:, 0], 0.5 ** 0.5, atol=1e-15)

    def test_of_no_curve(self):
        found = control_polygons([])
        self.assertEqual((len(found.poles), len(found.counts), len(found.ends)), (0, 0, 0))
        self.assertEqual(len(differences(found, 1).vectors), 0)
        self.assertEqual(len(derivatives(found, 2).vectors), 0)


class DifferencesTest(unittest.TestCase):
    def test_first_lead_from_pole_to_pole(self):
        found = control_polygons([cubic(), spline(2)])
        first = differences(found, 1)
        self.assertEqual(np.bincount(first.segments).tolist(), [3, 3, 3])
        np.testing.assert_allclose(first.poles[:3] + first.vectors[:3], cubic().poles[1:])

    def test_second_by_their_formula(self):
        poles = cubic().poles
        second = differences(control_polygons([cubic()]), 2)
        np.testing.assert_allclose(second.vectors, poles[2:] - 2 * poles[1:-1] + poles[:-2])
        np.testing.assert_array_equal(second.poles, poles[:2])

    def test_a_line_has_no_second_ones(self):
        line = Curve.bezier([(0, 0, 0), (1, 2, 3)])
        found = control_polygons([line, cubic(), line])
        self.assertEqual(np.unique(differences(found, 2).segments).tolist(), [1])
        self.assertEqual(len(differences(found, 4).vectors), 0)

    def test_are_the_poles_of_the_derivatives(self):
        for degree in range(1, 9):
            curve = random_segment(degree, False)
            found = control_polygons([curve])
            for order in range(1, min(degree, 3) + 1):
                poles = derivatives(found, order).vectors
                for t in (0.0, 0.3, 1.0):
                    value = de_casteljau(Curve.bezier(poles), t)[-1][0] if len(poles) > 1 else (
                        poles[0])
                    expected = curve.evaluate(t, derivatives=order)[order]
                    np.testing.assert_allclose(value, expected, rtol=1e-10, atol=1e-9)

    def test_rational_segments_have_no_such_derivatives(self):
        found = control_polygons([quarter_circle(), cubic(), quarter_circle()])
        self.assertEqual(np.unique(derivatives(found, 1).segments).tolist(), [1])
        self.assertEqual(np.unique(differences(found, 1).segments).tolist(), [0, 1, 2])


class DeCasteljauTest(unittest.TestCase):
    def test_ends_at_the_point_of_the_curve(self):
        for degree in range(1, 12):
            for is_rational in (False, True):
                curve = random_segment(degree, is_rational)
                for t in (0.0, 0.2, 0.75, 1.0):
                    levels = de_casteljau(curve, t)
                    self.assertEqual([len(level) for level in levels],
                                     list(range(degree + 1, 0, -1)))
                    np.testing.assert_allclose(levels[-1][0], curve.evaluate(t)[0], atol=1e-12)

    def test_begins_with_the_control_polygon(self):
        for is_rational in (False, True):
            curve = random_segment(4, is_rational)
            np.testing.assert_allclose(de_casteljau(curve, 0.4)[0], curve.poles, atol=1e-14)

    def test_its_sides_are_the_polygons_of_both_parts(self):
        for is_rational in (False, True):
            curve = random_segment(5, is_rational)
            levels = de_casteljau(curve, 0.3)
            first, second = curve.split(0.3)
            np.testing.assert_allclose([level[0] for level in levels], first.poles, atol=1e-12)
            np.testing.assert_allclose([level[-1] for level in levels[::-1]], second.poles,
                                       atol=1e-12)

    def test_points_of_the_last_leg_lie_on_the_tangent(self):
        curve = random_segment(5, True)
        first, second = de_casteljau(curve, 0.6)[-2]
        np.testing.assert_allclose(np.cross(second - first, curve.geometry(0.6).tangent), 0.0,
                                   atol=1e-12)

    def test_points_stay_on_the_legs_of_the_level_below(self):
        levels = de_casteljau(random_segment(4, True), 0.35)
        for below, level in zip(levels, levels[1:]):
            for start, end, point in zip(below, below[1:], level):
                np.testing.assert_allclose(np.cross(end - start, point - start), 0.0, atol=1e-11)

    def test_of_a_parabola_by_hand(self):
        levels = de_casteljau(Curve.bezier([(0, 0, 0), (4, 8, 0), (8, 0, 0)]), 0.25)
        np.testing.assert_array_equal(levels[1], [(1, 2, 0), (5, 6, 0)])
        np.testing.assert_array_equal(levels[2], [(2, 3, 0)])


if __name__ == "__main__":
    unittest.main()
