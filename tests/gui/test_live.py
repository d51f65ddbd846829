"""The panel follows the model: edits, undo, deletion, closing."""

from unittest import mock

import FreeCAD
import FreeCADGui

import samples
from gui_case import GuiCase


class LiveTest(GuiCase):
    def setUp(self):
        super().setUp()
        self.doc.UndoMode = 1
        self.line, self.arc = samples.line_and_arc(self.doc)
        self.form_ = self.analyze((self.line, "Edge1"), (self.arc, "Edge1"))

    def verdict(self):
        return self.form_.banner.text.text()

    def test_moving_an_edge(self):
        self.line.Placement.Base.z = 0.5
        self.pump()
        self.assertIn("<b>gap</b>, 0.5 mm", self.verdict())

    def test_expression_and_recompute(self):
        self.line.setExpression("Placement.Base.y", "0.25 mm")
        self.doc.recompute()
        self.pump()
        self.assertIn("0.25 mm", self.verdict())

    def test_undo_and_redo(self):
        self.doc.openTransaction("Move")
        self.line.Placement.Base.z = 0.5
        self.doc.commitTransaction()
        self.doc.undo()
        self.pump()
        self.assertIn("<b>G1</b>", self.verdict())
        self.doc.redo()
        self.pump()
        self.assertIn("<b>gap</b>", self.verdict())

    def test_deleting_an_object_is_said_and_undone(self):
        self.doc.openTransaction("Delete")
        self.doc.removeObject(self.arc.Name)
        self.doc.commitTransaction()
        self.pump()
        self.assertIn("Arc no longer exists", self.form_.trouble.text())
        self.assertFalse(self.form_.banner.isVisible())
        self.screenshot("deleted")
        self.doc.undo()
        self.pump()
        self.assertFalse(self.form_.trouble.isVisible())
        self.assertIn("<b>G1</b>", self.verdict())

    def test_an_edge_that_disappears_is_said(self):
        self.arc.Shape = self.arc.Shape.Vertexes[0]
        self.pump()
        self.assertIn("Arc has no Edge1", self.form_.trouble.text())

    def test_many_edits_are_one_analysis(self):
        shown = []
        table = self.form_.orders
        show = table.show_report
        table.show_report = lambda report: (shown.append(report.headline), show(report))
        for step in range(1, 51):
            self.line.Placement.Base.z = 0.01 * step
        self.pump()
        self.assertEqual(len(shown), 1)
        self.assertIn("0.5 mm", shown[0])

    def test_own_values_stay_while_the_model_changes(self):
        self.type_number(self.form_.tolerances.values[0], "1")
        self.line.Placement.Base.z = 0.5
        self.pump()
        self.assertNotIn("gap", self.verdict())

    def test_closing_the_document_closes_the_panel(self):
        FreeCAD.closeDocument(self.doc.Name)
        self.wait_for(lambda: self.form() is None, "the panel to close")

    def test_closing_another_document_does_not(self):
        other = FreeCAD.newDocument("Other")
        FreeCAD.closeDocument(other.Name)
        self.pump()
        self.assertIsNotNone(self.form())

    def test_closed_panel_does_not_listen(self):
        self.close_panel()
        with mock.patch("osculate.analyze") as analyze:
            self.line.Placement.Base.z = 0.5
            self.select((self.line, "Edge1"), (self.arc, "Edge1"))
            self.assertFalse(analyze.called)

    def test_dialog_closed_by_a_script_does_not_listen(self):
        FreeCADGui.Control.closeDialog()
        self.wait_for(lambda: self.form() is None, "the panel to close")
        with mock.patch("osculate.analyze") as analyze:
            self.line.Placement.Base.z = 0.5
            self.pump()
            self.assertFalse(analyze.called)
