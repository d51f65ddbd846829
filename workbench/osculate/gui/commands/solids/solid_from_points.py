"""The command Solid from points."""

import FreeCAD
from FreeCAD import Qt

from osculate.gui.commands.command import Command, show_panel
from osculate.gui.solid_panel.net_panel import NetPanel

QT_TRANSLATE_NOOP = Qt.QT_TRANSLATE_NOOP


class SolidFromPoints(Command):
    """Opens the table on a new solid."""

    name = "Osculate_SolidFromPoints"
    icon = "solid-points"
    menu_text = QT_TRANSLATE_NOOP("Osculate_SolidFromPoints", "New from points")
    tool_tip = QT_TRANSLATE_NOOP(
        "Osculate_SolidFromPoints",
        "Makes a Bézier solid of a table of control points and weights, typed, pasted or read "
        "from a file.")

    def Activated(self):
        show_panel(NetPanel(FreeCAD.ActiveDocument))
