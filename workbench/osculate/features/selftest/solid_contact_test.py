"""Tests of the document object SolidContact."""

import math

import FreeCAD

from osculate import solids
from osculate.features import make_solid_contact
from osculate.features.control_net import indices_of
from osculate.features.selftest.solid_case import SolidCase
from osculate.features.solid_contact import SolidContact

V = FreeCAD.Vector


class SolidContactTest(SolidCase):
    def pair(self, order=2):
        value = solids.random(3, 1)
        return self.solid(value), self.solid(value.join((-0.4, 0.5, 0.4, 0.5), order))

    def test_finds_the_order(self):
        for order in (0, 1, 2, 3):
            obj = make_solid_contact(self.doc, *self.pair(order))
            self.assertEqual((obj.Status, obj.Contact, obj.Order), ("OK", f"C{order}", order))
            self.assertEqual((obj.HomogeneousOrder, obj.Faces), (order, [0, 0]))
            self.assertEqual(len(obj.Residuals), 4)
            self.assertLess(max(obj.Residuals[:order + 1]), 1e-9)
            self.assertFalse(obj.Overlaps)

    def test_follows_both_solids(self):
        first, second = self.pair()
        obj = make_solid_contact(self.doc, first, second)
        for solid, layer, contact in ((second, 2, "C1"), (first, 1, "C0"), (second, 0, "none")):
            row = next(row for row, index in enumerate(indices_of(3)) if index[0] == layer)
            self.set_row(solid, "Points", row, solid.Points[row] + V(0, 0, 5))
            self.assertEqual(obj.Contact, contact)
        self.assertAlmostEqual(obj.Gap.Value, 5.0, delta=1.0)

    def test_faces_apart(self):
        first, second = self.pair()
        second.Points = [point + V(0.5, 0, 0) for point in second.Points]
        obj = make_solid_contact(self.doc, first, second)
        self.assertEqual((obj.Status, obj.Contact, obj.Order), ("OK", "none", -1))
        self.assertAlmostEqual(obj.Gap.Value, 0.5, delta=1e-9)
        obj.Tolerance = 1.0
        self.doc.recompute()
        self.assertGreaterEqual(obj.Order, 0)

    def test_parts_are_moved(self):
        first, second = self.pair()
        self.part_at(10, 20, first)
        obj = make_solid_contact(self.doc, first, second)
        self.assertEqual(obj.Contact, "none")
        self.part_at(10, 20, second)
        obj.touch()
        self.doc.recompute()
        self.assertEqual(obj.Contact, "C2")

    def test_what_is_missing_is_said(self):
        first, second = self.pair()
        obj = make_solid_contact(self.doc, first, second)
        obj.Second = first
        self.doc.recompute()
        self.assertIn("two different solids", obj.Status)
        self.assertIsNone(obj.Proxy.report)
        self.doc.removeObject(first.Name)
        self.doc.recompute()
        self.assertIn("No Bézier solid is linked", obj.Status)

    def test_bad_arguments_change_nothing(self):
        first, second = self.pair()
        for arguments in ((first, first), (first, None)):
            with self.assertRaises(ValueError):
                make_solid_contact(self.doc, *arguments)
        for tolerance in (0.0, -1.0, math.nan, math.inf):
            with self.assertRaises(ValueError):
                make_solid_contact(self.doc, first, second, tolerance_mm=tolerance)
        self.assertEqual(self.doc.Objects, [first, second])

    def test_saving_and_loading(self):
        name = make_solid_contact(self.doc, *self.pair()).Name
        obj = self.save_and_load().getObject(name)
        self.assertIsInstance(obj.Proxy, SolidContact)
        self.assertEqual((obj.Contact, obj.Proxy.report.order), ("C2", 2))
        self.assertNotIn("Touched", obj.State)
