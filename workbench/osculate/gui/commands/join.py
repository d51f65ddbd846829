"""The command Join."""

from FreeCAD import Qt

from osculate.gui.commands.command import ConstructCommand
from osculate.gui.construct.joined_panel import JoinedPanel

QT_TRANSLATE_NOOP = Qt.QT_TRANSLATE_NOOP


class Join(ConstructCommand):
    """Opens the panel on the selected edges; the panel asks for more."""

    name = "Osculate_Join"
    icon = "join"
    panel = JoinedPanel
    menu_text = QT_TRANSLATE_NOOP("Osculate_Join", "Join")
    tool_tip = QT_TRANSLATE_NOOP(
        "Osculate_Join",
        "Makes one B-spline of the edges of a chain, with as few knots as their continuity allows."
        "\nSelect edges, or a whole wire or sketch.")
