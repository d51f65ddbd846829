"""What the commands have in common."""

import FreeCAD
import FreeCADGui

from osculate.gui import resources
from osculate.gui.task_dock import widen_dock


class Command:
    """Base of a command: a subclass names itself and says what it does when it is run."""

    name = ""       #: as FreeCAD knows it, "Osculate_..."
    icon = ""       #: of resources/icons, without ending
    menu_text = ""  #: marked with QT_TRANSLATE_NOOP under the command's name
    tool_tip = ""   #: likewise

    def GetResources(self):
        return {"Pixmap": resources.icon_path(self.icon), "MenuText": self.menu_text,
                "ToolTip": self.tool_tip}

    def IsActive(self):
        """There is a document, and no other task is open."""
        return FreeCAD.ActiveDocument is not None and not FreeCADGui.Control.activeDialog()

    def Activated(self):
        raise NotImplementedError


class ConstructCommand(Command):
    """Base of a command that opens the panel of a construction on what is selected."""

    panel = None  #: the class of the ConstructPanel

    def Activated(self):
        panel = self.panel(FreeCAD.ActiveDocument)
        FreeCADGui.Control.showDialog(panel)
        widen_dock(panel.form)
        panel.take_selection()
