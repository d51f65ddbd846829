"""How a JoinCheck is seen: an icon by verdict in the tree, a label at the join in the 3D view."""

import json

import FreeCADGui
from pivy import coin

from osculate.gui import preferences, resources
from osculate.gui.overlays import nodes
from osculate.gui.overlays.join_overlay import label_node
from osculate.gui.task_dock import widen_dock
from osculate.gui.verdict import ERROR_LOOK, look_of

_MODE = "Label"


class JoinCheckView:
    """View provider proxy of a JoinCheck.

    Documents name this class: keep module and name.
    """

    def __init__(self, vobj):
        vobj.Proxy = self

    def attach(self, vobj):
        self._object = vobj.Object
        self._root = coin.SoSeparator()
        self._panel = None  #: open while the object is edited
        vobj.addDisplayMode(self._root, _MODE)
        self._show_label()

    def getDisplayModes(self, _vobj):
        return [_MODE]

    def getDefaultDisplayMode(self):
        return _MODE

    def setDisplayMode(self, mode):
        return mode

    def getIcon(self):
        return resources.icon_path(_look(self._object).icon)

    def updateData(self, obj, prop):
        if prop == "Verdicts":  # the last that a recompute sets
            self._show_label()
            obj.ViewObject.signalChangeIcon()

    def doubleClicked(self, vobj):
        FreeCADGui.getDocument(vobj.Object.Document.Name).setEdit(vobj.Object.Name)
        return True

    def setEdit(self, vobj, mode):
        if mode != 0:
            return False
        from osculate.gui.panel.edit_panel import EditPanel
        if FreeCADGui.Control.activeDialog():
            return False
        self._panel = EditPanel(vobj.Object)
        self._show_label()
        FreeCADGui.Control.showDialog(self._panel)
        widen_dock(self._panel.form)
        return True

    def unsetEdit(self, _vobj, mode):
        panel, self._panel = self._panel, None
        if panel is not None:
            panel.finish()
        self._show_label()
        return mode == 0

    def _show_label(self):
        self._root.removeAllChildren()
        obj = self._object
        if self._panel is None and getattr(obj, "Verdicts", None):
            verdict = obj.Order, obj.Verdicts, obj.Residuals
            surroundings = [(side["tangent"], side["normal"], side["segment"]["poles"])
                            for side in json.loads(obj.Report)["sides"]]
            self._root.addChild(nodes.untouchable(
                label_node(obj.Position, verdict, preferences.load(), surroundings)))

    def dumps(self):
        return None

    def loads(self, _state):
        return None

    __getstate__ = dumps
    __setstate__ = loads


def _look(obj):
    verdicts = getattr(obj, "Verdicts", None)
    return look_of(obj.Order, verdicts) if verdicts else ERROR_LOOK
