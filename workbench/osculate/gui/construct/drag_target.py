"""The mouse over what is dragged in the 3D views, and the end of a drag: the same for all of it."""

import FreeCADGui

from osculate.gui.construct.handle_mouse import HandleMouse
from osculate.gui.qt import QtCore, Signal


class DragTarget(QtCore.QObject):
    """Base of what can be dragged; a subclass has `hover`, `take`, `drag` and `double_click`."""

    let_loose = Signal()   #: a drag ended
    taken_back = Signal()  #: a drag was broken off

    def __init__(self, document_name=None):
        super().__init__()
        self._document = document_name
        self._mice = {}    # 3D view -> HandleMouse
        self.hot = None    #: which one is at the mouse
        self._held = None  # what is dragged, in the subclass's own terms

    @property
    def is_dragging(self):
        return self._held is not None

    def let_go(self):
        """The mouse was released; True if something was held."""
        return self._end_drag(self.let_loose)

    def break_off(self):
        """Escape was pressed; True if something was held."""
        return self._end_drag(self.taken_back)

    def _end_drag(self, signal):
        if self._held is None:
            return False
        self._held = None
        signal.emit()
        return True

    def _watch_new_views(self):
        """True if there were new ones."""
        views = FreeCADGui.getDocument(self._document).mdiViewsOfType("Gui::View3DInventor")
        new = [view for view in views if view not in self._mice]
        for view in new:
            self._mice[view] = HandleMouse(view, self)
        return bool(new)

    def _leave_views(self):
        """Nothing is hot, held or watched any more."""
        for mouse in self._mice.values():
            mouse.stop()
        self._mice, self.hot, self._held = {}, None, None
