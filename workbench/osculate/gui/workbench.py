"""The workbench Osculate: what its toolbar and menu hold."""

import FreeCAD
import FreeCADGui
from FreeCAD import Qt

from osculate.gui import resources

QT_TRANSLATE_NOOP = Qt.QT_TRANSLATE_NOOP


class OsculateWorkbench(FreeCADGui.Workbench):
    """Registered by InitGui.py; FreeCAD keeps the class's name in the user's configuration."""

    MenuText = "Osculate"
    ToolTip = QT_TRANSLATE_NOOP("Workbench", "Geometric continuity G0 to G4 of curves")
    Icon = resources.icon_path("osculate")

    def Initialize(self):
        try:
            from osculate.gui import commands  # the compiled core is loaded only when it is used
        except ImportError as error:
            FreeCAD.Console.PrintError(f"Osculate: {error}\n")
            return
        names = commands.register()
        self.appendToolbar(QT_TRANSLATE_NOOP("Workbench", "Osculate"), names)
        self.appendMenu(QT_TRANSLATE_NOOP("Workbench", "&Osculate"), names)

    def GetClassName(self):
        return "Gui::PythonWorkbench"
