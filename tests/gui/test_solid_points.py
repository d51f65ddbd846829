"""The panel with the table of control points: new from points, and editing."""

import os
import tempfile

import FreeCAD
import FreeCADGui

from gui_case import QTest, Qt
from osculate import solids
from osculate.features import net_text
from osculate.gui.qt import QtWidgets
from solid_case import SolidCase

V = FreeCAD.Vector


class TableCase(SolidCase):
    command = "Osculate_SolidFromPoints"

    @property
    def obj(self):
        return self.doc.getObject("BezierSolid")

    def type_cell(self, form, row, column, text):
        """Types into a cell as a user does: double-click, text, Return."""
        table = form.table
        table.scrollToItem(table.item(row, column))
        self.pump()
        place = table.visualItemRect(table.item(row, column)).center()
        viewport = table.viewport()
        QTest.mouseClick(viewport, Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier, place)
        QTest.mouseDClick(viewport, Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier,
                          place)
        self.pump()
        editor = table.findChild(QtWidgets.QLineEdit)
        self.assertIsNotNone(editor)
        editor.selectAll()
        QTest.keyClicks(editor, text)
        QTest.keyClick(editor, Qt.Key.Key_Return)
        self.pump()

    def edit_solid(self, value):
        """The panel on a solid with a value; returns the form."""
        self.solid(value)
        self.obj.ViewObject.doubleClicked()
        return self.shown_form()


class NewFromPointsTest(TableCase):
    def test_typed(self):
        form = self.run_on()
        self.assertIn("paste", form.advice.text())
        form.degree.setValue(2)
        self.pump()
        self.assertEqual((self.obj.Degree, form.table.rowCount()), (2, 10))
        self.type_cell(form, 9, 3, "80,5")
        self.assertEqual(self.obj.Points[9], V(0, 0, 80.5))
        self.type_cell(form, 3, 4, "2")
        self.assertEqual(self.obj.Weights, [1, 1, 1, 2] + [1] * 6)
        self.fit()
        self.screenshot("solid_points")
        self.finish("Ok")
        self.assertEqual(self.doc.UndoCount, 1)
        self.doc.undo()
        self.assertIsNone(self.obj)

    def test_pasted_and_copied(self):
        form = self.run_on()
        value = solids.random(3, 5)
        clipboard = QtWidgets.QApplication.clipboard()
        clipboard.setText(net_text.write(value))
        self.click(form.paste)
        self.assertEqual(self.obj.Proxy.value, value)
        clipboard.clear()
        self.click(form.copy)
        self.assertEqual(clipboard.text(), net_text.write(value))
        clipboard.setText("1 2 3\n4 5 6")
        self.click(form.paste)
        self.assertIn("2 points are no net", form.advice.text())
        self.assertEqual(self.obj.Proxy.value, value)

    def test_read_from_a_file(self):
        form = self.run_on()
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "net.csv")
            with open(path, "w", encoding="utf-8-sig") as file:
                file.write("x,y,z,w\n0,0,0,1\n10,0,0,2\n0,10,0,1\n0,0,10,1\n")
            form.panel.take_file(path)
            self.assertEqual((list(self.obj.Weights), self.obj.Points[1]),
                             ([1, 2, 1, 1], V(10, 0, 0)))
            with open(path, "w", encoding="utf-8") as file:
                file.write("0,0,0,1\n10,0,0,-2\n0,10,0,1\n0,0,10,1\n")
            form.panel.take_file(path)
            self.assertIn("weight of point 0 1 0 0 must be 0 or more", form.advice.text())
            form.panel.take_file(os.path.join(folder, "none.csv"))
            self.assertIn("none.csv", form.advice.text())
        self.assertEqual(list(self.obj.Weights), [1, 2, 1, 1])

    def test_points_can_be_dragged_until_the_panel_closes(self):
        self.run_on()
        view = self.obj.ViewObject.Proxy
        view._handles.moved.emit(3, (0.0, 0.0, 75.0))
        view._handles.let_loose.emit()
        self.pump()
        self.assertEqual(self.obj.Points[3], V(0, 0, 75))
        self.assertTrue(self.form().back.isEnabled())
        self.finish("Ok")
        self.assertIsNone(view._handles)

    def test_closing_the_document_closes_the_panel(self):
        self.run_on().table.selectRow(2)
        FreeCAD.closeDocument(self.doc.Name)
        self.wait_for(lambda: not FreeCADGui.Control.activeDialog(), "the panel to close")

    def test_cancel(self):
        form = self.run_on()
        form.degree.setValue(3)
        self.pump()
        self.finish("Cancel")
        self.assertEqual((self.doc.Objects, self.doc.UndoCount), ([], 0))


