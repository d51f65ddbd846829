"""The command Check contact."""

import FreeCAD
from FreeCAD import Qt

from osculate.gui.commands.command import SolidCommand, show_panel
from osculate.gui.solid_panel.contact_panel import ContactPanel
from osculate.gui.solid_panel.selected import take_selected_solids

QT_TRANSLATE_NOOP = Qt.QT_TRANSLATE_NOOP


class CheckContact(SolidCommand):
    """Opens the panel on two selected solids."""

    name = "Osculate_CheckContact"
    icon = "solid-contact"
    least = most = 2
    menu_text = QT_TRANSLATE_NOOP("Osculate_CheckContact", "Check contact")
    tool_tip = QT_TRANSLATE_NOOP(
        "Osculate_CheckContact",
        "Finds the face over which the two selected Bézier solids meet, and the highest C^s there; "
        "the check follows them.")

    def Activated(self):
        show_panel(ContactPanel(FreeCAD.ActiveDocument, solids=take_selected_solids()))
