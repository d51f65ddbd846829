"""How a JoinCheck is seen: an icon by verdict in the tree, a label at the join in the 3D view."""

import json

from pivy import coin

from osculate.gui import preferences, resources
from osculate.gui.editable_view import OneModeView
from osculate.gui.overlays import nodes
from osculate.gui.overlays.join_overlay import label_node
from osculate.gui.verdict import ERROR_LOOK, look_of


class JoinCheckView(OneModeView):
    """View provider proxy of a JoinCheck.

    Documents name this class: keep module and name.
    """

    mode = "Label"

    def attach(self, vobj):
        super().attach(vobj)
        self._root = coin.SoSeparator()
        vobj.addDisplayMode(self._root, self.mode)
        self._show_label()

    def getIcon(self):
        return resources.icon_path(_look(self._object).icon)

    def updateData(self, obj, prop):
        if prop == "Verdicts":  # the last that a recompute sets
            self._show_label()
            obj.ViewObject.signalChangeIcon()

    def make_panel(self, obj):
        from osculate.gui.panel.edit_panel import EditPanel
        return EditPanel(obj)

    def editing_changed(self):
        self._show_label()

    def _show_label(self):
        self._root.removeAllChildren()
        obj = self._object
        if self._panel is None and getattr(obj, "Verdicts", None):
            verdict = obj.Order, obj.Verdicts, obj.Residuals
            surroundings = [(side["tangent"], side["normal"], side["segment"]["poles"])
                            for side in json.loads(obj.Report)["sides"]]
            self._root.addChild(nodes.untouchable(
                label_node(obj.Position, verdict, preferences.load(), surroundings)))


def _look(obj):
    verdicts = getattr(obj, "Verdicts", None)
    return look_of(obj.Order, verdicts) if verdicts else ERROR_LOOK
