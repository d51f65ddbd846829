"""The command Export to ParaView."""

import FreeCAD
import FreeCADGui
from FreeCAD import Qt

from osculate import solids
from osculate.features.bezier_solid import value_in_document
from osculate.gui.commands.command import SolidCommand
from osculate.gui.qt import QtWidgets, translate
from osculate.gui.solid_panel.selected import selected_solids

QT_TRANSLATE_NOOP = Qt.QT_TRANSLATE_NOOP


class ExportSolid(SolidCommand):
    """Writes the selected solids into one file."""

    name = "Osculate_ExportSolid"
    icon = "solid-export"
    menu_text = QT_TRANSLATE_NOOP("Osculate_ExportSolid", "Export to ParaView")
    tool_tip = QT_TRANSLATE_NOOP(
        "Osculate_ExportSolid",
        "Writes the selected Bézier solids into one file for ParaView (.vtu), exactly, with their "
        "weights.")

    def Activated(self):
        path = QtWidgets.QFileDialog.getSaveFileName(
            FreeCADGui.getMainWindow(), translate("Osculate", "Export to ParaView"),
            FreeCAD.ActiveDocument.Label + ".vtu", translate("Osculate", "ParaView (*.vtu)"))[0]
        if path:
            export(selected_solids(), path)


def export(objects, path):
    """Writes BezierSolids; a message box says why where that fails."""
    path = path if path.lower().endswith(".vtu") else path + ".vtu"
    try:
        solids.write_vtu([value_in_document(obj) for obj in objects], path)
    except (ValueError, OSError, RuntimeError) as error:
        QtWidgets.QMessageBox.warning(FreeCADGui.getMainWindow(),
                                      translate("Osculate", "Export to ParaView"), str(error))
