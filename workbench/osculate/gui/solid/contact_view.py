"""How a SolidContact is seen: the shared face, the layers of control points that match, a label."""

import FreeCAD
from pivy import coin

from osculate.features.bezier_solid import value_in_document
from osculate.features.edge_link import LinkError
from osculate.features.solid_brep import source_of
from osculate.gui import preferences, resources
from osculate.gui.editable_view import OneModeView
from osculate.gui.qt import QtCore
from osculate.gui.solid.contact_node import contact_node


class ContactView(OneModeView):
    """View provider proxy of a SolidContact; documents name this class."""

    _shown = None  # the report that is drawn

    mode = "Contact"

    def attach(self, vobj):
        super().attach(vobj)
        self._root = coin.SoSeparator()
        vobj.addDisplayMode(self._root, self.mode)
        self._draw_later()

    def getIcon(self):
        return resources.icon_path("solid-contact")

    def updateData(self, obj, _prop):
        if getattr(obj.Proxy, "report", None) is not self._shown:
            self._draw()

    def make_panel(self, obj):
        from osculate.gui.solid_panel.contact_panel import ContactPanel
        return ContactPanel(obj.Document, obj)

    def _draw_later(self):
        """Draws when everything is loaded, the report of an old document only then being there."""
        if FreeCAD.isRestoring():
            QtCore.QTimer.singleShot(0, self._draw_later)
        else:
            self._draw()

    def _draw(self):
        try:
            report = getattr(self._object.Proxy, "report", None)
        except ReferenceError:
            return  # it was deleted meanwhile
        self._root.removeAllChildren()
        self._shown = report
        if report is None:
            return
        try:
            solids = [value_in_document(source_of(self._object, name))
                      for name in ("First", "Second")]
        except (LinkError, ValueError):
            return  # one changed since, and the next recompute says what is wrong with it
        self._root.addChild(contact_node(*solids, report, preferences.load().label_points))
