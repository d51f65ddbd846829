"""How a CurvatureComb is seen: in the tree, and drawn over the model."""

import numpy
from pivy import coin

from osculate.comb_drawing import size_of
from osculate.features.curvature_comb import CurvatureComb, scale_of
from osculate.gui import colors, comb_words, preferences, resources
from osculate.gui.comb.comb_legend import LINE, CombLegend, legend_picture
from osculate.gui.editable_view import OneModeView
from osculate.gui.observers import ModelObserver
from osculate.gui.overlays import nodes
from osculate.gui.overlays.comb_nodes import (
    JUMP_COLOR, MARK_LOOKS, CombLook, CombNodes, shown_marks)
from osculate.gui.overlays.legend import Legend
from osculate.gui.qt import translate

_DRAWN_AFTER = ("EdgeCount", "Status", "Quantity", "AutoScale", "Scale", "Factor", "Teeth",
                "Envelope", "Marks", "Legend")


class CurvatureCombView(OneModeView):
    """View provider proxy of a CurvatureComb; documents name this class.

    It follows the model while an edge is edited, before anything is recomputed; a hidden one does
    nothing until it is shown.
    """

    mode = "Comb"

    def attach(self, vobj):
        super().attach(vobj)
        self._document = vobj.Object.Document.Name
        self._to_world = coin.SoMatrixTransform()
        self._comb = CombNodes()
        self._legend = Legend(self._document, vobj.Object.Name, legend_picture)
        vobj.addDisplayMode(nodes.separator(
            nodes.separator(self._to_world, nodes.untouchable(self._comb.node)),
            self._legend.node), self.mode)
        self._observer = ModelObserver(self._follow, self._document_closed)

    def getIcon(self):
        return resources.icon_path("curvature-comb")

    def make_panel(self, obj):
        from osculate.gui.comb.comb_panel import CombPanel
        return CombPanel(obj.Document, obj)

    def updateData(self, _obj, prop):
        if prop in _DRAWN_AFTER:
            self._draw()

    def onChanged(self, _vobj, prop):
        if prop == "Visibility":
            self._draw()

    def _document_closed(self, name):
        if name == self._document:
            self._observer.stop()

    def _obj(self):
        """The document object; None before it is complete, and while it is deleted."""
        obj = getattr(self, "_object", None)
        try:
            is_complete = (isinstance(obj.Proxy, CurvatureComb) and hasattr(obj, "SchemaVersion")
                           and obj.Document.getObject(obj.Name) is not None)
        except (AttributeError, ReferenceError, RuntimeError):
            return None
        return obj if is_complete else None

    def _follow(self):
        """The model changed."""
        obj = self._obj()
        if obj is not None and obj.ViewObject.Visibility and (
                obj.Proxy.follow(obj) or self._was_deleted()):
            self._draw()

    def _was_deleted(self):
        """Undo brought the object back: its legend went with it."""
        return self._object.Legend and not self._legend.is_shown

    def _draw(self):
        obj = self._obj()
        if obj is None or not hasattr(self, "_legend"):
            return
        if not obj.ViewObject.Visibility:
            self._legend.remove()
            return
        obj.Proxy.follow(obj)  # it may have been loaded, or hidden while the model changed
        comb = obj.Proxy.result
        if comb is None:
            self._comb.clear()
            self._legend.remove()
        else:
            self._draw_comb(obj, comb)

    def _draw_comb(self, obj, comb):
        color = colors.QUANTITIES[obj.Quantity]
        look = CombLook(obj.Teeth, obj.Envelope, obj.Marks)
        scale = scale_of(obj)
        self._to_world.matrix = _matrix_from_world(obj)
        self._comb.show(comb, obj.Quantity, scale, size_of([comb]), color, look)
        if obj.Legend:
            rows = tuple(_legend_rows(comb, obj.Quantity, scale, self._comb, look))
            self._legend.show(CombLegend(comb_words.title_of(obj.Quantity), color, rows),
                              preferences.load().label_points)
        else:
            self._legend.remove()


def _matrix_from_world(obj):
    """Takes back the placement of an App::Part around the object: combs have world coordinates."""
    parent = obj.getParentGeoFeatureGroup()
    if parent is None:
        return coin.SbMatrix.identity()
    matrix = numpy.reshape(parent.getGlobalPlacement().inverse().toMatrix().A, (4, 4))
    return coin.SbMatrix(*map(float, matrix.T.ravel()))  # Coin multiplies rows


def _legend_rows(comb, quantity, scale, drawn, look):
    """(key, text) pairs for legend_picture."""
    if scale is None:
        yield None, translate("Osculate", "zero everywhere")
    else:
        yield LINE, comb_words.scale_text(quantity, scale)
        largest = float(numpy.nanmax(numpy.abs(getattr(comb, quantity))))
        yield None, translate("Osculate", "largest {}").format(
            comb_words.value_text(quantity, largest))
    if drawn.cut:
        yield None, translate("Osculate", "{} teeth cut").format(drawn.cut)
    if drawn.jumps and look.envelope:
        yield ("bar", JUMP_COLOR, True), f"{drawn.jumps} × " + translate("Osculate", "jump")
    kinds = [mark.kind for mark in shown_marks(comb, quantity)] if look.marks else []
    for kind, key in MARK_LOOKS.items():
        if kind in kinds:
            yield key, f"{kinds.count(kind)} × {comb_words.mark_name(kind)}"
