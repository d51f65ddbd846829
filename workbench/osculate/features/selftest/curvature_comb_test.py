"""Tests of the document object CurvatureComb."""

import FreeCAD
import Part

from osculate.comb_drawing import LIMIT
from osculate.features import make_curvature_comb
from osculate.features.curvature_comb import CurvatureComb, scale_of
from osculate.features.edge_overlay import links_of
from osculate.features.selftest.feature_case import FeatureCase

V = FreeCAD.Vector


class CurvatureCombTest(FeatureCase):
    """The line and the arc of radius 20 that touches it."""

    def comb(self, *sources, **options):
        return make_curvature_comb(self.doc, sources or (self.line, self.arc), **options)

    def test_says_what_the_curves_are(self):
        obj = self.comb()
        self.assertEqual((obj.Status, obj.EdgeCount, obj.Warnings), ("OK", 2, []))
        self.assertAlmostEqual(obj.LargestCurvature, 0.05, delta=1e-12)
        self.assertAlmostEqual(obj.SmallestRadius.Value, 20.0, delta=1e-9)
        self.assertAlmostEqual(obj.LargestTorsion, 0.0, delta=1e-10)
        self.assertAlmostEqual(obj.Length.Value, 50.0 + 31.41592653589793, delta=1e-8)
        self.assertEqual((obj.Inflections, obj.Vertices, obj.Cusps), (0, 0, 0))

    def test_marks_of_an_ellipse_are_its_axes(self):
        ellipse = self.add("Ellipse", Part.Ellipse(V(), 30, 10).toShape())
        obj = self.comb((ellipse, "Edge1"))
        self.assertEqual((obj.Vertices, obj.Inflections), (4, 0))
        self.assertAlmostEqual(obj.LargestCurvature, 30 / 10 ** 2, delta=1e-10)

    def test_takes_faces_and_whole_objects(self):
        box = self.add("Box", Part.makeCylinder(5, 10))
        self.assertEqual(self.comb(box).EdgeCount, 3)
        top = next(number for number, face in enumerate(box.Shape.Faces, 1)
                   if len(face.Edges) == 1)
        obj = self.comb((box, f"Face{top}"), self.arc)
        self.assertEqual(obj.EdgeCount, 2)
        self.assertEqual([link.sub for link in links_of(obj)], [f"Face{top}", ""])

    def test_placement_of_a_part_around_counts(self):
        part = self.doc.addObject("App::Part", "Part")
        part.addObject(self.arc)
        part.Placement.Base = V(0, 0, 7)
        self.doc.recompute()
        obj = self.comb((part, "Arc.Edge1"))
        self.assertEqual(obj.Status, "OK")
        for point in obj.Proxy.result.point:
            self.assertAlmostEqual(point[2], 7.0, delta=1e-12)

    def test_follows_edits(self):
        obj = self.comb(self.arc)
        scale = scale_of(obj)
        self.arc.Shape = Part.Circle(V(), V(0, 0, 1), 200).toShape()
        self.doc.recompute()
        self.assertAlmostEqual(obj.SmallestRadius.Value, 200.0, delta=1e-8)
        self.assertGreater(scale_of(obj), 10.0 * scale)

    def test_follow_knows_whether_the_comb_changed(self):
        obj = self.comb(self.arc)
        self.assertFalse(obj.Proxy.follow(obj))
        self.line.Placement.Base.z = 1.0
        self.assertFalse(obj.Proxy.follow(obj))
        self.arc.Placement.Base.z = 1.0  # and no recompute
        self.assertTrue(obj.Proxy.follow(obj))
        self.assertAlmostEqual(obj.Proxy.result.point[0, 2], 1.0, delta=1e-12)

    def test_other_quantities(self):
        obj = self.comb(quantity="torsion")
        self.assertIsNone(scale_of(obj))  # of plane curves
        helix = self.add("Helix", Part.makeHelix(10, 30, 8))
        obj = self.comb(helix, quantity="torsion", density=12)
        pitch = 10 / 6.283185307179586
        self.assertAlmostEqual(obj.LargestTorsion, pitch / (64 + pitch ** 2), delta=1e-4)
        self.assertIsNotNone(scale_of(obj))

    def test_scale_is_automatic_times_a_factor_or_given(self):
        obj = self.comb()
        scale = scale_of(obj)
        size = 86.0  # the diagonal of the box around both
        self.assertLess(0.05 * scale, LIMIT * size)
        obj.Factor = -2.0
        self.assertEqual(scale_of(obj), -2.0 * scale)
        obj.AutoScale, obj.Scale = False, 123.0
        self.assertEqual(scale_of(obj), 123.0)

    def test_look_asks_for_no_recompute(self):
        obj = self.comb()
        obj.Factor, obj.Marks = 3.0, False
        self.assertNotIn("Touched", obj.State)
        obj.Density = 40
        self.assertIn("Touched", obj.State)

    def test_deleted_edges(self):
        obj = self.comb()
        self.doc.removeObject(self.line.Name)
        self.doc.recompute()
        self.assertEqual((obj.Status, obj.EdgeCount), ("OK", 1))
        self.doc.removeObject(self.arc.Name)
        obj.touch()
        self.doc.recompute()
        self.assertIn("No edge is linked", obj.Status)
        self.assertFalse(obj.isValid())
        self.assertIsNone(scale_of(obj))

    def test_an_edge_that_is_gone_is_told_and_the_others_stay(self):
        wire = self.add("Wire", Part.makePolygon([V(), V(10, 0), V(10, 10), V(0, 20)]))
        obj = self.comb((wire, "Edge3"), self.arc)
        wire.Shape = Part.makePolygon([V(), V(10, 0), V(10, 10)])
        self.doc.recompute()
        self.assertEqual((obj.Status, obj.EdgeCount), ("OK", 1))
        self.assertIn("Wire has no", obj.Warnings[0])

    def test_wrong_options_leave_the_document_alone(self):
        for options in ({"quantity": "speed"}, {"density": 1}, {"density": 5000}):
            with self.subTest(options), self.assertRaises(ValueError):
                self.comb(**options)
        self.assertEqual(len(self.doc.Objects), 2)

    def test_survives_saving_and_loading(self):
        obj = self.comb(self.arc, quantity="curvature_rate", density=33)
        obj.Factor = 1.5
        doc = self.save_and_load()
        loaded = doc.CurvatureComb
        self.assertIsInstance(loaded.Proxy, CurvatureComb)
        self.assertNotIn("Touched", loaded.State)
        self.assertEqual((loaded.Quantity, loaded.Density, loaded.Factor),
                         ("curvature_rate", 33, 1.5))
        doc.Arc.Placement.Base.z = 2.0
        doc.recompute()
        self.assertAlmostEqual(loaded.Proxy.result.point[0, 2], 2.0, delta=1e-12)
