"""The one file that knows which Qt FreeCAD brings; the rest of the GUI imports Qt from here.

FreeCAD's shim `PySide` stands for PySide2 on 0.20 and 1.0 and for PySide6 on 1.1; on 0.20 it has no
QtWidgets, the widgets are in its QtGui.
"""

from FreeCAD import Qt as _FreeCADQt
from PySide import QtCore, QtGui

try:
    from PySide import QtWidgets
except ImportError:
    QtWidgets = QtGui

Qt = QtCore.Qt
Signal = QtCore.Signal
Slot = QtCore.Slot
translate = _FreeCADQt.translate


def button_bits(*buttons):
    """Standard buttons of a dialog as the integer that FreeCAD's task panels want."""
    bits = 0
    for button in buttons:
        bits |= int(getattr(button, "value", button))  # Qt 6 enumerations keep it in `value`
    return bits


def mouse_position(event):
    """(x, y) of a mouse event in its widget."""
    place = event.position() if hasattr(event, "position") else event.localPos()
    return place.x(), place.y()
