"""osculate.JoinReport: every attribute of a join known by hand, None where nothing exists, text."""
import json
import math
import unittest

import numpy as np

from osculate import Curve, analyze
from support import circle_then_line, cubic, quarter_circle


def line_then_singular_end():
    """A line and (t^2, t^3), which has one arc-length derivative and no more at its start."""
    return (Curve.bezier([(-1, 0, 0), (0, 0, 0)]),
            Curve.bezier([(0, 0, 0), (0, 0, 0), (1 / 3, 0, 0), (1, 1, 0)]))


class NumbersTest(unittest.TestCase):
    """A quarter circle of radius 10, then a line: G1, curvature 0.1 against 0."""

    @classmethod
    def setUpClass(cls):
        cls.report = analyze(*circle_then_line(), order=3)

    def test_orders_and_verdicts(self):
        self.assertEqual(self.report.order, 1)
        self.assertEqual(self.report.parametric_order, 0)
        self.assertEqual(self.report.requested_order, 3)
        self.assertEqual(self.report.verdicts, ("pass", "pass", "fail", "fail"))

    def test_residuals_of_each_order(self):
        report = self.report
        self.assertEqual(report.residuals[:2], (0, 0))
        self.assertAlmostEqual(report.residuals[2], 1, delta=1e-13)  # |0.1 - 0| / max(0.1, 1/L)
        # r_3 = -kappa^2 T of the circle, 0 of the line: 0.01 / max(0.01, 1/L^2), L = 10
        self.assertAlmostEqual(report.residuals[3], 1, delta=1e-12)
        self.assertEqual(report.tolerances, (1e-3, 0.1, 0.01, 0.02))
        for uncertainty, tolerance in zip(report.uncertainties, report.tolerances):
            self.assertGreater(uncertainty, 0)
            self.assertLess(uncertainty, tolerance)

    def test_parametric_residuals_up_to_the_first_that_fails(self):
        # |P' - Q'| / max(|P'|, |Q'|), both along the tangent: 1 - 10 / (20 sqrt(1/2))
        position, derivative = self.report.parametric_residuals
        self.assertEqual(position, 0)
        self.assertAlmostEqual(derivative, 1 - 0.5 ** 0.5, delta=1e-13)

    def test_beta_up_to_the_first_order_that_fails(self):
        # |Q'| = 10, |P'| at the end = 2 * 10 sqrt(1/2) (mathematics: 2 w1/w2 |P2 - P1|)
        self.assertAlmostEqual(self.report.beta[0], 10 / (20 * 0.5 ** 0.5), delta=1e-13)
        self.assertEqual(self.report.beta[1:], (None, None))

    def test_deviation(self):
        deviation = self.report.deviation
        self.assertEqual(deviation["gap_mm"], 0)
        self.assertAlmostEqual(deviation["tangent_angle_deg"], 0, delta=1e-12)
        self.assertAlmostEqual(deviation["curvature_vector_per_mm"], 0.1, delta=1e-14)
        self.assertAlmostEqual(deviation["curvature_relative"], 1, delta=1e-13)
        for name in ("osculating_plane_angle_deg", "torsion_per_mm", "torsion_rate_per_mm2"):
            self.assertIsNone(deviation[name], name)

    def test_sides(self):
        circle, straight = self.report.sides
        self.assertEqual((circle.end, straight.end), ("end", "start"))
        self.assertEqual(self.report.ends, ("end", "start"))
        for side in (circle, straight):
            np.testing.assert_allclose(side.point, [0, 10, 0], atol=1e-14)
            np.testing.assert_allclose(side.tangent, [-1, 0, 0], atol=1e-14)
            self.assertEqual(side.multiplicity, 1)
        np.testing.assert_allclose(circle.normal, [0, -1, 0], atol=1e-14)
        np.testing.assert_allclose(circle.binormal, [0, 0, 1], atol=1e-14)
        self.assertAlmostEqual(circle.curvature, 0.1, delta=1e-15)
        self.assertAlmostEqual(circle.torsion, 0, delta=1e-15)
        self.assertEqual(straight.curvature, 0)
        self.assertEqual((circle.linearity, straight.linearity), (1, 1))
        np.testing.assert_allclose(circle.segment.poles, quarter_circle().poles, rtol=1e-15)
        np.testing.assert_array_equal(circle.segment.weights, quarter_circle().weights)

    def test_what_a_straight_side_has_not_is_none(self):
        straight = self.report.sides[1]
        for name in ("normal", "binormal", "torsion", "torsion_rate"):
            self.assertIsNone(getattr(straight, name), name)

    def test_derivatives_in_frame(self):
        first, second = (side.derivatives_in_frame for side in self.report.sides)
        self.assertEqual((first.shape, second.shape), ((5, 3), (5, 3)))
        np.testing.assert_allclose(first[0], [0, 0, 0], atol=1e-14)
        np.testing.assert_allclose(second[1], [10, 0, 0], atol=1e-13)
        np.testing.assert_allclose(second[2:], np.zeros((3, 3)), atol=1e-13)
        speed = first[1, 0]
        self.assertAlmostEqual(first[2, 1], 0.1 * speed ** 2, delta=1e-12)  # P''.n = kappa |P'|^2

    def test_frame_of_the_first_curve(self):
        frame = self.report.frame
        np.testing.assert_allclose([frame.tangent, frame.normal, frame.binormal],
                                   [[-1, 0, 0], [0, -1, 0], [0, 0, 1]], atol=1e-14)
        self.assertEqual(self.report.frame_kind, "frenet")
        self.assertEqual(analyze(*reversed(circle_then_line())).frame_kind, "line")

    def test_definitions_with_their_details(self):
        definitions, details = self.report.definitions, self.report.definition_details
        self.assertEqual(definitions["g2-vector"], "fail")
        self.assertEqual(list(definitions), list(details))
        for name, detail in details.items():
            self.assertEqual(detail.verdict, definitions[name])
            self.assertTrue(detail.who and detail.meaning, name)
            self.assertEqual(detail.value is None, detail.verdict is None, name)
            self.assertEqual(detail.tolerance is None, detail.verdict is None, name)
        self.assertEqual(details["g3-graph-angle"].unit, "deg")
        self.assertAlmostEqual(details["g2-maximum"].value, 1, delta=1e-12)
        self.assertEqual(details["g2-maximum"].tolerance, 0.01)

    def test_warnings_are_found_by_their_code(self):
        self.assertEqual(self.report.warnings, ())
        back = analyze(Curve.bezier([(0, 0, 0), (2, 0, 0)]), Curve.bezier([(2, 0, 0), (1, 0, 0)]))
        self.assertIn("cusp", back.warnings)
        self.assertNotIn("near-flat", back.warnings)
        warning = next(warning for warning in back.warnings if warning == "cusp")
        self.assertEqual(warning.code, "cusp")
        self.assertEqual(str(warning), f"cusp: {warning.sentence}")
        self.assertEqual({warning: 1}["cusp"], 1)
        with self.assertRaises(AttributeError):
            warning.code = "none"

    def test_read_only(self):
        report = self.report
        for owner in (report, report.sides[0], report.frame):
            with self.assertRaises(AttributeError):
                owner.order = 3
        report.sides[0].point[:] = 99
        report.deviation["gap_mm"] = 99
        np.testing.assert_allclose(report.sides[0].point, [0, 10, 0], atol=1e-14)
        self.assertEqual(report.deviation["gap_mm"], 0)

    def test_a_side_outlives_its_report(self):
        side = analyze(*circle_then_line()).sides[0]
        self.assertAlmostEqual(side.curvature, 0.1, delta=1e-15)


class SingularEndTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.report = analyze(*line_then_singular_end())

    def test_residuals_that_do_not_exist_are_none(self):
        self.assertEqual(self.report.order, 1)
        self.assertEqual(self.report.residuals[2:], (None, None, None))
        self.assertEqual(self.report.verdicts[2:], ("fail", "fail", "fail"))

    def test_the_side_says_what_it_has(self):
        side = self.report.sides[1]
        self.assertEqual((side.multiplicity, side.smoothness), (2, 1))
        self.assertIsNone(side.curvature)
        np.testing.assert_allclose(side.tangent, [1, 0, 0], atol=1e-14)
        self.assertIn("degenerate-tangent", self.report.warnings)
        self.assertIn("fractional-smoothness", self.report.warnings)


class TextTest(unittest.TestCase):
    def test_headline(self):
        self.assertEqual(analyze(*cubic().split(0.5)).headline, "G4")
        self.assertEqual(analyze(*circle_then_line()).headline,
                         "G1, misses G2 by 1 (tolerance 0.01)")

    def test_repr_is_the_headline(self):
        self.assertEqual(repr(analyze(*circle_then_line())),
                         "<osculate.JoinReport: G1, misses G2 by 1 (tolerance 0.01)>")

    def test_str_is_a_table_with_every_order(self):
        report = analyze(*circle_then_line())
        lines = str(report).splitlines()
        self.assertEqual(lines[0], report.headline)
        for order, verdict in enumerate(report.verdicts):
            row = next(line for line in lines if line.split()[:1] == [f"G{order}"])
            self.assertIn(verdict.upper() if verdict == "fail" else verdict, row)
        self.assertLessEqual(max(map(len, lines)), 140)
        for text in ("curvature", "torsion", "g3-vector", "beta"):
            self.assertIn(text, str(report))

    def test_disagreement_is_empty_where_the_definitions_agree(self):
        self.assertEqual(analyze(*cubic().split(0.5)).disagreement, "")


