"""The command Control polygons."""

from FreeCAD import Qt

from osculate.gui.commands.command import ConstructCommand
from osculate.gui.polygons.polygons_panel import PolygonsPanel

QT_TRANSLATE_NOOP = Qt.QT_TRANSLATE_NOOP


class ControlPolygons(ConstructCommand):
    """Draws the control polygons of what is selected, and opens their panel."""

    name = "Osculate_ControlPolygons"
    icon = "control-polygons"
    panel = PolygonsPanel
    menu_text = QT_TRANSLATE_NOOP("Osculate_ControlPolygons", "Control polygons")
    tool_tip = QT_TRANSLATE_NOOP(
        "Osculate_ControlPolygons",
        "Draws the control polygon of every Bézier segment of curves, with weights and differences "
        "on demand; it stays in the document and follows every edit.\nSelect edges, faces, "
        "sketches or whole objects.")
