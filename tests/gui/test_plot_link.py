"""The dock Curve plot, linked to the 3D view and following the model."""

import math

import FreeCAD
import FreeCADGui
import Part

import samples
from gui_case import QTest
from osculate.gui import colors
from osculate.gui.canvas import widgets_of
from osculate.gui.plot.plot_dock import show_dock
from osculate.gui.qt import Qt, QtCore
from plot_case import PlotCase

V = samples.V


class LinkTest(PlotCase):
    def setUp(self):
        super().setUp()
        self.line, self.arc = samples.line_and_arc(self.doc)
        self.fit()
        self.plot((self.line, ""), (self.arc, ""))
        FreeCADGui.Selection.clearSelection()
        self.pump()

    def marked(self, name):
        return self.count_pixels(self.image(name), colors.CURSOR, 12)

    def move_in_view(self, point):
        _, canvas = widgets_of(self.view())
        x, y = self.view().getPointOnScreen(point)
        QTest.mouseMove(canvas, QtCore.QPoint(x, canvas.height() - 1 - y))
        self.pump()

    def test_the_mouse_over_the_plot_marks_the_point_in_the_view(self):
        self.assertLess(self.marked("plot_unmarked"), 20)
        self.move_to(60.0)
        self.assertGreater(self.marked("plot_marked"), 100)
        self.assertIn("κ 0.05 mm⁻¹ (R 20 mm)", self.tools.reading.text())
        self.assertIn("Arc.Edge1", self.tools.reading.text())
        self.screenshot("plot_cursor")
        QTest.mouseMove(FreeCADGui.getMainWindow(), QtCore.QPoint(5, 5))
        self.wait_for(lambda: self.canvas._cursor is None, "the cursor to go")
        self.assertLess(self.marked("plot_left"), 20)

    def test_the_mouse_over_the_edge_moves_the_cursor(self):
        self.move_in_view(V(20, 0, 0))
        self.wait_for(lambda: self.canvas._cursor is not None, "the cursor")
        self.assertAlmostEqual(self.canvas._cursor[0], 20.0, delta=0.3)
        self.move_in_view(V(35, 3, 0))
        self.move_in_view(V(20, 25, 0))
        self.assertIsNone(self.canvas._cursor)

    def test_a_click_keeps_the_cursor(self):
        self.move_to(60.0)
        QTest.mouseClick(self.canvas, Qt.MouseButton.LeftButton,
                         Qt.KeyboardModifier.NoModifier, self.place_of(60.0))
        QTest.mouseMove(self.canvas, self.place_of(10.0))
        self.pump()
        self.assertAlmostEqual(self.canvas._cursor[0], 60.0, delta=0.5)
        QTest.mouseClick(self.canvas, Qt.MouseButton.LeftButton,
                         Qt.KeyboardModifier.NoModifier, self.place_of(10.0))
        self.assertAlmostEqual(self.canvas._cursor[0], 10.0, delta=0.5)

    def test_the_wheel_zooms_about_the_mouse_and_dragging_moves(self):
        self.wheel(self.canvas, self.place_of(50.0), 120)
        first, last = self.canvas.seen
        self.assertAlmostEqual(last - first, self.dock.source.plot.length / 1.25, delta=1e-6)
        self.assertAlmostEqual((50.0 - first) / (last - first),
                               50.0 / self.dock.source.plot.length, delta=5e-3)
        start = self.place_of(50.0)
        QTest.mousePress(self.canvas, Qt.MouseButton.LeftButton,
                         Qt.KeyboardModifier.NoModifier, start)
        for step in (10, 30, 50):
            QTest.mouseMove(self.canvas, start + QtCore.QPoint(step, 0))
            self.pump()
        QTest.mouseRelease(self.canvas, Qt.MouseButton.LeftButton,
                           Qt.KeyboardModifier.NoModifier, start + QtCore.QPoint(50, 0))
        self.assertLess(self.canvas.seen[0], first)
        self.assertFalse(self.dock.is_pinned)
        QTest.mouseDClick(self.canvas, Qt.MouseButton.LeftButton,
                          Qt.KeyboardModifier.NoModifier, start)
        self.assertEqual(self.canvas.seen, (0.0, self.dock.source.plot.length))

    def test_the_scale_can_be_locked(self):
        top = self.canvas.drawing.axes["curvature"]
        before = top.get_ylim()
        self.click(self.tools.lock)
        self.arc.Shape = Part.ArcOfCircle(
            Part.Circle(V(50, 10, 0), V(0, 0, 1), 10), -math.pi / 2, 0).toShape()
        self.wait_for(lambda: self.dock.source.plot.length < 70.0, "the plot to follow")
        self.assertEqual(self.canvas.drawing.axes["curvature"].get_ylim(), before)
        self.click(self.tools.lock)
        self.assertGreater(self.canvas.drawing.axes["curvature"].get_ylim()[1], 0.09)
        self.wheel(self.canvas, self.place_of(30.0), 120, Qt.KeyboardModifier.ControlModifier)
        self.assertTrue(self.tools.lock.isChecked())


class ModelTest(PlotCase):
    def setUp(self):
        super().setUp()
        self.line, self.arc = samples.line_and_arc(self.doc)
        self.doc.UndoMode = 1
        self.fit()
        self.plot((self.line, ""), (self.arc, ""))

    def test_follows_edits_before_a_recompute(self):
        before = self.dock.source.plot
        self.line.Placement.Base = V(-1, 0, 0)
        self.wait_for(lambda: self.dock.source.plot is not before, "the plot to follow")
        self.assertEqual([join.label for join in self.dock.source.plot.joins], ["gap"])

    def test_deleted_edges_go_and_undo_brings_them_back(self):
        self.doc.openTransaction("Delete")
        self.doc.removeObject(self.arc.Name)
        self.doc.commitTransaction()
        self.wait_for(lambda: len(self.dock.source.plot.curves) == 1, "the edge to go")
        self.assertIn("Arc no longer exists", self.tools.trouble.text())
        self.doc.removeObject(self.line.Name)
        self.wait_for(lambda: self.dock.source.plot is None, "the plot to go")
        self.assertFalse(self.canvas.isVisible())
        self.screenshot("plot_deleted")
        self.doc.undo()
        self.wait_for(lambda: self.dock.source.plot is not None, "the plot to come back")

    def test_hidden_it_does_nothing(self):
        before = self.dock.source.plot
        self.move_to(60.0)
        self.dock.close()
        self.pump()
        self.assertEqual(self.dock._observers, [])
        self.assertLess(self.count_pixels(self.image("plot_closed"), colors.CURSOR, 12), 20)
        self.line.Placement.Base = V(-1, 0, 0)
        self.pump()
        self.assertIs(self.dock.source.plot, before)
        show_dock()
        self.wait_for(lambda: self.dock.source.plot is not before, "the plot to be made anew")

    def test_goes_with_its_document(self):
        FreeCAD.closeDocument(self.doc.Name)
        self.pump()
        self.assertIsNone(self.dock.source.plot)
        self.doc = FreeCAD.newDocument("Other")
