"""The command Subdivide."""

from FreeCAD import Qt

from osculate.gui.commands.command import DerivedCommand
from osculate.gui.solid_panel.subdivide_panel import SubdividePanel

QT_TRANSLATE_NOOP = Qt.QT_TRANSLATE_NOOP


class SubdivideSolid(DerivedCommand):
    """Opens the panel on the selected solid."""

    name = "Osculate_SubdivideSolid"
    icon = "solid-subdivide"
    panel = SubdividePanel
    menu_text = QT_TRANSLATE_NOOP("Osculate_SubdivideSolid", "Subdivide")
    tool_tip = QT_TRANSLATE_NOOP(
        "Osculate_SubdivideSolid",
        "Cuts the selected Bézier solid, exactly: into four around a point, into eight, or into "
        "halves.")
