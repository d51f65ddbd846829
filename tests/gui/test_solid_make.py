"""The command Bézier solid: kinds, parameters, OK and Cancel."""

import math

import FreeCAD
import FreeCADGui

from osculate import solids
from osculate.features.bezier_solid import is_solid
from solid_case import SolidCase


class MakeSolidTest(SolidCase):
    command = "Osculate_BezierSolid"

    def made(self):
        return [obj for obj in self.doc.Objects if is_solid(obj)]

    def choose_kind(self, form, name):
        self.choose(form.kind_box, name)
        self.assertEqual(form.kind.name, name)

    def test_every_kind_is_made_at_once(self):
        form = self.run_on()
        for kind in form.kinds:
            self.choose_kind(form, kind.name)
            self.assertEqual(form.trouble.text(), "", kind.name)
            made = self.made()
            self.assertTrue(made, kind.name)
            self.assertTrue(made[0].Label.startswith(kind.title), kind.name)
            self.assertTrue(all(obj.Status == "OK" for obj in made), kind.name)
            self.assertLessEqual(form.minimumSizeHint().width(), 340, kind.name)
        self.assertEqual(len(self.made()), 1)  # those of other kinds went

    def test_parameters_are_followed(self):
        form = self.run_on()
        self.choose_kind(form, "cone")
        self.type_number(form.page["radius"].box, "10")
        self.type_number(form.page["height"].box, "30")
        self.assertEqual(self.made()[0].Proxy.value, solids.cone(10, 30))
        self.fit()
        self.screenshot("solid_cone")
        self.finish("Ok")
        self.assertEqual(len(self.doc.Objects), 1)
        self.assertAlmostEqual(self.doc.Objects[0].Volume.Value, math.pi * 1000, delta=1e-8)
        self.doc.undo()
        self.assertEqual(self.doc.Objects, [])
        self.doc.redo()
        self.assertEqual(self.doc.Objects[0].Proxy.value, solids.cone(10, 30))

    def test_several_solids_are_a_group(self):
        form = self.run_on()
        self.choose_kind(form, "cylinder-wedge")
        self.assertEqual(len(self.made()), 3)
        self.type_number(form.page["angle"].box, "360")
        self.assertEqual(len(self.made()), 12)
        group = self.doc.getObject("BezierSolids")
        self.assertEqual(group.Group, self.made())
        self.assertIn("12", form.facts.text())
        self.type_number(form.page["angle"].box, "80")
        self.assertEqual((len(self.made()), group.Group), (3, self.made()))
        self.choose_kind(form, "ball-octant")
        self.assertEqual([obj.Name for obj in self.doc.Objects], [self.made()[0].Name])
        self.finish("Cancel")
        self.assertEqual(self.doc.Objects, [])

    def test_what_cannot_be_is_said_and_not_kept(self):
        form = self.run_on()
        self.choose_kind(form, "cone")
        self.type_number(form.page["radius"].box, "0")
        self.assertIn("radius", form.trouble.text())
        self.press("Ok")
        self.assertIsNotNone(self.form())
        self.assertTrue(form.advice.isVisible())
        self.type_number(form.page["radius"].box, "5")
        self.assertEqual((form.trouble.text(), form.advice.text()), ("", ""))
        self.finish("Ok")
        self.assertEqual(self.made()[0].Proxy.value, solids.cone(5, 50))

    def test_wedge_lies_on_its_sphere(self):
        form = self.run_on()
        self.choose_kind(form, "sphere-wedge")
        self.type_number(form.page["radius"].box, "40")
        self.assertEqual(form.trouble.text(), "")
        value = self.made()[0].Proxy.value
        place = value.evaluate([0.2, 0.5, 0.3, 0.0])
        self.assertAlmostEqual(math.hypot(*place), 40.0, delta=1e-9)
        self.darken()
        self.fit()
        self.screenshot("solid_wedge_dark")
        for box in form.page["a"].row.boxes:
            self.type_number(box, "0")
        self.assertIn("direction", form.trouble.text())

    def test_four_dimensions(self):
        form = self.run_on()
        self.choose_kind(form, "random")
        self.choose(form.page["dimension"].box, 4)
        self.assertEqual(self.made()[0].Proxy.value, solids.random(3, 1, 4))
        self.assertIn("four dimensions", form.facts.text())

    def test_cancel_leaves_the_document_as_it_was(self):
        self.solid()
        before = self.as_it_was()
        form = self.run_on()
        self.choose_kind(form, "frustum-wedge")
        self.finish("Cancel")
        self.assertEqual(self.as_it_was(), before)
        self.assertEqual(self.doc.UndoCount, 0)

    def test_deleting_what_is_made_closes_the_panel(self):
        self.run_on()
        self.doc.removeObject(self.made()[0].Name)
        self.wait_for(lambda: self.form() is None, "the panel to close")
        self.assertEqual(self.doc.Objects, [])

    def test_closing_the_document_closes_the_panel(self):
        self.run_on()
        FreeCAD.closeDocument(self.doc.Name)
        self.wait_for(lambda: not FreeCADGui.Control.activeDialog(), "the panel to close")
