"""Tests of the document object BezierSolid."""

import math

import FreeCAD

from osculate import solids
from osculate.features import make_bezier_solid
from osculate.features.bezier_solid import (
    CHECKED_DEGREE, BezierSolid, check_validity, value_in_document)
from osculate.features.selftest.solid_case import SolidCase

V = FreeCAD.Vector
CORNERS = ((0, 0, 0), (10, 0, 0), (0, 20, 0), (0, 0, 30))


class BezierSolidTest(SolidCase):
    def test_keeps_the_net_to_the_bit(self):
        value = solids.random(3, 5)
        obj = self.solid(value)
        self.assertEqual(obj.Status, "OK")
        self.assertEqual(obj.Proxy.value, value)
        self.assertEqual((obj.Degree, len(obj.Points)), (3, 20))
        self.assertEqual(list(obj.Weights), value.weights.tolist())

    def test_measures(self):
        obj = self.solid(CORNERS)
        self.assertAlmostEqual(obj.Volume.Value, 1000.0, delta=1e-9)
        self.assertEqual(obj.Volume.Unit, FreeCAD.Units.Volume)
        self.assertTrue(obj.Centroid.isEqual(V(2.5, 5, 7.5), 1e-12))
        self.assertEqual((obj.Validity, obj.Warnings, obj.Weights), ("valid", [], []))

    def test_mirror_image_has_a_volume_and_a_warning(self):
        obj = self.solid((*CORNERS[:2], CORNERS[3], CORNERS[2]))
        self.assertAlmostEqual(obj.Volume.Value, 1000.0, delta=1e-9)
        self.assertIn("mirror image", obj.Warnings[0])
        self.assertIn("inverted", obj.Validity)

    def test_follows_its_points(self):
        obj = self.solid(CORNERS)
        self.set_row(obj, "Points", 3, V(0, 0, 60))
        self.assertAlmostEqual(obj.Volume.Value, 2000.0, delta=1e-9)
        obj.Weights = [1.0, 2.0, 1.0, 1.0]
        self.doc.recompute()
        self.assertTrue(obj.Proxy.value.is_rational)

    def test_folding_shows(self):
        obj = self.solid(solids.tetrahedron(*CORNERS).elevated())
        self.assertEqual(obj.Validity, "valid")
        self.set_row(obj, "Points", 1, V(-30, 0, 0))
        self.assertIn("inverted at", obj.Validity)
        self.assertEqual(obj.Proxy.validity.verdict, "inverted")

    def test_high_degrees_are_checked_on_demand(self):
        obj = self.solid(solids.tetrahedron(*CORNERS).elevated(CHECKED_DEGREE))
        self.assertEqual((obj.Validity, obj.Proxy.validity), ("", None))
        self.assertEqual(check_validity(obj).verdict, "valid")
        self.assertEqual(obj.Validity, "valid")
        self.set_row(obj, "Points", 0, V(-1, 0, 0))
        self.assertEqual(obj.Validity, "")

    def test_wrong_numbers_are_named(self):
        for name, row, number, words in (
                ("Points", 1, V(math.nan, 0, 0), "x of point 1 1 0 0 must be a finite number"),
                ("Points", 2, V(0, 0, math.inf), "z of point 1 0 1 0 must be"),
                ("Weights", 9, -1.0, "weight of point 0 0 0 2 must be 0 or more, not -1"),
                ("Weights", 0, math.nan, "weight of point 2 0 0 0 must be 0 or more")):
            with self.subTest(name=name, number=number):
                obj = self.solid(solids.cone(10, 20))
                good = list(getattr(obj, name))[row]
                volume = obj.Volume.Value
                self.set_row(obj, name, row, number)
                self.assertIn(words, obj.Status)
                self.assertFalse(obj.isValid())
                self.assertIsNone(obj.Proxy.value)
                self.assertEqual(obj.Volume.Value, volume)
                self.set_row(obj, name, row, good)
                self.assertEqual((obj.Status, obj.isValid()), ("OK", True))

    def test_wrong_counts_and_weights_are_named(self):
        obj = self.solid(CORNERS)
        for name, numbers, words in (
                ("Points", [V(*corner) for corner in CORNERS[:3]], "3 points are no net"),
                ("Weights", [1.0, 2.0], "weight: 2 numbers for 4 points"),
                ("Weights", [0.0] * 4, "All weights are 0"),
                ("FourthCoordinates", [1.0], "fourth: 1 numbers for 4 points")):
            with self.subTest(words):
                before = list(getattr(obj, name))
                setattr(obj, name, numbers)
                self.doc.recompute()
                self.assertIn(words, obj.Status)
                setattr(obj, name, before)
                self.doc.recompute()
                self.assertEqual(obj.Status, "OK")

    def test_bad_arguments_change_nothing(self):
        for points, weights in ((CORNERS[:3], None), (CORNERS, (1, 1, 1)), (CORNERS, (0, 0, 0, 0)),
                                (CORNERS, (1, 1, 1, -1)), (((0, 0),) * 4, None),
                                (((0, 0, math.nan), *CORNERS[1:]), None),
                                (solids.cone(1, 1), (1,) * 10)):
            with self.subTest(points=points), self.assertRaises(ValueError):
                make_bezier_solid(self.doc, points, weights)
        self.assertEqual(self.doc.Objects, [])

    def test_flat_nets_are_legal(self):
        obj = self.solid(((0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0)))
        self.assertEqual((obj.Status, obj.Volume.Value), ("OK", 0.0))
        self.assertIn("flat", obj.Warnings[0])

    def test_four_dimensions(self):
        value = solids.random(2, 3, dimension=4)
        obj = self.solid(value)
        self.assertEqual(obj.Status, "OK")
        self.assertEqual(obj.Proxy.value, value)
        self.assertEqual(len(obj.FourthCoordinates), 10)
        self.assertTrue(math.isnan(obj.Volume.Value))
        self.assertEqual(obj.Validity, "")
        with self.assertRaisesRegex(ValueError, "project"):
            check_validity(obj)

    def test_saving_and_loading(self):
        values = [solids.random(3, 5), solids.random(2, 3, dimension=4), solids.cone(10, 20)]
        names = [self.solid(value).Name for value in values]
        validity = self.doc.Objects[2].Validity
        doc = self.save_and_load()
        for name, value in zip(names, values):
            obj = doc.getObject(name)
            self.assertIsInstance(obj.Proxy, BezierSolid)
            self.assertEqual(obj.Proxy.value, value)  # before any recompute
            self.assertNotIn("Touched", obj.State)
        self.assertEqual(doc.Objects[2].Validity, validity)

    def test_copy(self):
        obj = self.solid(solids.ball_octant(10))
        copy = self.doc.copyObject(obj)
        self.doc.recompute()
        self.assertIsInstance(copy.Proxy, BezierSolid)
        self.assertEqual(copy.Proxy.value, obj.Proxy.value)
        self.set_row(copy, "Points", 0, V(20, 0, 0))
        self.assertNotEqual(copy.Proxy.value, obj.Proxy.value)
        self.assertAlmostEqual(obj.Volume.Value, math.pi / 6 * 1000, delta=1e-8)

    def test_undo(self):
        self.doc.UndoMode = 1
        obj = self.solid(CORNERS)
        self.doc.openTransaction("Move")
        self.set_row(obj, "Points", 3, V(0, 0, 60))
        self.doc.commitTransaction()
        self.doc.undo()
        self.assertAlmostEqual(obj.Volume.Value, 1000.0, delta=1e-9)
        self.assertEqual(value_in_document(obj).points[3].tolist(), [0, 0, 30])

    def test_inside_a_part(self):
        obj = self.solid(CORNERS)
        self.part_at(100, 90, obj)
        points = value_in_document(obj).points
        self.assertLess(abs(points - [[100, 0, 0], [100, 10, 0], [80, 0, 0], [100, 0, 30]]).max(),
                        1e-12)
