"""The command Match."""

from FreeCAD import Qt

from osculate.gui.commands.command import ConstructCommand
from osculate.gui.construct.match_panel import MatchPanel

QT_TRANSLATE_NOOP = Qt.QT_TRANSLATE_NOOP


class Match(ConstructCommand):
    """Opens the panel on the selected edges; the panel asks for those that are missing."""

    name = "Osculate_Match"
    icon = "match"
    panel = MatchPanel
    menu_text = QT_TRANSLATE_NOOP("Osculate_Match", "Match")
    tool_tip = QT_TRANSLATE_NOOP(
        "Osculate_Match",
        "Changes an edge as little as possible so that it meets another one with continuity G0 to "
        "G4.\nSelect the edge that stays, then the edge that changes, or click first and select "
        "then.")
