"""osculate.join: exactness, multiplicities, chains, tolerance, edges and wires."""
import math
import unittest

import numpy as np

import osculate
from osculate import ContactError, Curve, join
from support import circle_then_line, cubic, full_circle, needs_freecad, shared_file, spline

try:
    import FreeCAD
    import Part
except ImportError:
    FreeCAD = Part = None


def with_range(curve, first, last):
    """The same curve over another range."""
    begin, end = curve.parameter_range
    knots = first + (curve.knots - begin) * (last - first) / (end - begin)
    return Curve.bspline(curve.poles, knots, curve.multiplicities, curve.degree, curve.weights)


def cut(curve, *parameters):
    """The pieces of a curve in disguise: other ranges, every second one reversed."""
    pieces = []
    for parameter in parameters:
        piece, curve = curve.split(parameter)
        pieces.append(piece)
    pieces.append(curve)
    return [pieces[0]] + [with_range(piece, i, 5 * i + 1).reversed() if i % 2 else piece
                          for i, piece in enumerate(pieces[1:], start=1)]


def line(start, end):
    return Curve.bezier([start, end])


class JoinTest(unittest.TestCase):
    def assert_same_curve(self, actual, expected, delta):
        self.assertEqual(actual.degree, expected.degree)
        self.assertEqual(actual.multiplicities.tolist(), expected.multiplicities.tolist())
        np.testing.assert_allclose(actual.knots, expected.knots, rtol=0, atol=delta)
        np.testing.assert_allclose(actual.poles, expected.poles, rtol=0, atol=delta)

    def test_the_pieces_of_a_spline_are_the_spline(self):
        whole = spline(8)
        result = join(cut(whole, 1.5, 3.0, 4.0, 6.25))
        self.assert_same_curve(result.curve, whole, 1e-11)
        self.assertLess(result.max_displacement_mm, 1e-13)
        self.assertEqual(result.warnings, ())

    def test_reports_of_the_result_and_of_the_inputs(self):
        result = join(cut(spline(8), 1.5, 3.0))
        self.assertEqual([report.parametric_order for report in result.reports], [4, 2])
        self.assertEqual([report.parametric_order for report in result.input_reports], [0, 0])
        self.assertEqual([report.order for report in result.input_reports], [4, 2])
        np.testing.assert_allclose([report.parameter for report in result.reports], [1.5, 3.0],
                                   rtol=0, atol=1e-12)
        self.assertEqual(result.beta, ((), ()))
        self.assertIn("length_mm", result.energy)

    def test_a_blend_has_no_input_reports(self):
        result = osculate.blend(line((0, 0, 0), (1, 0, 0)), line((3, 1, 0), (4, 1, 0)))
        self.assertEqual(result.input_reports, ())

    def test_degrees_are_raised(self):
        result = join([cubic(), line((20, 20, 10), (30, 20, 10))])
        self.assertEqual(result.curve.degree, 3)
        self.assertEqual(result.curve.multiplicities.tolist(), [4, 3, 4])
        self.assertRegex(result.warnings[0], r"^corner: G0 only at 1 join \(90 degrees, between "
                                             r"curves\[0\] and curves\[1\]\)$")

    def test_a_circle_and_its_tangent(self):
        result = join(circle_then_line())
        self.assertTrue(result.curve.is_rational)
        self.assertEqual(result.reports[0].order, 1)
        self.assertEqual(result.reports[0].parametric_order, 1)
        self.assertEqual(result.warnings, ())

    def test_a_closed_chain_is_periodic(self):
        loop = spline(6, periodic=True)
        first, rest = loop.split(2.5)
        result = join([first, rest])
        self.assertTrue(result.curve.is_periodic)
        self.assert_same_curve(result.curve, loop, 1e-11)
        self.assertEqual(len(result.reports), 2)

    def test_a_full_circle_stays_clamped(self):
        result = join([full_circle()])
        self.assertFalse(result.curve.is_periodic)
        self.assertEqual(result.curve.multiplicities.tolist(), [3, 2, 2, 2, 3])
        self.assertEqual(result.reports[0].order, 4)

    def test_any_iterable_in_any_order(self):
        pieces = cut(spline(8), 1.5, 3.0, 4.0)
        result = join(pieces[i] for i in (2, 0, 3, 1))
        self.assertEqual(result.curve.multiplicities.tolist(), spline(8).multiplicities.tolist())
        self.assertRegex(result.warnings[0], "^order: ")

    def test_gaps(self):
        pair = line((0, 0, 0), (1, 0, 0)), line((1, 0.002, 0), (1, 5, 0))
        with self.assertRaisesRegex(ContactError, r"curves\[0\] and curves\[1\] .* 0.002 mm"):
            join(pair)
        result = join(pair, tolerance=0.001)
        self.assertAlmostEqual(result.max_displacement_mm, 0.001, delta=2e-6)
        self.assertRegex(result.warnings[0], "^gap: closed at 1 join")

    def test_repr_stays_short(self):
        corner = [line((i, i % 2, 0), (i + 1, (i + 1) % 2, 0)) for i in range(40)]
        self.assertEqual(repr(join(corner)), "<osculate.Construction: degree 1, 39 joins, the "
                                             "lowest G0, warnings: 1>")
        self.assertIn(", G0, warnings", repr(join(corner[:2])))

    def test_bad_input(self):
        curve = cubic()
        for bad in (curve, "Edge1", None, 3):
            with self.assertRaisesRegex(TypeError, "^curves: a list of Part.Edge"):
                join(bad)
        for bad in (None, 1, [(0, 0, 0)]):
            with self.assertRaisesRegex(TypeError, r"^curves\[1\]: "):
                join([curve, bad])
        with self.assertRaisesRegex(ValueError, "^curves: at least one"):
            join([])
        with self.assertRaisesRegex(ValueError, r"curves\[0\] and curves\[1\] are the same curve"):
            join([curve, curve.reversed()])
        for bad in (-1, math.nan, math.inf):
            with self.assertRaisesRegex(ValueError, "^tolerance: must be finite and >= 0"):
                join([curve], tolerance=bad)
        with self.assertRaisesRegex(TypeError, "^tolerance: must be a number"):
            join([curve], tolerance="1")
        with self.assertRaisesRegex(ContactError, "branches"):
            join([line((0, 0, 0), (1, 0, 0)), line((1, 0, 0), (2, 1, 0)),
                  line((1, 0, 0), (2, -1, 0))])


