"""Check contact and Check validity."""

import FreeCAD
import FreeCADGui

from osculate import solids
from osculate.gui.qt import QtWidgets
from solid_case import SolidCase


class ContactTest(SolidCase):
    command = "Osculate_CheckContact"

    def pair(self, order=1):
        value = solids.random(3, 2)
        return self.solid(value), self.solid(value.join((-0.8, 0.6, 0.6, 0.6), order))

    @property
    def obj(self):
        return self.doc.getObject("SolidContact")

    def test_found_kept_and_undone(self):
        form = self.run_on_objects(*self.pair())
        self.assertIn("<b>C1</b>", form.label.text())
        self.assertEqual(form.label.text().count("✗"), 2)
        self.fit()
        self.screenshot("solid_contact")
        self.finish("Ok")
        self.assertEqual(self.obj.Contact, "C1")
        self.doc.undo()
        self.assertIsNone(self.obj)
        self.assertEqual(len(self.doc.Objects), 2)

    def test_tolerance(self):
        first, second = self.pair()
        second.Points = [point + point.__class__(0.25, 0, 0) for point in second.Points]
        self.doc.recompute()
        form = self.run_on_objects(first, second)
        self.assertIn("No faces meet", form.label.text())
        self.type_number(form.tolerance.box, "0.5")
        self.assertIn("<b>C", form.label.text())
        self.assertEqual(self.obj.Tolerance.Value, 0.5)
        self.finish("Cancel")
        self.assertEqual(self.doc.Objects, [first, second])

    def test_edited(self):
        self.run_on_objects(*self.pair(2))
        self.finish("Ok")
        self.obj.ViewObject.doubleClicked()
        form = self.shown_form()
        self.assertIn("<b>C2</b>", form.label.text())
        self.type_number(form.tolerance.box, "100")
        self.assertEqual(self.obj.Contact, "C3")
        self.darken()
        self.screenshot("solid_contact_dark")
        self.finish("Cancel")
        self.assertEqual((self.obj.Contact, self.obj.Tolerance.Value), ("C2", 1e-7))

    def test_follows_while_the_panel_is_open(self):
        first, second = self.pair()
        form = self.run_on_objects(first, second)
        second.Points = [point + point.__class__(5, 0, 0) for point in second.Points]
        self.doc.recompute()
        self.pump()
        self.assertIn("No faces meet", form.label.text())

    def test_needs_two(self):
        first, _second = self.pair()
        self.select((first, ""))
        self.assertFalse(self.is_active(self.command))


class ValidityTest(SolidCase):
    command = "Osculate_CheckValidity"

    def close(self):
        self.press("Close")
        self.wait_for(lambda: self.form() is None, "the panel to close")

    def test_valid_singular_and_folded(self):
        folded = self.solid(solids.tetrahedron((0, 0, 0), (50, 0, 0), (0, 50, 0),
                                               (0, 0, 50)).elevated())
        points = folded.Points
        points[1].x = -90
        folded.Points = points
        valid, singular = self.solid(solids.random(3, 2)), self.solid(solids.cone(25, 50))
        self.doc.recompute()
        form = self.run_on_objects(valid, singular, folded)
        text = form.label.text()
        self.assertIn("valid", text)
        self.assertIn("edge 0–3, edge 1–3, edge 2–3", text)
        self.assertIn("folds over itself", text)
        self.assertIn("in space at", text)
        self.fit()
        self.screenshot("solid_validity")
        self.assertTrue(self.has_overlay())
        self.close()
        self.assertFalse(self.has_overlay())

    def has_overlay(self):
        from pivy import coin
        scene = self.view().getSceneGraph()
        return any(scene.getChild(number).getName().getString() == "OsculateOverlay"
                   and isinstance(scene.getChild(number), coin.SoSeparator)
                   for number in range(scene.getNumChildren()))

    def test_high_degree_is_kept_in_the_object(self):
        obj = self.solid(solids.random(3, 2).elevated(3))
        self.assertEqual(obj.Validity, "")
        self.run_on_objects(obj)
        self.close()
        self.assertEqual(obj.Validity, "valid")
        self.doc.undo()
        self.assertEqual(obj.Validity, "")

    def test_follows_the_points(self):
        obj = self.solid(solids.tetrahedron((0, 0, 0), (50, 0, 0), (0, 50, 0), (0, 0, 50)))
        form = self.run_on_objects(obj)
        points = obj.Points
        points[3].z = -50
        obj.Points = points
        self.doc.recompute()
        self.pump()
        self.assertIn("mirror image", form.label.text())
        self.doc.removeObject(obj.Name)
        self.pump()
        self.assertEqual(form.label.text(), "")

    def test_closing_the_document_closes_the_panel(self):
        self.run_on_objects(self.solid())
        FreeCAD.closeDocument(self.doc.Name)
        self.wait_for(lambda: not FreeCADGui.Control.activeDialog(), "the panel to close")

    def test_four_dimensions_are_said(self):
        form = self.run_on_objects(self.solid(solids.random(2, 2, 4)))
        self.assertIn("E4", form.label.text())
        boxes = FreeCADGui.getMainWindow().findChildren(QtWidgets.QDialogButtonBox)
        self.assertFalse(any(box.button(box.StandardButton.Ok) for box in boxes if box.isVisible()))
