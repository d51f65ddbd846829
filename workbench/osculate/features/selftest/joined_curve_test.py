"""Tests of the document object JoinedCurve."""

import os
import tempfile

import FreeCAD
import Part

from osculate.features import make_joined_curve
from osculate.features.joined_curve import JoinedCurve, links_of
from osculate.features.selftest.feature_case import FeatureCase

V = FreeCAD.Vector


class JoinedCurveTest(FeatureCase):
    """The line and the arc that touches it, and pieces of one cubic B-spline."""

    def join(self, *edges, **options):
        edges = edges or ((self.line, "Edge1"), (self.arc, "Edge1"))
        return make_joined_curve(self.doc, edges, **options)

    def cut_spline(self):
        """One B-spline of degree 3 with simple knots, cut at two of them; and its edges."""
        curve = Part.BSplineCurve()
        curve.interpolate([V(0, 0), V(10, 5), V(20, 0), V(30, 8, 4), V(40, 0), V(50, 3)])
        knots = curve.getKnots()
        cuts = [knots[0], knots[2], knots[3], knots[-1]]
        pieces = [Part.Edge(curve, first, last) for first, last in zip(cuts, cuts[1:])]
        pieces[1].reverse()
        obj = self.add("Pieces", Part.makeCompound(pieces))
        return curve, [(obj, f"Edge{number}") for number in (1, 2, 3)]

    def test_line_and_arc(self):
        obj = self.join()
        self.assertEqual((obj.Status, obj.Continuity, obj.EdgesContinuity), ("OK", ["G1"], ["G1"]))
        self.assertLess(obj.Deviation.Value, 1e-12)
        self.assertEqual(len(obj.Shape.Edges), 1)
        self.assertEqual(len(obj.Knots), len(obj.Multiplicities))
        for place in (V(0, 0, 0), V(25, 0, 0), V(70, 20, 0)):
            self.assertLess(obj.Shape.distToShape(Part.Vertex(place))[0], 1e-9)

    def test_pieces_become_the_curve_that_they_were(self):
        curve, edges = self.cut_spline()
        obj = self.join(*edges)
        self.assertEqual(obj.Status, "OK")
        self.assertEqual(obj.Multiplicities, curve.getMultiplicities())
        poles = obj.Shape.Edges[0].Curve.getPoles()
        self.assertEqual(len(poles), curve.NbPoles)
        for pole, expected in zip(poles, curve.getPoles()):
            self.assertTrue(pole.isEqual(expected, 1e-9))

    def test_edges_in_any_order(self):
        _curve, edges = self.cut_spline()
        obj = self.join(edges[2], edges[0], edges[1])
        self.assertEqual(obj.Status, "OK")
        self.assertEqual([link.sub for link in links_of(obj)], ["Edge3", "Edge1", "Edge2"])

    def test_gap_is_refused_and_closed_within_the_tolerance(self):
        self.arc.Placement.Base.z = 0.01
        self.doc.recompute()
        obj = self.join()
        self.assertIn("Line.Edge1 and Arc.Edge1 are no chain", obj.Status)
        self.assertTrue(obj.Shape.isNull())
        obj.Tolerance = 0.02
        self.doc.recompute()
        self.assertEqual(obj.Status, "OK")
        self.assertLessEqual(obj.Deviation.Value, 0.02)
        self.assertEqual(obj.EdgesContinuity, ["gap"])
        self.assertIn("between Line.Edge1 and Arc.Edge1", obj.Warnings[0])

    def test_follows_edits_and_keeps_the_last_good_shape(self):
        obj = self.join()
        length = obj.Shape.Length
        self.line.Placement.Base.z = 5.0
        self.doc.recompute()
        self.assertNotEqual(obj.Status, "OK")
        self.assertFalse(obj.isValid())
        self.assertAlmostEqual(obj.Shape.Length, length, delta=1e-9)
        self.line.Placement.Base.z = 0.0
        self.doc.recompute()
        self.assertEqual(obj.Status, "OK")
        self.assertTrue(obj.isValid())

    def test_deleted_edges_stand_in_the_status(self):
        obj = self.join()
        self.doc.removeObject("Arc")
        self.doc.removeObject("Line")
        self.doc.recompute()
        self.assertIn("No edges", obj.Status)

    def test_closed_chain(self):
        box = self.doc.addObject("Part::Box", "Box")
        self.doc.recompute()
        wire = box.Shape.Faces[0].OuterWire
        numbers = [next(number for number, edge in enumerate(box.Shape.Edges, 1)
                        if edge.isSame(side)) for side in wire.OrderedEdges]
        obj = self.join(*((box, f"Edge{number}") for number in numbers))
        self.assertEqual((obj.Status, obj.Continuity), ("OK", ["G0"] * 4))
        self.assertTrue(obj.Shape.isClosed())
        self.assertTrue(any("corner" in warning for warning in obj.Warnings))

    def test_bad_tolerance_changes_nothing(self):
        for tolerance in (-1.0, float("nan")):
            with self.subTest(tolerance), self.assertRaises(ValueError):
                self.join(tolerance_mm=tolerance)
        self.assertEqual(len(self.doc.Objects), 2)

    def test_saving_and_loading(self):
        obj = self.join(tolerance_mm=0.001)
        before = obj.Continuity, obj.Multiplicities, obj.Tolerance.Value
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "joined.FCStd")
            self.doc.saveAs(path)
            FreeCAD.closeDocument(self.doc.Name)
            self.doc = FreeCAD.openDocument(path)
        obj = self.doc.JoinedCurve
        self.assertIsInstance(obj.Proxy, JoinedCurve)
        self.assertEqual((obj.Continuity, obj.Multiplicities, obj.Tolerance.Value), before)
        self.doc.Arc.Placement.Base.z = 1.0
        self.doc.recompute()
        self.assertNotEqual(obj.Status, "OK")

    def test_is_an_ordinary_shape(self):
        obj = self.join()
        extrusion = self.doc.addObject("Part::Extrusion", "Extrusion")
        extrusion.Base, extrusion.Dir, extrusion.LengthFwd = obj, V(0, 0, 1), 10.0
        self.doc.recompute()
        self.assertEqual(len(extrusion.Shape.Faces), 1)
        self.assertLess(extrusion.Shape.distToShape(Part.Vertex(V(70, 20, 10)))[0], 1e-9)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "joined.step")
            obj.Shape.exportStep(path)
            back = Part.read(path)
        self.assertAlmostEqual(back.Length, obj.Shape.Length, delta=1e-6)
