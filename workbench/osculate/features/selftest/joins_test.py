"""Tests of the document object JoinCheck and of the joins of edges."""

import math

import FreeCAD
import Part

from osculate.features import make_join_check
from osculate.features.edge_link import EdgeLink, LinkError
from osculate.features.join_check_properties import _GROUPS
from osculate.features.joins import analyze_links
from osculate.features.selftest.feature_case import FeatureCase
from osculate.features.tolerance_choice import ToleranceValues, tolerances_of

V = FreeCAD.Vector


class JoinCheckTest(FeatureCase):
    def check(self, **options):
        return make_join_check(self.doc, (self.line, "Edge1"), (self.arc, "Edge1"), **options)

    def test_result(self):
        check = self.check()
        self.assertEqual((check.Status, check.Continuity, check.Order), ("OK", "G1", 1))
        self.assertEqual(check.Verdicts, ["pass", "pass", "fail", "fail", "fail"])
        self.assertLess(check.Gap.Value, 1e-12)
        self.assertEqual(check.CurvatureFirst, 0.0)
        self.assertAlmostEqual(check.CurvatureSecond, 0.05, delta=1e-12)
        self.assertTrue(math.isnan(check.RadiusFirst.Value))
        self.assertAlmostEqual(check.RadiusSecond.Value, 20.0, delta=1e-9)
        self.assertAlmostEqual(check.CurvatureDeviation, 0.05, delta=1e-12)
        self.assertTrue(check.Position.isEqual(V(50, 0, 0), 1e-9))

    def test_units(self):
        check = self.check()
        self.line.Placement.Base.z = 0.5
        self.doc.recompute()
        self.assertEqual(check.Gap.Unit, FreeCAD.Units.Length)
        self.assertAlmostEqual(check.Gap.Value, 0.5, delta=1e-12)
        self.assertEqual(check.TangentAngle.Unit, FreeCAD.Units.Angle)

    def test_what_does_not_exist_is_hidden(self):
        check = self.check()
        self.assertTrue(math.isnan(check.TorsionDeviation))
        self.assertIn("Hidden", check.getEditorMode("TorsionDeviation"))
        self.assertNotIn("Hidden", check.getEditorMode("CurvatureSecond"))

    def test_follows_edits(self):
        check = self.check()
        self.line.Placement.Base.z = 0.5
        self.doc.recompute()
        self.assertEqual((check.Continuity, check.Order), ("gap", -1))

    def test_follows_the_part_around_an_edge(self):
        part = self.doc.addObject("App::Part", "Part")
        part.addObject(self.arc)
        check = make_join_check(self.doc, (self.line, "Edge1"), (part, "Arc.Edge1"))
        self.assertEqual(check.Continuity, "G1")
        part.Placement.Base.z = 3.0
        self.doc.recompute()
        self.assertAlmostEqual(check.Gap.Value, 3.0, delta=1e-9)

    def test_preset_fills_the_tolerances_and_locks_them(self):
        check = self.check(preset="catia-v5")
        self.assertEqual(check.AngleTolerance.Value, 0.01)
        self.assertIn("ReadOnly", check.getEditorMode("AngleTolerance"))
        check.Preset = "custom"
        self.assertEqual(check.getEditorMode("AngleTolerance"), [])
        check.CurvatureTolerance = 1.5
        self.doc.recompute()
        self.assertEqual(check.Continuity, "G2")

    def test_own_values(self):
        values = ToleranceValues(1.0, 1.0, 1.5, 0.1, 0.1)
        self.assertEqual(self.check(preset="custom", values=values).Continuity, "G2")

    def test_unfit_own_value_stands_in_the_status(self):
        check = self.check()
        check.Preset = "custom"
        check.CurvatureTolerance = 0.0
        self.doc.recompute()
        self.assertEqual(check.Continuity, "error")
        self.assertIn("curvature", check.Status)

    def test_given_ends(self):
        check = self.check(ends=("start", "start"))
        self.assertEqual(check.Ends, "start-start")
        self.assertAlmostEqual(check.Gap.Value, 50.0, delta=1e-9)

    def test_order_asked_for(self):
        self.assertEqual(self.check(order=1).Verdicts, ["pass", "pass"])

    def test_closing_join(self):
        circle = self.add("Circle", Part.Circle(V(0, 0, 0), V(0, 0, 1), 5).toShape())
        check = make_join_check(self.doc, (circle, "Edge1"), (circle, "Edge1"))
        self.assertEqual(check.Continuity, "G4")

    def test_inner_knot(self):
        curve = Part.BSplineCurve()
        curve.buildFromPolesMultsKnots([V(0, 0), V(10, 0), V(20, 10), V(30, 10), V(40, 0)],
                                       [3, 2, 3], [0, 1, 2], False, 2)
        spline = self.add("Spline", curve.toShape())
        check = make_join_check(self.doc, (spline, "Edge1"), (spline, "Edge1"), knot=1)
        self.assertEqual(check.Continuity, "G0")
        check.Knot = 2
        self.doc.recompute()
        self.assertIn("no inner knot 2", check.Status)

    def test_deleted_edge_stands_in_the_status(self):
        check = self.check()
        self.doc.removeObject("Arc")
        self.doc.recompute()
        self.assertEqual((check.Continuity, check.Order), ("error", -1))
        self.assertIn("deleted", check.Status)

    def test_vanished_edge_stands_in_the_status(self):
        check = self.check()
        self.arc.Shape = Part.Vertex(0, 0, 0)
        self.doc.recompute()
        self.assertIn("Arc has no Edge1", check.Status)

    def test_face_stands_in_the_status(self):
        box = self.doc.addObject("Part::Box", "Box")
        self.doc.recompute()
        check = make_join_check(self.doc, (self.line, "Edge1"), (box, "Face1"))
        self.assertIn("not an edge but a face", check.Status)

    def test_bad_arguments_change_nothing(self):
        for options in ({"order": 9}, {"knot": -1}, {"preset": "nobody"}, {"preset": "custom"},
                        {"ends": ("end", "middle")},
                        {"preset": "custom", "values": ToleranceValues(0, 1, 1, 1, 1)}):
            with self.subTest(options), self.assertRaises(ValueError):
                self.check(**options)
        self.assertEqual(len(self.doc.Objects), 2)

    def test_saving_and_loading(self):
        check = self.check(preset="class-a", order=3)
        before = self.values(check)
        check = self.save_and_load().JoinCheck
        self.assertEqual(self.values(check), before)
        self.assertNotIn("Touched", check.State)
        self.doc.Line.Placement.Base.z = 1.0
        self.doc.recompute()
        self.assertEqual(check.Continuity, "gap")

    @staticmethod
    def values(check):
        """All properties that files keep exactly; 0.20 rounds numbers, which the report has."""
        return {name: getattr(check, name) for _, group in _GROUPS for name, kind, _ in group
                if not any(word in kind for word in ("Link", "Float", "Distance", "Angle"))}


