"""The command Blend: how its panel begins and ends."""

import FreeCAD
import FreeCADGui

import samples
from construct_case import ConstructCase
from osculate.gui import colors
from osculate.gui.construct.blend_form import BlendForm


class BlendCase(ConstructCase):
    form_type = BlendForm
    command = "Osculate_Blend"

    def setUp(self):
        super().setUp()
        self.first, self.second = samples.blend_ends(self.doc)
        self.fit()

    def blend(self, *targets):
        return self.run_on(*targets)

    def blend_both(self):
        return self.blend((self.first, "Edge1"), (self.second, "Edge1"))


class StartTest(BlendCase):
    def test_two_selected_edges_are_blended_at_once(self):
        form = self.blend_both()
        self.assertEqual(self.doc.BlendCurve.Continuity, ["G3", "G3"])
        self.assertEqual(form.ends[0].edge.name.text(), "Left.Edge1")
        self.assertFalse(form.advice.isVisible())
        self.screenshot("blend_panel")

    def test_edges_are_asked_for_one_by_one(self):
        form = self.blend()
        self.assertIn("two edges", form.advice.text())
        self.assertTrue(form.ends[0].edge.pick.isChecked())
        self.screenshot("blend_asks")
        self.select((self.first, "Edge1"))
        self.assertTrue(form.ends[1].edge.pick.isChecked())
        self.assertEqual(self.names(), ["Left", "Right"])
        image = self.image("blend_first_picked")
        self.assertGreater(self.count_pixels(image, colors.SIDES[0]), 200)
        self.assertEqual(FreeCADGui.Selection.getSelectionEx(), [])
        self.select((self.second, "Edge1"))
        self.assertEqual(self.doc.BlendCurve.Status, "OK")
        self.assertEqual(FreeCADGui.Selection.getSelectionEx(), [])

    def test_edges_are_picked_in_the_3d_view(self):
        form = self.blend()
        self.click_at(self.first.Shape.Edges[0].valueAt(0.3))
        self.wait_for(form.ends[1].edge.pick.isChecked, "the first edge")
        self.click_at(self.second.Shape.Edges[0].valueAt(0.7))
        self.wait_for(lambda: self.doc.getObject("BlendCurve"), "the blend")
        self.assertEqual((self.doc.BlendCurve.First[0], self.doc.BlendCurve.Second[0]),
                         (self.first, self.second))

    def test_one_selected_edge_counts_as_the_first(self):
        form = self.blend((self.second, "Edge1"))
        self.select((self.first, "Edge1"))
        self.assertEqual(self.doc.BlendCurve.First[0].Name, "Right")
        self.assertEqual(form.ends[1].edge.name.text(), "Left.Edge1")

    def test_the_same_edge_twice_is_closed(self):
        self.blend()
        self.select((self.first, "Edge1"))
        self.select((self.first, "Edge1"))
        obj = self.doc.BlendCurve
        self.assertEqual((obj.Status, obj.EndsMade), ("OK", "end-start"))

    def test_faces_and_too_many_edges_are_refused(self):
        box = self.doc.addObject("Part::Box", "Box")
        self.doc.recompute()
        form = self.blend((box, "Face1"))
        self.assertIn("Box.Face1 is no edge", form.advice.text())
        self.select((box, ""))
        self.assertIn("12 edges", form.advice.text())
        self.select((self.first, "Edge1"))
        self.assertIn("two edges", form.advice.text())

    def test_edges_of_another_document_are_refused(self):
        other = FreeCAD.newDocument("Other")
        line, _ = samples.line_and_arc(other)
        FreeCAD.setActiveDocument(self.doc.Name)
        form = self.blend()
        FreeCADGui.Selection.addSelection("Other", line.Name, "Edge1")
        self.pump()
        self.assertIn("in one document", form.advice.text())

    def test_coinciding_ends_are_said_and_nothing_is_kept(self):
        self.second.Placement.Base = FreeCAD.Vector(-50, -10, 0)
        self.doc.recompute()
        form = self.blend_both()
        self.assertIn("coincide", form.trouble.text())
        self.assertFalse(form.verdicts.isVisible())
        self.press("Ok")
        self.assertIsNotNone(self.form())
        self.assertIn("nothing to keep", form.advice.text())
        self.finish("Cancel")
        self.assertEqual(self.names(), ["Left", "Right"])


class EndTest(BlendCase):
    def test_ok_is_one_step_of_undo(self):
        undos = self.doc.UndoCount
        form = self.blend_both()
        self.click(form.ends[0].order.buttons[1])
        self.type_number(form.ends[0].numbers[0].box, "0.8")
        self.finish("Ok")
        self.assertEqual(self.doc.UndoCount, undos + 1)
        self.assertEqual(self.doc.BlendCurve.FirstBeta1, 0.8)
        self.doc.undo()
        self.assertEqual(self.names(), ["Left", "Right"])
        self.doc.redo()
        self.assertEqual(self.doc.BlendCurve.FirstBeta1, 0.8)

    def test_cancel_leaves_the_document_as_it_was(self):
        undos = self.doc.UndoCount
        form = self.blend_both()
        self.click(form.ends[0].order.buttons[1])
        self.second.touch()  # as a command of someone else would
        self.finish("Cancel")
        self.assertEqual(self.names(), ["Left", "Right"])
        self.assertEqual(self.doc.UndoCount, undos)
        self.assertNotIn("Touched", self.first.State)
        self.assertIn("Touched", self.second.State)

    def test_cancel_without_edges(self):
        self.blend()
        self.finish("Cancel")
        self.assertEqual(self.names(), ["Left", "Right"])

    def test_ok_without_edges_keeps_nothing(self):
        undos = self.doc.UndoCount
        self.blend()
        self.finish("Ok")
        self.assertEqual((self.names(), self.doc.UndoCount), (["Left", "Right"], undos))

    def test_dialog_closed_by_a_script_keeps_nothing(self):
        self.blend_both()
        FreeCADGui.Control.closeDialog()
        self.wait_for(lambda: self.form() is None, "the panel to close")
        self.pump()
        self.assertEqual(self.names(), ["Left", "Right"])

    def test_document_closed(self):
        self.blend_both()
        FreeCAD.closeDocument(self.doc.Name)
        self.wait_for(lambda: self.form() is None, "the panel to close")

    def test_undo_while_the_panel_is_open(self):
        self.blend_both()
        self.doc.undo()
        self.wait_for(lambda: self.form() is None, "the panel to close")
        self.assertEqual(self.names(), ["Left", "Right"])
        self.doc.redo()
        self.assertEqual(self.doc.BlendCurve.Status, "OK")
