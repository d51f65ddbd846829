"""osculate.Curve: what it says, what it computes, and that nothing changes it."""
import inspect
import math
import pickle
import unittest

import numpy as np

import osculate
from osculate import Curve
from support import cubic, full_circle, quarter_circle, spline


class DataTest(unittest.TestCase):
    def test_bezier_keeps_its_numbers(self):
        curve = Curve.bezier([[0, 0, 0], [1, 2, 3], [4, 4, 4]], weights=[1, 2, 3])
        self.assertEqual(curve.degree, 2)
        self.assertTrue(curve.is_rational)
        self.assertFalse(curve.is_periodic)
        np.testing.assert_array_equal(curve.poles, [[0, 0, 0], [1, 2, 3], [4, 4, 4]])
        np.testing.assert_array_equal(curve.weights, [1, 2, 3])
        np.testing.assert_array_equal(curve.knots, [0, 1])
        np.testing.assert_array_equal(curve.multiplicities, [3, 3])
        self.assertEqual(curve.parameter_range, (0.0, 1.0))
        self.assertEqual(curve.pole_error, 0.0)

    def test_polynomial_curve_has_no_weights(self):
        self.assertIsNone(cubic().weights)
        self.assertFalse(cubic().is_rational)

    def test_periodic_bspline(self):
        curve = spline(6, periodic=True)
        self.assertTrue(curve.is_periodic)
        self.assertEqual(curve.poles.shape, (6, 3))
        np.testing.assert_allclose(curve.evaluate(0, 2), curve.evaluate(6, 2, side="left"),
                                   rtol=1e-14, atol=1e-14)

    def test_range_of_knots_that_are_not_clamped(self):
        curve = Curve.bspline(cubic().poles, range(8), [1] * 8, 3)
        self.assertEqual(curve.parameter_range, (3.0, 4.0))
        self.assertEqual(len(curve.segments()), 1)

    def test_data_may_be_lists_tuples_or_arrays_of_any_layout(self):
        poles = cubic().poles
        for form in (poles.tolist(), tuple(map(tuple, poles)), np.asfortranarray(poles),
                     poles.astype(np.float32), poles.astype(int), np.repeat(poles, 2, axis=0)[::2]):
            np.testing.assert_array_equal(Curve.bezier(form).poles, poles)

    def test_equality_is_of_all_numbers(self):
        self.assertEqual(cubic(), cubic())
        self.assertNotEqual(cubic(), cubic().reversed())
        self.assertNotEqual(cubic(), Curve.bezier(cubic().poles, [1, 1, 1, 1]))
        self.assertNotEqual(cubic(), "a curve")

    def test_pickle_gives_an_equal_curve(self):
        for curve in (cubic(), quarter_circle(), spline(5, periodic=True)):
            self.assertEqual(pickle.loads(pickle.dumps(curve)), curve)

    def test_repr_tells_what_it_is(self):
        self.assertEqual(repr(quarter_circle()), "<osculate.Curve: rational, degree 2, 3 poles, "
                                                 "1 segment, over [0, 1]>")
        self.assertIn("periodic polynomial, degree 3, 6 poles, 6 segments",
                      repr(spline(6, periodic=True)))


class ImmutabilityTest(unittest.TestCase):
    def test_attributes_cannot_be_set_or_added(self):
        curve = cubic()
        for name in ("degree", "poles", "weights", "knots", "note"):
            with self.assertRaises(AttributeError, msg=name):
                setattr(curve, name, 1)

    def test_arrays_are_copies_that_own_their_memory(self):
        curve = quarter_circle()
        for name in ("poles", "weights", "knots", "multiplicities"):
            array = getattr(curve, name)
            self.assertTrue(array.flags.owndata or array.base is None, name)
            array += 1
            self.assertFalse(np.array_equal(getattr(curve, name), array), name)

    def test_the_arrays_given_are_not_kept(self):
        poles = np.array([[0.0, 0, 0], [1, 0, 0]])
        curve = Curve.bezier(poles)
        poles[0] = 9
        np.testing.assert_array_equal(curve.poles[0], [0, 0, 0])

    def test_arrays_outlive_the_curve(self):
        poles = spline(50).poles
        np.testing.assert_array_equal(poles, spline(50).poles)


