"""Every bad input is an error that names the argument and the rule, and changes nothing."""
import unittest

import numpy as np

from osculate import ContactError, Curve, analyze, analyze_edge
from support import cubic, spline

NAN, INFINITE = float("nan"), float("inf")
POLES = [(0, 0, 0), (1, 0, 0), (2, 1, 0), (3, 1, 1)]


class ErrorCase(unittest.TestCase):
    def assert_error(self, kind, pattern, function, *arguments, **keywords):
        with self.assertRaisesRegex(kind, pattern):
            function(*arguments, **keywords)

    def assert_value_error(self, pattern, function, *arguments, **keywords):
        self.assert_error(ValueError, pattern, function, *arguments, **keywords)

    def assert_type_error(self, pattern, function, *arguments, **keywords):
        self.assert_error(TypeError, pattern, function, *arguments, **keywords)


class BezierTest(ErrorCase):
    def test_poles_that_are_not_finite(self):
        for bad in (NAN, INFINITE, -INFINITE):
            self.assert_value_error("poles: every coordinate must be finite", Curve.bezier,
                                    [(0, 0, 0), (1, bad, 0), (2, 0, 0)])

    def test_weights_that_are_not_positive(self):
        for bad in (0, -1, NAN, INFINITE):
            self.assert_value_error("weights: every weight must be finite and > 0", Curve.bezier,
                                    POLES, [1, 1, bad, 1])

    def test_wrong_number_of_weights(self):
        for weights in ([], [1], [1] * 5):
            expected = f"weights: one for each pole is needed, got {len(weights)} for 4"
            self.assert_value_error(expected, Curve.bezier, POLES, weights)
        self.assert_value_error(r"weights: must have the shape \(n,\), got \(4, 1\)", Curve.bezier,
                                POLES, [[1]] * 4)

    def test_wrong_shapes_of_poles(self):
        for shape in ((4,), (4, 2), (4, 4), (2, 4, 3), (0,)):
            expected = r"poles: must have the shape \(n\+1, 3\), got \(" + str(shape[0])
            self.assert_value_error(expected, Curve.bezier, np.zeros(shape))

    def test_too_few_and_too_many_poles(self):
        for count in (0, 1, 27):
            self.assert_value_error("poles: .*2 to 26", Curve.bezier,
                                    np.arange(3.0 * count).reshape(count, 3))

    def test_degree_25_is_the_last(self):
        self.assertEqual(Curve.bezier(np.arange(78.0).reshape(26, 3) ** 0.5).degree, 25)

    def test_zero_length(self):
        self.assert_value_error("poles: .*one point.*zero length", Curve.bezier, [(1, 2, 3)] * 4)

    def test_what_is_no_array_of_numbers(self):
        self.assert_type_error("poles: must be an array of real numbers, got str", Curve.bezier,
                               "abc")
        self.assert_type_error("poles", Curve.bezier, [["a", "b", "c"], ["d", "e", "f"]])
        self.assert_type_error("poles", Curve.bezier, None)
        self.assert_type_error("poles", Curve.bezier, np.zeros((3, 3), complex))
        self.assert_type_error("poles: .*rows of equal length", Curve.bezier, [(0, 0, 0), (1, 0)])


class BsplineTest(ErrorCase):
    def bspline(self, **changes):
        arguments = {"poles": POLES + [(4, 0, 1)], "knots": [0, 1, 2], "multiplicities": [4, 1, 4],
                     "degree": 3, **changes}
        return Curve.bspline(**arguments)

    def test_the_unchanged_arguments_are_right(self):
        self.assertEqual(self.bspline().degree, 3)

    def test_knots_that_do_not_increase(self):
        for knots in ([0, 2, 1], [0, 1, 1], [2, 1, 0]):
            self.assert_value_error("knots: .*increas", self.bspline, knots=knots)

    def test_knots_that_are_not_finite(self):
        for bad in (NAN, INFINITE):
            self.assert_value_error("knots", self.bspline, knots=[0, 1, bad])

    def test_wrong_sum_of_multiplicities(self):
        self.assert_value_error("multiplicities: .*(sum|together)", self.bspline,
                                multiplicities=[4, 2, 4])

    def test_multiplicities_out_of_range(self):
        for bad in ([5, 1, 3], [4, 0, 5], [9, 1, -1]):
            self.assert_value_error("multiplicities", self.bspline, multiplicities=bad)
        self.assert_value_error("multiplicities: must be whole numbers", self.bspline,
                                multiplicities=[4, 1.5, 4])

    def test_as_many_multiplicities_as_knots(self):
        self.assert_value_error("multiplicities", self.bspline, multiplicities=[4, 5])
        self.assert_value_error("knots", self.bspline, knots=[0], multiplicities=[9])

    def test_degree_out_of_range(self):
        for degree in (0, -1, 26, 2 ** 40, -2 ** 70):
            self.assert_value_error("degree", self.bspline, degree=degree)
        self.assert_type_error("degree: must be an integer, got float", self.bspline, degree=3.0)

    def test_periodic_is_true_or_false(self):
        self.assert_type_error("periodic: must be True or False, got str", self.bspline,
                               periodic="no")

    def test_too_few_poles(self):
        self.assert_value_error("poles|multiplicities", self.bspline, poles=POLES)

    def test_poles_and_weights_as_for_bezier(self):
        self.assert_value_error("poles: every coordinate", self.bspline,
                                poles=POLES + [(NAN, 0, 0)])
        self.assert_value_error("weights: every weight", self.bspline, weights=[1, 1, 0, 1, 1])
        self.assert_value_error("poles: .*one point", self.bspline, poles=[(1, 1, 1)] * 5)

    def test_periodic_knots(self):
        poles = np.random.default_rng(1).normal(size=(6, 3))
        self.assert_value_error("multiplicities", Curve.bspline, poles, range(7), [2] + [1] * 6, 3,
                                periodic=True)
        self.assert_value_error("multiplicities", Curve.bspline, poles, [0, 1, 2], [4, 2, 4], 3,
                                periodic=True)


