"""The command Bézier solid."""

import FreeCAD
from FreeCAD import Qt

from osculate.gui.commands.command import Command, show_panel
from osculate.gui.solid_panel.primitive_panel import PrimitivePanel

QT_TRANSLATE_NOOP = Qt.QT_TRANSLATE_NOOP


class MakeSolid(Command):
    """Opens the panel of the kinds."""

    name = "Osculate_BezierSolid"
    icon = "bezier-solid"
    menu_text = QT_TRANSLATE_NOOP("Osculate_BezierSolid", "Bézier solid")
    tool_tip = QT_TRANSLATE_NOOP(
        "Osculate_BezierSolid",
        "Makes a rational Bézier tetrahedron: a tetrahedron, a cone, a part of a ball or of a "
        "cylinder, exactly, or a random one.")

    def Activated(self):
        show_panel(PrimitivePanel(FreeCAD.ActiveDocument))
