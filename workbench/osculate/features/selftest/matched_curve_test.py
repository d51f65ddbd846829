"""Tests of the document object MatchedCurve."""

import math
import os
import tempfile

import FreeCAD
import Part

import osculate
from osculate.features import make_matched_curve
from osculate.features.matched_curve import MatchedCurve
from osculate.features.selftest.feature_case import FeatureCase

V = FreeCAD.Vector


class MatchedCurveTest(FeatureCase):
    """A spline of five spans that begins near the end of the line."""

    def setUp(self):
        super().setUp()
        curve = Part.BSplineCurve()
        curve.interpolate([V(50, 1, 0), V(65, 3, 0), V(80, 10, 2), V(95, 8, 4), V(110, 0, 0),
                           V(125, 5, 0)])
        self.spline = self.add("Spline", curve.toShape())
        self.doc.recompute()

    def match(self, **options):
        return make_matched_curve(self.doc, (self.line, "Edge1"), (self.spline, "Edge1"),
                                  **options)

    def expected(self, **options):
        return osculate.match(self.line.Shape.Edges[0], self.spline.Shape.Edges[0], **options)

    def assert_is_curve(self, obj, result):
        poles = obj.Shape.Edges[0].Curve.getPoles()
        self.assertEqual([tuple(pole) for pole in poles],
                         [tuple(pole) for pole in result.curve.poles.tolist()])

    def start(self, obj):
        return obj.Shape.Edges[0].valueAt(obj.Shape.Edges[0].FirstParameter)

    def test_is_the_match_of_the_api(self):
        obj = self.match(order=2)
        result = self.expected(order=2)
        self.assert_is_curve(obj, result)
        self.assertEqual((obj.Status, obj.EndsMade), ("OK", "end-start"))
        self.assertEqual(obj.Continuity[0], "G2")
        self.assertEqual(obj.MaxDisplacement.Value, result.max_displacement_mm)
        self.assertEqual(obj.MaxDisplacement.Unit, FreeCAD.Units.Length)
        self.assertEqual(obj.RmsDisplacement.Value, result.change["rms_mm"])
        self.assertEqual((obj.Beta1, obj.Beta2), result.beta[0])
        self.assertTrue(self.start(obj).isEqual(V(50, 0, 0), 1e-9))

    def test_the_edge_itself_stays(self):
        before = self.spline.Shape.exportBrepToString()
        self.match()
        self.assertEqual(self.spline.Shape.exportBrepToString(), before)

    def test_all_arguments_arrive(self):
        for options in ({"order": 3, "keep": 1}, {"order": 1, "degree": 5}, {"spans": 3},
                        {"beta": (1.2, None)}, {"order": 0, "keep": 0}):
            with self.subTest(options):
                obj = self.match(**options)
                self.assertEqual(obj.Status, "OK")
                self.assert_is_curve(obj, self.expected(**options))

    def test_the_far_end_is_judged(self):
        few = self.match(order=2, spans=3)
        self.assertEqual(few.ChangedSpans, 3)
        self.assertIsNone(few.Proxy.result.change["kept"])
        self.assertGreaterEqual(few.Orders[1], 4)
        loose = self.match(order=2, keep=0)
        self.assertEqual(len(loose.Orders), 2)
        self.assertEqual(loose.Orders[1] >= 4, loose.Proxy.result.change["kept"] is None)

    def test_one_segment_keeps_what_it_should_at_its_far_end(self):
        curve = Part.BezierCurve()
        curve.setPoles([V(51, 2, 0), V(60, 8, 0), V(80, 8, 5), V(90, 0, 5)])
        self.spline.Shape = curve.toShape()
        for keep in (0, 1, 2):
            obj = self.match(order=1, keep=keep)
            self.assertEqual((obj.Status, obj.Orders[0]), ("OK", 1))
            self.assertGreaterEqual(obj.Orders[1], keep)
            self.assertGreaterEqual(obj.Proxy.far_report.parametric_order, keep)
        self.assertEqual(self.match(order=1, keep=0).Orders[1], 0)

    def test_given_ends_and_a_place_inside(self):
        obj = self.match(ends=("start", "end"), order=1)
        self.assertEqual(obj.EndsMade, "start-end")
        obj = self.match(ends=("inside-forward", "start"), position=0.8, order=1)
        self.assertTrue(self.start(obj).isEqual(V(40, 0, 0), 1e-9))

    def test_what_meets_already_stays(self):
        first = self.match(order=2)
        again = make_matched_curve(self.doc, (self.line, "Edge1"), (first, "Edge1"), order=2)
        self.assertEqual(again.MaxDisplacement.Value, 0.0)
        self.assertEqual(again.Continuity[0], "G2")

    def test_one_closed_edge_closes_smoothly(self):
        curve = Part.BSplineCurve()
        curve.interpolate([V(0, 0, 0), V(30, 0, 0), V(30, 30, 0), V(0, 30, 0), V(0, 0, 0)])
        self.spline.Shape = curve.toShape()
        obj = make_matched_curve(self.doc, (self.spline, "Edge1"), (self.spline, "Edge1"), order=2)
        self.assertEqual((obj.Status, obj.Orders), ("OK", [2]))

    def test_follows_edits(self):
        obj = self.match()
        before = obj.MaxDisplacement.Value
        self.line.Placement.Base.z = 0.5
        self.doc.recompute()
        self.assertTrue(self.start(obj).isEqual(V(50, 0, 0.5), 1e-9))
        self.assertNotEqual(obj.MaxDisplacement.Value, before)

    def test_inside_a_part(self):
        part = self.doc.addObject("App::Part", "Part")
        part.Placement = FreeCAD.Placement(V(1, 2, 3), FreeCAD.Rotation(V(0, 0, 1), 30))
        part.addObject(self.line)
        obj = make_matched_curve(self.doc, (part, "Line.Edge1"), (self.spline, "Edge1"),
                                 ends=("end", "start"))
        self.assertEqual(obj.Status, "OK")
        end = part.Placement.multVec(V(50, 0, 0))
        self.assertTrue(self.start(obj).isEqual(end, 1e-9))

    def test_hiding_the_original(self):
        obj = self.match(hide_original=True)
        self.assertFalse(self.spline.Visibility)
        other = self.add("Other", self.spline.Shape.copy())
        obj.Changed = (other, "Edge1")
        self.assertEqual((self.spline.Visibility, other.Visibility), (True, False))
        obj.HideOriginal = False
        self.assertTrue(other.Visibility)

    def test_what_cannot_be_met_keeps_the_shape_and_says_why(self):
        obj = self.match()
        before = obj.Shape.Length
        obj.Order, obj.Degree = 5, 3
        self.doc.recompute()
        self.assertIn("degree", obj.Status)
        self.assertFalse(obj.isValid())
        self.assertEqual(obj.Shape.Length, before)
        obj.Degree = 0
        self.doc.recompute()
        self.assertEqual((obj.Status, obj.CurveDegree), ("OK", 5))
        self.doc.removeObject("Line")
        self.doc.recompute()
        self.assertIn("deleted", obj.Status)
        self.assertFalse(obj.Shape.isNull())

    def test_bad_arguments_change_nothing(self):
        for options in ({"order": 9}, {"keep": -1}, {"ends": ("end", "inside-forward")},
                        {"position": 2.0}, {"degree": 26}, {"spans": 0}, {"beta": (0.0,)},
                        {"beta": (1.0, 1.0), "order": 1}):
            with self.subTest(options), self.assertRaises(ValueError):
                self.match(**options)
        self.assertEqual(len(self.doc.Objects), 3)

    def test_copy_lives_on_its_own(self):
        obj = self.match()
        copy = self.doc.copyObject(obj, False)
        obj.Order = 1
        self.doc.recompute()
        self.assertEqual((copy.Order, copy.Continuity[0]), (2, "G2"))
        self.assertIsInstance(copy.Proxy, MatchedCurve)

    def test_undo_and_redo(self):
        self.doc.UndoMode = 1
        self.doc.openTransaction("Match")
        obj = self.match(hide_original=True)
        name, length = obj.Name, obj.Shape.Length
        self.doc.commitTransaction()
        self.doc.undo()
        self.assertIsNone(self.doc.getObject(name))
        self.assertTrue(self.spline.Visibility)
        self.doc.redo()
        self.assertEqual(self.doc.getObject(name).Shape.Length, length)

    def test_saving_and_loading(self):
        obj = self.match(order=3, keep=2, spans=4, ends=("end", "nearest"), hide_original=True)
        names = ("Order", "Keep", "Spans", "ReferenceEnd", "ChangedEnd", "HideOriginal", "Status",
                 "Continuity", "Orders", "EndsMade", "ChangedSpans")
        before = [getattr(obj, name) for name in names]
        obj = self.save_and_load().MatchedCurve
        self.assertEqual([getattr(obj, name) for name in names], before)
        self.assertNotIn("Touched", obj.State)
        self.doc.Line.Placement.Base.z = 1.0
        self.doc.recompute()
        self.assertEqual(obj.Status, "OK")
        self.assertAlmostEqual(self.start(obj).z, 1.0, delta=1e-9)

    def test_is_an_ordinary_shape(self):
        """A pipe along the changed edge, a loft to the edge as it was, and STEP."""
        obj = self.match(order=2)
        circle = self.add("Circle", Part.Wire(Part.makeCircle(1, V(50, 0, 0), V(1, 0, 0))))
        sweep = self.doc.addObject("Part::Sweep", "Sweep")
        sweep.Sections, sweep.Spine, sweep.Solid = [circle], (obj, ["Edge1"]), True
        self.spline.Placement.Base.z = 20.0
        self.doc.recompute()
        loft = self.doc.addObject("Part::Loft", "Loft")
        loft.Sections = [obj, self.line]
        self.doc.recompute()
        self.assertTrue(sweep.isValid() and sweep.Shape.isValid())
        self.assertAlmostEqual(sweep.Shape.Volume, math.pi * obj.Shape.Length, delta=1.0)
        self.assertEqual(len(loft.Shape.Faces), 1)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "match.step")
            Part.export([obj], path)
            self.assertAlmostEqual(Part.read(path).Length, obj.Shape.Length, delta=1e-6)
