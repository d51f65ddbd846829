"""Tests of the document object Audit."""

import FreeCAD
import Part

from osculate.features import long_work, make_audit, make_matched_curve
from osculate.features.audit import Audit, add_fix, why_not_matched
from osculate.features.edge_link import EdgeLink
from osculate.features.selftest.feature_case import FeatureCase
from osculate.features.tolerance_choice import ToleranceValues

V = FreeCAD.Vector


class AuditTest(FeatureCase):
    """The line and the arc of radius 20 that touches it: G1, misses G2."""

    def audit(self, *sources, **options):
        return make_audit(self.doc, sources or (self.line, self.arc), **options)

    def orders(self, obj):
        return [obj.Gaps] + [getattr(obj, f"G{order}") for order in range(5)]

    def profile(self):
        """A wire: line, arc, line that the arc meets with an angle of 90°."""
        end = self.arc.Shape.Vertexes[-1].Point
        return self.add("Profile", Part.Wire([*self.line.Shape.Edges, *self.arc.Shape.Edges,
                                              Part.LineSegment(end, end + V(9, 0, 0)).toShape()]))

    def test_says_how_many_joins_have_which_order(self):
        obj = self.audit()
        self.assertEqual((obj.Status, obj.Joins, obj.EdgeCount, obj.Warnings), ("OK", 1, 2, []))
        self.assertEqual(self.orders(obj), [0, 0, 1, 0, 0, 0])
        self.assertEqual((obj.WorstOrder, obj.OutOfTolerance, obj.Corners), (1, 0, 0))
        self.assertTrue(obj.Worst.startswith("Line.Edge1 – Arc.Edge1: G1, misses G2"), obj.Worst)
        self.assertLess(obj.WorstPosition.distanceToPoint(V(50, 0, 0)), 1e-9)

    def test_required_order_says_what_is_out_of_tolerance(self):
        obj = self.audit(required=2)
        self.assertEqual(obj.OutOfTolerance, 1)
        obj.Required = 1
        self.doc.recompute()
        self.assertEqual(obj.OutOfTolerance, 0)

    def test_corners_count_on_demand(self):
        profile = self.profile()
        obj = self.audit(profile)
        self.assertEqual((obj.Joins, obj.Corners), (1, 1))
        obj.Pairs = "all"
        self.doc.recompute()
        self.assertEqual((obj.Joins, obj.Corners), (2, 0))
        self.assertEqual((obj.G0, obj.G1, obj.OutOfTolerance), (1, 1, 1))
        self.assertIn("Edge2 – Edge3: G0", obj.Worst)
        obj.Pairs, obj.CornerAngle = "tangent", 91.0
        self.doc.recompute()
        self.assertEqual(obj.Joins, 2)

    def test_tolerances(self):
        values = ToleranceValues(1.0, 1.0, 1.5, 0.1, 0.1)
        obj = self.audit(preset="custom", values=values)
        self.assertEqual(obj.G2, 1)
        self.assertEqual(obj.CurvatureTolerance, 1.5)
        obj.Preset = "catia-v5"
        self.assertEqual(obj.AngleTolerance.Value, 0.01)
        self.assertIn("ReadOnly", obj.getEditorMode("AngleTolerance"))
        self.doc.recompute()
        self.assertEqual(obj.G1, 1)

    def test_orders_that_are_not_analysed_are_hidden(self):
        obj = self.audit(order=2)
        self.assertEqual(obj.getEditorMode("G2"), ["ReadOnly"])
        self.assertIn("Hidden", obj.getEditorMode("G3"))

    def test_follows_the_model(self):
        obj = self.audit(self.profile())
        wire = self.doc.Profile
        wire.Shape = Part.makePolygon([V(), V(10, 0), V(20, 1), V(30, 0)])
        self.doc.recompute()
        self.assertEqual((obj.Joins, obj.G0), (2, 2))
        self.assertIn("Edge", obj.Worst)

    def test_a_gap_between_objects(self):
        self.arc.Placement.Base.z = 0.005
        obj = self.audit()
        self.assertEqual((obj.Gaps, obj.WorstOrder, obj.OutOfTolerance), (1, -1, 1))
        obj.TouchDistance = 0.001
        self.doc.recompute()
        self.assertEqual((obj.Status, obj.Joins, obj.Worst), ("OK", 0, ""))

    def test_open_ends_of_wires_touch_others(self):
        wires = [self.add("Wire", Part.makePolygon([V(*point) for point in points]))
                 for points in (((0, 0), (10, 0), (20, 1)), ((20.005, 1), (30, 2), (40, 4)))]
        obj = self.audit(*wires)
        self.assertEqual((obj.Joins, obj.Gaps), (3, 1))
        self.assertIn("Wire.Edge2 – Wire001.Edge1", obj.Worst)
        obj.Pairs = "wire"
        self.doc.recompute()
        self.assertEqual((obj.Joins, obj.Gaps), (2, 0))

    def test_an_app_part_counts_as_all_that_is_seen_in_it(self):
        part = self.doc.addObject("App::Part", "Part")
        part.addObjects([self.line, self.arc])
        part.Placement.Base = V(0, 0, 7)
        self.doc.recompute()
        obj = self.audit(part)
        self.assertEqual((obj.Status, obj.G1), ("OK", 1))
        self.assertAlmostEqual(obj.WorstPosition.z, 7.0, delta=1e-12)
        model = obj.Proxy.result.model
        self.assertEqual([model.edge_link(number).sub for number in (1, 2)],
                         ["Line.Edge1", "Arc.Edge1"])
        self.assertAlmostEqual(model.edge_link(2).resolve().CenterOfMass.z, 7.0, delta=1e-9)
        self.arc.Visibility = False
        obj.touch()
        self.doc.recompute()
        self.assertEqual(obj.EdgeCount, 1)

    def test_objects_that_share_edges_have_each_edge_once(self):
        box = self.add("Box", Part.makeBox(10, 10, 10))
        face = self.add("Face", box.Shape.Faces[0])
        for other in (box, face):
            other.purgeTouched()  # a recompute would give each a location of its own
        obj = self.audit(face, box, pairs="all")
        self.assertEqual(obj.EdgeCount, 12)
        model = obj.Proxy.result.model
        for number, edge in enumerate(model.shape.Edges, 1):
            self.assertTrue(model.edge_link(number).resolve().isPartner(edge), number)
        self.assertEqual(model.edge_label(1), "Face.Edge1")
        self.assertTrue(model.edge_label(12).startswith("Box."))

    def test_deleted_and_empty_objects_are_told_and_the_numbers_stay(self):
        obj = self.audit()
        self.doc.removeObject(self.line.Name)
        self.doc.removeObject(self.arc.Name)
        obj.touch()
        self.doc.recompute()
        self.assertIn("nothing to audit", obj.Status)
        self.assertFalse(obj.isValid())
        self.assertEqual((obj.Joins, obj.G1), (1, 1))
        vertex = self.add("Vertex", Part.Vertex(0, 0, 0))
        self.assertIn("Vertex has no edges", self.audit(vertex).Status)

    def test_a_stopped_audit_keeps_the_last_numbers(self):
        obj = self.audit(required=2)

        class Stops:
            def __enter__(self):
                return lambda share: False

            def __exit__(self, *_):
                return False

        self.addCleanup(setattr, long_work, "_maker", long_work._maker)
        long_work.register(lambda title: Stops())
        obj.touch()
        self.doc.recompute()
        self.assertIn("stopped", obj.Status)
        self.assertTrue(obj.Proxy.was_stopped)
        self.assertEqual((obj.Joins, obj.OutOfTolerance), (1, 1))
        self.assertEqual(obj.Proxy.audited(obj).report.summary["joins"], 1)
        long_work.register(None)
        obj.touch()
        self.doc.recompute()
        self.assertEqual((obj.Status, obj.Proxy.was_stopped), ("OK", False))

    def test_a_preview_audits_again_only_what_changed(self):
        obj = self.audit()
        first = obj.Proxy.result
        obj.Required = 2
        obj.Proxy.preview(obj)
        self.assertIs(obj.Proxy.result, first)
        self.doc.recompute()  # as after every preview
        self.assertIs(obj.Proxy.result, first)
        self.assertEqual(obj.OutOfTolerance, 1)
        obj.touch()
        self.doc.recompute()
        self.assertIsNot(obj.Proxy.result, first)
        self.arc.Placement.Base.z = 0.005
        obj.Proxy.preview(obj)
        self.assertEqual(obj.Proxy.result.rows.count(-1), 1)

    def test_wrong_options_leave_the_document_alone(self):
        for options in ({"pairs": "some"}, {"corner_deg": 200.0}, {"touch_mm": -1.0},
                        {"required": 9}, {"order": -1}, {"required": 3, "order": 2},
                        {"preset": "mine"}, {"preset": "custom"}):
            with self.subTest(options), self.assertRaises(ValueError):
                self.audit(**options)
        self.assertEqual(len(self.doc.Objects), 2)

    def test_what_is_required_must_be_analysed(self):
        obj = self.audit()
        obj.OrderAsked, obj.Required = 2, 3
        self.doc.recompute()
        self.assertIn("up to G2", obj.Status)
        self.assertEqual(obj.Joins, 1)

    def test_a_part_of_an_object_is_refused(self):
        obj = self.audit((self.line, "Edge1"))
        self.assertIn("only a part", obj.Status)

    def test_survives_saving_and_loading(self):
        self.audit(required=2, pairs="wire")
        loaded = self.save_and_load().Audit
        self.assertIsInstance(loaded.Proxy, Audit)
        self.assertNotIn("Touched", loaded.State)
        self.assertEqual((loaded.Required, loaded.Pairs, loaded.OutOfTolerance), (2, "wire", 1))
        self.assertEqual(len(loaded.Proxy.audited(loaded).rows), 1)
        self.doc.Arc.Placement.Base.z = 0.005
        self.doc.recompute()
        self.assertEqual((loaded.Gaps, loaded.G1), (1, 0))


