"""The command Blend."""

from FreeCAD import Qt

from osculate.gui.commands.command import ConstructCommand
from osculate.gui.construct.blend_panel import BlendPanel

QT_TRANSLATE_NOOP = Qt.QT_TRANSLATE_NOOP


class Blend(ConstructCommand):
    """Opens the panel on the selected edges; the panel asks for those that are missing."""

    name = "Osculate_Blend"
    icon = "blend"
    panel = BlendPanel
    menu_text = QT_TRANSLATE_NOOP("Osculate_Blend", "Blend")
    tool_tip = QT_TRANSLATE_NOOP(
        "Osculate_Blend",
        "Connects two edges by a curve that meets each with its own order of continuity, G0 to G4."
        "\nSelect two edges, or click first and select then.")
