"""The dock that holds FreeCAD's task panels."""

import FreeCADGui

from osculate.gui.qt import Qt, QtWidgets

#: Narrower, the tables of numbers would be cut; pixels at the usual 96 dots per inch.
_LEAST_WIDTH = 370


def widen_dock(form):
    """Makes the dock around a task panel wide enough, if it is narrower; never smaller."""
    dock = form.parent()
    while dock is not None and not isinstance(dock, QtWidgets.QDockWidget):
        dock = dock.parent()
    width = round(_LEAST_WIDTH * form.logicalDpiX() / 96)
    if dock is not None and dock.width() < width and not dock.isFloating():
        FreeCADGui.getMainWindow().resizeDocks([dock], [width], Qt.Orientation.Horizontal)