class FixTest(FeatureCase):
    """What stands for an edge after Match."""

    def setUp(self):
        super().setUp()
        self.obj = make_audit(self.doc, [self.line, self.arc], required=2)

    def fix(self, reference, changed, **options):
        fix = make_matched_curve(self.doc, reference, changed, **options)
        self.assertEqual(fix.Status, "OK")
        add_fix(self.obj, fix)
        self.doc.recompute()
        return fix

    def test_a_matched_curve_stands_for_the_edge(self):
        self.assertEqual(self.obj.OutOfTolerance, 1)
        fix = self.fix((self.line, "Edge1"), (self.arc, "Edge1"), order=2)
        self.assertEqual((self.obj.Status, self.obj.OutOfTolerance), ("OK", 0))
        model = self.obj.Proxy.result.model
        self.assertEqual(model.edge_link(2), EdgeLink.of(fix, "Edge1"))
        self.assertEqual((self.obj.Joins, model.edge_label(2)), (1, f"{fix.Label}.Edge1"))

    def test_deleting_it_brings_the_edge_back(self):
        fix = self.fix((self.line, "Edge1"), (self.arc, "Edge1"), order=2)
        self.doc.removeObject(fix.Name)
        self.obj.touch()
        self.doc.recompute()
        self.assertEqual((self.obj.Status, self.obj.OutOfTolerance), ("OK", 1))

    def test_a_fix_can_be_fixed(self):
        fix = self.fix((self.line, "Edge1"), (self.arc, "Edge1"), order=2)
        better = self.fix((self.line, "Edge1"), (fix, "Edge1"), order=3)
        model = self.obj.Proxy.result.model
        self.assertEqual(model.edge_link(2), EdgeLink.of(better, "Edge1"))
        self.assertGreaterEqual(self.obj.WorstOrder, 3)

    def test_in_a_wire_the_other_edges_keep_their_joins(self):
        end = self.arc.Shape.Vertexes[-1].Point
        wire = self.add("Wire", Part.Wire([
            *self.line.Shape.Edges, *self.arc.Shape.Edges,
            Part.LineSegment(end, end + V(0, 9, 0)).toShape()]))
        self.obj.Sources = [(wire, "")]
        self.doc.recompute()
        self.assertEqual((self.obj.Joins, self.obj.OutOfTolerance), (2, 2))
        self.fix((wire, "Edge1"), (wire, "Edge2"), order=2, keep=1)
        self.assertEqual((self.obj.Status, self.obj.Joins, self.obj.OutOfTolerance),
                         ("OK", 2, 1))
        model = self.obj.Proxy.result.model
        self.assertEqual([model.edge_link(number).object for number in (1, 2, 3)],
                         ["Wire", "MatchedCurve", "Wire"])

    def test_in_an_app_part_the_hidden_edge_is_still_replaced(self):
        part = self.doc.addObject("App::Part", "Part")
        part.addObjects([self.line, self.arc])
        part.Placement.Base = V(0, 0, 7)
        self.obj.Sources = [(part, "")]
        self.doc.recompute()
        self.assertEqual((self.obj.Status, self.obj.OutOfTolerance), ("OK", 1))
        fix = self.fix((part, "Line.Edge1"), (part, "Arc.Edge1"), order=2, hide_original=True)
        self.assertFalse(self.arc.Visibility)
        self.assertEqual((self.obj.Status, self.obj.Joins, self.obj.OutOfTolerance), ("OK", 1, 0))
        self.assertEqual(self.obj.Proxy.result.model.edge_link(2), EdgeLink.of(fix, "Edge1"))
        self.assertAlmostEqual(self.obj.WorstPosition.z, 7.0, delta=1e-9)

    def test_edges_of_faces_cannot_be_replaced(self):
        box = self.add("Box", Part.makeBox(10, 10, 10))
        self.assertIn("bounds a face of Box", why_not_matched(EdgeLink.of(box, "Edge1")))
        self.assertEqual(why_not_matched(EdgeLink.of(self.arc, "Edge1")), "")
        fix = make_matched_curve(self.doc, (self.line, "Edge1"), (box, "Edge2"), order=0)
        self.obj.Sources = [(box, "")]
        add_fix(self.obj, fix)
        self.doc.recompute()
        self.assertIn("bound faces", self.obj.Status)
