"""Tests of the document object BlendCurve."""

import math

import FreeCAD
import Part

import osculate
from osculate.features import beta_properties, make_blend_curve
from osculate.features.blend_curve import BlendCurve
from osculate.features.constructed import refuse_loop
from osculate.features.edge_link import EdgeLink, LinkError
from osculate.features.selftest.feature_case import FeatureCase

V = FreeCAD.Vector


class BlendCurveTest(FeatureCase):
    """Between the line and an arc that is moved away from it."""

    def setUp(self):
        super().setUp()
        self.arc.Placement.Base = V(40, 30, 10)
        self.doc.recompute()

    def blend(self, **options):
        return make_blend_curve(self.doc, (self.line, "Edge1"), (self.arc, "Edge1"), **options)

    def ends(self, obj):
        return [obj.Shape.Edges[0].valueAt(t) for t in obj.Shape.Edges[0].ParameterRange]

    def expected(self, **options):
        return osculate.blend(self.line.Shape.Edges[0], self.arc.Shape.Edges[0], **options)

    def assert_is_curve(self, obj, result):
        poles = obj.Shape.Edges[0].Curve.getPoles()
        self.assertEqual([tuple(pole) for pole in poles],
                         [tuple(pole) for pole in result.curve.poles.tolist()])

    def test_is_the_blend_of_the_api(self):
        obj = self.blend(order=(2, 4))
        result = self.expected(order=(2, 4))
        self.assert_is_curve(obj, result)
        self.assertEqual((obj.Status, obj.Orders), ("OK", [report.order for report in
                                                           result.reports]))
        self.assertEqual(obj.EndsMade, "end-start")
        self.assertEqual(obj.CurveDegree, 7)
        self.assertEqual(obj.Variation, result.energy["mvc"])
        self.assertAlmostEqual(obj.Length.Value, obj.Shape.Length, delta=1e-6)
        self.assertEqual((obj.FirstBeta1, obj.FirstBeta2), result.beta[0])
        self.assertTrue(obj.isValid())

    def test_all_arguments_arrive(self):
        options = {"order": (1, 3), "beta": ((0.8,), (None, 2.0)), "degree": 7,
                   "fairness": "bending", "symmetric": True}
        obj = self.blend(**options)
        self.assert_is_curve(obj, self.expected(**options))
        self.assertEqual((obj.FirstBeta1, obj.FirstBeta1Fixed), (0.8, True))
        self.assertEqual((obj.SecondBeta1Fixed, obj.SecondBeta2), (False, 2.0))

    def test_no_fairness(self):
        self.assert_is_curve(self.blend(fairness=None), self.expected(fairness=None))

    def test_other_ends(self):
        obj = self.blend(ends=("start", "end"))
        self.assertEqual(obj.EndsMade, "start-end")
        self.assertTrue(self.ends(obj)[0].isEqual(V(0, 0, 0), 1e-9))

    def test_a_place_inside_an_edge(self):
        obj = self.blend(ends=("inside-forward", "nearest"), positions=(0.2, 0.5))
        first, last = self.ends(obj)
        self.assertTrue(first.isEqual(V(10, 0, 0), 1e-9))
        self.assertTrue(last.isEqual(self.arc.Shape.Edges[0].valueAt(-math.pi / 2), 1e-9))
        self.assertTrue(obj.Shape.Edges[0].tangentAt(0.0).isEqual(V(1, 0, 0), 1e-9))
        obj.FirstEnd = "inside-backward"
        self.doc.recompute()
        self.assertTrue(obj.Shape.Edges[0].tangentAt(0.0).isEqual(V(-1, 0, 0), 1e-9))

    def test_nearest_end_to_a_given_one(self):
        obj = self.blend(ends=("nearest", "end"))
        self.assertEqual(obj.EndsMade, "end-end")

    def test_one_edge_is_closed(self):
        obj = make_blend_curve(self.doc, (self.arc, "Edge1"), (self.arc, "Edge1"), order=2)
        self.assertEqual((obj.Status, obj.EndsMade), ("OK", "end-start"))
        self.assertEqual(obj.Orders, [2, 2])

    def test_follows_edits(self):
        obj = self.blend()
        self.line.Placement.Base.z = -5.0
        self.doc.recompute()
        self.assertTrue(self.ends(obj)[0].isEqual(V(50, 0, -5), 1e-9))

    def test_free_numbers_follow_and_fixed_ones_stay(self):
        obj = self.blend(order=2, beta=((None, 1.5), ()))
        before = obj.FirstBeta1
        self.arc.Placement.Base.x += 30.0
        self.doc.recompute()
        self.assertNotEqual(obj.FirstBeta1, before)
        self.assertEqual(obj.FirstBeta2, 1.5)
        self.assertEqual(obj.Proxy.result.beta[0], (obj.FirstBeta1, 1.5))

    def test_fixed_numbers_stay_where_the_order_changes(self):
        obj = self.blend(order=2, beta=((0.7, 1.5), (0.9,)))
        for order in (4, 1, 3):
            obj.FirstOrder = obj.SecondOrder = order
            self.doc.recompute()
            self.assertEqual((obj.FirstBeta1, obj.SecondBeta1), (0.7, 0.9))
        self.assertEqual(obj.FirstBeta2, 1.5)

    def test_editors(self):
        obj = self.blend(order=2)
        self.assertEqual(obj.getEditorMode("FirstBeta2"), ["ReadOnly"])
        self.assertEqual(obj.getEditorMode("FirstBeta3"), ["Hidden"])
        obj.FirstBeta2Fixed = True
        obj.FirstOrder = 3
        self.assertEqual(obj.getEditorMode("FirstBeta2"), [])
        self.assertEqual(obj.getEditorMode("FirstBeta3"), ["ReadOnly"])

    def test_what_cannot_be_met_keeps_the_shape_and_says_why(self):
        obj = self.blend()
        length = obj.Shape.Length
        obj.Degree = 3
        self.doc.recompute()
        self.assertFalse(obj.isValid())
        self.assertIn("degree", obj.Status)
        self.assertEqual(obj.getStatusString(), obj.Status)
        self.assertEqual(obj.Shape.Length, length)
        obj.Degree = 0
        self.doc.recompute()
        self.assertTrue(obj.isValid())
        self.assertEqual(obj.Status, "OK")

    def test_beta_1_must_be_positive(self):
        obj = self.blend()
        obj.FirstBeta1, obj.FirstBeta1Fixed = -1.0, True
        self.doc.recompute()
        self.assertIn("beta", obj.Status)
        self.assertFalse(obj.isValid())

    def test_deleted_edge(self):
        obj = self.blend()
        length = obj.Shape.Length
        self.doc.removeObject(self.arc.Name)
        self.doc.recompute()
        self.assertIn("deleted", obj.Status)
        self.assertFalse(obj.isValid())
        self.assertEqual(obj.Shape.Length, length)

    def test_coinciding_ends(self):
        self.arc.Placement.Base = V(0, 0, 0)
        self.doc.recompute()
        obj = self.blend()
        self.assertFalse(obj.isValid())
        self.assertIn("coincide", obj.Status)
        self.assertTrue(obj.Shape.isNull())

    def test_follows_the_part_around_an_edge(self):
        part = self.doc.addObject("App::Part", "Part")
        part.addObject(self.arc)
        obj = make_blend_curve(self.doc, (self.line, "Edge1"), (part, "Arc.Edge1"))
        before = self.ends(obj)[1]
        part.Placement.Base.z = 7.0
        self.doc.recompute()
        self.assertTrue(self.ends(obj)[1].isEqual(before + V(0, 0, 7), 1e-9))

    def test_stays_at_its_edges_inside_a_part(self):
        obj = self.blend()
        part = self.doc.addObject("App::Part", "Part")
        part.Placement = FreeCAD.Placement(V(1, 2, 3), FreeCAD.Rotation(V(0, 0, 1), 30))
        part.addObject(obj)
        obj.touch()
        self.doc.recompute()
        seen = Part.getShape(part, obj.Name + ".Edge1", needSubElement=True)
        self.assertTrue(seen.valueAt(0.0).isEqual(V(50, 0, 0), 1e-9))

    def test_blend_of_a_blend(self):
        obj = self.blend()
        other = self.add("Other", Part.LineSegment(V(0, 60, 0), V(30, 60, 0)).toShape())
        second = make_blend_curve(self.doc, (obj, "Edge1"), (other, "Edge1"),
                                  ends=("inside-forward", "end"))
        start = self.ends(second)[0]
        self.line.Placement.Base.z = -5.0
        self.doc.recompute()
        self.assertEqual(second.Status, "OK")
        self.assertFalse(self.ends(second)[0].isEqual(start, 1e-3))

    def test_a_loop_is_refused(self):
        obj = self.blend()
        second = make_blend_curve(self.doc, (obj, "Edge1"), (self.arc, "Edge1"),
                                  ends=("start", "end"))
        with self.assertRaisesRegex(LinkError, "BlendCurve001 depends on BlendCurve"):
            refuse_loop(obj, EdgeLink.of(second, "Edge1"))
        with self.assertRaises(LinkError):
            refuse_loop(obj, EdgeLink.of(obj, "Edge1"))
        refuse_loop(second, EdgeLink.of(obj, "Edge1"))

    def test_is_an_ordinary_shape(self):
        obj = self.blend()
        sweep = self.doc.addObject("Part::Extrusion", "Extrusion")
        sweep.Base, sweep.Dir = obj, V(0, 0, 5)
        self.doc.recompute()
        self.assertEqual(len(sweep.Shape.Faces), 1)
        self.assertAlmostEqual(Part.Wire(obj.Shape.Edges).Length, obj.Length.Value, delta=1e-3)

    def test_bad_arguments_change_nothing(self):
        for options in ({"order": 9}, {"order": (2, -1)}, {"ends": ("end", "middle")},
                        {"positions": (0.5, 2.0)}, {"beta": ((1.0, 2.0), ()), "order": 1},
                        {"beta": ((0.0,), ())}, {"degree": 26}, {"fairness": "best"}):
            with self.subTest(options), self.assertRaises(ValueError):
                self.blend(**options)
        self.assertEqual(len(self.doc.Objects), 2)

    def test_copy_lives_on_its_own(self):
        obj = self.blend()
        copy = self.doc.copyObject(obj, False)
        obj.FirstOrder = 1
        self.doc.recompute()
        self.assertEqual((copy.FirstOrder, copy.Continuity[0]), (3, "G3"))
        self.assertIsInstance(copy.Proxy, BlendCurve)

    def test_undo_and_redo(self):
        self.doc.UndoMode = 1
        self.doc.openTransaction("Blend")
        obj = self.blend()
        name, length = obj.Name, obj.Shape.Length
        self.doc.commitTransaction()
        self.doc.undo()
        self.assertIsNone(self.doc.getObject(name))
        self.doc.redo()
        self.assertEqual(self.doc.getObject(name).Shape.Length, length)

    def test_saving_and_loading(self):
        obj = self.blend(order=(2, 4), beta=((0.9, None), ()), ends=("inside-forward", "nearest"))
        before = self.values(obj)
        obj = self.save_and_load().BlendCurve
        self.assertEqual(self.values(obj), before)
        self.assertNotIn("Touched", obj.State)
        self.doc.Line.Placement.Base.z = 1.0
        self.doc.recompute()
        self.assertEqual(obj.Status, "OK")
        self.assertTrue(self.ends(obj)[0].isEqual(V(25, 0, 1), 1e-6))

    def test_loading_what_could_not_be_met(self):
        obj = self.blend()
        obj.Degree = 3
        self.doc.recompute()
        obj = self.save_and_load().BlendCurve
        self.assertIn("degree", obj.Status)
        self.assertFalse(obj.Shape.isNull())
        obj.Degree = 0
        self.doc.recompute()
        self.assertEqual(obj.Status, "OK")

    @staticmethod
    def values(obj):
        """All that files keep exactly; 0.20 rounds numbers."""
        names = BlendCurve.inputs() + ["Status", "Continuity", "Orders", "Warnings", "EndsMade"]
        rounded = [beta_properties.number_name(side, k) for side in ("First", "Second")
                   for k in range(1, 9)]
        return {name: getattr(obj, name) for name in names
                if name not in (*rounded, "First", "Second")}
