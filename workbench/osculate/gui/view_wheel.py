"""Ctrl and the mouse wheel over the 3D views, before FreeCAD zooms."""

from osculate.gui.qt import Qt, QtCore, Signal
from osculate.gui.view_watcher import ViewWatcher

_NOTCH = 120.0  # of a wheel, in Qt's eighths of a degree


class ViewWheel(ViewWatcher):
    """Watches all 3D views of a document."""

    turned = Signal(float)  #: notches, positive away from the user

    def eventFilter(self, _widget, event):
        if (event.type() != QtCore.QEvent.Type.Wheel
                or not event.modifiers() & Qt.KeyboardModifier.ControlModifier):
            return False
        event.accept()  # else Qt gives it to the parent too
        self.turned.emit(event.angleDelta().y() / _NOTCH)
        return True
