"""The command Project from 4D."""

from FreeCAD import Qt

from osculate.gui.commands.command import DerivedCommand
from osculate.gui.solid_panel.project_panel import ProjectPanel
from osculate.gui.solid_panel.selected import selected_solids

QT_TRANSLATE_NOOP = Qt.QT_TRANSLATE_NOOP


class ProjectSolid(DerivedCommand):
    """Opens the panel on the selected solid of four dimensions."""

    name = "Osculate_ProjectSolid"
    icon = "solid-project"
    panel = ProjectPanel
    menu_text = QT_TRANSLATE_NOOP("Osculate_ProjectSolid", "Project from 4D")
    tool_tip = QT_TRANSLATE_NOOP(
        "Osculate_ProjectSolid",
        "Makes the image of the selected Bézier solid of four dimensions in three, parallel or "
        "from a point.")

    def IsActive(self):
        return super().IsActive() and bool(selected_solids()[0].FourthCoordinates)
