"""View providers of objects that are edited in a task panel of Osculate."""

import FreeCADGui

from osculate.gui.task_dock import widen_dock


class EditableView:
    """Base of view provider proxies: a double-click opens the panel on the object.

    Documents name the subclasses: keep their modules and names.
    """

    _panel = None  #: open while the object is edited

    def __init__(self, vobj):
        vobj.Proxy = self

    def attach(self, vobj):
        self._object = vobj.Object

    def complete_object(self, proxy_type):
        """The document object with a proxy of this type; None before it is complete, and while it
        is deleted.
        """
        obj = getattr(self, "_object", None)
        try:
            is_complete = (isinstance(obj.Proxy, proxy_type) and hasattr(obj, "SchemaVersion")
                           and obj.Document.getObject(obj.Name) is not None)
        except (AttributeError, ReferenceError, RuntimeError, TypeError):  # no name is left
            return None
        return obj if is_complete else None

    def make_panel(self, obj):
        """The task panel that edits the object. When it ends, its `finish` is called."""
        raise NotImplementedError

    def editing_changed(self):
        """The panel was opened or closed."""

    def doubleClicked(self, vobj):
        FreeCADGui.getDocument(vobj.Object.Document.Name).setEdit(vobj.Object.Name)
        return True

    def setEdit(self, vobj, mode):
        if mode != 0 or FreeCADGui.Control.activeDialog():
            return False
        self._panel = self.make_panel(vobj.Object)
        self.editing_changed()
        FreeCADGui.Control.showDialog(self._panel)
        widen_dock(self._panel.form)
        return True

    def unsetEdit(self, _vobj, mode):
        panel, self._panel = self._panel, None
        if panel is not None:
            panel.finish()
        self.editing_changed()
        return mode == 0

    def dumps(self):
        return None

    def loads(self, _state):
        return None

    __getstate__ = dumps
    __setstate__ = loads


class OneModeView(EditableView):
    """Base of those that are drawn in one way only."""

    mode = ""  #: its name, which documents keep

    def getDisplayModes(self, _vobj):
        return [self.mode]

    def getDefaultDisplayMode(self):
        return self.mode

    def setDisplayMode(self, mode):
        return mode
