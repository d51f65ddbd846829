"""Tests of the document object ExtendedCurve."""

import math
import os
import tempfile

import FreeCAD
import Part

import osculate
from osculate.features import make_extended_curve
from osculate.features.extended_curve import ExtendedCurve, tangential_of
from osculate.features.extended_curve_properties import tangential_numbers
from osculate.features.selftest.feature_case import FeatureCase

V = FreeCAD.Vector


class ExtendedCurveTest(FeatureCase):
    """Of the arc from (50, 0) to (70, 20), radius 20."""

    def extend(self, **options):
        return make_extended_curve(self.doc, (self.arc, "Edge1"), **options)

    def expected(self, **options):
        return osculate.extend(self.arc.Shape.Edges[0], **options)

    def assert_is_curve(self, obj, result):
        poles = obj.Shape.Edges[-1].Curve.getPoles()
        self.assertEqual([tuple(pole) for pole in poles],
                         [tuple(pole) for pole in result.curve.poles.tolist()])

    def ends(self, obj):
        edge = obj.Shape.Edges[0]
        return [edge.valueAt(t) for t in edge.ParameterRange]

    def test_is_the_extension_of_the_api(self):
        obj = self.extend(order=2, length=15.0)
        result = self.expected(order=2, length=15.0)
        self.assert_is_curve(obj, result)
        self.assertEqual((obj.Status, obj.Orders), ("OK", [2]))
        self.assertEqual(obj.FreeNumbers, result.free_numbers)
        self.assertEqual((obj.Beta1, obj.Beta2), result.beta[0])
        self.assertAlmostEqual(obj.Shape.Length, 15.0, delta=1e-6)
        self.assertTrue(self.ends(obj)[0].isEqual(V(70, 20, 0), 1e-9))
        self.assertTrue(obj.isValid())

    def test_all_arguments_arrive(self):
        for options in ({"order": 3, "beta": (0.9, None, 2.0), "degree": 5, "fairness": "bending"},
                        {"order": 3, "parametric": True}, {"order": 3, "parameter": 0.5},
                        {"order": 2, "tangential": (4.0, None)}, {"natural": True, "length": 12.0},
                        {"order": 0, "fairness": None, "to_point": (90, 40, 5), "degree": 1},
                        {"order": 1, "to_point": (90, 40, 5), "to_direction": (0, 1, 0),
                         "to_curvature": 0.01},
                        {"order": 1, "to_curvature": (0.0, 0.0, 0.02), "end": "start"}):
            with self.subTest(options):
                obj = self.extend(**options)
                self.assertEqual(obj.Status, "OK")
                self.assert_is_curve(obj, self.expected(**options))

    def test_natural_continuation_is_the_same_circle(self):
        obj = self.extend(natural=True, length=20.0 * math.pi / 2)
        self.assertTrue(self.ends(obj)[1].isEqual(V(50, 40, 0), 1e-9))
        self.assertEqual(obj.Continuity, ["G4"])
        self.assertEqual(obj.getEditorMode("Degree"), ["Hidden"])

    def test_the_start_is_continued_too(self):
        obj = self.extend(end="start", order=1, length=5.0)
        self.assertTrue(self.ends(obj)[0].isEqual(V(50, 0, 0), 1e-9))
        self.assertTrue(obj.Shape.Edges[0].tangentAt(0.0).isEqual(V(-1, 0, 0), 1e-9))

    def test_free_length_and_numbers_are_shown(self):
        obj = self.extend(order=2, to_point=(90, 40, 0))
        self.assertAlmostEqual(obj.WantedLength.Value, obj.Shape.Length, delta=1e-6)
        self.assertEqual(obj.getEditorMode("WantedLength"), ["ReadOnly"])
        result = obj.Proxy.result
        self.assertEqual([obj.Tangential1.Value, obj.Tangential2.Value], tangential_of(result, 2))

    def test_tangential_coordinates_that_are_shown_give_the_same_curve(self):
        obj = self.extend(order=3, length=20.0)
        before = obj.Shape.Edges[0].Curve.getPoles()
        obj.Numbers = "tangential coordinates"
        for k in (1, 2, 3):
            setattr(obj, tangential_numbers.fixed_name(k), True)
        obj.WantedLengthFixed = False
        obj.Degree = obj.CurveDegree
        self.doc.recompute()
        self.assertEqual(obj.Status, "OK")
        for pole, other in zip(obj.Shape.Edges[0].Curve.getPoles(), before):
            self.assertTrue(pole.isEqual(other, 1e-6))

    def test_follows_a_vertex(self):
        vertex = self.add("Goal", Part.Vertex(90, 40, 0))
        obj = self.extend(order=2, to_point=(vertex, "Vertex1"))
        self.assertTrue(self.ends(obj)[1].isEqual(V(90, 40, 0), 1e-6))
        vertex.Placement.Base.z = 8.0
        self.doc.recompute()
        self.assertTrue(self.ends(obj)[1].isEqual(V(90, 40, 8), 1e-6))
        obj.PointVertex = (self.line, "Edge1")
        self.doc.recompute()
        self.assertIn("not a vertex but a", obj.Status)

    def test_with_its_source_it_is_one_wire(self):
        for end in ("end", "start"):
            obj = self.extend(end=end, order=2, length=10.0, include_source=True)
            self.assertEqual((obj.Shape.ShapeType, len(obj.Shape.Edges)), ("Wire", 2))
            self.assertAlmostEqual(obj.Shape.Length, 10.0 * math.pi + 10.0, delta=1e-6)
            self.assertAlmostEqual(obj.Length.Value, 10.0, delta=1e-6)
            self.assertEqual(len(obj.Shape.Vertexes), 3)

    def test_follows_edits_and_parts(self):
        part = self.doc.addObject("App::Part", "Part")
        part.addObject(self.arc)
        obj = make_extended_curve(self.doc, (part, "Arc.Edge1"), include_source=True)
        part.Placement.Base.z = 7.0
        self.doc.recompute()
        self.assertEqual(obj.Shape.BoundBox.ZMin, 7.0)
        part.addObject(obj)
        obj.touch()
        self.doc.recompute()
        seen = Part.getShape(part, obj.Name + ".Edge2", needSubElement=True)
        self.assertTrue(seen.valueAt(seen.FirstParameter).isEqual(V(70, 20, 7), 1e-9))

    def test_what_cannot_be_met_keeps_the_shape_and_says_why(self):
        obj = self.extend(order=2, length=10.0)
        before = obj.Shape.Length
        obj.Fairness = "none"
        self.doc.recompute()
        self.assertIn("under-determined", obj.Status)
        self.assertFalse(obj.isValid())
        self.assertEqual(obj.Shape.Length, before)
        obj.Fairness = "mvc"
        self.doc.recompute()
        self.assertEqual(obj.Status, "OK")

    def test_editors(self):
        obj = self.extend(order=2, beta=(0.9,))
        self.assertEqual(obj.getEditorMode("Beta1"), [])
        self.assertEqual(obj.getEditorMode("Beta2"), ["ReadOnly"])
        self.assertEqual(obj.getEditorMode("Tangential1"), ["Hidden"])
        obj.Numbers = "tangential coordinates"
        self.assertEqual(obj.getEditorMode("Beta1"), ["Hidden"])
        self.assertEqual(obj.getEditorMode("Tangential1"), ["ReadOnly"])
        obj.Continuation = "re-parametrised"
        self.assertEqual(obj.getEditorMode("Tangential1"), ["Hidden"])
        self.assertEqual(obj.getEditorMode("Parameter"), [])
        self.assertEqual(obj.getEditorMode("PointPosition"), ["Hidden"])
        obj.PointTarget = "position"
        self.assertEqual(obj.getEditorMode("PointPosition"), [])

    def test_bad_arguments_change_nothing(self):
        for options in ({"order": 9}, {"end": "middle"}, {"degree": 26}, {"length": 0.0},
                        {"order": 1, "beta": (1.0, 2.0)}, {"beta": (0.0,)}, {"tangential": (-1.0,)},
                        {"beta": (1.0,), "tangential": (1.0,)}, {"parameter": 0.0},
                        {"natural": True, "parametric": True}, {"fairness": "best"},
                        {"to_direction": (0, 0, 0)}, {"to_curvature": -1.0}):
            with self.subTest(options), self.assertRaises(ValueError):
                self.extend(**options)
        self.assertEqual(len(self.doc.Objects), 2)

    def test_copy_lives_on_its_own(self):
        obj = self.extend()
        copy = self.doc.copyObject(obj, False)
        obj.Order = 1
        self.doc.recompute()
        self.assertEqual((copy.Order, copy.Status), (4, "OK"))
        self.assertIsInstance(copy.Proxy, ExtendedCurve)

    def test_undo_and_redo(self):
        self.doc.UndoMode = 1
        self.doc.openTransaction("Extend")
        obj = self.extend()
        name, length = obj.Name, obj.Shape.Length
        self.doc.commitTransaction()
        self.doc.undo()
        self.assertIsNone(self.doc.getObject(name))
        self.doc.redo()
        self.assertEqual(self.doc.getObject(name).Shape.Length, length)

    def test_saving_and_loading(self):
        vertex = self.add("Goal", Part.Vertex(90, 40, 0))
        obj = self.extend(order=2, to_point=(vertex, "Vertex1"), to_direction=(0, 1, 0),
                          include_source=True)
        names = ("Order", "PointTarget", "DirectionTarget", "Direction", "IncludeSource", "Status",
                 "Continuity", "CurveDegree", "FreeNumbers")
        before = [getattr(obj, name) for name in names]
        obj = self.save_and_load().ExtendedCurve
        self.assertEqual([getattr(obj, name) for name in names], before)
        self.assertNotIn("Touched", obj.State)
        self.assertEqual(obj.getEditorMode("Direction"), [])
        self.doc.Goal.Placement.Base.z = 3.0
        self.doc.recompute()
        self.assertEqual(obj.Status, "OK")
        self.assertAlmostEqual(obj.Shape.BoundBox.ZMax, 3.0, delta=1e-3)

    def test_is_an_ordinary_shape(self):
        """A pipe along the edge and its continuation, a loft to it, and STEP."""
        obj = self.extend(order=3, length=30.0, include_source=True)
        circle = self.add("Circle", Part.Wire(Part.makeCircle(2, V(50, 0, 0), V(1, 0, 0))))
        sweep = self.doc.addObject("Part::Sweep", "Sweep")
        sweep.Sections, sweep.Spine, sweep.Solid = [circle], (obj, ["Edge1", "Edge2"]), True
        alone = self.extend(order=3, length=30.0)
        other = self.add("Other", Part.LineSegment(V(70, 20, 9), V(70, 60, 9)).toShape())
        loft = self.doc.addObject("Part::Loft", "Loft")
        loft.Sections = [alone, other]
        self.doc.recompute()
        self.assertTrue(sweep.isValid() and sweep.Shape.isValid())
        self.assertAlmostEqual(sweep.Shape.Volume, math.pi * 4.0 * obj.Shape.Length, delta=1.0)
        self.assertEqual(len(loft.Shape.Faces), 1)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "extension.step")
            Part.export([obj], path)
            self.assertAlmostEqual(Part.read(path).Length, obj.Shape.Length, delta=1e-6)
