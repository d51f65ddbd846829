"""The command Join: its panel, the chain of edges, the tolerance."""

import FreeCAD
import FreeCADGui
import Part

import samples
from gui_case import DARK, GuiCase
from osculate.gui.construct.joined_form import JoinedForm
from osculate.gui.qt import QtWidgets

V = FreeCAD.Vector


class JoinTest(GuiCase):
    form_type = JoinedForm

    def setUp(self):
        super().setUp()
        self.doc.UndoMode = 1
        self.line, self.arc = samples.line_and_arc(self.doc)
        self.fit()

    def join(self, *targets):
        self.select(*targets)
        FreeCADGui.runCommand("Osculate_Join")
        self.wait_for(lambda: self.form() is not None and self.form().isVisible(), "the panel")
        self.pump()
        return self.form()

    def join_both(self):
        return self.join((self.line, "Edge1"), (self.arc, "Edge1"))

    def press(self, name):
        standard = getattr(QtWidgets.QDialogButtonBox.StandardButton, name)
        boxes = FreeCADGui.getMainWindow().findChildren(QtWidgets.QDialogButtonBox)
        self.click(next(filter(None, (box.button(standard) for box in boxes if box.isVisible()))))
        self.wait_for(lambda: self.form() is None, "the panel to close")

    def edges(self):
        return [f"{obj.Name}.{sub}" for obj, subs in self.doc.JoinedCurve.Edges for sub in subs]

    def test_selected_edges_are_joined_at_once(self):
        form = self.join_both()
        obj = self.doc.JoinedCurve
        self.assertEqual((obj.Status, obj.Continuity), ("OK", ["G1"]))
        self.assertEqual(form.table.item(0, 0).text(), "Line.Edge1")
        self.assertIn("G1", form.table.item(0, 2).toolTip())
        self.assertIn("Degree 2", form.summary.text())
        self.screenshot("join_panel")
        self.press("Ok")
        self.assertEqual([o.Name for o in self.doc.Objects], ["Line", "Arc", "JoinedCurve"])
        self.doc.undo()
        self.assertEqual([o.Name for o in self.doc.Objects], ["Line", "Arc"])

    def test_cancel_leaves_the_document_as_it_was(self):
        self.join_both()
        self.press("Cancel")
        self.assertEqual([o.Name for o in self.doc.Objects], ["Line", "Arc"])
        self.assertEqual(self.doc.UndoNames, [])

    def test_edges_are_asked_for(self):
        form = self.join()
        self.assertIn("chain", form.advice.text())
        self.select((self.line, "Edge1"))
        self.assertIsNone(self.doc.getObject("JoinedCurve"))
        self.select((self.arc, "Edge1"))
        self.assertEqual(self.edges(), ["Line.Edge1", "Arc.Edge1"])

    def test_a_picked_edge_is_added_and_taken_out(self):
        third = samples.add_edge(self.doc, "Third", Part.LineSegment(V(70, 20, 0), V(70, 60, 0)))
        self.doc.recompute()
        form = self.join_both()
        if not form.tools.pick.isChecked():
            self.click(form.tools.pick)
        self.select((third, "Edge1"))
        self.assertEqual(self.edges(), ["Line.Edge1", "Arc.Edge1", "Third.Edge1"])
        self.assertEqual(self.doc.JoinedCurve.Continuity, ["G1", "G1"])
        self.select((third, "Edge1"))
        self.assertEqual(self.edges(), ["Line.Edge1", "Arc.Edge1"])

    def test_marked_edges_are_removed_and_moved(self):
        samples.add_edge(self.doc, "Third", Part.LineSegment(V(70, 20, 0), V(70, 60, 0)))
        self.doc.recompute()
        form = self.join((self.line, "Edge1"), (self.arc, "Edge1"), (self.doc.Third, "Edge1"))
        form.table.mark(2)
        self.click(form.tools.up)
        self.assertEqual(self.edges(), ["Line.Edge1", "Third.Edge1", "Arc.Edge1"])
        form.table.mark(1)
        self.click(form.tools.remove)
        self.assertEqual(self.edges(), ["Line.Edge1", "Arc.Edge1"])
        form.table.mark(0)
        self.click(form.tools.remove)
        self.assertIn("At least two", form.advice.text())
        self.assertEqual(len(self.edges()), 2)

    def test_whole_sketch_with_a_gap_and_a_tolerance(self):
        sketch = samples.profile(self.doc)
        form = self.join((sketch, ""))
        self.assertIn("0.02", form.trouble.text())
        self.type_number(form.tolerance, "0.05")
        obj = self.doc.JoinedCurve
        self.assertEqual(obj.Status, "OK")
        self.assertEqual(len(obj.Continuity), 4)
        self.assertLessEqual(obj.Deviation.Value, 0.05)
        self.assertFalse(form.trouble.isVisible())
        self.assertIn("between Profile.Edge4 and Profile.Edge5", form.warnings.text())
        self.fit()
        self.screenshot("join_sketch")
        self.set_background(DARK)
        self.pump()
        self.screenshot("join_dark")

    def test_double_click_reopens_the_panel(self):
        self.join_both()
        self.press("Ok")
        FreeCADGui.getDocument(self.doc.Name).setEdit("JoinedCurve")
        self.wait_for(lambda: self.form() is not None, "the panel")
        form = self.form()
        self.type_number(form.tolerance, "0.01")
        self.press("Cancel")
        self.assertEqual(self.doc.JoinedCurve.Tolerance.Value, 0.0)

    def test_steps_go_back(self):
        form = self.join_both()
        self.type_number(form.tolerance, "0.01")
        self.click(form.back)
        self.assertEqual(self.doc.JoinedCurve.Tolerance.Value, 0.0)
        self.click(form.forward)
        self.assertEqual(self.doc.JoinedCurve.Tolerance.Value, 0.01)
