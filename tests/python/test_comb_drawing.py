"""How combs are scaled and where their envelopes break, without FreeCAD."""
import unittest

import numpy as np

from osculate import COMB_QUANTITIES, Curve, comb
from osculate.comb_drawing import LIMIT, CombDrawing, automatic_scale, size_of
from support import cubic, full_circle, quarter_circle, spline


def arcs(first=10.0, second=20.0):
    """Quarters of circles with a common tangent as one curve: curvature 1/first, then 1/second."""
    root = 0.5 ** 0.5
    return Curve.bspline([(first, 0, 0), (first, first, 0), (0, first, 0),
                          (-second, first, 0), (-second, first - second, 0)],
                         [0, 1, 2], [3, 2, 3], 2, [1, root, 1, root, 1])


def s_curve():
    return Curve.bezier([(0, 0, 0), (10, 20, 0), (20, -20, 0), (30, 0, 0)])


class TeethTest(unittest.TestCase):
    def test_point_away_from_the_centre_of_curvature(self):
        found = comb(full_circle(10.0))
        tips, cut = CombDrawing(found, "curvature").tips(20.0, 100.0)
        np.testing.assert_allclose(np.linalg.norm(tips, axis=1), 12.0, atol=1e-12)
        self.assertFalse(cut.any())

    def test_of_torsion_point_along_the_binormal(self):
        found = comb(cubic())
        drawing = CombDrawing(found, "torsion")
        np.testing.assert_allclose(np.cross(drawing.vectors, found.binormal), 0.0, atol=1e-12)
        along = (drawing.vectors * found.binormal).sum(axis=1)
        np.testing.assert_allclose(along, found.torsion, atol=1e-12)

    def test_are_cut_at_the_limit(self):
        tips, cut = CombDrawing(comb(arcs(1.0, 20.0)), "curvature").tips(10.0, 5.0)
        lengths = np.linalg.norm(tips - comb(arcs(1.0, 20.0)).point, axis=1)
        np.testing.assert_allclose(lengths[cut], 5.0)
        np.testing.assert_allclose(lengths[~cut], 0.5)
        self.assertTrue(cut.any() and not cut.all())

    def test_at_ends_of_runs_are_teeth(self):
        found = comb(s_curve(), density=7)
        teeth = set(CombDrawing(found, "curvature").teeth)
        self.assertLessEqual(set(found.runs[:, :2].ravel()), teeth)
        self.assertLess(len(teeth), len(found.parameter))

    def test_of_a_line_have_no_length(self):
        found = comb(Curve.bezier([(0, 0, 0), (10, 0, 0)]))
        tips, _ = CombDrawing(found, "curvature").tips(100.0, 5.0)
        np.testing.assert_array_equal(tips, found.point)
        self.assertEqual(len(CombDrawing(found, "torsion").teeth), 0)


class EnvelopeTest(unittest.TestCase):
    def pieces(self, found, quantity):
        members, counts = CombDrawing(found, quantity).lines()
        return np.split(members, np.cumsum(counts)[:-1])

    def test_has_a_piece_for_each_run(self):
        found = comb([arcs(), s_curve()])
        pieces = self.pieces(found, "curvature")
        self.assertEqual([(piece[0], piece[-1]) for piece in pieces],
                         [tuple(run) for run in found.runs[:, :2]])
        for piece in pieces:
            np.testing.assert_array_equal(np.diff(piece), 1)

    def test_never_passes_what_does_not_exist(self):
        found = comb([Curve.bezier([(0, 0, 0), (10, 0, 0)]), cubic()])
        pieces = self.pieces(found, "torsion")
        self.assertEqual(len(pieces), 1)
        self.assertTrue(np.isfinite(found.torsion[pieces[0]]).all())

    def test_of_nothing_is_empty(self):
        members, counts = CombDrawing(comb([]), "curvature").lines()
        self.assertEqual((len(members), len(counts)), (0, 0))

    def test_jumps(self):
        self.assertEqual(len(CombDrawing(comb(arcs()), "curvature").jumps()), 1)
        self.assertEqual(len(CombDrawing(comb(full_circle()), "curvature").jumps()), 0)
        smooth = comb(spline(5))
        self.assertEqual(len(CombDrawing(smooth, "curvature").jumps()), 0)
        self.assertEqual(len(CombDrawing(smooth, "curvature_rate").jumps()), 4)

    def test_an_inflection_is_no_jump(self):
        found = comb(s_curve())
        for quantity in ("curvature", "curvature_rate", "curvature_rate2"):
            self.assertEqual(len(CombDrawing(found, quantity).jumps()), 0, quantity)

    def test_two_curves_do_not_jump_from_one_to_the_other(self):
        self.assertEqual(len(CombDrawing(comb([cubic(), arcs()]), "curvature").jumps()), 1)


class ScaleTest(unittest.TestCase):
    def test_is_1_2_or_5_times_a_power_of_ten(self):
        for radius in np.geomspace(1e-3, 1e5, 50):
            scale = automatic_scale([comb(full_circle(radius))], "curvature")
            self.assertIn(f"{scale:e}"[0], "125")
            self.assertAlmostEqual(float(f"{scale:.0e}"), scale, delta=1e-9 * scale)

    def test_teeth_never_hide_the_shape(self):
        for curve in (cubic(), s_curve(), spline(9), arcs(), quarter_circle()):
            found = comb(curve)
            size = size_of([found])
            for quantity in COMB_QUANTITIES:
                scale = automatic_scale([found], quantity)
                if scale is None:
                    continue
                tips, _ = CombDrawing(found, quantity).tips(scale, LIMIT * size)
                lengths = np.linalg.norm(tips - found.point, axis=1)
                self.assertLess(np.nanmax(lengths), 1.01 * LIMIT * size)
                self.assertGreater(np.nanmax(lengths), 0.09 * size)

    def test_a_small_round_does_not_flatten_the_rest(self):
        large = arcs(500.0, 1000.0)
        tiny = quarter_circle(0.2)
        alone = automatic_scale([comb(large)], "curvature")
        self.assertEqual(automatic_scale([comb([large, tiny])], "curvature"), alone)

    def test_one_scale_serves_all(self):
        small, large = comb(full_circle(1.0)), comb(full_circle(100.0))
        both = automatic_scale([small, large], "curvature")
        self.assertEqual(both, automatic_scale([small], "curvature", size_of([small, large])))

    def test_rounding_has_no_scale(self):
        for quantity in ("torsion", "curvature_rate", "curvature_rate2", "torsion_rate"):
            self.assertIsNone(automatic_scale([comb(full_circle(7.0))], quantity), quantity)
        self.assertIsNone(automatic_scale([comb(Curve.bezier([(0, 0, 0), (1, 2, 3)]))],
                                          "curvature"))
        self.assertIsNone(automatic_scale([], "curvature"))

    def test_turns_with_the_size(self):
        found = [comb(Curve.bezier(factor * s_curve().poles)) for factor in (1.0, 10.0)]
        scales = [automatic_scale([each], "curvature") for each in found]
        self.assertAlmostEqual(scales[1], 100.0 * scales[0], delta=1e-9 * scales[1])


if __name__ == "__main__":
    unittest.main()
