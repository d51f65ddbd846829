"""Watches the mouse and the keys over all 3D views of a document, before FreeCAD sees them."""

import FreeCADGui

from osculate.gui.canvas import widgets_of
from osculate.gui.qt import QtCore, mouse_position


class ViewWatcher(QtCore.QObject):
    """Base of event filters; a subclass has an `eventFilter`."""

    def __init__(self, document_name):
        super().__init__()
        self.document_name = document_name
        self._watched = {}  # view -> its widgets
        self.watch_new_views()

    def watch_new_views(self):
        """Takes in views that were opened meanwhile."""
        document = FreeCADGui.getDocument(self.document_name)
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

    def canvas_view(self, widget):
        """The view whose canvas, which has the mouse, a widget is; None for other widgets."""
        return next((view for view, widgets in self._watched.items()
                     if widgets and widgets[1] is widget), None)


def pixel_of(event, canvas):
    """Where the mouse is in a canvas, in pixels of the device from the lower left."""
    x, y = mouse_position(event)
    density = canvas.devicePixelRatioF()
    return x * density, (canvas.height() - 1 - y) * density
