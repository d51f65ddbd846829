"""Handles in the 3D view, used with the mouse."""

from gui_case import QTest
from osculate.gui.canvas import widgets_of
from osculate.gui.overlays.screen import Screen
from osculate.gui.qt import Qt, QtCore, QtGui, QtWidgets


class MouseUser:
    """Mixed into a test case, in front of it: the mouse in the widget `canvas` of a 3D view."""

    def setUp(self):
        super().setUp()
        _, self.canvas = widgets_of(self.view())

    def tearDown(self):
        self.canvas = None  # PySide would take it for the next one at the same address
        super().tearDown()

    def press_at(self, place):
        self.move_to(place, Qt.MouseButton.NoButton)
        QTest.mousePress(self.canvas, Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier,
                         place)

    def move_to(self, place, buttons=Qt.MouseButton.LeftButton):
        """As QTest.mouseMove, which asks the X server to move the pointer, and does not wait."""
        event = QtGui.QMouseEvent(
            QtCore.QEvent.Type.MouseMove, QtCore.QPointF(place),
            QtCore.QPointF(self.canvas.mapToGlobal(place)), Qt.MouseButton.NoButton, buttons,
            Qt.KeyboardModifier.NoModifier)
        QtWidgets.QApplication.sendEvent(self.canvas, event)
        self.pump()

    def let_go_at(self, place):
        QTest.mouseRelease(self.canvas, Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier,
                           place)
        self.pump()


class HandleUser(MouseUser):
    """Mixed into a test case, in front of it; `handles()` of the class says where they are."""

    def handles(self):
        """The Handles as they are now."""
        raise NotImplementedError

    def handle(self, key):
        return {handle.key: handle for handle in self.handles()}[key]

    def place(self, key, distance=None):
        """Where a handle is in the canvas, or would be at a distance in mm."""
        handle, screen = self.handle(key), Screen(self.view())
        seen = screen.beside(handle.at(handle.distance), handle.direction, handle.aside)
        aside = [x - y for x, y in zip(seen, handle.at(handle.distance))]
        point = handle.at(handle.distance if distance is None else distance)
        x, y = screen.pixel_of([a + b for a, b in zip(point, aside)])
        return QtCore.QPoint(round(x), self.canvas.height() - 1 - round(y))

    def drag(self, key, distance):
        """Drags a handle to a distance in mm, in two moves."""
        start, target = self.place(key), self.place(key, distance)
        self.press_at(start)
        self.move_to((start + target) / 2)
        self.move_to(target)
        self.let_go_at(target)
