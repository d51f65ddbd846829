"""What the commands have in common."""

import sys

import FreeCAD
import FreeCADGui

from osculate.gui import resources
from osculate.gui.solid_panel.selected import selected_solids, take_selected_solids
from osculate.gui.task_dock import show_panel


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


class SolidCommand(Command):
    """Base of a command on selected Bézier solids."""

    least, most = 1, sys.maxsize  #: how many it takes

    def IsActive(self):
        return super().IsActive() and self.least <= len(selected_solids()) <= self.most


class DerivedCommand(SolidCommand):
    """Base of a command that opens the panel of what is made of one selected solid."""

    most = 1
    panel = None  #: the class of the DerivedPanel

    def IsActive(self):
        return super().IsActive() and selected_solids()[0].isValid()

    def Activated(self):
        show_panel(self.panel(take_selected_solids()[0]))


class ConstructCommand(Command):
    """Base of a command that opens a panel, which makes an object of what is selected."""

    panel = None  #: the class of the panel

    def Activated(self):
        show_panel(self.panel(FreeCAD.ActiveDocument)).take_selection()
