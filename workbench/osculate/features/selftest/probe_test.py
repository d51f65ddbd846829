"""Tests of the document object Probe."""

import math

import FreeCAD
import Part

from osculate.features import make_probe
from osculate.features.probe import PARTS, Probe
from osculate.features.selftest.feature_case import FeatureCase

V = FreeCAD.Vector


class ProbeTest(FeatureCase):
    """The line and the arc of radius 20 that touches it, 50 and 10 π mm long."""

    def probe(self, *sources, **options):
        return make_probe(self.doc, sources or (self.line, self.arc), **options)

    def assertNear(self, vector, expected, delta=1e-9):
        for value, other in zip(vector, expected):
            self.assertAlmostEqual(value, other, delta=delta)

    def test_says_what_there_is_on_an_arc(self):
        obj = self.probe(self.arc, position=0.5)
        self.assertEqual((obj.Status, obj.EdgeCount, obj.Missing, obj.At), ("OK", 1, [], []))
        root = 0.5 ** 0.5
        self.assertNear(obj.Point, (50 + 20 * root, 20 - 20 * root, 0))
        self.assertNear(obj.Tangent, (root, root, 0))
        self.assertNear(obj.Normal, (-root, root, 0))
        self.assertNear(obj.Binormal, (0, 0, 1))
        self.assertAlmostEqual(obj.Radius.Value, 20.0, delta=1e-9)
        self.assertAlmostEqual(obj.Curvature, 0.05, delta=1e-12)
        self.assertAlmostEqual(obj.Torsion, 0.0, delta=1e-12)
        self.assertAlmostEqual(obj.ArcLength.Value, 5.0 * math.pi, delta=1e-9)

    def test_what_does_not_exist_is_named(self):
        obj = self.probe(self.line, position=0.2)
        self.assertEqual(obj.Missing, ["Normal", "Binormal", "Radius", "Torsion"])
        self.assertNear(obj.Tangent, (1, 0, 0))
        self.assertEqual((obj.Normal, obj.Radius.Value), (V(), 0.0))
        self.assertIsNone(obj.Proxy.result.geometry.torsion)
        self.assertNear(obj.Point, (10, 0, 0))

    def test_runs_through_a_chain_of_edges(self):
        obj = self.probe()
        self.assertAlmostEqual(obj.TotalLength.Value, 50.0 + 10.0 * math.pi, delta=1e-9)
        obj.Position = 50.0 / obj.TotalLength.Value
        self.doc.recompute()
        self.assertEqual((obj.At, obj.Edge), (["join"], 2))
        before, after = obj.Proxy.result.sides
        self.assertEqual(before.geometry.curvature, 0.0)
        self.assertAlmostEqual(after.geometry.curvature, 0.05, delta=1e-12)

    def test_follows_edits_at_its_share_of_the_length(self):
        obj = self.probe(self.line, position=0.25)
        self.line.Shape = Part.LineSegment(V(0, 0, 0), V(0, 80, 0)).toShape()
        self.assertTrue(obj.Proxy.follow(obj))  # and no recompute
        self.assertFalse(obj.Proxy.follow(obj))
        self.doc.recompute()
        self.assertNear(obj.Point, (0, 20, 0))

    def test_placement_of_a_part_around_counts(self):
        part = self.doc.addObject("App::Part", "Part")
        part.addObject(self.line)
        part.Placement.Base = V(0, 0, 7)
        self.doc.recompute()
        self.assertNear(self.probe((part, "Line.Edge1"), position=0.0).Point, (0, 0, 7))

    def test_position_stays_within_the_edges(self):
        obj = self.probe(self.line)
        obj.Position = 3.0
        self.doc.recompute()
        self.assertEqual((obj.Position, obj.At), (1.0, ["end"]))
        self.assertNear(obj.Point, (50, 0, 0))

    def test_parts_are_chosen_and_ask_for_no_recompute(self):
        obj = self.probe(parts=["circle", "de Casteljau"])
        shown = {part for part, name in PARTS.items() if getattr(obj, name)}
        self.assertEqual(shown, {"circle", "de Casteljau"})
        obj.Frame = obj.OsculatingPlane = True
        self.assertNotIn("Touched", obj.State)
        obj.Position = 0.3
        self.assertIn("Touched", obj.State)

    def test_deleted_edges(self):
        obj = self.probe()
        self.doc.removeObject(self.arc.Name)
        self.doc.recompute()
        self.assertEqual((obj.Status, obj.EdgeCount), ("OK", 1))
        self.doc.removeObject(self.line.Name)
        obj.touch()
        self.doc.recompute()
        self.assertIn("No edge is linked", obj.Status)
        self.assertFalse(obj.isValid())

    def test_wrong_options_leave_the_document_alone(self):
        for options, words in (({"position": 1.2}, "position: must be from 0 to 1"),
                               ({"parts": ["circles"]}, "parts: 'circles' is none of frame")):
            with self.subTest(options), self.assertRaisesRegex(ValueError, words):
                self.probe(**options)
        self.assertEqual(len(self.doc.Objects), 2)

    def test_survives_saving_and_loading(self):
        self.probe(self.arc, position=0.25, parts=["frame"])
        doc = self.save_and_load()
        loaded = doc.Probe
        self.assertIsInstance(loaded.Proxy, Probe)
        self.assertNotIn("Touched", loaded.State)
        self.assertEqual((loaded.Position, loaded.Frame, loaded.Circle), (0.25, True, False))
        self.assertAlmostEqual(loaded.Radius.Value, 20.0, delta=1e-9)
