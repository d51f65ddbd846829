"""osculate.comb: arrays of curvature, torsion and their rates along curves."""
import math
import unittest

import numpy as np

from osculate import COMB_QUANTITIES, Curve, comb
from support import Part, cubic, full_circle, needs_freecad, quarter_circle, spline


def names_of(marks):
    return [mark.kind for mark in marks]


class ArraysTest(unittest.TestCase):
    def test_every_array_has_a_row_for_each_sample(self):
        found = comb([spline(5), cubic(), quarter_circle()])
        count = len(found.parameter)
        for name in ("arc_length", *COMB_QUANTITIES):
            self.assertEqual(getattr(found, name).shape, (count,))
        for name in ("point", "tangent", "normal", "binormal"):
            self.assertEqual(getattr(found, name).shape, (count, 3))
        self.assertEqual((found.is_tooth.shape, found.is_tooth.dtype), ((count,), bool))
        self.assertEqual(found.lengths.shape, (3,))
        for array in found[:-1]:
            self.assertTrue(array.flags.owndata)

    def test_runs_cover_all_samples_in_order(self):
        found = comb([spline(5), cubic()])
        self.assertEqual(found.runs[0, 0], 0)
        self.assertEqual(found.runs[-1, 1], len(found.parameter) - 1)
        np.testing.assert_array_equal(found.runs[1:, 0], found.runs[:-1, 1] + 1)
        self.assertEqual(list(found.runs[:, 2]), sorted(found.runs[:, 2]))
        self.assertEqual(set(found.runs[:, 2]), {0, 1})

    def test_values_are_those_of_geometry(self):
        curve = spline(4, seed=5)
        found = comb(curve)
        last = set(found.runs[:, 1])
        for i in range(0, len(found.parameter), 7):
            at = curve.geometry(found.parameter[i], "left" if i in last else "right")
            for name in COMB_QUANTITIES:
                self.assertAlmostEqual(getattr(found, name)[i], getattr(at, name), delta=1e-7)
            np.testing.assert_allclose(found.normal[i], at.normal, atol=1e-9)

    def test_circle(self):
        found = comb(full_circle(10.0))
        np.testing.assert_allclose(found.curvature, 0.1, atol=1e-13)
        np.testing.assert_allclose(found.torsion, 0.0, atol=1e-12)
        self.assertAlmostEqual(found.lengths[0], 20.0 * math.pi, delta=1e-10)
        self.assertEqual(found.marks, ())

    def test_a_jump_stays_a_jump(self):
        # quarters of circles of radius 10 and 20 with a common tangent
        root = 0.5 ** 0.5
        curve = Curve.bspline([(10, 0, 0), (10, 10, 0), (0, 10, 0), (-20, 10, 0), (-20, -10, 0)],
                              [0, 1, 2], [3, 2, 3], 2, [1, root, 1, root, 1])
        found = comb(curve, tolerance=0)
        self.assertEqual(len(found.runs), 2)
        before, after = found.runs[0, 1], found.runs[1, 0]
        self.assertEqual(found.parameter[before], found.parameter[after])
        self.assertAlmostEqual(found.curvature[before], 0.1, delta=1e-13)
        self.assertAlmostEqual(found.curvature[after], 0.05, delta=1e-13)

    def test_line(self):
        found = comb(Curve.bezier([(0, 0, 0), (0, 0, 5)]), density=3, tolerance=0)
        self.assertEqual(len(found.parameter), 4)
        np.testing.assert_array_equal(found.curvature, 0.0)
        self.assertTrue(np.isnan(found.normal).all() and np.isnan(found.torsion).all())
        np.testing.assert_allclose(found.arc_length, [0, 5 / 3, 10 / 3, 5], atol=1e-14)

    def test_no_curves_give_empty_arrays(self):
        found = comb([])
        self.assertEqual((len(found.parameter), found.runs.shape, found.marks), (0, (0, 3), ()))


class MarksTest(unittest.TestCase):
    def test_inflection_and_vertices_of_an_s(self):
        curve = Curve.bezier([(0, 0, 0), (10, 20, 0), (20, -20, 0), (30, 0, 0)])
        found = comb([cubic(), curve], quantities="curvature")
        marks = [mark for mark in found.marks if mark.curve == 1]
        inflection, = (mark for mark in marks if mark.kind == "inflection")
        self.assertAlmostEqual(found.parameter[inflection.sample], 0.5, delta=1e-12)
        np.testing.assert_allclose(found.point[inflection.sample], (15, 0, 0), atol=1e-10)
        self.assertLess(inflection.uncertainty_mm, 1e-9)
        self.assertEqual(names_of(marks).count("vertex"), 2)
        self.assertEqual(names_of(marks).count("peak"), 2)

    def test_peaks_of_the_quantities_asked_for(self):
        curve = spline(3, seed=2)
        for name in COMB_QUANTITIES:
            found = comb(curve, quantities=[name])
            peaks = [mark for mark in found.marks if mark.kind == "peak"]
            self.assertTrue(peaks)
            self.assertEqual({mark.quantity for mark in peaks}, {name})
            best = max(abs(getattr(found, name)[mark.sample]) for mark in peaks)
            self.assertAlmostEqual(best, np.nanmax(abs(getattr(found, name))), delta=1e-9 * best)


class BadInputTest(unittest.TestCase):
    def test_what_is_no_curve(self):
        for value in (None, 3, "Edge1", [cubic(), None]):
            with self.subTest(value), self.assertRaises(TypeError) as caught:
                comb(value)
            self.assertIn("curves", str(caught.exception))

    def test_options(self):
        for options, error, words in (
                ({"density": 1}, ValueError, "density: must be from 2 to 10000"),
                ({"density": 2.5}, TypeError, "density: must be an integer"),
                ({"tolerance": 1.0}, ValueError, "tolerance: must be from 0 to below 1"),
                ({"tolerance": "x"}, TypeError, "tolerance: must be a number"),
                ({"quantities": ["speed"]}, ValueError, "'speed' is none of curvature, torsion"),
                ({"quantities": [1]}, TypeError, "quantities: must be names")):
            with self.subTest(options), self.assertRaisesRegex(error, words):
                comb(cubic(), **options)


@needs_freecad
class EdgesTest(unittest.TestCase):
    def test_edges_are_travelled_in_their_direction(self):
        edge = Part.Circle().toShape(0, math.pi)
        found = comb(edge)
        np.testing.assert_allclose(found.curvature, 1.0, atol=1e-13)
        np.testing.assert_allclose(found.point[0], (1, 0, 0), atol=1e-13)
        turned = comb(edge.reversed())
        np.testing.assert_allclose(turned.point[0], (-1, 0, 0), atol=1e-13)

    def test_all_edges_of_a_shape(self):
        box = Part.makeBox(1, 2, 3)
        found = comb(box.Edges)
        self.assertAlmostEqual(found.lengths.sum(), 24.0, delta=1e-12)
        np.testing.assert_array_equal(found.curvature, 0.0)

    def test_a_face_is_refused_with_advice(self):
        with self.assertRaisesRegex(TypeError, "curves"):
            comb(Part.makeBox(1, 1, 1).Faces[0])
        with self.assertRaisesRegex(TypeError, r"curves\[0\]"):
            comb([Part.makeBox(1, 1, 1).Faces[0]])


if __name__ == "__main__":
    unittest.main()
