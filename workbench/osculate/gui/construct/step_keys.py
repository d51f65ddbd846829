"""Ctrl+Z and Ctrl+Y while a panel is open: its own steps, not those of the document."""

import FreeCADGui

from osculate.gui.qt import Qt, QtCore, QtGui


class StepKeys(QtCore.QObject):
    """Sees the keys before FreeCAD makes commands of them."""

    def __init__(self, back, forward):
        super().__init__()
        self._back, self._forward = back, forward
        FreeCADGui.getMainWindow().installEventFilter(self)

    def stop(self):
        FreeCADGui.getMainWindow().removeEventFilter(self)

    def eventFilter(self, _window, event):
        # Qt asks every widget around the focus, the window last, before it looks for a shortcut.
        if event.type() != QtCore.QEvent.Type.ShortcutOverride:
            return False
        reaction = self._reaction(event)
        if reaction is None:
            return False
        event.accept()
        reaction()
        return True

    def _reaction(self, event):
        keys = QtGui.QKeySequence.StandardKey
        if event.matches(keys.Undo):
            return self._back
        is_ctrl_y = (event.key() == Qt.Key.Key_Y
                     and event.modifiers() == Qt.KeyboardModifier.ControlModifier)
        return self._forward if is_ctrl_y or event.matches(keys.Redo) else None
