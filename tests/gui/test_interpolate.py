"""The command Interpolate: points from vertices and from coordinates, tensions, ends."""

import FreeCAD
import FreeCADGui
import Part

from gui_case import DARK, GuiCase
from osculate.gui.construct.interpolated_form import InterpolatedForm
from osculate.gui.construct.vector_row import VectorRow
from osculate.gui.qt import QtWidgets

V = FreeCAD.Vector
POINTS = (V(0, 0, 0), V(20, 15, 0), V(40, 0, 5), V(55, 20, 0), V(80, 10, 0))


class InterpolateTest(GuiCase):
    form_type = InterpolatedForm

    def setUp(self):
        super().setUp()
        self.doc.UndoMode = 1
        self.wire = self.doc.addObject("Part::Feature", "Wire")
        self.wire.Shape = Part.makePolygon(POINTS)
        self.doc.recompute()
        self.fit()

    def interpolate(self, *targets):
        self.select(*targets)
        FreeCADGui.runCommand("Osculate_Interpolate")
        self.wait_for(lambda: self.form() is not None and self.form().isVisible(), "the panel")
        self.pump()
        return self.form()

    def press(self, name):
        standard = getattr(QtWidgets.QDialogButtonBox.StandardButton, name)
        boxes = FreeCADGui.getMainWindow().findChildren(QtWidgets.QDialogButtonBox)
        self.click(next(filter(None, (box.button(standard) for box in boxes if box.isVisible()))))
        self.wait_for(lambda: self.form() is None, "the panel to close")

    @property
    def obj(self):
        return self.doc.getObject("InterpolatedCurve")

    def vertices(self):
        return [sub for _, subs in self.obj.Vertices for sub in subs]

    def test_all_vertices_of_an_object(self):
        form = self.interpolate((self.wire, ""))
        self.assertEqual(self.vertices(), [f"Vertex{number}" for number in range(1, 6)])
        self.assertEqual(form.table.item(0, 0).text(), "Wire.Vertex1")
        self.type_number(form.tension.box, "4")
        self.assertEqual(self.obj.Tension, 4.0)
        self.screenshot("interpolate_panel")
        self.press("Ok")
        self.doc.undo()
        self.assertIsNone(self.obj)

    def test_picked_vertices(self):
        form = self.interpolate()
        self.assertIn("vertices", form.advice.text())
        self.select((self.wire, "Vertex1"))
        self.assertIsNone(self.obj)
        self.select((self.wire, "Vertex3"))
        self.assertEqual(self.obj.Status, "OK")
        self.select((self.wire, "Vertex5"))
        self.assertEqual(self.vertices(), ["Vertex1", "Vertex3", "Vertex5"])
        self.select((self.wire, "Vertex3"))
        self.assertEqual(self.vertices(), ["Vertex1", "Vertex5"])

    def test_an_edge_is_no_vertex(self):
        form = self.interpolate((self.wire, "Edge1"))
        self.assertIn("is no vertex", form.advice.text())

    def test_tension_of_one_point(self):
        form = self.interpolate((self.wire, ""))
        form.table.mark(1)
        self.pump()
        self.type_number(form.own.box, "50")
        self.assertEqual(list(self.obj.Tensions), [-1.0, 50.0, -1.0, -1.0, -1.0])
        self.assertEqual(form.table.item(1, 1).text(), "50")
        self.assertTrue(form.table.item(1, 1).font().bold())
        self.screenshot("interpolate_own")
        self.click(form.tools.down)
        self.assertEqual(self.vertices()[2], "Vertex2")
        self.assertEqual(list(self.obj.Tensions)[2], 50.0)
        self.click(form.own.lock)
        self.assertEqual(set(self.obj.Tensions), {-1.0})

    def test_points_by_their_coordinates(self):
        form = self.interpolate()
        self.click(form.tools.add)
        self.assertEqual(len(self.obj.Points), 3)
        self.click(form.tools.add)
        self.assertEqual(len(self.obj.Points), 4)
        form.table.mark(3)
        self.pump()
        self.type_number(form.position.boxes[1], "25")
        self.assertEqual(self.obj.Points[3].y, 25.0)
        self.fit()
        self.set_background(DARK)
        self.pump()
        self.screenshot("interpolate_points_dark")
        self.click(form.tools.remove)
        self.assertEqual(len(self.obj.Points), 3)

    def test_two_points_must_stay(self):
        form = self.interpolate((self.wire, "Vertex1"), (self.wire, "Vertex2"))
        form.table.mark(0)
        self.click(form.tools.remove)
        self.assertIn("two points", form.advice.text())
        self.assertEqual(self.vertices(), ["Vertex1", "Vertex2"])

    def test_ends(self):
        form = self.interpolate((self.wire, ""))
        for name in ("closed", "tangents"):
            form.ends.setCurrentIndex(form.ends.findData(name))
            form.ends.activated.emit(form.ends.currentIndex())
            self.pump()
            self.assertEqual((self.obj.Ends, self.obj.Status), (name, "OK"))
        self.assertTrue(form.start.isVisible())
        self.type_number(form.start.findChild(VectorRow).boxes[1], "3")
        self.assertEqual(self.obj.StartTangent, V(1, 3, 0))

    def test_cancel_leaves_the_document_as_it_was(self):
        self.interpolate((self.wire, ""))
        self.press("Cancel")
        self.assertEqual([obj.Name for obj in self.doc.Objects], ["Wire"])

    def test_double_click_reopens_the_panel(self):
        self.interpolate((self.wire, ""))
        self.press("Ok")
        FreeCADGui.getDocument(self.doc.Name).setEdit("InterpolatedCurve")
        self.wait_for(lambda: self.form() is not None, "the panel")
        self.type_number(self.form().tension.box, "7")
        self.press("Ok")
        self.assertEqual(self.obj.Tension, 7.0)
