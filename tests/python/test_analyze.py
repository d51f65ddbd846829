"""osculate.analyze and analyze_edge on Curve values: ends, closed curves, options, inner knots."""
import unittest

import numpy as np

import osculate
from osculate import Curve, Tolerances, analyze, analyze_edge
from support import circle_then_line, cubic, full_circle, quarter_circle, spline


def line(*points):
    return Curve.bezier(points)


class EndsTest(unittest.TestCase):
    def test_nearest_ends_in_every_arrangement(self):
        first, second = cubic().split(0.5)
        for a, end_a in ((first, "end"), (first.reversed(), "start")):
            for b, end_b in ((second, "start"), (second.reversed(), "end")):
                report = analyze(a, b)
                self.assertEqual(report.ends, (end_a, end_b))
                self.assertEqual(report.order, 4)
        self.assertEqual(analyze(second, first).ends, ("start", "end"))

    def test_given_ends_are_obeyed(self):
        first, second = cubic().split(0.5)
        report = analyze(first, second, ends=("start", "end"))
        self.assertEqual(report.ends, ("start", "end"))
        self.assertEqual(report.order, -1)
        np.testing.assert_array_equal(report.sides[0].point, first.poles[0])
        np.testing.assert_array_equal(report.sides[1].point, second.poles[-1])

    def test_ends_may_be_a_list(self):
        self.assertEqual(analyze(*cubic().split(0.5), ends=["end", "start"]).order, 4)

    def test_two_curves_that_touch_at_both_ends(self):
        there = quarter_circle()
        back = line((0, 10, 0), (10, 0, 0))
        report = analyze(there, back)
        self.assertEqual(report.ends, ("end", "start"))
        self.assertIn("touches-at-both-ends", report.warnings)

    def test_one_pair_of_touching_ends_is_no_tie(self):
        self.assertNotIn("touches-at-both-ends", analyze(*circle_then_line()).warnings)


class SameCurveTest(unittest.TestCase):
    def test_a_closed_curve_against_itself_is_its_closing_join(self):
        for circle in (full_circle(), full_circle().reversed()):
            report = analyze(circle, circle)
            self.assertEqual((report.order, report.ends), (4, ("end", "start")))
            self.assertNotIn("touches-at-both-ends", report.warnings)

    def test_the_closing_join_travelled_backwards(self):
        drop = Curve.bezier([(0, 0, 0), (10, 0, 0), (10, 10, 0), (0, 0, 0)])
        forth = analyze(drop, drop)
        back = analyze(drop, drop, ends=("start", "end"))
        self.assertEqual(forth.order, 0)
        self.assertEqual(back.ends, ("start", "end"))
        self.assertAlmostEqual(back.deviation["tangent_angle_deg"],
                               forth.deviation["tangent_angle_deg"])

    def test_equal_curves_are_one(self):
        with self.assertRaisesRegex(ValueError, "b: is the same curve as a, which is open"):
            analyze(cubic(), cubic())
        self.assertEqual(analyze(full_circle(), full_circle()).order, 4)

    def test_the_same_open_curve_twice(self):
        curve = cubic()
        with self.assertRaisesRegex(ValueError, "open"):
            analyze(curve, curve)

    def test_the_gap_tolerance_says_what_is_closed(self):
        almost = Curve.bezier([(0, 0, 0), (10, 0, 0), (10, 10, 0), (0, 0.01, 0)])
        with self.assertRaises(ValueError):
            analyze(almost, almost)
        report = analyze(almost, almost, tolerances=Tolerances(gap_mm=0.1))
        self.assertEqual(report.order, 0)

    def test_a_closed_curve_has_no_other_ends(self):
        with self.assertRaisesRegex(ValueError, "ends"):
            analyze(full_circle(), full_circle(), ends=("end", "end"))


class OptionsTest(unittest.TestCase):
    def test_order_sets_how_much_is_analysed(self):
        curves = cubic().split(0.5)
        for order in range(osculate.MAX_ORDER + 1):
            report = analyze(*curves, order=order)
            self.assertEqual(report.requested_order, order)
            self.assertEqual(report.order, order)
            for name in ("verdicts", "residuals", "tolerances", "uncertainties"):
                self.assertEqual(len(getattr(report, name)), order + 1, name)
            self.assertEqual(len(report.beta), order)

    def test_numpy_integers_are_integers(self):
        self.assertEqual(analyze(*cubic().split(0.5), order=np.int64(3)).order, 3)

    def test_tolerances_by_name_by_value_or_default(self):
        curves = circle_then_line()
        self.assertEqual(analyze(*curves).tolerances, (1e-3, 0.1, 0.01, 0.02, 0.05))
        by_name = analyze(*curves, tolerances="exact")
        by_value = analyze(*curves, tolerances=Tolerances.preset("exact"))
        self.assertEqual(by_name.to_json(), by_value.to_json())
        self.assertEqual(by_name.preset, "exact")

    def test_a_loose_tolerance_passes_what_a_strict_one_fails(self):
        first = quarter_circle()
        second = Curve.bezier([(0, 10, 0), (-5, 10.05, 0), (-10, 8, 0)])
        self.assertEqual(analyze(first, second).order, 0)
        self.assertEqual(analyze(first, second, tolerances=Tolerances(angle_deg=1)).order, 1)

    def test_scale_mm_overrides_the_reach(self):
        curves = circle_then_line()
        self.assertAlmostEqual(analyze(*curves).scale_mm, 10, delta=1e-12)
        report = analyze(*curves, scale_mm=2)
        self.assertEqual(report.scale_mm, 2)
        # |r_2 - r_2'| / max(|r_2|, |r_2'|, 1/L) = 0.1 / 0.5
        self.assertAlmostEqual(report.residuals[2], 0.2, delta=1e-12)