class DictTest(unittest.TestCase):
    def reports(self):
        yield analyze(*cubic().split(0.5), order=8)
        yield analyze(*circle_then_line())
        yield analyze(*line_then_singular_end())

    def test_json_and_dict_are_the_same(self):
        for report in self.reports():
            self.assertEqual(json.loads(report.to_json()), report.to_dict())
            self.assertEqual(json.loads(report.to_json(indent=2)), report.to_dict())
            self.assertEqual(report.to_dict()["schema"], "osculate.join/1")

    def test_the_attributes_say_what_the_dict_says(self):
        for report in self.reports():
            data = report.to_dict()
            for name in ("order", "parametric_order", "requested_order", "preset", "scale_mm",
                         "deviation", "frame_kind", "parameter"):
                self.assertEqual(getattr(report, name), data[name], name)
            for name in ("verdicts", "residuals", "tolerances", "uncertainties", "beta",
                         "parametric_residuals"):
                self.assertEqual(list(getattr(report, name)), data[name], name)
            self.assertEqual(report.definitions, {
                name: detail["verdict"] for name, detail in data["definitions"].items()})
            self.assertEqual([(warning.code, warning.sentence) for warning in report.warnings],
                             [(warning["code"], warning["sentence"])
                              for warning in data["warnings"]])

    def test_the_sides_say_what_the_dict_says(self):
        for report in self.reports():
            for side, data in zip(report.sides, report.to_dict()["sides"]):
                for name in ("end", "curvature", "torsion", "curvature_rate", "curvature_rate2",
                             "torsion_rate", "linearity", "multiplicity"):
                    self.assertEqual(getattr(side, name), data[name], name)
                for name in ("point", "tangent", "normal", "binormal", "derivatives_in_frame"):
                    value = getattr(side, name)
                    self.assertEqual(None if value is None else value.tolist(), data[name], name)
                self.assertEqual(side.segment.poles.tolist(), data["segment"]["poles"])

    def test_no_number_is_nan_or_infinite(self):
        def refuse(name):
            self.fail(f"{name} in the JSON text")

        for report in self.reports():
            json.loads(report.to_json(), parse_constant=refuse)
            self.assertTrue(all(value is None or math.isfinite(value)
                                for value in report.residuals + report.uncertainties))


if __name__ == "__main__":
    unittest.main()
