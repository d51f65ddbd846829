"""The command Extend."""

from FreeCAD import Qt

from osculate.gui.commands.command import ConstructCommand
from osculate.gui.construct.extend_panel import ExtendPanel

QT_TRANSLATE_NOOP = Qt.QT_TRANSLATE_NOOP


class Extend(ConstructCommand):
    """Opens the panel on the selected edge; the panel asks for one where there is none."""

    name = "Osculate_Extend"
    icon = "extend"
    panel = ExtendPanel
    menu_text = QT_TRANSLATE_NOOP("Osculate_Extend", "Extend")
    tool_tip = QT_TRANSLATE_NOOP(
        "Osculate_Extend",
        "Continues an edge beyond one of its ends with continuity G0 to G4: to a length, a point, "
        "a direction, a curvature.\nSelect the edge near the end, or click first and select then.")
