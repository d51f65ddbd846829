"""Between Part shapes and curves: every bit, both ways in, the way back, wires, cost."""
import random
import sys
import time
import unittest
from unittest import mock

import numpy as np

from osculate import Curve, OcctError, _core, shapes
from support import FreeCAD, Part, assert_no_growth, cubic, needs_freecad

EDGE_SECONDS = 8e-6  # aimed at for one B-spline edge


def spline_edge(rng, degree=5, poles=8, rational=True):
    spline = Part.BSplineCurve()
    inner = poles - degree - 1
    knots = sorted(rng.uniform(0, 1) for _ in range(inner))
    spline.buildFromPolesMultsKnots(
        [FreeCAD.Vector(*(rng.uniform(-1e3, 1e3) for _ in range(3))) for _ in range(poles)],
        [degree + 1] + [1] * inner + [degree + 1], [-0.1, *knots, 1.1], False, degree,
        [rng.uniform(0.1, 10) if rational else 1.0 for _ in range(poles)])
    return spline.toShape()


def placed(edge):
    moved = edge.copy()
    moved.Placement = FreeCAD.Placement(FreeCAD.Vector(1, 2, 3), FreeCAD.Rotation(10, 20, 30))
    return moved


def edges_of_all_kinds():
    rng = random.Random(1)
    circle = Part.Circle(FreeCAD.Vector(1, 2, 3), FreeCAD.Vector(1, 1, 0), 5)
    seam = Part.BSplineCurve()
    seam.buildFromPolesMultsKnots([FreeCAD.Vector(*p) for p in [(0, 0, 0), (1, 0, 0), (1, 1, 1),
                                                                (0, 1, 0)]],
                                  [1] * 5, [0, 0.3, 0.5, 0.7, 1], True, 3)
    bezier = Part.BezierCurve()
    bezier.setPoles([FreeCAD.Vector(*p) for p in [(0, 0, 0), (1, 0, 0), (1, 1, 1)]])
    ellipse = Part.Ellipse(FreeCAD.Vector(0, 0, 0), 3, 2)
    return {
        "spline": spline_edge(rng), "polynomial": spline_edge(rng, rational=False),
        "trimmed": spline_edge(rng).Curve.toShape(0.1, 0.7), "bezier": bezier.toShape(),
        "seam": seam.toShape(0.8, 1.3), "line": Part.makeLine((1, 2, 3), (4, 5, 7)),
        "arc": circle.toShape(1, 4), "circle": circle.toShape(), "ellipse": ellipse.toShape(1, 2),
        "hyperbola": Part.Hyperbola(FreeCAD.Vector(1, 2, 3), 3, 2).toShape(-1, 1),
        "parabola": Part.Parabola().toShape(-1, 2),
        "offset": Part.OffsetCurve(ellipse, 0.5, FreeCAD.Vector(0, 0, 1)).toShape(1, 2),
        "placed": placed(spline_edge(rng)), "reversed": placed(circle.toShape(1, 4).reversed()),
    }


def ends(curve):
    first, last = curve.parameter_range
    return np.vstack((curve.evaluate(first)[0], curve.evaluate(last)[0]))


@needs_freecad
class CurveFromEdgeTest(unittest.TestCase):
    def test_bits_of_splines(self):
        rng = random.Random(2)
        for count in range(50):
            edge = spline_edge(rng, rational=count % 2 == 0)
            curve, spline = shapes.curve_from_edge(edge), edge.Curve
            self.assertEqual(curve.poles.tolist(), [list(pole) for pole in spline.getPoles()])
            self.assertEqual(curve.knots.tolist(), spline.getKnots())
            self.assertEqual(curve.multiplicities.tolist(), spline.getMultiplicities())
            self.assertEqual((curve.degree, curve.is_periodic), (spline.Degree, False))
            if curve.is_rational:
                self.assertEqual(curve.weights.tolist(), spline.getWeights())
            self.assertEqual(curve.is_rational, count % 2 == 0)
            self.assertEqual(curve.pole_error, 0)

    def test_ends_and_range_of_every_kind(self):
        for kind, edge in edges_of_all_kinds().items():
            with self.subTest(kind):
                curve = shapes.curve_from_edge(edge)
                np.testing.assert_allclose(curve.parameter_range, edge.ParameterRange, atol=1e-15)
                points = [edge.valueAt(u) for u in edge.ParameterRange]
                if edge.Orientation == "Reversed":
                    points.reverse()
                np.testing.assert_allclose(ends(curve), points, rtol=1e-14, atol=1e-13)

    def test_a_general_shape_that_holds_an_edge(self):
        edge = Part.makeCircle(3)
        self.assertEqual(shapes.curve_from_edge(Part.Shape(edge)), shapes.curve_from_edge(edge))

    def test_an_edge_may_be_forgotten(self):
        curve = shapes.curve_from_edge(Part.makeLine((0, 0, 0), (1, 2, 3)))
        self.assertEqual(curve.poles.tolist(), [[0, 0, 0], [1, 2, 3]])