class EditTest(TableCase):
    def test_steps_and_one_step_of_undo(self):
        value = solids.cone(25, 50)
        form = self.edit_solid(value)
        self.type_cell(form, 9, 3, "60")
        self.type_cell(form, 9, 1, "5")
        self.assertEqual(self.obj.Points[9], V(5, 0, 60))
        self.click(form.back)
        self.assertEqual(self.obj.Points[9], V(0, 0, 60))
        self.click(form.forward)
        QTest.keyClick(form.table, Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
        self.pump()
        self.assertEqual(self.obj.Points[9], V(0, 0, 60))
        self.finish("Ok")
        self.doc.undo()
        self.assertEqual(self.obj.Points[9], V(0, 0, 50))

    def test_cancel_takes_all_back(self):
        value = solids.cone(25, 50)
        form = self.edit_solid(value)
        before = self.as_it_was()
        self.type_cell(form, 9, 3, "60")
        form.degree.setValue(4)
        self.pump()
        self.assertEqual(len(self.obj.Points), 35)
        self.finish("Cancel")
        self.assertEqual(self.as_it_was(), before)
        self.assertNotIn("Touched", self.obj.State)

    def test_bad_numbers_are_named_in_place(self):
        form = self.edit_solid(solids.cone(25, 50))
        self.type_cell(form, 1, 1, "wide")
        self.assertIn("“wide” is no finite number: x of point 1 1 0 0", form.advice.text())
        self.type_cell(form, 1, 1, "inf")
        self.assertIn("“inf” is no finite number", form.advice.text())
        self.assertEqual(self.obj.Status, "OK")
        self.type_cell(form, 4, 4, "-1")
        self.assertIn("weight of point 0 2 0 0 must be 0 or more", form.trouble.text())
        self.assertGreater(form.table.item(4, 4).background().color().alpha(), 0)
        self.screenshot("solid_points_wrong")
        self.press("Ok")
        self.assertIsNotNone(self.form())
        self.type_cell(form, 4, 4, "1")
        self.assertEqual(form.trouble.text(), "")
        self.finish("Ok")

    def test_what_a_script_left_can_be_mended(self):
        obj = self.solid(solids.cone(25, 50))
        points = obj.Points
        points[9].z = float("nan")
        obj.Points = points
        self.doc.recompute()
        obj.ViewObject.doubleClicked()
        form = self.shown_form()
        self.assertIn("z of point 0 0 0 2 must be a finite number", form.trouble.text())
        self.type_cell(form, 9, 3, "50")
        self.assertEqual((form.trouble.text(), obj.Proxy.value), ("", solids.cone(25, 50)))
        self.finish("Ok")

    def test_all_weights_zero(self):
        form = self.edit_solid(solids.tetrahedron((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)))
        for row in range(4):
            self.type_cell(form, row, 4, "0")
        self.assertIn("All weights are 0", form.trouble.text())

    def test_every_digit_stays(self):
        value = solids.random(2, 9)
        form = self.edit_solid(value)
        place = form.table.item(3, 2)
        form.table.editItem(place)
        editor = form.table.findChild(QtWidgets.QLineEdit)
        QTest.keyClick(editor, Qt.Key.Key_Return)
        self.pump()
        self.assertEqual(self.obj.Proxy.value, value)

    def test_four_dimensions(self):
        form = self.edit_solid(solids.random(2, 9, 4))
        self.type_cell(form, 0, 4, "12.5")
        self.assertEqual(self.obj.FourthCoordinates[0], 12.5)
        self.assertEqual(form.table.columnCount(), 6)
        self.darken()
        self.fit()
        self.screenshot("solid_points_4d_dark")

    def test_folding_is_said(self):
        form = self.edit_solid(
            solids.tetrahedron((0, 0, 0), (50, 0, 0), (0, 50, 0), (0, 0, 50)).elevated())
        self.type_cell(form, 1, 1, "-90")
        self.assertIn("folds over itself", form.facts.text())
