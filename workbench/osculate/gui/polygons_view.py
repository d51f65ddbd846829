"""How ControlPolygons are seen: in the tree, and drawn over the model."""

import numpy

from osculate.features.control_polygons import PLAIN, arrows_of
from osculate.gui import colors, numbers, preferences, resources
from osculate.gui.edge_overlay_view import EdgeOverlayView
from osculate.gui.overlays.polygon_nodes import PolygonLook, PolygonNodes
from osculate.gui.overlays.rows_legend import LINE, RowsLegend
from osculate.gui.qt import translate

_NAMES = {PLAIN: ("Δb", "Δ²b"), "derivatives": ("n Δb", "n (n−1) Δ²b")}


class ControlPolygonsView(EdgeOverlayView):
    """View provider proxy of a ControlPolygons; documents name this class."""

    mode = "Polygons"
    drawn_after = (*EdgeOverlayView.drawn_after, "Weights", "FirstDifferences",
                   "SecondDifferences", "DifferenceScale")

    def getIcon(self):
        return resources.icon_path("control-polygons")

    def make_panel(self, obj):
        from osculate.gui.polygons.polygons_panel import PolygonsPanel
        return PolygonsPanel(obj.Document, obj)

    def make_drawing(self):
        return PolygonNodes()

    def draw(self, drawing, obj, result):
        look = PolygonLook(obj.Weights, (obj.FirstDifferences, obj.SecondDifferences),
                           obj.DifferenceScale)
        drawing.show(result, look, preferences.load().label_points)
        return RowsLegend(translate("Osculate", "Control polygons"),
                          tuple(_legend_rows(result, look, drawing)))


def _legend_rows(polygons, look, drawn):
    yield (LINE, colors.POLYGON), segments_text(polygons)
    yield ("square", colors.POLYGON_ENDS, True), translate("Osculate", "end of a segment")
    if not polygons.ends.all():
        yield ("circle", colors.POLYGON, True), translate("Osculate", "inner pole")
    for order, is_shown in enumerate(look.differences, 1):
        if is_shown:
            yield (LINE, colors.DIFFERENCES[order - 1]), _difference_text(polygons, look, drawn,
                                                                          order)
    rational = int(polygons.is_rational.sum())
    if rational and look.scaling != PLAIN and any(look.differences):
        yield None, translate("Osculate", "none of {} rational segments").format(rational)
    if look.weights and not rational:
        yield None, translate("Osculate", "all weights are 1")
    if drawn.hidden_weights:
        yield None, translate("Osculate", "{} weights not shown").format(drawn.hidden_weights)


def segments_text(polygons):
    """"3 segments, degree 3, 5"."""
    degrees = ", ".join(map(str, numpy.unique(polygons.degrees).tolist()))
    count = len(polygons.counts)
    if count == 1:
        return translate("Osculate", "1 segment, degree {}").format(degrees)
    return translate("Osculate", "{} segments, degree {}").format(count, degrees)


def _difference_text(polygons, look, drawn, order):
    name = _NAMES[look.scaling][order - 1]
    if not len(arrows_of(polygons, order, look.scaling)[0].vectors):
        return f"{name}: " + translate("Osculate", "none")
    if look.scaling == PLAIN:
        return f"{name}: " + translate("Osculate", "as it is")
    return f"{name} × {numbers.number(drawn.factors[order - 1])}"
