"""How an Audit is seen: in the tree, and drawn over the model."""

from osculate.features.audit import Audit
from osculate.gui import preferences, resources
from osculate.gui.audit import audit_words
from osculate.gui.editable_view import OneModeView
from osculate.gui.observers import Later, UndoObserver
from osculate.gui.overlays import nodes
from osculate.gui.overlays.audit_nodes import AuditNodes, color_key
from osculate.gui.overlays.legend import Legend
from osculate.gui.overlays.rows_legend import RowsLegend, legend_picture
from osculate.gui.overlays.world import matrix_from_world
from osculate.gui.qt import translate

_DRAWN_AFTER = ("Joins", "Status", "Required", "Drawn", "MostLabels", "Legend")


class AuditView(OneModeView):
    """View provider proxy of an Audit; documents name this class.

    A hidden one draws nothing until it is shown.
    """

    mode = "Joins"

    def attach(self, vobj):
        super().attach(vobj)
        self._joins = AuditNodes()
        self._to_world = self._joins.to_world
        self._legend = Legend(vobj.Object.Document.Name, vobj.Object.Name, legend_picture)
        vobj.addDisplayMode(nodes.separator(self._joins.node, self._legend.node), self.mode)
        self._observer = UndoObserver(vobj.Object.Document.Name, self._undone)
        self._later = Later(self._draw)
        self._later.start()  # of one that was loaded nothing changes

    def getIcon(self):
        return resources.icon_path("audit")

    def make_panel(self, obj):
        from osculate.gui.audit.audit_panel import AuditPanel
        return AuditPanel(obj.Document, obj)

    def edit_row(self, edges):
        """Opens the panel on the worst join of a pair of edges."""
        self.doubleClicked(self._object.ViewObject)
        if self._panel is not None:
            self._panel.show_row(edges)

    def updateData(self, _obj, prop):
        if prop in _DRAWN_AFTER:
            self._draw()

    def onChanged(self, _vobj, prop):
        if prop == "Visibility":
            self._draw()

    def _undone(self):
        """The model may be as it was when another result was found, or the object be back."""
        obj = self.complete_object(Audit)
        if obj is not None:
            obj.Proxy.look_again()
            self._draw()

    def _draw(self):
        obj = self.complete_object(Audit)
        if obj is None or not hasattr(self, "_legend"):
            return
        audited = obj.Proxy.audited(obj) if obj.ViewObject.Visibility else None
        if audited is None:
            self._joins.clear()
            self._legend.remove()
            return
        below = {"all": None, "out of tolerance": obj.Required, "none": -1}[obj.Drawn]
        self._to_world.matrix = matrix_from_world(obj)
        self._joins.show(audited.rows, below, obj.Required, obj.MostLabels,
                         preferences.load().label_points)
        if obj.Legend:
            self._legend.show(RowsLegend(obj.Label, tuple(self._legend_rows(obj))),
                              preferences.load().label_points)
        else:
            self._legend.remove()

    def _legend_rows(self, obj):
        """(key, text) pairs for legend_picture."""
        if obj.Proxy.error:
            yield None, translate("Osculate", "out of date")
        for order, count in self._joins.counts.items():
            yield color_key(order), f"{count:,} × {audit_words.order_name(order)}"
        if self._joins.labels < self._joins.out_of_tolerance:
            yield None, translate("Osculate", "the worst {} of {} numbered").format(
                f"{self._joins.labels:,}", f"{self._joins.out_of_tolerance:,}")
