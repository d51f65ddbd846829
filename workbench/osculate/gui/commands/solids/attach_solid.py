"""The command Attach neighbour."""

from FreeCAD import Qt

from osculate.gui.commands.command import DerivedCommand
from osculate.gui.solid_panel.attach_panel import AttachPanel

QT_TRANSLATE_NOOP = Qt.QT_TRANSLATE_NOOP


class AttachSolid(DerivedCommand):
    """Opens the panel on the selected solid."""

    name = "Osculate_AttachSolid"
    icon = "solid-attach"
    panel = AttachPanel
    menu_text = QT_TRANSLATE_NOOP("Osculate_AttachSolid", "Attach neighbour")
    tool_tip = QT_TRANSLATE_NOOP(
        "Osculate_AttachSolid",
        "Makes a Bézier solid that meets the selected one over a face with contact C0, C1, …")
