"""A picture of the 3D view for the page of an audit."""

from contextlib import contextmanager

import FreeCADGui

from osculate.gui.qt import Qt, QtWidgets

_WIDTH, _MOST_SHARE = 1400, 1.0  # pixels; of the height in the width


def save_view(document_name, path):
    """Saves what a 3D view of the document shows; False if it has none."""
    document = FreeCADGui.getDocument(document_name)
    views = document.mdiViewsOfType("Gui::View3DInventor")
    view = document.ActiveView
    if view not in views:
        view = views[0] if views else None
    if view is None:
        return False
    width, height = view.getSize()
    view.saveImage(path, _WIDTH, round(_WIDTH * min(height / width, _MOST_SHARE)), "Current")
    return True


@contextmanager
def waiting():
    """The cursor says that the user has to wait."""
    QtWidgets.QApplication.setOverrideCursor(Qt.CursorShape.WaitCursor)
    try:
        yield
    finally:
        QtWidgets.QApplication.restoreOverrideCursor()
