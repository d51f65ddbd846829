"""The command Extend and its panel, used with mouse and keyboard."""

import FreeCAD
import FreeCADGui
import Part

import samples
from construct_case import ConstructCase
from osculate.gui.construct.extend_form import ExtendForm

V = FreeCAD.Vector


class ExtendCase(ConstructCase):
    form_type = ExtendForm
    command = "Osculate_Extend"

    def setUp(self):
        super().setUp()
        self.edge = samples.add_edge(
            self.doc, "Cubic", samples.bezier((0, 0, 0), (20, 0, 0), (40, 10, 0), (50, 20, 10)))
        self.goal = self.doc.addObject("Part::Feature", "Goal")
        self.goal.Shape = Part.Vertex(90, 30, 0)
        self.doc.recompute()
        self.fit()

    def extend(self):
        return self.run_on((self.edge, "Edge1"))

    def select_at(self, obj, sub, point):
        """As a click in the 3D view does."""
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(self.doc.Name, obj.Name, sub, *point)
        self.pump()


class OpenCase(ExtendCase):
    """With the panel open on the edge."""

    def setUp(self):
        super().setUp()
        self.form_ = self.extend()
        self.obj = self.doc.ExtendedCurve


class StartTest(ExtendCase):
    def test_a_selected_edge_is_continued_at_once(self):
        form = self.extend()
        obj = self.doc.ExtendedCurve
        self.assertEqual((obj.Status, obj.End), ("OK", "end"))
        self.assertEqual(form.edge.name.text(), "Cubic.Edge1")
        self.assertFalse(form.advice.isVisible())
        self.screenshot("extend_panel")

    def test_an_edge_is_asked_for(self):
        form = self.run_on()
        self.assertIn("Select the edge", form.advice.text())
        self.assertFalse(form.order.isVisible())
        self.screenshot("extend_asks")
        self.select((self.edge, "Edge1"))
        self.assertEqual(self.doc.ExtendedCurve.Status, "OK")

    def test_the_end_near_the_click_is_continued(self):
        for point, end in (((5, 0.2, 0), "start"), ((48, 17, 8), "end")):
            self.select_at(self.edge, "Edge1", point)
            FreeCADGui.runCommand(self.command)
            self.shown_form()
            self.assertEqual(self.doc.ExtendedCurve.End, end)
            self.finish("Cancel")

    def test_a_selected_vertex_is_continued(self):
        self.run_on((self.edge, "Vertex1"))
        self.assertEqual(self.doc.ExtendedCurve.End, "start")

    def test_two_edges_are_refused(self):
        box = self.doc.addObject("Part::Box", "Box")
        self.doc.recompute()
        form = self.run_on((box, "Edge1"), (box, "Edge2"))
        self.assertIn("2 edges", form.advice.text())
        self.finish("Cancel")


class EndTest(ExtendCase):
    def test_ok_is_one_step_of_undo(self):
        undos = self.doc.UndoCount
        form = self.extend()
        self.click(form.order.buttons[2])
        self.type_number(form.length.box, "25")
        self.finish("Ok")
        self.assertEqual(self.doc.UndoCount, undos + 1)
        self.assertAlmostEqual(self.doc.ExtendedCurve.Shape.Length, 25.0, delta=1e-6)
        self.doc.undo()
        self.assertEqual(self.names(), ["Cubic", "Goal"])

    def test_cancel_leaves_the_document_as_it_was(self):
        undos = self.doc.UndoCount
        self.extend()
        self.finish("Cancel")
        self.assertEqual((self.names(), self.doc.UndoCount), (["Cubic", "Goal"], undos))

    def test_editing_and_cancel(self):
        self.extend()
        self.finish("Ok")
        obj = self.doc.ExtendedCurve
        before = obj.Shape.Length
        form = self.edit(obj)
        self.type_number(form.length.box, "12")
        self.assertNotEqual(obj.Shape.Length, before)
        self.finish("Cancel")
        self.assertEqual((obj.Shape.Length, obj.WantedLengthFixed), (before, False))