class EvaluationTest(unittest.TestCase):
    def test_derivatives_of_a_parabola(self):
        curve = Curve.bezier([[0, 0, 0], [1, 0, 0], [2, 2, 0]])  # (2t, 2t^2, 0)
        np.testing.assert_allclose(curve.evaluate(0.5, derivatives=3),
                                   [[1, 0.5, 0], [2, 2, 0], [0, 4, 0], [0, 0, 0]], atol=1e-15)

    def test_shapes(self):
        self.assertEqual(cubic().evaluate(0.5).shape, (1, 3))
        self.assertEqual(cubic().evaluate([0, 0.5], derivatives=2).shape, (2, 3, 3))
        self.assertEqual(cubic().evaluate([]).shape, (0, 1, 3))

    def test_an_array_gives_what_its_numbers_give(self):
        curve = spline(7)
        parameters = np.linspace(0, 7, 23)
        singly = [curve.evaluate(t, derivatives=2) for t in parameters]
        np.testing.assert_array_equal(curve.evaluate(parameters, derivatives=2), singly)

    def test_rational_quarter_circle_has_its_radius(self):
        points = quarter_circle(7).evaluate(np.linspace(0, 1, 11))[:, 0]
        np.testing.assert_allclose(np.linalg.norm(points, axis=1), 7, rtol=1e-15)

    def test_a_knot_has_two_sides(self):
        corner = Curve.bspline([(0, 0, 0), (1, 0, 0), (1, 1, 0)], [0, 1, 2], [2, 1, 2], 1)
        np.testing.assert_array_equal(corner.evaluate(1, 1, side="left")[1], [1, 0, 0])
        np.testing.assert_array_equal(corner.evaluate(1, 1, side="right")[1], [0, 1, 0])
        np.testing.assert_array_equal(corner.geometry(1, side="left").tangent, [1, 0, 0])
        np.testing.assert_array_equal(corner.geometry(1).tangent, [0, 1, 0])


class OperationsTest(unittest.TestCase):
    def assert_same_trace(self, curve, other):
        for share in (0.0, 0.3, 1.0):
            first, second = (c.evaluate(c.parameter_at_length(share * c.length()))
                             for c in (curve, other))
            np.testing.assert_allclose(first, second, atol=1e-9)

    def test_segments_are_bezier_curves_in_order(self):
        curve = spline(5)
        segments = curve.segments()
        self.assertEqual(len(segments), 5)
        for i, segment in enumerate(segments):
            np.testing.assert_array_equal(segment.knots, [0, 1])
            np.testing.assert_allclose(segment.evaluate(0.25), curve.evaluate(i + 0.25), atol=1e-13)

    def test_segments_that_are_points_are_left_out(self):
        poles = [(0, 0, 0)] * 3 + [(1, 0, 0), (2, 1, 0)]
        curve = Curve.bspline(poles, [0, 1, 2], [3, 2, 3], 2)
        self.assertEqual(len(curve.segments()), 1)

    def test_reversed_twice_is_the_curve(self):
        for curve in (quarter_circle(), spline(5), spline(5, periodic=True)):
            np.testing.assert_allclose(curve.reversed().evaluate(0.25 + curve.parameter_range[0]),
                                       curve.evaluate(curve.parameter_range[1] - 0.25), atol=1e-12)
            self.assertEqual(curve.reversed().reversed(), curve)

    def test_elevated(self):
        for curve in (cubic(), quarter_circle(), spline(4), spline(5, periodic=True)):
            higher = curve.elevated(2)
            self.assertEqual(higher.degree, curve.degree + 2)
            t = np.linspace(*curve.parameter_range, 9)
            np.testing.assert_allclose(higher.evaluate(t), curve.evaluate(t), atol=1e-12)
        self.assertEqual(cubic().elevated().degree, 4)

    def test_split_and_trimmed(self):
        curve = spline(5)
        first, second = curve.split(2.5)
        self.assertEqual(first.parameter_range, (0.0, 2.5))
        self.assertEqual(second.parameter_range, (2.5, 5.0))
        np.testing.assert_allclose(second.evaluate(3.25, 2), curve.evaluate(3.25, 2), atol=1e-12)
        part = curve.trimmed(1.5, 3.5)
        self.assertEqual(part.parameter_range, (1.5, 3.5))
        np.testing.assert_allclose(part.evaluate(2.0, 1), curve.evaluate(2.0, 1), atol=1e-12)

    def test_a_periodic_curve_is_trimmed_across_its_seam(self):
        curve = spline(6, periodic=True)
        part = curve.trimmed(5, 7)
        np.testing.assert_allclose(part.evaluate(6.5), curve.evaluate(0.5), atol=1e-12)

    def test_length_of_a_circle_and_its_inverse(self):
        self.assertAlmostEqual(full_circle(10).length(), 20 * math.pi, delta=1e-10)
        curve = quarter_circle(2)
        self.assertAlmostEqual(curve.parameter_at_length(math.pi / 2), 0.5, delta=1e-12)
        self.assertEqual(curve.parameter_at_length(0), 0)

    def test_operations_do_not_change_the_trace(self):
        self.assert_same_trace(cubic(), cubic().elevated(3))
        self.assert_same_trace(cubic(), cubic().reversed().reversed())


