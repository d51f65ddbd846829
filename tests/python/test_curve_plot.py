"""osculate.curve_plot: curvature and its kin over arc length along chains of curves."""
import math
import unittest

import numpy as np

import osculate
from osculate import COMB_QUANTITIES, Curve, Tolerances, curve_plot, nu_spline
from support import (
    Part, circle_then_line, cubic, full_circle, needs_freecad, quarter_circle, shared_file, spline)


def quarter_ellipse(a, b):
    """From (a, 0, 0) to (0, b, 0)."""
    return Curve.bezier([(a, 0, 0), (a, b, 0), (0, b, 0)], [1, 0.5 ** 0.5, 1])


def clothoid(length, steps):
    """A C2 cubic spline through points of the curve of curvature s."""
    middle = (np.arange(steps * 50) + 0.5) * length / (steps * 50)
    ends = np.exp(0.5j * middle ** 2).reshape(steps, 50).sum(axis=1) * length / (steps * 50)
    points = np.concatenate(([0.0], np.cumsum(ends)))
    tangent = np.exp(0.5j * length ** 2)
    return nu_spline(np.column_stack((points.real, points.imag, 0.0 * points.real)),
                     parameters="chordal", ends=((1, 0, 0), (tangent.real, tangent.imag, 0)))


class ClosedFormTest(unittest.TestCase):
    def test_circle(self):
        plot = curve_plot(full_circle(10.0))
        np.testing.assert_allclose(plot.comb.curvature, 0.1, atol=1e-13)
        self.assertAlmostEqual(plot.length, 20.0 * math.pi, delta=1e-9)
        self.assertEqual([(join.kind, join.label) for join in plot.joins],
                         3 * [("knot", "G4")] + [("closing", "G4")])
        np.testing.assert_allclose([join.s for join in plot.joins],
                                   5.0 * math.pi * np.arange(1, 5), atol=1e-9)

    def test_vertices_of_an_ellipse(self):
        plot = curve_plot(quarter_ellipse(30.0, 20.0))
        at_ends = plot.comb.curvature[[0, -1]]
        np.testing.assert_allclose(at_ends, (30.0 / 20.0 ** 2, 20.0 / 30.0 ** 2), rtol=1e-12)
        np.testing.assert_allclose(plot.comb.curvature_rate[[0, -1]], 0.0, atol=1e-12)
        x, y, _ = plot.comb.point.T
        expected = 30.0 * 20.0 / ((30.0 / 20.0 * y) ** 2 + (20.0 / 30.0 * x) ** 2) ** 1.5
        np.testing.assert_allclose(plot.comb.curvature, expected, rtol=1e-11)

    def test_curvature_of_a_clothoid_is_its_arc_length(self):
        plot = curve_plot(clothoid(1.5, 60))
        self.assertAlmostEqual(plot.length, 1.5, delta=1e-6)
        np.testing.assert_allclose(plot.comb.curvature, plot.s, atol=2e-3)

    @needs_freecad
    def test_helix(self):
        radius, pitch = 20.0, 30.0
        rise = pitch / (2.0 * math.pi)
        plot = curve_plot(Part.makeHelix(pitch, 3.0 * pitch, radius))
        inner = slice(5, -5)
        square = radius ** 2 + rise ** 2
        np.testing.assert_allclose(plot.comb.curvature[inner], radius / square, rtol=1e-5)
        np.testing.assert_allclose(plot.comb.torsion[inner], rise / square, rtol=1e-3)
        self.assertAlmostEqual(plot.length, 6.0 * math.pi * math.sqrt(square), delta=1e-4)

    def test_a_jump_is_two_samples_at_one_place(self):
        plot = curve_plot(circle_then_line())
        s = 5.0 * math.pi
        before, after = np.flatnonzero(abs(plot.s - s) < 1e-9)
        self.assertEqual(plot.s[before], plot.s[after])
        self.assertAlmostEqual(plot.comb.curvature[before], 0.1, delta=1e-13)
        self.assertEqual(plot.comb.curvature[after], 0.0)
        place, = plot.joins
        self.assertEqual((place.kind, place.order, place.label), ("join", 1, "G1"))
        self.assertEqual(place.s, plot.s[before])

    def test_series_break_at_every_knot_and_join(self):
        plot = curve_plot([spline(5), *circle_then_line()])
        for quantity in COMB_QUANTITIES:
            s, values = plot.series(quantity)
            self.assertEqual(len(s), len(plot.s) + len(plot.comb.runs) - 1)
            self.assertTrue(np.isfinite(s).all() and (np.diff(s) >= 0.0).all())
            for join in plot.joins:  # never a line from one side to the other
                here = np.flatnonzero(s == join.s)
                self.assertEqual(len(here), 3)
                self.assertTrue(np.isnan(values[here[1]]))


