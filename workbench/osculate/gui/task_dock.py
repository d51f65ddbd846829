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
    window = FreeCADGui.getMainWindow()
    if dock is None or window.dockWidgetArea(dock) == Qt.DockWidgetArea.NoDockWidgetArea:
        return  # it floats over the 3D view and takes the width that it needs
    width = round(_LEAST_WIDTH * form.logicalDpiX() / 96)
    if dock.width() < width:
        window.resizeDocks([dock], [width], Qt.Orientation.Horizontal)


def show_panel(panel):
    """Shows a task panel, wide enough; returns it."""
    FreeCADGui.Control.showDialog(panel)
    widen_dock(panel.form)
    return panel
