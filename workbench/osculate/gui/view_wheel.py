"""Ctrl and the mouse wheel over the 3D views, before FreeCAD zooms."""

import FreeCADGui

from osculate.gui.canvas import widgets_of
from osculate.gui.qt import Qt, QtCore, Signal

_NOTCH = 120.0  # of a wheel, in Qt's eighths of a degree


class ViewWheel(QtCore.QObject):
    """Watches all 3D views of a document."""

    turned = Signal(float)  #: notches, positive away from the user

    def __init__(self, document_name):
        super().__init__()
        self._document = document_name
        self._watched = {}  # view -> its widgets
        self.watch_new_views()

    def watch_new_views(self):
        document = FreeCADGui.getDocument(self._document)
        for view in document.mdiViewsOfType("Gui::View3DInventor"):
            if view not in self._watched:
                self._watched[view] = widgets_of(view) or ()
                for widget in self._watched[view]:
                    widget.installEventFilter(self)

    def stop(self):
        watched, self._watched = self._watched, {}
        for widgets in watched.values():
            for widget in widgets:
                try:
                    widget.removeEventFilter(self)
                except RuntimeError:
                    pass  # the view was closed, and its widgets are gone

    def eventFilter(self, _widget, event):
        if (event.type() != QtCore.QEvent.Type.Wheel
                or not event.modifiers() & Qt.KeyboardModifier.ControlModifier):
            return False
        event.accept()  # else Qt gives it to the parent too
        self.turned.emit(event.angleDelta().y() / _NOTCH)
        return True
