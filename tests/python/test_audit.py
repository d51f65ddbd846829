"""osculate.audit: rows, options, progress, memory."""
import inspect
import threading
import unittest
from unittest import mock

import numpy as np

import osculate
from audit_models import rows_of
from osculate import (
    JOIN_KINDS, VERDICTS, AuditReport, JoinReport, SkippedEdge, analyze, analyze_edge, audit,
    shapes)
from support import FreeCAD, Part, assert_no_growth, needs_freecad


def wire(*points):
    return Part.makePolygon([FreeCAD.Vector(*point) for point in points])


@needs_freecad
class RowsTest(unittest.TestCase):
    def setUp(self):
        self.shape = Part.makeCylinder(2, 5)
        self.report = audit(self.shape)

    def test_numbers_are_those_of_the_shape(self):
        edges = self.shape.Edges
        self.assertEqual(self.report.edge_count, len(edges))
        for row in rows_of(self.report, "vertex"):
            a, b = (edges[number - 1] for number in row.edges)
            report = analyze(a, b, ends=row.ends)
            self.assertEqual((row.order, row.parametric_order, row.verdicts, row.residuals),
                             (report.order, report.parametric_order, report.verdicts,
                              report.residuals))
            self.assertEqual(row.deviation, report.deviation)
            self.assertEqual(row.warnings, report.warnings)
            np.testing.assert_array_equal(row.point, report.sides[0].point)

    def test_knots_and_seams(self):
        found = [(row.edges[0], row.parameter, row.residuals) for row in self.report.rows
                 if row.kind != "vertex"]
        expected = [(number, report.parameter, report.residuals)
                    for number, edge in enumerate(self.shape.Edges, start=1)
                    for report in analyze_edge(edge)]
        self.assertEqual(found, expected)
        for row in self.report.rows:
            self.assertEqual(row.ends is None, row.kind == "knot")
            self.assertEqual(row.parameter is not None, row.kind == "knot")
            self.assertEqual(row.edges[0] == row.edges[1], row.kind != "vertex")
        self.assertEqual(rows_of(self.report, "seam")[0].ends, ("end", "start"))

    def test_is_a_sequence(self):
        rows = self.report.rows
        listed = list(rows)
        self.assertEqual(len(rows), len(listed))
        self.assertEqual([row.index for row in listed], list(range(len(rows))))
        self.assertEqual(rows[-1].edges, listed[-1].edges)
        self.assertEqual([row.index for row in rows[1:7:2]], [1, 3, 5])
        for bad in (len(rows), -len(rows) - 1):
            with self.assertRaisesRegex(IndexError, f"there are {len(rows)} rows"):
                rows[bad]

    def test_columns(self):
        columns = self.report.columns()
        for i, row in enumerate(self.report.rows):
            self.assertEqual(JOIN_KINDS[columns.kind[i]], row.kind)
            self.assertEqual(tuple(columns.edges[i]), row.edges)
            self.assertEqual((columns.order[i], columns.parametric_order[i]),
                             (row.order, row.parametric_order))
            self.assertEqual(columns.point[i].tolist(), row.point.tolist())
            self.assertEqual(tuple(VERDICTS[v] for v in columns.verdicts[i]), row.verdicts)
            self.assertEqual(tuple(columns.residuals[i]), row.residuals)
        self.assertTrue(all(column.flags.owndata for column in columns))

    def test_the_whole_report_of_a_row(self):
        for row in self.report.rows:
            report = self.report.analyze(row)
            self.assertIsInstance(report, JoinReport)
            self.assertEqual((report.residuals, report.parameter), (row.residuals, row.parameter))

    def test_rows_are_read_only_and_live_without_the_report(self):
        row = audit(self.shape).rows[0]
        self.assertEqual(row.residuals, self.report.rows[0].residuals)
        with self.assertRaises(AttributeError):
            row.order = 3

    def test_worst(self):
        broken = wire((0, 0, 0), (5, 0, 0), (10, 1e-3, 0), (10, 9, 0))
        report = audit(broken)
        self.assertEqual([row.edges for row in report.worst(5)], [(2, 3), (1, 2)])
        self.assertEqual([row.edges for row in report.worst(1)], [(2, 3)])
        self.assertEqual(report.worst(0), [])
        with self.assertRaisesRegex(ValueError, "n: must be 0 or more"):
            report.worst(-1)

    def test_summary(self):
        self.assertEqual(self.report.summary, {
            "edges": 3, "joins": 12, "kinds": {"vertex": 4, "knot": 6, "seam": 2},
            "orders": {"gap": 0, "G0": 4, "G1": 0, "G2": 0, "G3": 0, "G4": 8}, "undecided": 0,
            "corners_left_out": 0, "skipped": 0})

    def test_text(self):
        text = str(self.report)
        self.assertTrue(text.startswith("3 edges, 12 joins: 4 at vertices"), text)
        self.assertIn("misses G1 by 90 deg (tolerance 0.1 deg)", text)
        self.assertEqual(repr(self.report), "<AuditReport of 12 joins of 3 edges>")


