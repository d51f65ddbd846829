"""Tests of the document object SolidBRep."""

import math
import os
import tempfile

import FreeCAD
import Part

from osculate import solids
from osculate.features import make_solid_brep
from osculate.features.selftest.solid_case import SolidCase
from osculate.features.solid_brep import SolidBRep

V = FreeCAD.Vector


class SolidBRepTest(SolidCase):
    def assert_follows(self, obj):
        solid = obj.Source
        volume = solid.Volume.Value
        self.set_row(solid, "Points", 9, V(0, 0, 40))
        self.assertGreater(solid.Volume.Value, 1.05 * volume)
        self.assertAlmostEqual(obj.Shape.Volume / solid.Volume.Value, 1.0, delta=1e-5)

    def test_is_exact_and_whole(self):
        obj = make_solid_brep(self.doc, self.solid(solids.ball_octant(10)))
        self.assertEqual((obj.Status, obj.Shape.ShapeType), ("OK", "Solid"))
        self.assertTrue(obj.Shape.isValid())
        self.assertAlmostEqual(obj.Shape.Volume / (math.pi / 6 * 1000), 1.0, delta=1e-6)

    def test_follows_the_solid(self):
        solid = self.solid(solids.cone(10, 20))
        obj = make_solid_brep(self.doc, solid)
        self.assert_follows(obj)

    def test_booleans_and_step(self):
        obj = make_solid_brep(self.doc, self.solid(solids.ball_octant(10)))
        box = self.doc.addObject("Part::Box", "Box")
        cut = self.doc.addObject("Part::Cut", "Cut")
        cut.Base, cut.Tool = obj, box
        box.Length = box.Width = box.Height = 5
        self.doc.recompute()
        self.assertTrue(cut.Shape.isValid())
        self.assertAlmostEqual(cut.Shape.Volume, math.pi / 6 * 1000 - 125, delta=1e-2)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "octant.step")
            obj.Shape.exportStep(path)
            self.assertAlmostEqual(Part.read(path).Volume / obj.Shape.Volume, 1.0, delta=1e-6)

    def test_what_bounds_no_solid_is_said(self):
        flat = self.solid(((0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0)))
        space = self.solid(solids.random(2, 1, dimension=4))
        for source in (flat, space):
            obj = make_solid_brep(self.doc, source)
            self.assertNotEqual(obj.Status, "OK")
            self.assertFalse(obj.isValid())
            self.assertTrue(obj.Shape.isNull())

    def test_folding_is_said(self):
        solid = self.solid(solids.tetrahedron((0, 0, 0), (10, 0, 0), (0, 10, 0),
                                              (0, 0, 10)).elevated())
        obj = make_solid_brep(self.doc, solid)
        self.assertEqual((obj.Status, obj.Warnings), ("OK", []))
        self.set_row(solid, "Points", 1, V(-2, 0, 0))
        self.assertEqual(obj.Status, "OK")
        self.assertIn("folds over itself", obj.Warnings[0])

    def test_keeps_the_last_good_shape(self):
        solid = self.solid(solids.cone(10, 20))
        obj = make_solid_brep(self.doc, solid)
        volume = obj.Shape.Volume
        self.set_row(solid, "Weights", 0, -1.0)
        obj.touch()
        self.doc.recompute()
        self.assertEqual(obj.Shape.Volume, volume)
        self.set_row(solid, "Weights", 0, 1.0)
        self.assertEqual(obj.Status, "OK")

    def test_other_sources_are_refused(self):
        box = self.doc.addObject("Part::Box", "Box")
        for source in (box, None):
            with self.assertRaisesRegex(ValueError, "source"):
                make_solid_brep(self.doc, source)
        self.assertEqual(self.doc.Objects, [box])
        obj = make_solid_brep(self.doc, self.solid(solids.cone(10, 20)))
        obj.Source = box
        self.doc.recompute()
        self.assertIn("Box is no Bézier solid", obj.Status)
        obj.Source = None
        self.doc.recompute()
        self.assertIn("No Bézier solid", obj.Status)

    def test_inside_parts(self):
        solid = self.solid(solids.tetrahedron((0, 0, 0), (10, 0, 0), (0, 10, 0), (0, 0, 10)))
        self.part_at(100, 90, solid)
        obj = make_solid_brep(self.doc, solid)
        self.assertTrue(obj.Shape.CenterOfMass.isEqual(V(97.5, 2.5, 2.5), 1e-6))
        self.part_at(-7, 30, obj)
        obj.touch()
        self.doc.recompute()
        shape = Part.getShape(obj.getParentGeoFeatureGroup(), obj.Name + ".")
        self.assertTrue(shape.CenterOfMass.isEqual(V(97.5, 2.5, 2.5), 1e-6))

    def test_saving_and_loading(self):
        solid = self.solid(solids.cone(10, 20))
        name = make_solid_brep(self.doc, solid).Name
        doc = self.save_and_load()
        obj = doc.getObject(name)
        self.assertIsInstance(obj.Proxy, SolidBRep)
        self.assert_follows(obj)