class GeometryTest(unittest.TestCase):
    def test_circle(self):
        geometry = quarter_circle(4).geometry(0.5)
        middle = np.array([0.5, 0.5, 0]) ** 0.5
        np.testing.assert_allclose(geometry.point, 4 * middle, rtol=1e-14)
        np.testing.assert_allclose(geometry.normal, -middle, rtol=1e-14)
        np.testing.assert_allclose(geometry.binormal, [0, 0, 1], atol=1e-14)
        self.assertAlmostEqual(geometry.curvature, 0.25, delta=1e-15)
        for rate in (geometry.torsion, geometry.curvature_rate, geometry.curvature_rate2,
                     geometry.torsion_rate):
            self.assertAlmostEqual(rate, 0, delta=1e-13)
        self.assertEqual(geometry.frame_kind, "frenet")

    def test_what_a_straight_line_has_not_is_none(self):
        geometry = Curve.bezier([(0, 0, 0), (3, 4, 0)]).geometry(0.5)
        np.testing.assert_allclose(geometry.tangent, [0.6, 0.8, 0])
        self.assertEqual(geometry.curvature, 0)
        self.assertIsNone(geometry.normal)
        self.assertIsNone(geometry.binormal)
        self.assertIsNone(geometry.torsion)
        self.assertIsNone(geometry.torsion_rate)
        self.assertEqual(geometry.frame_kind, "line")

    def test_read_only(self):
        with self.assertRaises(AttributeError):
            cubic().geometry(0.5).curvature = 1


class DocumentationTest(unittest.TestCase):
    def test_every_public_name_has_a_docstring(self):
        for name in osculate.__all__:
            thing = getattr(osculate, name)
            if inspect.isclass(thing) or callable(thing):
                self.assertTrue(inspect.getdoc(thing), name)

    def test_every_member_has_a_docstring(self):
        for owner in (osculate.Curve, osculate.JoinReport, osculate.JoinSide, osculate.Tolerances,
                      osculate.PointGeometry, osculate.DefinitionDetail, osculate.FrenetFrame,
                      osculate.JoinWarning, osculate.TolerancePreset):
            for name, member in vars(owner).items():
                if not name.startswith("_"):
                    self.assertTrue(inspect.getdoc(member), f"{owner.__name__}.{name}")

    def test_signatures_can_be_read(self):
        self.assertEqual(str(inspect.signature(Curve.bezier)), "(poles, weights=None)")
        self.assertEqual(str(inspect.signature(cubic().evaluate)),
                         "(t, derivatives=0, side='right')")


if __name__ == "__main__":
    unittest.main()