class KnownJoinsTest(unittest.TestCase):
    def order(self, a, b, **options):
        return analyze(a, b, ends=("end", "start"), **options).order

    def test_gap(self):
        report = analyze(line((0, 0, 0), (1, 0, 0)), line((1, 0.5, 0), (2, 0.5, 0)))
        self.assertEqual(report.order, -1)
        self.assertEqual(report.parametric_order, -1)
        self.assertEqual(report.residuals[0], 0.5)
        self.assertEqual(report.deviation["gap_mm"], 0.5)

    def test_collinear_lines(self):
        self.assertEqual(self.order(line((0, 0, 0), (1, 0, 0)), line((1, 0, 0), (4, 0, 0))), 4)

    def test_right_angle_and_cusp(self):
        corner = analyze(line((0, 0, 0), (1, 0, 0)), line((1, 0, 0), (1, 1, 0)))
        self.assertEqual((corner.order, corner.residuals[1]), (0, 90))
        cusp = analyze(line((0, 0, 0), (1, 0, 0)), line((1, 0, 0), (0.5, 0, 0)))
        self.assertEqual((cusp.order, cusp.residuals[1]), (0, 180))
        self.assertIn("cusp", cusp.warnings)

    def test_s_join_of_equal_circles(self):
        up = Curve.bezier([(0, 10, 0), (-10, 10, 0), (-10, 20, 0)], [1, 0.5 ** 0.5, 1])
        report = analyze(quarter_circle(), up)
        self.assertEqual(report.order, 1)
        self.assertEqual(report.definitions["g2-maximum"], "pass")
        self.assertEqual(report.definitions["g2-vector"], "fail")
        self.assertIn("opposite", report.disagreement)

    def test_line_to_arc(self):
        self.assertEqual(analyze(*circle_then_line()).order, 1)

    def test_geometric_but_not_parametric(self):
        first, second = cubic().split(0.5)
        moebius = Curve.bezier(second.poles, [1, 3, 9, 27])
        report = analyze(first, moebius)
        self.assertEqual(report.order, 4)
        self.assertEqual(report.parametric_order, 0)
        self.assertAlmostEqual(report.beta[0], 3, delta=1e-12)
        self.assertEqual(report.definitions["c3"], "fail")

    def test_reversal_elevation_and_scaling_change_no_verdict(self):
        for a, b in (cubic().split(0.4), circle_then_line()):
            report = analyze(a, b)
            for p, q in ((b.reversed(), a.reversed()), (a.elevated(2), b), (a, b.elevated(3))):
                self.assertEqual(analyze(p, q).verdicts, report.verdicts)
            for got, wanted in zip(analyze(b.reversed(), a.reversed()).residuals, report.residuals):
                self.assertAlmostEqual(got, wanted, delta=1e-9)


class InnerJoinsTest(unittest.TestCase):
    def test_a_report_for_each_inner_knot(self):
        curve = spline(5)
        reports = analyze_edge(curve)
        self.assertEqual([report.parameter for report in reports], [1, 2, 3, 4])
        for report in reports:
            self.assertEqual(report.ends, ("end", "start"))
            self.assertGreaterEqual(report.order, 2)
            self.assertEqual(report.parametric_order, 2)
            np.testing.assert_allclose(report.sides[0].point, curve.evaluate(report.parameter)[0],
                                       atol=1e-12)

    def test_a_smooth_knot_of_low_continuity_multiplicity(self):
        orders = [(report.order, report.parametric_order) for report in analyze_edge(full_circle())]
        self.assertEqual(orders, [(4, 1)] * 4)  # quarters as rational quadratics are C1

    def test_a_closed_curve_ends_with_its_closing_join(self):
        reports = analyze_edge(spline(6, periodic=True))
        self.assertEqual([report.parameter for report in reports], [1, 2, 3, 4, 5, None])
        self.assertEqual(reports[-1].parametric_order, 2)

    def test_one_open_segment_has_none(self):
        self.assertEqual(analyze_edge(cubic()), [])

    def test_options(self):
        reports = analyze_edge(spline(4), order=1, tolerances="exact")
        self.assertEqual({len(report.verdicts) for report in reports}, {2})
        self.assertEqual({report.preset for report in reports}, {"exact"})


if __name__ == "__main__":
    unittest.main()