@needs_freecad
class ThroughFileTest(unittest.TestCase):
    def setUp(self):
        patch = mock.patch.object(shapes, "_proxy_maker", lambda: None)
        patch.start()
        self.addCleanup(patch.stop)

    def test_gives_the_same_curves(self):
        for kind, edge in edges_of_all_kinds().items():
            with self.subTest(kind), mock.patch.object(
                    _core, "curve_from_proxy", side_effect=AssertionError("used the proxy"),
                    create=True):
                through_file = shapes.curve_from_edge(edge)
            direct = proxied(edge)
            if edge.Placement.isIdentity():
                self.assertEqual(through_file, direct)
            else:  # the file keeps matrices of placements to 4e-14 only
                np.testing.assert_allclose(through_file.poles, direct.poles, rtol=1e-12)

    def test_keeps_the_errors(self):
        pole = next(edge for edge in Part.makeSphere(1).Edges if edge.Degenerated)
        with self.assertRaisesRegex(ValueError, "edge: is degenerated"):
            shapes.curve_from_edge(pole)
        with self.assertRaisesRegex(ValueError, "edge: the shape is null"):
            shapes.curve_from_edge(Part.Edge())

    def test_is_taken_where_freecad_has_no_proxies(self):
        def refuse(_edge):
            raise Part.OCCError("No SWIG wrapped library loaded")
        edge = Part.makeCircle(3)
        with mock.patch.object(shapes, "_proxy_maker", lambda: refuse):
            self.assertEqual(shapes.curve_from_edge(edge), proxied(edge))

    def test_a_file_that_is_no_shape(self):
        self.assertTrue(issubclass(OcctError, RuntimeError))
        with self.assertRaisesRegex(OcctError, "^OpenCASCADE: Storage_StreamTypeMismatchError"):
            _core.curve_from_binary(__file__)
        with self.assertRaisesRegex(ValueError, "path: cannot read"):
            _core.curve_from_binary("/no/such/file")


def proxied(edge):
    return _core.curve_from_proxy(Part.__toPythonOCC__(edge))


@needs_freecad
@unittest.skipUnless(hasattr(_core, "curve_from_proxy"), "built without SWIG")
class ProxyTest(unittest.TestCase):
    def setUp(self):
        _core.register_shape_type()

    def test_a_proxy_is_used_once(self):
        proxy = Part.__toPythonOCC__(Part.makeCircle(3))
        _core.curve_from_proxy(proxy)
        with self.assertRaisesRegex(TypeError, "proxy: must be what Part.__toPythonOCC__ returns"):
            _core.curve_from_proxy(proxy)

    def test_anything_else_is_refused(self):
        for other in (None, 3, object(), Part.makeCircle(3)):
            with self.assertRaisesRegex(TypeError, "proxy: must be"):
                _core.curve_from_proxy(other)

    def test_pivy_shares_the_runtime(self):
        """pivy is made with SWIG too; its types and ours must not disturb each other."""
        try:
            from pivy import coin
        except ImportError:
            self.skipTest("needs pivy")
        self.assertEqual(proxied(Part.makeCircle(3)).degree, 2)
        self.assertEqual(coin.SbVec3f(1, 2, 3).getValue(), (1, 2, 3))
        self.assertEqual(proxied(Part.makeCircle(3)).degree, 2)


@needs_freecad
class EdgeFromCurveTest(unittest.TestCase):
    def test_bits_there_and_back(self):
        rng = random.Random(3)
        curves = [shapes.curve_from_edge(spline_edge(rng)) for _ in range(20)]
        curves += [cubic(), shapes.curve_from_edge(Part.makeCircle(3)),
                   Curve.bspline([(0, 0, 0), (1, 0, 0), (1, 1, 1), (0, 1, 0)],
                                 [0, 0.3, 0.5, 0.7, 1], [1] * 5, 3, periodic=True),
                   Curve.bspline([(5e-324, -0.0, 1.7e308)] + [(1, 2, i) for i in range(3)],
                                 [0, 1], [4, 4], 3)]
        for curve in curves:
            edge = shapes.edge_from_curve(curve)
            self.assertIsInstance(edge, Part.Edge)
            back = shapes.curve_from_edge(edge)
            self.assertEqual(back.poles.tobytes(), curve.poles.tobytes())
            self.assertEqual(back.knots.tobytes(), curve.knots.tobytes())
            self.assertEqual((back.weights is None, back.is_periodic),
                             (curve.weights is None, curve.is_periodic))
            if curve.is_rational:
                self.assertEqual(back.weights.tobytes(), curve.weights.tobytes())

    def test_what_no_edge_can_be(self):
        torn = Curve.bspline([(i, i * i, 0) for i in range(4)], [0, 1, 2], [2, 2, 2], 1)
        with self.assertRaisesRegex(ValueError, "^curve: is torn at a knot"):
            shapes.edge_from_curve(torn)
        close = Curve.bspline([(i, i * i, 0) for i in range(4)],
                              [0, 1, np.nextafter(1, 2), 2], [2, 1, 1, 2], 1)
        with self.assertRaisesRegex(ValueError, "^curve: FreeCAD makes no edge of it"):
            shapes.edge_from_curve(close)
        with self.assertRaisesRegex(TypeError, "^curve: an osculate.Curve is needed"):
            shapes.edge_from_curve(Part.makeCircle(3))