class CurveMethodsTest(ErrorCase):
    def test_parameters_outside_the_range(self):
        for bad in (-1e-9, 1 + 1e-9, NAN, INFINITE):
            self.assert_value_error(r"t: must be within the range \[0, 1\]", cubic().evaluate, bad)
            self.assert_value_error("t: must be within", cubic().geometry, bad)
        self.assert_value_error("t: must be within", cubic().evaluate, [0.5, 2])

    def test_parameters_that_are_none(self):
        self.assert_type_error("t: .*got str", cubic().evaluate, "start")
        self.assert_type_error("t: must be a number", cubic().geometry, [0.5])
        self.assert_value_error("t: must be a number or have the shape", cubic().evaluate, [[0.5]])

    def test_derivatives(self):
        for bad in (-1, 26):
            self.assert_value_error("derivatives: must be from 0 to 25", cubic().evaluate, 0, bad)
        self.assert_type_error("derivatives: must be an integer", cubic().evaluate, 0, 1.5)

    def test_side(self):
        self.assert_value_error("side: must be 'left' or 'right'", cubic().geometry, 0.5, "both")
        self.assert_value_error("side", cubic().evaluate, 0.5, side=None)

    def test_elevated(self):
        self.assert_value_error("times", cubic().elevated, 23)
        self.assert_value_error("times", cubic().elevated, -1)
        self.assert_type_error("times", cubic().elevated, 1.0)

    def test_split_and_trimmed(self):
        for bad in (0, 1, -1, NAN):
            self.assert_value_error("split: t must be inside", cubic().split, bad)
        for first, last in ((0.5, 0.5), (0.6, 0.4), (-1, 0.5), (0.5, NAN)):
            self.assert_value_error("trim", cubic().trimmed, first, last)

    def test_parameter_at_length(self):
        for bad in (-1, 1000, NAN):
            self.assert_value_error(r"\bs\b", cubic().parameter_at_length, bad)
        self.assert_type_error("s: must be a number", cubic().parameter_at_length, None)


class AnalyzeTest(ErrorCase):
    def test_what_is_no_curve(self):
        for bad in (None, 1, "Edge1", [(0, 0, 0), (1, 0, 0)]):
            self.assert_type_error("^a: ", analyze, bad, cubic())
            self.assert_type_error("^b: ", analyze, cubic(), bad)
            self.assert_type_error("^a: ", analyze_edge, bad)

    def test_order(self):
        for bad in (-1, 9, 10 ** 20):
            self.assert_value_error("order", analyze, *cubic().split(0.5), order=bad)
            self.assert_value_error("order", analyze_edge, spline(3), order=bad)
        self.assert_type_error("order: must be an integer, got str", analyze, *cubic().split(0.5),
                               order="G2")

    def test_ends(self):
        curves = cubic().split(0.5)
        self.assert_value_error("ends: each must be 'start' or 'end', got 'middle'", analyze,
                                *curves, ends=("middle", "end"))
        self.assert_value_error("ends: must be a pair", analyze, *curves, ends=("end",))
        self.assert_type_error("ends: .*pair", analyze, *curves, ends="end")

    def test_tolerances(self):
        curves = cubic().split(0.5)
        self.assert_type_error("tolerances: .*got float", analyze, *curves, tolerances=0.1)
        self.assert_value_error("preset: .*osculate", analyze, *curves, tolerances="strict")

    def test_scale(self):
        for bad in (0, -1, NAN, INFINITE):
            self.assert_value_error("scale_mm: must be finite and > 0", analyze,
                                    *cubic().split(0.5), scale_mm=bad)
        self.assert_type_error("scale_mm: must be a number", analyze, *cubic().split(0.5),
                               scale_mm="1 mm")

    def test_progress(self):
        self.assert_type_error("progress: must be None or a callable", analyze_edge, spline(3),
                               progress=1)

    def test_contact_error_is_a_value_error(self):
        self.assertTrue(issubclass(ContactError, ValueError))


if __name__ == "__main__":
    unittest.main()