class ChainTest(unittest.TestCase):
    def test_order_and_direction_of_the_selection_do_not_matter(self):
        whole = spline(6, seed=3)
        random = np.random.default_rng(7)
        first, last = whole.parameter_range
        cuts = [first, *np.sort(random.uniform(first, last, 5)), last]
        pieces = [whole.trimmed(*pair) for pair in zip(cuts, cuts[1:])]
        expected = curve_plot(whole)
        for _ in range(20):
            order = random.permutation(len(pieces))
            chosen = [pieces[i].reversed() if random.random() < 0.5 else pieces[i] for i in order]
            plot = curve_plot(chosen)
            self.assertEqual((len(plot.chains), plot.chains[0].is_closed), (1, False))
            self.assertAlmostEqual(plot.length, expected.length, delta=1e-9)
            runs_backwards = plot.order != sorted(plot.order, key=lambda i: order[i])
            for share in random.uniform(0.0, 1.0, 5):
                s = share * expected.length
                at = plot.at(expected.length - s if runs_backwards else s).geometry
                other = expected.at(s).geometry
                np.testing.assert_allclose(at.point, other.point, atol=1e-8)
                self.assertAlmostEqual(at.curvature, other.curvature, delta=1e-7)
                sign = -1.0 if runs_backwards else 1.0
                self.assertAlmostEqual(sign * at.curvature_rate, other.curvature_rate, delta=1e-5)

    def test_chains_are_those_that_join_makes(self):
        whole, random = spline(5, seed=9), np.random.default_rng(11)
        pieces = [whole.trimmed(0, 1.2), whole.trimmed(1.2, 2.7), whole.trimmed(2.7, 3.1),
                  whole.trimmed(3.1, 5)]
        for _ in range(10):
            chosen = [pieces[i].reversed() if random.random() < 0.5 else pieces[i]
                      for i in random.permutation(4)]
            joined, plot = osculate.join(chosen), curve_plot(chosen)
            self.assertAlmostEqual(joined.curve.length(), plot.length, delta=1e-9)
            np.testing.assert_allclose(joined.curve.evaluate(joined.curve.parameter_range[0])[0],
                                       plot.comb.point[0], atol=1e-9)
            self.assertEqual([report.order for report in joined.input_reports],
                             [each.order for each in plot.joins if each.kind == "join"])

    def test_the_first_curve_keeps_its_direction(self):
        arc, line = circle_then_line()
        for curves in ([arc, line], [arc, line.reversed()]):
            plot = curve_plot(curves)
            self.assertEqual(plot.order, [0, 1])
            np.testing.assert_allclose(plot.comb.point[0], (10, 0, 0), atol=1e-12)
        plot = curve_plot([arc.reversed(), line])
        self.assertEqual(plot.order, [1, 0])
        np.testing.assert_allclose(plot.comb.point[0], (-10, 10, 0), atol=1e-12)

    def test_a_closed_chain_has_a_closing_join(self):
        quarters = [Curve.bezier(quarter_circle().poles @ turn, quarter_circle().weights)
                    for turn in (np.diag((1, 1, 1)), np.diag((-1, -1, 1)), np.diag((1, -1, 1)),
                                 np.diag((-1, 1, 1)))]
        plot = curve_plot(quarters)
        chain, = plot.chains
        self.assertTrue(chain.is_closed)
        self.assertEqual([(join.kind, join.label) for join in plot.joins],
                         3 * [("join", "G4")] + [("closing", "G4")])
        self.assertAlmostEqual(plot.joins[-1].s, plot.length, delta=1e-9)

    def test_where_three_meet_the_straightest_goes_on(self):
        arriving = Curve.bezier([(0, 0, 0), (10, 0, 0)])
        aside = Curve.bezier([(10, 0, 0), (10, 10, 0)])
        ahead = Curve.bezier([(20, 1, 0), (10, 0, 0)])
        plot = curve_plot([arriving, aside, ahead])
        self.assertEqual([[link.curve for link in chain.links] for chain in plot.chains],
                         [[0, 2], [1]])

    def test_gaps(self):
        line = Curve.bezier([(0, 0, 0), (10, 0, 0)])
        for gap, chains, kind in ((0.0005, 1, "join"), (0.05, 1, "join"), (3.0, 2, "gap")):
            plot = curve_plot([line, Curve.bezier([(10 + gap, 0, 0), (20, 0, 0)])])
            join, = plot.joins
            self.assertEqual((len(plot.chains), join.kind), (chains, kind))
            self.assertAlmostEqual(join.gap_mm, gap, delta=1e-12)
            self.assertEqual(join.label, "G4" if gap < 0.001 else "gap")
            self.assertEqual(join.s, 10.0)

    def test_a_closed_curve_is_a_chain_of_its_own(self):
        plot = curve_plot([full_circle(), Curve.bezier([(10, 0, 0), (20, 0, 0)])])
        self.assertEqual([chain.is_closed for chain in plot.chains], [True, False])

    def test_scaling_and_rigid_motion(self):
        poles = cubic().poles
        turn = np.linalg.qr(np.random.default_rng(2).normal(size=(3, 3)))[0]
        turn *= np.linalg.det(turn)
        plain, moved = (curve_plot(Curve.bezier(p)) for p in (poles, 4 * poles @ turn.T + 7))
        for share in (0.1, 0.5, 0.9):
            one = plain.at(share * plain.length).geometry
            other = moved.at(share * moved.length).geometry
            self.assertAlmostEqual(one.curvature, 4 * other.curvature, delta=1e-9)
            self.assertAlmostEqual(one.torsion, 4 * other.torsion, delta=1e-9)
            self.assertAlmostEqual(one.curvature_rate, 16 * other.curvature_rate, delta=1e-8)


