"""osculate.analyze_joins: arrays of joins give what single analyses give."""
import unittest

import numpy as np

import osculate
from osculate import VERDICTS, Curve, analyze, analyze_joins


def random_joins(count, degree=3, seed=7):
    """Pairs of segments, of which the second half share an end and the last quarter a tangent."""
    random = np.random.default_rng(seed)
    first = random.uniform(-10, 10, (count, degree + 1, 3))
    second = random.uniform(-10, 10, (count, degree + 1, 3))
    half, quarter = count // 2, 3 * count // 4
    second[half:, 0] = first[half:, -1]
    second[quarter:, 1] = 2 * first[quarter:, -1] - first[quarter:, -2]
    return first, second


class BatchTest(unittest.TestCase):
    def assert_as_single(self, batch, firsts, seconds, **options):
        for row, (a, b) in enumerate(zip(firsts, seconds)):
            report = analyze(a, b, ends=("end", "start"), **options)
            self.assertEqual(batch.order[row], report.order)
            self.assertEqual(batch.parametric_order[row], report.parametric_order)
            self.assertEqual(tuple(VERDICTS[v] for v in batch.verdicts[row]), report.verdicts)
            # the segments of a rational Curve carry the rounding of their extraction too
            np.testing.assert_allclose(batch.residuals[row], report.residuals, rtol=1e-12,
                                       atol=1e-13)
            single = np.array(report.uncertainties)
            self.assertTrue((batch.uncertainties[row] <= (1 + 1e-9) * single).all())

    def test_polynomial_joins_as_single_analyses(self):
        first, second = random_joins(40)
        batch = analyze_joins(first, second)
        self.assertEqual(set(batch.order), {-1, 0, 1})
        self.assert_as_single(batch, map(Curve.bezier, first), map(Curve.bezier, second))

    def test_rational_joins_of_different_degrees(self):
        random = np.random.default_rng(3)
        first, second = random_joins(20, degree=4)[0], random_joins(20, degree=2)[1]
        second[:, 0] = first[:, -1]
        weights = random.uniform(0.5, 2, (20, 5))
        options = {"order": 6, "tolerances": "catia-v5"}
        batch = analyze_joins(first, second, weights, **options)
        self.assertEqual(batch.residuals.shape, (20, 7))
        self.assert_as_single(batch, map(Curve.bezier, first, weights), map(Curve.bezier, second),
                              **options)

    def test_arrays_own_their_memory(self):
        batch = analyze_joins(*random_joins(5))
        for array in batch:
            self.assertTrue(array.flags.owndata)
            self.assertEqual(len(array), 5)
        self.assertEqual((batch.order.dtype, batch.verdicts.dtype), (np.int8, np.uint8))

    def test_the_input_is_not_changed(self):
        first, second = random_joins(5)
        copies = first.copy(), second.copy()
        analyze_joins(first, second)
        np.testing.assert_array_equal(first, copies[0])
        np.testing.assert_array_equal(second, copies[1])

    def test_input_of_any_layout(self):
        first, second = random_joins(6)
        expected = analyze_joins(first, second)
        for form in (np.asfortranarray, np.ndarray.tolist, lambda a: np.repeat(a, 2, axis=0)[::2]):
            np.testing.assert_array_equal(analyze_joins(form(first), form(second)).residuals,
                                          expected.residuals)

    def test_no_joins(self):
        batch = analyze_joins(np.zeros((0, 4, 3)), np.zeros((0, 3, 3)), order=2)
        self.assertEqual(batch.order.shape, (0,))
        self.assertEqual(batch.residuals.shape, (0, 3))

    def test_a_residual_that_does_not_exist_is_infinite(self):
        line = [[(-1, 0, 0), (-0.5, 0, 0), (-0.25, 0, 0), (0, 0, 0)]]
        batch = analyze_joins(line, [[(0, 0, 0), (0, 0, 0), (1 / 3, 0, 0), (1, 1, 0)]])
        self.assertEqual(batch.order[0], 1)
        self.assertTrue(np.isinf(batch.residuals[0, 2:]).all())


class BadInputTest(unittest.TestCase):
    def assert_value_error(self, pattern, *arguments, **keywords):
        with self.assertRaisesRegex(ValueError, pattern):
            analyze_joins(*arguments, **keywords)

    def test_shapes(self):
        first, second = random_joins(4)
        self.assert_value_error("first_poles: must have the shape", first[0], second)
        self.assert_value_error("second_poles: must have the shape", first, second[:, :, :2])
        self.assert_value_error("second_poles: as many segments as first_poles", first, second[1:])
        self.assert_value_error("first_poles: 2 to 26 poles", first[:, :1], second)
        self.assert_value_error("second_poles: 2 to 26 poles", first, np.zeros((4, 27, 3)))
        self.assert_value_error("first_weights: must have the shape", first, second,
                                np.ones((4, 3)))
        self.assert_value_error("second_weights: must have the shape", first, second, None,
                                np.ones(4))

    def test_values(self):
        first, second = random_joins(4)
        for bad in (np.nan, np.inf):
            broken = second.copy()
            broken[2, 1, 0] = bad
            self.assert_value_error("second_poles: every coordinate must be finite", first, broken)
        for bad in (0, -1, np.nan, np.inf):
            weights = np.ones((4, 4))
            weights[3, 3] = bad
            self.assert_value_error("first_weights: every weight must be finite and > 0", first,
                                    second, weights)

    def test_options(self):
        self.assert_value_error("order", *random_joins(4), order=9)
        self.assert_value_error("preset", *random_joins(4), tolerances="none")
        with self.assertRaisesRegex(TypeError, "first_poles"):
            analyze_joins("poles", random_joins(4)[1])


class PublicNamesTest(unittest.TestCase):
    def test_verdict_codes(self):
        self.assertEqual(osculate.VERDICTS, ("pass", "fail", "undecided"))


if __name__ == "__main__":
    unittest.main()
