"""The command Check validity."""

import FreeCAD
from FreeCAD import Qt

from osculate.gui.commands.command import SolidCommand, show_panel
from osculate.gui.solid_panel.selected import take_selected_solids
from osculate.gui.solid_panel.validity_panel import ValidityPanel

QT_TRANSLATE_NOOP = Qt.QT_TRANSLATE_NOOP


class CheckValidity(SolidCommand):
    """Opens the panel on the selected solids."""

    name = "Osculate_CheckValidity"
    icon = "solid-validity"
    menu_text = QT_TRANSLATE_NOOP("Osculate_CheckValidity", "Check validity")
    tool_tip = QT_TRANSLATE_NOOP(
        "Osculate_CheckValidity",
        "Proves whether the selected Bézier solids fold over themselves, and shows where.")

    def Activated(self):
        show_panel(ValidityPanel(FreeCAD.ActiveDocument, take_selected_solids()))
