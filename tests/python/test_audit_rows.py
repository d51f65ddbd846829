"""The rows of an audit as the panel ranks, sorts and filters them."""
import time
import unittest
from types import SimpleNamespace

import numpy as np

from osculate import AuditColumns, Tolerances, audit
from osculate.audit_rows import AuditRows, RowFilter
from support import FreeCAD, Part, needs_freecad

TOLERANCES = Tolerances.preset("osculate")


def rows_of(order, residuals, edges=None):
    """AuditRows of orders and of the residuals of G0, G1, ..."""
    count = len(order)
    edges = edges if edges is not None else [(2 * i + 1, 2 * i + 2) for i in range(count)]
    residuals = np.asarray(residuals, float)
    columns = AuditColumns(np.zeros(count, np.uint8), np.asarray(edges, np.int32),
                           np.asarray(order, np.int8), np.asarray(order, np.int8),
                           np.zeros((count, 3)), np.zeros(residuals.shape, np.uint8), residuals)
    return AuditRows(SimpleNamespace(columns=lambda: columns), TOLERANCES)


class RankTest(unittest.TestCase):
    def test_lower_orders_first_then_what_misses_more(self):
        rows = rows_of([1, 0, 1, -1], [(0, 0, .5), (0, 3, 0), (0, 0, np.inf), (1, 0, 0)])
        np.testing.assert_array_equal(rows.rank, [4, 2, 3, 1])
        np.testing.assert_array_equal(rows.worst(), [3, 1, 2, 0])
        np.testing.assert_array_equal(rows.worst(below=1), [3, 1])
        self.assertEqual([rows.count(order) for order in (-1, 0, 1, 2)], [1, 1, 2, 0])

    def test_missed_by_is_in_tolerances_of_the_next_order(self):
        rows = rows_of([0, 2], [(0, 3.0, 9.0), (0, 0, 0.001)])
        np.testing.assert_allclose(rows.missed_by, [3.0 / TOLERANCES.angle_deg,
                                                    0.001 / TOLERANCES.curvature])

    @needs_freecad
    def test_is_the_order_of_the_core(self):
        wires = [Part.makePolygon([FreeCAD.Vector(*point) for point in points]) for points in (
            ((0, 0, 0), (1, 0, 0), (2, .3, 0), (2, 1, 0)), ((9, 0, 0), (9, 1, 1), (9, 2, 1)))]
        shape = Part.Compound([Part.makeTorus(10, 2, FreeCAD.Vector(30, 0, 0)), *wires,
                               Part.makeCylinder(2, 5), Part.makeHelix(2, 7, 3)])
        report = audit(shape)
        rows = AuditRows(report, TOLERANCES)
        self.assertGreater(len(rows), 20)
        self.assertEqual(rows.worst().tolist(), [row.index for row in report.worst(len(rows))])


class SortTest(unittest.TestCase):
    def setUp(self):
        self.rows = rows_of([1, 0, 1, 2], [(0, 0, .5), (0, 3, np.inf), (.002, 0, .7), (0, 0, 0)],
                            [(1, 12), (2, 9), (1, 2), (7, 7)])

    def sorted(self, key, descending=False, members=(0, 1, 2, 3)):
        return self.rows.sorted(np.array(members, int), key, descending).tolist()

    def test_by_rank(self):
        self.assertEqual(self.sorted("rank"), [1, 2, 0, 3])
        self.assertEqual(self.sorted("rank", True), [3, 0, 2, 1])

    def test_edges_sort_as_numbers(self):
        self.assertEqual(self.sorted("edges"), [2, 0, 1, 3])

    def test_a_residual_that_does_not_exist_is_last_both_ways(self):
        self.assertEqual(self.sorted(2), [3, 0, 2, 1])
        self.assertEqual(self.sorted(2, True), [2, 0, 3, 1])

    def test_equal_ones_stay_worst_first(self):
        self.assertEqual(self.sorted(0), [1, 0, 3, 2])
        self.assertEqual(self.sorted("order", True), [3, 2, 0, 1])

    def test_of_some_rows(self):
        self.assertEqual(self.sorted("order", members=(3, 0)), [0, 3])
        self.assertEqual(self.sorted("missed_by", members=()), [])


class FilterTest(unittest.TestCase):
    def setUp(self):
        self.rows = rows_of([1, 0, 1, -1], [(0, 0, .5), (0, 3, .2), (0, 0, np.inf), (1, 9, 0)])

    def test_conditions(self):
        for wanted, found in ((RowFilter(), [0, 1, 2, 3]), (RowFilter(below=0), [3]),
                              (RowFilter(below=1), [1, 3]), (RowFilter(below=9), [0, 1, 2, 3]),
                              (RowFilter(deviates_in=2, least=.4), [0]),
                              (RowFilter(deviates_in=1, least=3.0), [1, 3]),
                              (RowFilter(below=0, deviates_in=1, least=4.0), [3]),
                              (RowFilter(deviates_in=5, least=1.0), [0, 1, 2, 3])):
            with self.subTest(wanted):
                self.assertEqual(self.rows.chosen(wanted).tolist(), found)

    def test_row_of_two_edges(self):
        rows = rows_of([2, 0, 1], [(0, 0, 0)] * 3, [(1, 2), (1, 2), (2, 3)])
        self.assertEqual(rows.index_of((1, 2)), 1)
        self.assertIsNone(rows.index_of((1, 3)))

    def test_none(self):
        rows = rows_of([], np.empty((0, 3)))
        self.assertEqual((len(rows), rows.chosen(RowFilter(below=1)).tolist(),
                          rows.worst().tolist()), (0, [], []))


class SpeedTest(unittest.TestCase):
    def test_a_hundred_thousand_rows_sort_while_nobody_waits(self):
        random = np.random.default_rng(5)
        rows = rows_of(random.integers(-1, 5, 100000), random.random((100000, 5)))
        started = time.perf_counter()
        for key in ("rank", "edges", 3):
            rows.sorted(rows.chosen(RowFilter(below=4)), key, True)
        self.assertLess(time.perf_counter() - started, 1.0)


if __name__ == "__main__":
    unittest.main()
