"""The workbench Osculate: what its toolbar and menu hold."""

import FreeCADGui
from FreeCAD import Qt

from osculate.gui import resources

QT_TRANSLATE_NOOP = Qt.QT_TRANSLATE_NOOP


class OsculateWorkbench(FreeCADGui.Workbench):
    """Registered by InitGui.py; FreeCAD keeps the class's name in the user's configuration."""

    MenuText = "Osculate"
    ToolTip = QT_TRANSLATE_NOOP("Workbench", "Geometric continuity G0 to G4 of curves, "
                                             "Bézier solids")
    Icon = resources.icon_path("osculate")

    def Initialize(self):
        from osculate.gui import commands  # the panel's modules are loaded when they are used
        curves, solids = commands.register()
        self.appendToolbar(QT_TRANSLATE_NOOP("Workbench", "Osculate"), curves)
        # In ASCII: when the language changes FreeCAD 0.20 reads these names as Latin-1.
        self.appendToolbar(QT_TRANSLATE_NOOP("Workbench", "Bezier solids"), solids)
        self.appendMenu(QT_TRANSLATE_NOOP("Workbench", "&Osculate"), curves)
        self.appendMenu(QT_TRANSLATE_NOOP("Workbench", "&Bezier solids"), solids)

    def GetClassName(self):
        return "Gui::PythonWorkbench"
