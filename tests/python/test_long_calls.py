"""Threads, the GIL, progress, stopping, and memory over many analyses."""
import threading
import time
import unittest
from concurrent.futures import ThreadPoolExecutor

import numpy as np

from osculate import Curve, analyze, analyze_edge, analyze_joins
from support import assert_no_growth, circle_then_line, cubic, spline


class ThreadsTest(unittest.TestCase):
    def test_one_curve_in_four_threads(self):
        curve = spline(60)
        expected = [report.to_json() for report in analyze_edge(curve, order=8)]

        def analyse(_):
            return [report.to_json() for report in analyze_edge(curve, order=8)]

        with ThreadPoolExecutor(4) as threads:
            for found in threads.map(analyse, range(20)):
                self.assertEqual(found, expected)

    def test_a_long_call_lets_other_threads_run(self):
        """While the call runs, this thread must not stand still for most of its time."""
        poles = np.random.default_rng(1).normal(size=(2, 250_000, 6, 3))
        duration = []

        def analyse():
            start = time.perf_counter()
            analyze_joins(*poles, order=8)
            duration.append(time.perf_counter() - start)

        thread = threading.Thread(target=analyse)
        longest, last = 0.0, time.perf_counter()
        thread.start()
        while thread.is_alive():
            now = time.perf_counter()
            longest, last = max(longest, now - last), now
        thread.join()
        self.assertLess(longest, 0.5 * duration[0])


class ProgressTest(unittest.TestCase):
    def test_shares_increase_to_one(self):
        shares = []
        analyze_edge(spline(20), progress=shares.append)
        self.assertEqual(shares, sorted(shares))
        self.assertEqual((shares[0], shares[-1]), (0, 1))

    def test_false_stops_and_what_was_done_is_returned(self):
        calls = []
        reports = analyze_edge(spline(20), progress=lambda share: calls.append(share) or
                               len(calls) <= 5)
        self.assertEqual([report.parameter for report in reports], [1, 2, 3, 4, 5])

    def test_an_answer_without_a_truth_value_is_an_error(self):
        with self.assertRaisesRegex(ValueError, "truth value"):
            analyze_edge(spline(3), progress=lambda share: np.zeros(3))

    def test_none_goes_on(self):
        self.assertEqual(len(analyze_edge(spline(20), progress=lambda share: None)), 19)

    def test_an_exception_is_raised(self):
        def fail(share):
            raise LookupError("from the callback")

        with self.assertRaisesRegex(LookupError, "from the callback"):
            analyze_edge(spline(20), progress=fail)
        with self.assertRaisesRegex(LookupError, "from the callback"):
            analyze_joins(np.ones((3, 2, 3)), np.ones((3, 2, 3)), progress=fail)
        self.assertEqual(len(analyze_edge(spline(20))), 19)

    def test_a_batch_stops_with_the_rows_done(self):
        poles = np.random.default_rng(1).normal(size=(2, 200_000, 2, 3))
        shares = []
        batch = analyze_joins(*poles, order=1, progress=lambda share: shares.append(share) or
                              share < 0.3)
        self.assertTrue(0 < len(batch.order) < 200_000)
        for array in batch:
            self.assertEqual(len(array), len(batch.order))
            self.assertTrue(array.flags.owndata)
        whole = analyze_joins(*poles, order=1)
        np.testing.assert_array_equal(batch.residuals, whole.residuals[:len(batch.order)])

    def test_a_batch_stopped_at_once_is_empty(self):
        batch = analyze_joins(np.ones((3, 2, 3)), np.ones((3, 2, 3)), progress=lambda share: False)
        self.assertEqual(len(batch.order), 0)


class MemoryTest(unittest.TestCase):
    def test_100_000_analyses_with_their_attributes(self):
        a, b = circle_then_line()

        def analyse():
            report = analyze(a, b)
            return (report.verdicts, report.residuals, report.beta, report.deviation,
                    report.sides[0].normal, report.sides[1].segment, report.warnings)

        assert_no_growth(self, analyse, 100_000)

    def test_reports_as_dict_and_json(self):
        a, b = circle_then_line()

        def analyse():
            report = analyze(a, b)
            return report.to_dict(), report.to_json(), str(report)

        assert_no_growth(self, analyse, 10_000)

    def test_curves_and_their_arrays(self):
        poles = cubic().poles

        def make():
            curve = Curve.bezier(poles)
            return curve.poles, curve.evaluate([0, 0.5, 1], 2), curve.split(0.5)

        assert_no_growth(self, make, 20_000)

    def test_errors(self):
        a, b = circle_then_line()

        def fail():
            with self.assertRaises(ValueError):
                analyze(a, b, order=9)

        assert_no_growth(self, fail, 20_000)


if __name__ == "__main__":
    unittest.main()
