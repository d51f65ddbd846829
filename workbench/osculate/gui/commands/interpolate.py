"""The command Interpolate."""

from FreeCAD import Qt

from osculate.gui.commands.command import ConstructCommand
from osculate.gui.construct.interpolated_panel import InterpolatedPanel

QT_TRANSLATE_NOOP = Qt.QT_TRANSLATE_NOOP


class Interpolate(ConstructCommand):
    """Opens the panel on the selected vertices; the panel asks for more."""

    name = "Osculate_Interpolate"
    icon = "interpolate"
    panel = InterpolatedPanel
    menu_text = QT_TRANSLATE_NOOP("Osculate_Interpolate", "Interpolate")
    tool_tip = QT_TRANSLATE_NOOP(
        "Osculate_Interpolate",
        "Runs a G2 curve through points, with a tension at each."
        "\nSelect vertices, or an object for all its vertices.")
