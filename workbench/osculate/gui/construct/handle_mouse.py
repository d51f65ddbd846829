"""The mouse over handles: an event filter in front of FreeCAD's navigation and selection.

A scene node would see the mouse only where the user's style of navigation leaves it.
"""

from osculate.gui.canvas import widgets_of
from osculate.gui.qt import Qt, QtCore
from osculate.gui.view_watcher import pixel_of


class HandleMouse(QtCore.QObject):
    """Tells a HandleSet what the mouse does in one 3D view; keeps from FreeCAD what it uses."""

    def __init__(self, view, handles):
        super().__init__()
        self._view = view
        self._handles = handles
        self._watched = widgets_of(view) or ()
        self._canvas = self._watched[1] if self._watched else None
        self._reactions = {
            QtCore.QEvent.Type.MouseMove: self._moved,
            QtCore.QEvent.Type.MouseButtonPress: self._pressed,
            QtCore.QEvent.Type.MouseButtonRelease: self._released,
            QtCore.QEvent.Type.MouseButtonDblClick: self._double_clicked,
        }
        for widget in self._watched:
            widget.installEventFilter(self)

    def stop(self):
        try:
            for widget in self._watched:
                widget.removeEventFilter(self)
            if self._canvas is not None:
                self._canvas.unsetCursor()
        except RuntimeError:
            pass  # the view was closed, and its widgets are gone
        # PySide would take a reference to a dead widget for the next one at the same address.
        self._view, self._canvas, self._watched = None, None, ()

    def eventFilter(self, widget, event):
        if event.type() == QtCore.QEvent.Type.KeyPress:
            return event.key() == Qt.Key.Key_Escape and self._handles.break_off()
        reaction = self._reactions.get(event.type()) if widget is self._canvas else None
        return bool(reaction and reaction(event))

    def _moved(self, event):
        if self._handles.is_dragging:
            self._handles.drag(self._view, self._pixel(event))
            return True
        if event.buttons() != Qt.MouseButton.NoButton:
            return False
        was_over = self._handles.hot is not None
        is_over = self._handles.hover(self._view, self._pixel(event), self._density())
        if is_over:
            self._canvas.setCursor(Qt.CursorShape.PointingHandCursor)
        elif was_over:
            self._canvas.unsetCursor()
        return is_over

    def _pressed(self, event):
        return (event.button() == Qt.MouseButton.LeftButton
                and self._handles.take(self._view, self._pixel(event), self._density()))

    def _released(self, event):
        return event.button() == Qt.MouseButton.LeftButton and self._handles.let_go()

    def _double_clicked(self, event):
        return (event.button() == Qt.MouseButton.LeftButton
                and self._handles.double_click(self._view, self._pixel(event), self._density()))

    def _pixel(self, event):
        return pixel_of(event, self._canvas)

    def _density(self):
        return self._canvas.devicePixelRatioF()