@needs_freecad
class OptionsTest(unittest.TestCase):
    def test_pairs(self):
        box = Part.makeBox(1, 2, 3)
        self.assertEqual(len(audit(box).rows), 24)
        self.assertEqual(len(audit(box, pairs="wire").rows), 24)
        tangent = audit(box, pairs="tangent")
        self.assertEqual((len(tangent.rows), tangent.summary["corners_left_out"]), (0, 24))
        self.assertEqual(len(audit(box, pairs="tangent", corner_deg=91).rows), 24)

    def test_order_and_tolerances(self):
        bent = wire((0, 0, 0), (5, 0, 0), (10, 0.05, 0))  # 0.573 degrees
        self.assertEqual(audit(bent).rows[0].order, 0)
        self.assertEqual(audit(bent, tolerances="rhino").rows[0].order, 4)
        row = audit(bent, tolerances="rhino", order=2).rows[0]
        self.assertEqual((row.order, len(row.verdicts), len(row.residuals)), (2, 3, 3))

    def test_threads_change_nothing(self):
        shape = Part.makeCompound([Part.makeTorus(5, 1), Part.makeCylinder(2, 5)] * 3)
        one = audit(shape, threads=1).columns()
        for several in (2, 5, None):
            for a, b in zip(one, audit(shape, threads=several).columns()):
                np.testing.assert_array_equal(a, b)

    def test_every_kind_of_shape(self):
        box = Part.makeBox(1, 2, 3)
        for shape, joins in ((box, 24), (box.Shells[0], 24), (box.Faces[0], 4), (box.Wires[0], 4),
                             (box.Edges[0], 0), (box.Vertexes[0], 0), (Part.Shape(box), 24),
                             (Part.makeCompound([]), 0)):
            self.assertEqual(len(audit(shape).rows), joins)

    def test_skipped_edges(self):
        report = audit(Part.makeSphere(1))
        self.assertEqual([entry.degenerated for entry in report.skipped], [True, True])
        self.assertIsInstance(report.skipped[0], SkippedEdge)
        infinite = Part.Line(FreeCAD.Vector(), FreeCAD.Vector(1, 0, 0)).toShape()
        report = audit(Part.makeCompound([infinite, wire((0, 0, 0), (1, 0, 0), (2, 1, 0))]))
        self.assertEqual(report.skipped, ((1, False, "is infinite; trim it to a finite range"),))
        self.assertEqual([row.edges for row in report.rows], [(2, 3)])

    def test_without_proxies(self):
        shape = Part.makeCylinder(2, 5)
        expected = audit(shape).columns()
        with mock.patch.object(shapes, "_proxy_maker", lambda: None):
            for a, b in zip(audit(shape).columns(), expected):
                np.testing.assert_array_equal(a, b)

    def test_signature(self):
        names = list(inspect.signature(audit).parameters)
        self.assertEqual(names[:4], ["shape_or_path", "order", "tolerances", "progress"])
        self.assertEqual(AuditReport.__module__, "osculate.auditing")