@needs_freecad
class EdgesTest(unittest.TestCase):
    def test_a_wire(self):
        arc = Part.Arc(FreeCAD.Vector(0, 0, 0), FreeCAD.Vector(5, 5, 0), FreeCAD.Vector(10, 0, 0))
        wire = Part.Wire([arc.toShape(), Part.makeLine((10, 0, 0), (10, -8, 0))])
        result = join(wire)
        self.assertEqual(result.reports[0].order, 1)
        self.assertAlmostEqual(result.edge.Length, wire.Length, delta=1e-9)
        self.assertEqual(join(wire.Edges).curve, result.curve)

    def test_a_rectangle_closes(self):
        wire = Part.makePolygon([(0, 0, 0), (4, 0, 0), (4, 2, 0), (0, 2, 0), (0, 0, 0)])
        result = join(wire)
        self.assertEqual(result.curve.multiplicities.tolist(), [2, 1, 1, 1, 2])
        self.assertTrue(result.edge.isClosed())
        self.assertAlmostEqual(result.edge.Length, 12, delta=1e-12)

    def test_a_periodic_edge_is_valid(self):
        loop = spline(6, periodic=True)
        first, rest = loop.split(2.5)
        edge = join([rest.to_edge(), first.to_edge()]).edge
        self.assertTrue(edge.isValid())
        self.assertTrue(edge.Curve.isPeriodic())
        self.assertAlmostEqual(edge.Length, loop.to_edge().Length, delta=1e-9)

    def test_curves_that_a_modeller_split(self):
        whole = spline(9, seed=4).to_edge()
        pieces = whole.split([2.2, 5.0, 7.7]).Edges
        result = join(pieces)
        self.assertEqual(result.curve.multiplicities.tolist(), [4] + [1] * 8 + [4])
        np.testing.assert_allclose(result.curve.poles, spline(9, seed=4).poles, atol=1e-11)

    def test_wires_of_a_real_model(self):
        """Every wire of a model: on its edges to rounding, or refused with its gap."""
        shape = Part.Shape()
        shape.read(str(shared_file("data/Fuselage_guides.brep")))
        joined = 0
        for chain in Part.sortEdges(shape.Edges[:120]):
            try:
                result = join(chain, tolerance=1e-6)
            except ContactError as error:
                self.assertRegex(str(error), "mm apart|branches")
                continue
            joined += 1
            self.assertLessEqual(result.max_displacement_mm, 1e-6)
            length = sum(edge.Length for edge in chain)
            self.assertAlmostEqual(result.edge.Length, length, delta=1e-5 * length)
        self.assertGreater(joined, 0)


if __name__ == "__main__":
    unittest.main()
