"""The reference joins (exact orders, invariants and residuals to 20 digits) through the API."""
import json
import math
import unittest

from osculate import Curve, analyze
from support import shared_file

INVARIANTS = {"kappa": "curvature", "tau": "torsion", "dkappa_ds": "curvature_rate",
              "d2kappa_ds2": "curvature_rate2", "dtau_ds": "torsion_rate"}
RELATIVE_ERROR = 1e-9


def curve(data):
    weights = data["weights"] and [float(weight) for weight in data["weights"]]
    return Curve.bezier([[float(x) for x in point] for point in data["points"]], weights)


def number(text):
    return None if text is None else float(text)


def norm(texts):
    return math.hypot(*map(float, texts))


class OracleTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.pairs = json.loads(shared_file("oracle/joins.json").read_text())["pairs"]

    def reports(self, **options):
        for pair in self.pairs:
            with self.subTest(pair["id"]):
                yield pair, analyze(curve(pair["P"]), curve(pair["Q"]), ends=("end", "start"),
                                    **options)

    def test_orders(self):
        for pair, report in self.reports(order=4, tolerances="exact"):
            expected = min(4, float(pair["order"]))
            self.assertEqual(report.order, expected, report)

    def test_orders_up_to_eight(self):
        """Beyond order 4 an order may be undecided, never wrong."""
        for pair, report in self.reports(order=8, tolerances="exact"):
            expected = min(8, float(pair["order"]))
            self.assertLessEqual(report.order, expected, report)
            if report.order < expected:
                self.assertEqual(report.verdicts[report.order + 1], "undecided", report)

    def test_invariants(self):
        for pair, report in self.reports():
            for letter, side in zip("PQ", report.sides):
                for key, name in INVARIANTS.items():
                    self.assert_close(getattr(side, name), number(pair["invariants"][letter][key]),
                                      float(pair["size"]), f"{letter}.{name}")

    def assert_close(self, value, expected, size, message):
        """Numbers that are zero but for rounding are compared on the scale of the curve."""
        if expected is None:
            return self.assertIsNone(value, message)
        allowed = max(RELATIVE_ERROR * abs(expected), 1e-13 / size)
        self.assertLessEqual(abs(value - expected), allowed, message)

    def test_residuals(self):
        """|r_k - r_k'| / max(|r_k|, |r_k'|, L^(1-k)) from the reference derivatives."""
        for pair, report in self.reports(order=4):
            for order in range(2, 5):
                if pair["residuals"][order] is None:
                    continue
                sizes = [norm(pair["arc_derivatives"][letter][order - 1]) for letter in "PQ"]
                expected = float(pair["residuals"][order]) / max(
                    *sizes, report.scale_mm ** (1 - order))
                self.assertAlmostEqual(report.residuals[order], expected,
                                       delta=report.uncertainties[order])


if __name__ == "__main__":
    unittest.main()
