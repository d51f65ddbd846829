"""What the tests of the panels of constructions have in common."""

import FreeCADGui

from gui_case import DARK, GuiCase
from osculate.gui.qt import QtWidgets


class ConstructCase(GuiCase):
    """A document with undo; commands, OK and Cancel."""

    command = ""  #: the name of the command

    def setUp(self):
        super().setUp()
        self.doc.UndoMode = 1

    def run_on(self, *targets):
        """The command on a selection; returns the form."""
        self.select(*targets)
        FreeCADGui.runCommand(self.command)
        return self.shown_form()

    def edit(self, obj):
        """Double-clicks an object in the tree; returns the form."""
        obj.ViewObject.doubleClicked()
        return self.shown_form()

    def shown_form(self):
        self.wait_for(lambda: self.form() is not None and self.form().isVisible(), "the panel")
        self.pump()
        return self.form()

    def press(self, name):
        """Presses OK or Cancel of the task panel."""
        standard = getattr(QtWidgets.QDialogButtonBox.StandardButton, name)
        boxes = FreeCADGui.getMainWindow().findChildren(QtWidgets.QDialogButtonBox)
        self.click(next(filter(None, (box.button(standard) for box in boxes
                                      if box.isVisible()))))

    def finish(self, name):
        self.press(name)
        self.wait_for(lambda: self.form() is None, "the panel to close")

    def names(self):
        return [obj.Name for obj in self.doc.Objects]

    def choose(self, box, data):
        """Chooses an entry of a combo box as the user does."""
        index = box.findData(data)
        self.assertGreaterEqual(index, 0, data)
        box.setCurrentIndex(index)
        box.activated.emit(index)
        self.pump()

    def darken(self):
        """Dark widgets and a dark 3D view until the test ends."""
        window = FreeCADGui.getMainWindow()
        window.setStyleSheet("QWidget { background: #2b2b2b; color: #e0e0e0 }")
        self.set_background(DARK)
        self.addCleanup(window.setStyleSheet, "")
