"""How objects are seen that draw something along edges: over the model, live, with a legend."""

from pivy import coin

from osculate.features.edge_overlay import EdgeOverlay
from osculate.gui import preferences
from osculate.gui.editable_view import OneModeView
from osculate.gui.observers import ModelObserver
from osculate.gui.overlays import nodes
from osculate.gui.overlays.legend import Legend
from osculate.gui.overlays.rows_legend import legend_picture
from osculate.gui.overlays.world import matrix_from_world


class EdgeOverlayView(OneModeView):
    """Base of view provider proxies of an EdgeOverlay.

    It follows the model while an edge is edited, before anything is recomputed; a hidden one does
    nothing until it is shown.
    """

    drawn_after = ("EdgeCount", "Status", "Legend")  #: properties whose change is drawn

    # What a subclass does

    def make_drawing(self):
        """What is drawn; its `node` goes into the scene, its `clear()` draws nothing."""
        raise NotImplementedError

    def draw(self, drawing, obj, result):
        """Draws the result of an object in coordinates of the world; returns the RowsLegend."""
        raise NotImplementedError

    # What FreeCAD calls

    def attach(self, vobj):
        super().attach(vobj)
        self._document = vobj.Object.Document.Name
        self._to_world = coin.SoMatrixTransform()
        self._drawing = self.make_drawing()
        self._legend = Legend(self._document, vobj.Object.Name, legend_picture)
        vobj.addDisplayMode(nodes.separator(
            nodes.separator(self._to_world, nodes.untouchable(self._drawing.node)),
            self._legend.node), self.mode)
        self._observer = ModelObserver(self._follow, self._document_closed)

    def updateData(self, _obj, prop):
        if prop in self.drawn_after:
            self._draw()

    def onChanged(self, _vobj, prop):
        if prop == "Visibility":
            self._draw()

    def _document_closed(self, name):
        if name == self._document:
            self._observer.stop()

    def _follow(self):
        """The model changed."""
        obj = self.complete_object(EdgeOverlay)
        if obj is not None and obj.ViewObject.Visibility and (
                obj.Proxy.follow(obj) or self._was_deleted()):
            self._draw()

    def _was_deleted(self):
        """Undo brought the object back: its legend went with it."""
        return self._object.Legend and not self._legend.is_shown

    def _draw(self):
        obj = self.complete_object(EdgeOverlay)
        if obj is None or not hasattr(self, "_legend"):
            return
        if not obj.ViewObject.Visibility:
            self._legend.remove()
            return
        obj.Proxy.follow(obj)  # it may have been loaded, or hidden while the model changed
        result = obj.Proxy.result
        if result is None:
            self._drawing.clear()
            self._legend.remove()
            return
        self._to_world.matrix = matrix_from_world(obj)
        legend = self.draw(self._drawing, obj, result)
        if obj.Legend:
            self._legend.show(legend, preferences.load().label_points)
        else:
            self._legend.remove()