@needs_freecad
class WireTest(unittest.TestCase):
    POINTS = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 2, 0)]

    def assert_chain(self, wire, first, last, count):
        curves = [shapes.curve_from_edge(edge) for edge in shapes.edges_in_order(wire)]
        self.assertEqual(len(curves), count)
        points = [ends(curve) for curve in curves]
        np.testing.assert_allclose(points[0][0], first, atol=1e-15)
        np.testing.assert_allclose(points[-1][1], last, atol=1e-15)
        for before, after in zip(points, points[1:]):
            np.testing.assert_allclose(before[1], after[0], atol=1e-15)

    def test_open_wire_both_ways(self):
        wire = Part.makePolygon([FreeCAD.Vector(*point) for point in self.POINTS])
        self.assert_chain(wire, self.POINTS[0], self.POINTS[-1], 3)
        self.assert_chain(wire.reversed(), self.POINTS[-1], self.POINTS[0], 3)

    def test_edges_that_run_against_the_wire(self):
        a, b, c, d = self.POINTS
        wire = Part.Wire([Part.makeLine(b, c), Part.makeLine(b, a), Part.makeLine(d, c)])
        self.assert_chain(wire, a, d, 3)

    def test_closed_wire(self):
        wire = Part.makePolygon([FreeCAD.Vector(*p) for p in self.POINTS + self.POINTS[:1]])
        self.assert_chain(wire, self.POINTS[0], self.POINTS[0], 4)

    def test_seam_and_poles_of_a_sphere(self):
        wire = Part.makeSphere(1).Faces[0].OuterWire
        edges = shapes.edges_in_order(wire)
        self.assertEqual([edge.Degenerated for edge in edges], [False, False])
        self.assertNotEqual(edges[0].Orientation, edges[1].Orientation)

    def test_wire_with_a_hole_in_it(self):
        wire = Part.makePolygon([FreeCAD.Vector(*point) for point in self.POINTS])
        with self.assertRaisesRegex(ValueError, "^wire: its edges are no chain; 1 of 2"):
            shapes.edges_in_order(wire.removeShape([wire.Edges[1]]))

    def test_what_is_no_wire(self):
        with self.assertRaisesRegex(TypeError, "^wire: .* a face instead of a wire$"):
            shapes.edges_in_order(Part.makeBox(1, 1, 1).Faces[0])
        with self.assertRaisesRegex(TypeError, "^wire: .* got list"):
            shapes.edges_in_order([])
        with self.assertRaisesRegex(ValueError, "^wire: the shape is null"):
            shapes.edges_in_order(Part.Wire())


@needs_freecad
class CostTest(unittest.TestCase):
    @unittest.skipUnless(hasattr(_core, "curve_from_proxy"), "built without SWIG")
    def test_time_of_a_spline_edge(self):
        """The best of several runs, with room for a machine that is busy otherwise."""
        edge = spline_edge(random.Random(4))
        runs = []
        for _ in range(10):
            start = time.perf_counter()
            for _ in range(1000):
                shapes.curve_from_edge(edge)
            runs.append((time.perf_counter() - start) / 1000)
        self.assertLess(min(runs), 2 * EDGE_SECONDS)

    def test_memory_of_100_000_conversions(self):
        edge = spline_edge(random.Random(5))
        assert_no_growth(self, lambda: shapes.curve_from_edge(edge), 100_000)

    def test_memory_of_conversions_through_files(self):
        edge = spline_edge(random.Random(6))
        with mock.patch.object(shapes, "_proxy_maker", lambda: None):
            assert_no_growth(self, lambda: shapes.curve_from_edge(edge), 20_000)

    def test_memory_of_edges_made(self):
        curve = cubic()
        assert_no_growth(self, lambda: shapes.edge_from_curve(curve), 20_000)


class WithoutPartTest(unittest.TestCase):
    def test_nothing_imports_part_before_there_is_a_shape(self):
        with mock.patch.dict(sys.modules):
            sys.modules.pop("Part", None)
            self.assertFalse(shapes.is_edge(cubic()))
            self.assertEqual(shapes.curve_from(cubic(), "a"), cubic())
            for call in (shapes.curve_from_edge, shapes.edges_in_order, shapes.edge_from_curve):
                with self.assertRaisesRegex(TypeError, "is needed, got int$"):
                    call(3)
            self.assertNotIn("Part", sys.modules)


if __name__ == "__main__":
    unittest.main()