@needs_freecad
class BadInputTest(unittest.TestCase):
    def assert_raises(self, error, pattern, *arguments, **options):
        with self.assertRaisesRegex(error, pattern):
            audit(*arguments, **options)

    def test_what_is_no_shape(self):
        self.assert_raises(TypeError, "^shape_or_path: a Part.Shape or the path .* got int$", 3)
        self.assert_raises(TypeError, "got list", Part.makeBox(1, 1, 1).Edges)
        self.assert_raises(ValueError, "the shape is null", Part.Shape())

    def test_options(self):
        box = Part.makeBox(1, 1, 1)
        self.assert_raises(ValueError, "^pairs: must be one of all, wire, tangent", box, pairs="x")
        self.assert_raises(TypeError, "^pairs: must be", box, pairs=3)
        self.assert_raises(ValueError, "^corner_deg: must be from 0 to 180", box, corner_deg=-1)
        self.assert_raises(TypeError, "^corner_deg: must be a number", box, corner_deg="x")
        self.assert_raises(ValueError, "^threads: must be 0", box, threads=-1)
        self.assert_raises(TypeError, "^threads: must be an integer", box, threads=1.5)
        self.assert_raises(ValueError, "^order: must be from 0 to 8", box, order=9)
        self.assert_raises(ValueError, "^preset: must be one of", box, tolerances="none")
        self.assert_raises(TypeError, "^progress: must be None or a callable", box, progress=3)


@needs_freecad
class LongCallsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        torus = Part.makeTorus(5, 1)
        moved = [torus.translated(FreeCAD.Vector(i, 0, 0)) for i in range(3000)]
        cls.shape = Part.makeCompound(moved)

    def test_progress(self):
        shares, threads = [], set()

        def note(share):
            shares.append(share)
            threads.add(threading.get_ident())

        report = audit(self.shape, progress=note)
        self.assertEqual(shares, sorted(shares))
        self.assertEqual((shares[0], shares[-1]), (0, 1))
        self.assertEqual(threads, {threading.get_ident()})
        self.assertTrue(report.is_complete)

    def test_stopping(self):
        whole = audit(self.shape)
        for limit in (-1, 0, 0.4):
            part = audit(self.shape, progress=lambda share: share <= limit)
            self.assertFalse(part.is_complete)
            self.assertLess(len(part.rows), len(whole.rows))
            np.testing.assert_array_equal(part.columns().residuals,
                                          whole.columns().residuals[:len(part.rows)])
            self.assertIn("stopped before the end", str(part))

    def test_an_exception_ends_it(self):
        def fail(share):
            raise LookupError("from the callback")

        with self.assertRaisesRegex(LookupError, "from the callback"):
            audit(self.shape, progress=fail)

    def test_other_threads_run_meanwhile(self):
        counted = []
        thread = threading.Thread(target=lambda: audit(self.shape))
        thread.start()
        while thread.is_alive():
            counted.append(len(counted))
        thread.join()
        self.assertGreater(len(counted), 100)

    def test_memory(self):
        shape = Part.makeCylinder(2, 5)

        def use():
            report = audit(shape)
            return ([row.deviation for row in report.rows], report.summary, str(report),
                    report.columns(), report.analyze(report.rows[0]))

        assert_no_growth(self, use, 1000)

    def test_memory_without_proxies(self):
        shape = Part.makeBox(1, 1, 1)
        with mock.patch.object(shapes, "_proxy_maker", lambda: None):
            assert_no_growth(self, lambda: audit(shape), 1000)


class PublicNamesTest(unittest.TestCase):
    def test_names(self):
        for name in ("audit", "AuditReport", "AuditRow", "AuditColumns", "SkippedEdge"):
            self.assertIn(name, osculate.__all__)
        self.assertEqual(osculate.AuditRow.__module__, "osculate")


if __name__ == "__main__":
    unittest.main()
