"""What the tests of the dock Curve plot have in common."""

import FreeCADGui

from gui_case import GuiCase, QTest
from osculate.gui.plot.plot_dock import the_dock
from osculate.gui.qt import Qt, QtCore, QtGui, QtWidgets


class PlotCase(GuiCase):
    def setUp(self):
        super().setUp()
        self.dock = the_dock()
        self.tools = self.dock.form
        self.tools.lock.setChecked(False)
        self.tools.follow.setChecked(True)
        for quantity, box in self.tools.boxes.items():
            box.setChecked(quantity != "torsion_rate")

    def tearDown(self):
        self.dock.close()
        super().tearDown()

    def plot(self, *targets):
        """The command on a selection; returns the CurvePlot."""
        self.select(*targets)
        FreeCADGui.runCommand("Osculate_CurvePlot")
        self.wait_for(lambda: self.dock.source.plot is not None, "the plot")
        self.pump()
        return self.dock.source.plot

    @property
    def canvas(self):
        return self.tools.canvas

    def place_of(self, s, quantity="curvature"):
        """Where an arc length is in the canvas, in the middle of the axes of a quantity."""
        axes = self.canvas.drawing.axes[quantity]
        box = self.canvas._box_of(axes)
        return QtCore.QPoint(round(self.canvas._place_of(axes, s, 0.0).x()),
                             round(box.center().y()))

    def move_to(self, s):
        """Moves the mouse over the plot to an arc length."""
        QTest.mouseMove(self.canvas, self.place_of(s) + QtCore.QPoint(5, 0))
        QTest.mouseMove(self.canvas, self.place_of(s))
        self.wait_for(lambda: self.canvas._cursor is not None, "the cursor")
        self.pump()

    def wheel(self, widget, place, angle, modifiers=Qt.KeyboardModifier.NoModifier):
        event = QtGui.QWheelEvent(
            QtCore.QPointF(place), QtCore.QPointF(widget.mapToGlobal(place)),
            QtCore.QPoint(0, 0), QtCore.QPoint(0, angle), Qt.MouseButton.NoButton, modifiers,
            Qt.ScrollPhase.NoScrollPhase, False)
        QtWidgets.QApplication.sendEvent(widget, event)
        self.pump()
