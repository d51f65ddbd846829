"""The command Analyze join."""

import FreeCADGui
from FreeCAD import Qt

from osculate.gui.commands.command import Command
from osculate.gui.panel.join_panel import JoinPanel
from osculate.gui.task_dock import widen_dock

QT_TRANSLATE_NOOP = Qt.QT_TRANSLATE_NOOP


class AnalyzeJoin(Command):
    """Opens the panel on what is selected; the panel asks for edges where nothing is."""

    name = "Osculate_AnalyzeJoin"
    icon = "analyze-join"
    menu_text = QT_TRANSLATE_NOOP("Osculate_AnalyzeJoin", "Analyze join")
    tool_tip = QT_TRANSLATE_NOOP(
        "Osculate_AnalyzeJoin",
        "Shows which continuity G0 to G4 two edges have where they meet, and by how much each "
        "order misses.\nSelect two edges, the vertex between them, or a whole wire or sketch.")

    def Activated(self):
        panel = JoinPanel()
        FreeCADGui.Control.showDialog(panel)
        widen_dock(panel.form)
        panel.take_selection()
