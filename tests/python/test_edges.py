"""The analyses on Part.Edge: closed, same, reversed and placed edges, and what is no edge."""
import time
import unittest

from osculate import Curve, analyze, analyze_edge
from support import FreeCAD, Part, assert_no_growth, cubic, needs_freecad

ANALYZE_SECONDS = 30e-6  # aimed at for a whole report of two edges


def vector(*coordinates):
    return FreeCAD.Vector(*coordinates)


def spline_edges():
    """Two halves of one rational quintic B-spline edge."""
    spline = Part.BSplineCurve()
    poles = [vector(10 * i, (-1) ** i * i, i * i) for i in range(8)]
    spline.buildFromPolesMultsKnots(poles, [6, 1, 1, 6], [0, 0.3, 0.6, 1], False, 5,
                                    [1, 1, 2, 1, 1, 1, 2, 1])
    return spline.toShape(0, 0.5), spline.toShape(0.5, 1)


@needs_freecad
class EdgesTest(unittest.TestCase):
    def test_arc_and_line(self):
        arc = Part.Arc(vector(10, 0, 0), vector(6, 8, 0), vector(0, 10, 0)).toShape()
        report = analyze(arc, Part.makeLine(vector(0, 10, 0), vector(-10, 10, 0)))
        self.assertEqual((report.order, report.ends), (1, ("end", "start")))
        self.assertAlmostEqual(report.sides[0].curvature, 0.1, delta=1e-14)

    def test_trimmed_rational_halves_meet_smoothly(self):
        self.assertEqual(analyze(*spline_edges(), order=8).order, 8)

    def test_reversed_and_placed_edges(self):
        first, second = spline_edges()
        placement = FreeCAD.Placement(vector(100, -20, 3), FreeCAD.Rotation(10, 20, 30))
        for edge in (first, second):
            edge.Placement = placement
        self.assertEqual(analyze(first, second).order, 4)
        backwards = first.reversed()
        report = analyze(backwards, second)
        self.assertEqual((report.order, report.ends), (4, ("start", "start")))

    def test_an_edge_and_a_curve(self):
        first, second = spline_edges()
        self.assertEqual(analyze(first, Curve.from_edge(second)).order, 4)

    def test_to_edge_and_back_is_the_same_curve(self):
        curve = cubic()
        edge = curve.to_edge()
        self.assertIsInstance(edge, Part.Edge)
        self.assertEqual(Curve.from_edge(edge), curve)

    def test_inner_knots_of_an_edge(self):
        reports = analyze_edge(spline_edges()[0])
        self.assertEqual([report.parameter for report in reports], [0.3])
        self.assertGreaterEqual(reports[0].order, 4)

    def test_a_closed_edge(self):
        circle = Part.makeCircle(10)
        self.assertEqual(analyze(circle, circle).order, 4)
        self.assertIsNone(analyze_edge(circle)[-1].parameter)

    def test_the_edge_of_a_shape_taken_twice_is_one_edge(self):
        box = Part.makeBox(1, 2, 3)
        for other in (box.Edges[0], box.Edges[0].reversed()):
            with self.assertRaisesRegex(ValueError, "b: is the same curve as a, which is open"):
                analyze(box.Edges[0], other)
        cylinder = Part.makeCylinder(3, 5)
        rim = next(edge for edge in cylinder.Edges if edge.isClosed())
        self.assertEqual(analyze(rim, rim.reversed()).order, 4)

    def test_edges_that_cannot_be_analysed(self):
        line = Part.makeLine(vector(0, 0, 0), vector(1, 0, 0))
        pole = next(edge for edge in Part.makeSphere(1).Edges if edge.Degenerated)
        infinite = Part.Line(vector(0, 0, 0), vector(1, 0, 0)).toShape()
        for bad in (pole, infinite, Part.Edge()):
            with self.assertRaisesRegex(ValueError, "^b: "):
                analyze(line, bad)
            with self.assertRaisesRegex(ValueError, "^a: "):
                analyze_edge(bad)

    def test_shapes_that_are_no_edge_are_called_by_name(self):
        box = Part.makeBox(1, 1, 1)
        for bad, name in ((box.Faces[0], "face"), (box.Wires[0], "wire"),
                          (box.Vertexes[0], "vertex"), (box, "solid")):
            with self.assertRaisesRegex(TypeError, f"^a: .*a {name} instead of an edge"):
                analyze(bad, box.Edges[0])
            with self.assertRaisesRegex(TypeError, f"^b: .*a {name} instead of an edge"):
                analyze(box.Edges[0], bad)


@needs_freecad
class CostTest(unittest.TestCase):
    def test_time_of_a_report(self):
        """Processor time, the best of several runs, with room for a machine that is busy."""
        first, second = spline_edges()
        runs = []
        for _ in range(10):
            start = time.thread_time()
            for _ in range(500):
                analyze(first, second)
            runs.append((time.thread_time() - start) / 500)
        self.assertLess(min(runs), 2 * ANALYZE_SECONDS)

    def test_memory_of_100_000_analyses(self):
        first, second = spline_edges()
        assert_no_growth(self, lambda: analyze(first, second), 100_000)


if __name__ == "__main__":
    unittest.main()
