"""How a Probe is seen: in the tree, and drawn over the model."""

from osculate.features.probe import radius_of
from osculate.gui import colors, numbers, preferences, resources
from osculate.gui.edge_overlay_view import EdgeOverlayView
from osculate.gui.overlays.construction_nodes import color_of_level
from osculate.gui.overlays.probe_nodes import (
    PLANES, SPECIAL_LOOKS, ProbeLook, ProbeNodes, is_whole)
from osculate.gui.overlays.rows_legend import LINE, RowsLegend
from osculate.gui.probe_words import kind_name, label_lines, missing_lines
from osculate.gui.qt import translate

_MOST_LEVELS = 5  # of a construction, that have a row of the legend each


class ProbeView(EdgeOverlayView):
    """View provider proxy of a Probe; documents name this class."""

    mode = "Probe"
    drawn_after = (*EdgeOverlayView.drawn_after, "Frame", "Circle", "OsculatingPlane",
                   "NormalPlane", "RectifyingPlane", "DeCasteljau", "ReadOut", "Marks")

    def getIcon(self):
        return resources.icon_path("probe")

    def make_panel(self, obj):
        from osculate.gui.probe.probe_panel import ProbePanel
        return ProbePanel(obj.Document, obj)

    def make_drawing(self):
        return ProbeNodes()

    def draw(self, drawing, obj, result):
        chosen = preferences.load()
        probe = obj.Proxy.probe
        look = ProbeLook(
            frame=obj.Frame, circle=obj.Circle,
            planes=tuple(name for name, *_ in PLANES if getattr(obj, name)),
            construction=obj.DeCasteljau, marks=obj.Marks,
            label=label_lines(result, probe.size) if obj.ReadOut else None,
            frame_pixels=chosen.frame_pixels, text_points=chosen.label_points)
        drawing.show(probe, result, look)
        return RowsLegend(translate("Osculate", "Probe"),
                          tuple(_legend_rows(probe, result, look)))


def _legend_rows(probe, reading, look):
    if reading.kinds:
        yield None, translate("Osculate", "at: {}").format(
            ", ".join(map(kind_name, reading.kinds)))
    if look.frame:
        yield from _frame_rows(reading.geometry)
    if look.circle:
        yield from _circle_rows(reading, probe.size)
    for line in missing_lines(reading):
        yield None, line
    if look.construction:
        yield from _level_rows(reading.sides[-1])
    if look.marks:
        yield from _mark_rows(probe)


def _frame_rows(geometry):
    names = (translate("Osculate", "tangent"), translate("Osculate", "normal"),
             translate("Osculate", "binormal"))
    axes = geometry.tangent, geometry.normal, geometry.binormal
    for letter, name, axis, color in zip("tnb", names, axes, colors.FRAME):
        if axis is not None:
            yield (LINE, color), f"{letter}  {name}"


def _circle_rows(reading, size):
    radii = [radius_of(side.geometry) for side in reading.sides]
    texts = [numbers.quantity(radius, "mm") for radius in radii]
    if any(radius is not None for radius in radii):
        text = " | ".join(dict.fromkeys(texts))
        yield (LINE, colors.CIRCLE), translate("Osculate", "osculating circle, R {}").format(text)
    if any(radius is not None and not is_whole(radius, size) for radius in radii):
        yield None, translate("Osculate", "its centre is far away")


def _level_rows(side):
    if side.segment is None:
        yield None, translate("Osculate", "no construction: the segment is a point")
        return
    degree = side.segment.degree
    yield None, translate("Osculate", "de Casteljau, t = {} on the segment").format(
        numbers.number(side.t))
    yield (LINE, color_of_level(0)), translate("Osculate", "control polygon, degree {}").format(
        degree)
    for level in range(1, min(degree, _MOST_LEVELS)):
        yield (LINE, color_of_level(level)), translate("Osculate", "level {}").format(level)
    last = translate("Osculate", "level {}: the point").format(degree)
    yield ("circle", color_of_level(degree), True), ("… " if degree > _MOST_LEVELS else "") + last


def _mark_rows(probe):
    kinds = [special.kind for special in probe.specials]
    for kind, look in SPECIAL_LOOKS.items():
        count = kinds.count(kind) if kind != "closing" else kinds.count(kind) // 2
        if count:
            yield look, f"{count} × {kind_name(kind)}"