class PointTest(unittest.TestCase):
    def test_is_on_the_curve_that_was_given(self):
        line, curve = Curve.bezier([(-5, 0, 0), (0, 0, 0)]), cubic()
        plot = curve_plot([line, curve.reversed()])
        for s in np.linspace(0.0, plot.length, 23):
            at = plot.at(s)
            own = (line, curve.reversed())[at.curve]
            np.testing.assert_allclose(own.evaluate(at.parameter)[0], at.geometry.point, atol=1e-9)

    def test_agrees_with_the_samples(self):
        plot = curve_plot([spline(4), *circle_then_line()])
        for i in range(0, len(plot.s), 11):
            at = plot.at(plot.s[i])
            np.testing.assert_allclose(at.geometry.point, plot.comb.point[i], atol=1e-8)

    def test_beyond_the_ends_is_the_end(self):
        plot = curve_plot(cubic())
        np.testing.assert_allclose(plot.at(-3.0).geometry.point, (0, 0, 0), atol=1e-12)
        self.assertEqual(plot.at(1e9).s, plot.length)


class BadInputTest(unittest.TestCase):
    def test_what_is_no_curve(self):
        for value in (None, 3, "Edge1", [cubic(), None]):
            with self.subTest(value), self.assertRaisesRegex(TypeError, "curves"):
                curve_plot(value)

    def test_nothing(self):
        with self.assertRaisesRegex(ValueError, "curves: at least one is needed"):
            curve_plot([])
        with self.assertRaisesRegex(ValueError, "quantities: at least one is needed"):
            curve_plot(cubic(), quantities=())

    def test_options(self):
        for options, error, words in (
                ({"quantities": "speed"}, ValueError, "quantities: 'speed' is none of curvature"),
                ({"order": 9}, ValueError, "order"),
                ({"tolerances": "none"}, ValueError, "none"),
                ({"tolerances": 3}, TypeError, "tolerances"),
                ({"density": 1}, ValueError, "density: must be from 2")):
            with self.subTest(options), self.assertRaisesRegex(error, words):
                curve_plot(cubic(), **options)

    def test_tolerances_decide_what_meets(self):
        lines = [Curve.bezier([(0, 0, 0), (10, 0, 0)]), Curve.bezier([(10.5, 0, 0), (20, 0, 0)])]
        wide = curve_plot(lines, tolerances=Tolerances(gap_mm=1.0))
        self.assertEqual([join.order for join in wide.joins], [4])


@needs_freecad
class RealModelsTest(unittest.TestCase):
    def check(self, name, least_joins):
        shape = Part.read(str(shared_file(f"data/{name}")))
        curves = [Curve.from_edge(edge) for edge in shape.Edges if not edge.Degenerated][:300]
        plot = curve_plot(curves)
        self.assertEqual(sorted(plot.order), list(range(len(curves))))
        total = sum(curve.length() for curve in curves)
        self.assertAlmostEqual(plot.length, total, delta=1e-12 * total)
        joins = [each for each in plot.joins if each.kind == "join"]
        self.assertGreaterEqual(len(joins), least_joins)
        self.assertLess(max(each.gap_mm for each in joins), 0.1)
        self.assertTrue((np.diff(plot.s) >= 0.0).all())

    def test_propeller(self):
        self.check("Propeller.brep", 100)

    def test_impeller(self):
        self.check("impeller.igs", 200)


@needs_freecad
class EdgesTest(unittest.TestCase):
    def test_a_wire_and_a_whole_shape(self):
        wire = Part.makePolygon([(0, 0, 0), (10, 0, 0), (10, 5, 0), (0, 5, 0), (0, 0, 0)])
        for shape in (wire, Part.Face(wire), wire.Edges, Part.Compound(wire.Edges[::-1])):
            plot = curve_plot(shape)
            self.assertEqual([chain.is_closed for chain in plot.chains], [True])
            self.assertAlmostEqual(plot.length, 30.0, delta=1e-12)
            self.assertEqual([join.label for join in plot.joins], 4 * ["G0"])

    def test_all_edges_of_a_box(self):
        plot = curve_plot(Part.makeBox(1, 2, 3))
        self.assertAlmostEqual(plot.length, 24.0, delta=1e-12)
        self.assertEqual(sorted(plot.order), list(range(12)))

    def test_a_null_shape(self):
        with self.assertRaisesRegex(ValueError, "curves"):
            curve_plot(Part.Shape())


if __name__ == "__main__":
    unittest.main()
