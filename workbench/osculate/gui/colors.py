"""The colours of Osculate, the same in icons, panels and the 3D view."""

from osculate.palette import GAP, ORDERS, QUANTITIES, SIDES, UNDECIDED, of_order

__all__ = ["CURSOR", "ERROR", "FRAME", "GAP", "MADE", "ORDERS", "QUANTITIES", "SIDES",
           "UNDECIDED", "VERDICT_TEXT", "of_order"]

#: What is constructed from them.
MADE = "#2f9e44"

#: A point that is looked at, in plots and in the 3D view.
CURSOR = "#a24bd8"

#: Tangent, normal, binormal.
FRAME = ("#e5484d", "#2f9e44", "#3b82f6")

#: Of control polygons: legs with inner poles, ends of segments, first and second differences.
POLYGON, POLYGON_ENDS = "#c98a00", "#1c86d1"
DIFFERENCES = ("#009e73", "#b8689a")

#: Of a probe: the osculating circle, and the levels of the construction of de Casteljau, which come
#: again after the last.
CIRCLE = "#c98a00"
LEVELS = ("#7c8794", "#1c86d1", "#d55e00", "#009e73", "#b8689a", "#c98a00")

ERROR = "#6b7280"

#: Text of a verdict on light and on dark widgets.
VERDICT_TEXT = {
    "pass": ("#237a35", "#6fd486"),
    "fail": ("#c01f34", "#ff8c98"),
    "undecided": ("#7040b0", "#c9a6ff"),
}
