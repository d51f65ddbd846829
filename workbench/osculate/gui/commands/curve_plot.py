"""The command Curve plot."""

import FreeCAD
from FreeCAD import Qt

from osculate.gui.commands.command import Command
from osculate.gui.plot.plot_dock import show_dock

QT_TRANSLATE_NOOP = Qt.QT_TRANSLATE_NOOP


class CurvePlot(Command):
    """Opens the dock, beside whatever task is open."""

    name = "Osculate_CurvePlot"
    icon = "curve-plot"
    menu_text = QT_TRANSLATE_NOOP("Osculate_CurvePlot", "Curve plot")
    tool_tip = QT_TRANSLATE_NOOP(
        "Osculate_CurvePlot",
        "Plots curvature, torsion and their rates over the arc length of what is selected, with "
        "every join and its order.\nSelect edges, faces, sketches or whole objects.")

    def IsActive(self):
        return FreeCAD.ActiveDocument is not None

    def Activated(self):
        show_dock()
