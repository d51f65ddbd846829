"""The panel on a BlendCurve that is in the document."""

import FreeCAD
import FreeCADGui

import samples
from test_blend import BlendCase


class EditTest(BlendCase):
    def setUp(self):
        super().setUp()
        self.blend_both()
        self.finish("Ok")
        self.blend_ = self.doc.BlendCurve
        self.undos = self.doc.UndoCount

    def test_ok_keeps_as_one_step(self):
        form = self.edit(self.blend_)
        self.click(form.ends[1].order.buttons[2])
        self.click(form.symmetric)
        self.finish("Ok")
        self.assertEqual(self.doc.UndoCount, self.undos + 1)
        self.assertEqual((self.blend_.SecondOrder, self.blend_.Symmetric), (2, True))
        self.doc.undo()
        self.assertEqual((self.blend_.SecondOrder, self.blend_.Symmetric), (3, False))

    def test_cancel_takes_back(self):
        before = self.blend_.Shape.Length, self.blend_.FirstBeta1
        form = self.edit(self.blend_)
        self.type_number(form.ends[0].numbers[0].box, "2.5")
        self.assertNotEqual(self.blend_.Shape.Length, before[0])
        self.finish("Cancel")
        self.assertEqual((self.blend_.Shape.Length, self.blend_.FirstBeta1), before)
        self.assertFalse(self.blend_.FirstBeta1Fixed)
        self.assertEqual(self.doc.UndoCount, self.undos)
        self.assertEqual(self.blend_.State, ["Up-to-date"])

    def test_undo_while_editing_and_going_on(self):
        form = self.edit(self.blend_)
        self.click(form.ends[0].order.buttons[2])
        self.doc.undo()
        self.pump()
        self.assertEqual(self.blend_.FirstOrder, 3)
        self.assertTrue(form.ends[0].order.buttons[3].isChecked())
        self.click(form.ends[0].order.buttons[1])
        self.finish("Ok")
        self.assertEqual(self.blend_.FirstOrder, 1)
        self.doc.undo()
        self.assertEqual(self.blend_.FirstOrder, 3)

    def test_other_edges_are_picked_and_loops_refused(self):
        line, _ = samples.line_and_arc(self.doc)
        line.Placement.Base.y = 60
        self.doc.recompute()
        form = self.edit(self.blend_)
        self.click(form.ends[0].edge.pick)
        self.select((self.blend_, "Edge1"))
        self.assertIn("cannot use its edges", form.advice.text())
        self.select((line, "Edge1"))
        self.assertEqual(self.blend_.First[0].Name, line.Name)
        self.assertFalse(form.advice.isVisible())
        self.finish("Ok")

    def test_document_closed(self):
        self.edit(self.blend_)
        FreeCAD.closeDocument(self.doc.Name)
        self.wait_for(lambda: self.form() is None, "the panel to close")

    def test_object_deleted(self):
        self.edit(self.blend_)
        self.doc.removeObject(self.blend_.Name)
        self.wait_for(lambda: self.form() is None, "the panel to close")
        self.assertEqual(self.names(), ["Left", "Right"])
        self.assertIsNone(FreeCADGui.getDocument(self.doc.Name).getInEdit())

    def test_what_depends_on_it_follows_each_step(self):
        sweep = self.doc.addObject("Part::Extrusion", "Extrusion")
        sweep.Base, sweep.Dir = self.blend_, FreeCAD.Vector(0, 0, 5)
        self.doc.recompute()
        area = sweep.Shape.Area
        form = self.edit(self.blend_)
        self.type_number(form.ends[0].numbers[0].box, "2.5")
        self.assertNotEqual(sweep.Shape.Area, area)
        self.finish("Cancel")
        self.assertEqual((sweep.Shape.Area, sweep.State), (area, ["Up-to-date"]))

    def test_fails_and_heals_in_the_tree(self):
        self.blend_.Degree = 3
        self.doc.recompute()
        self.pump()
        self.assertFalse(self.blend_.isValid())
        self.assertIn("degree", self.report_view().toPlainText())
        form = self.edit(self.blend_)
        self.assertIn("degree", form.trouble.text())
        self.screenshot("blend_error")
        self.assertEqual(form.degree.value(), 3)
        form.degree.setValue(7)
        self.pump()
        self.assertEqual(self.blend_.Degree, 0)
        self.finish("Ok")
        self.assertTrue(self.blend_.isValid())

    def test_deleted_edge(self):
        self.doc.removeObject("Right")
        self.doc.recompute()
        length = self.blend_.Shape.Length
        form = self.edit(self.blend_)
        self.assertIn("deleted", form.trouble.text())
        self.screenshot("blend_broken")
        line, _ = samples.line_and_arc(self.doc)
        line.Placement.Base.y = 60
        self.doc.recompute()
        self.select((line, "Edge1"))
        self.assertEqual(self.blend_.Status, "OK")
        self.assertNotEqual(self.blend_.Shape.Length, length)
        self.finish("Ok")
        self.assertTrue(self.blend_.isValid())