class JoinsTest(FeatureCase):
    def analyze(self, *links):
        return analyze_links(links, 4, tolerances_of("osculate"))

    def links(self, obj, numbers):
        return [EdgeLink.of(obj, f"Edge{number}") for number in numbers]

    def test_two_edges_are_one_join_even_far_apart(self):
        self.line.Placement.Base.z = 100.0
        (place, report), = self.analyze(*self.links(self.line, [1]), *self.links(self.arc, [1]))
        self.assertEqual(place.label(), "Line.Edge1 – Arc.Edge1")
        self.assertEqual(report.order, -1)

    def test_box_has_three_joins_at_each_vertex(self):
        box = self.doc.addObject("Part::Box", "Box")
        self.doc.recompute()
        joins = self.analyze(*self.links(box, range(1, 13)))
        self.assertEqual(len(joins), 8 * 3)
        for _, report in joins:
            self.assertEqual(report.order, 0)
            self.assertAlmostEqual(report.deviation["tangent_angle_deg"], 90.0, delta=1e-9)

    def test_polygon_is_travelled_from_end_to_start(self):
        points = [V(0, 0), V(10, 0), V(10, 10), V(0, 10), V(0, 0)]
        wire = self.add("Wire", Part.makePolygon(points))
        joins = self.analyze(*self.links(wire, [1, 2, 3, 4]))
        self.assertEqual(len(joins), 4)
        self.assertEqual({report.ends for _, report in joins}, {("end", "start")})

    def test_small_gaps_are_joins_and_large_ones_are_not(self):
        for gap, count in ((0.05, 1), (0.5, 0)):
            shapes = [Part.LineSegment(V(0, 0), V(10, 0)).toShape(),
                      Part.LineSegment(V(10 + gap, 0), V(20, 0)).toShape(),
                      Part.LineSegment(V(0, 50), V(0, 60)).toShape()]
            pieces = self.add("Pieces", Part.makeCompound(shapes))
            self.assertEqual(len(self.analyze(*self.links(pieces, [1, 2, 3]))), count)

    def test_an_end_that_meets_another_is_not_joined_with_a_third_nearby(self):
        shapes = [Part.LineSegment(V(0, 0), V(10, 0)).toShape(),
                  Part.LineSegment(V(10, 0), V(20, 0)).toShape(),
                  Part.LineSegment(V(0, 0.05), V(10, 0.05)).toShape(),
                  Part.LineSegment(V(10, 0.05), V(20, 0.05)).toShape()]
        pieces = self.add("Pieces", Part.makeCompound(shapes))
        labels = {place.label() for place, _ in self.analyze(*self.links(pieces, [1, 2, 3, 4]))}
        self.assertIn("Pieces.Edge1 – Edge2", labels)
        self.assertNotIn("Pieces.Edge1 – Edge4", labels)

    def test_missing_object_is_named(self):
        with self.assertRaisesRegex(LinkError, "Nobody no longer exists"):
            EdgeLink(self.doc.Name, "Nobody", "Edge1").resolve()
