"""How a CurvatureComb is seen: in the tree, and drawn over the model."""

import numpy

from osculate.comb_drawing import size_of
from osculate.features.curvature_comb import scale_of
from osculate.gui import colors, comb_words, resources
from osculate.gui.edge_overlay_view import EdgeOverlayView
from osculate.gui.overlays.comb_nodes import (
    JUMP_COLOR, MARK_LOOKS, CombLook, CombNodes, shown_marks)
from osculate.gui.overlays.rows_legend import LINE, RowsLegend
from osculate.gui.qt import translate


class CurvatureCombView(EdgeOverlayView):
    """View provider proxy of a CurvatureComb; documents name this class."""

    mode = "Comb"
    drawn_after = (*EdgeOverlayView.drawn_after, "Quantity", "AutoScale", "Scale", "Factor",
                   "Teeth", "Envelope", "Marks")

    def getIcon(self):
        return resources.icon_path("curvature-comb")

    def make_panel(self, obj):
        from osculate.gui.comb.comb_panel import CombPanel
        return CombPanel(obj.Document, obj)

    def make_drawing(self):
        return CombNodes()

    def draw(self, drawing, obj, result):
        color = colors.QUANTITIES[obj.Quantity]
        look = CombLook(obj.Teeth, obj.Envelope, obj.Marks)
        scale = scale_of(obj)
        drawing.show(result, obj.Quantity, scale, size_of([result]), color, look)
        return RowsLegend(comb_words.title_of(obj.Quantity),
                          tuple(_legend_rows(result, obj.Quantity, scale, drawing, look)))


def _legend_rows(comb, quantity, scale, drawn, look):
    """(key, text) pairs of a RowsLegend."""
    if scale is None:
        yield None, translate("Osculate", "zero everywhere")
    else:
        yield (LINE, colors.QUANTITIES[quantity]), comb_words.scale_text(quantity, scale)
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
