"""What FreeCAD asks of a task panel."""

from osculate.gui.qt import QtWidgets, button_bits


class TransactionAnswers:
    """Mixed into panels that hold a transaction open, with OK and Cancel."""

    def getStandardButtons(self):
        buttons = QtWidgets.QDialogButtonBox.StandardButton
        return button_bits(buttons.Ok, buttons.Cancel)

    def isAllowedAlterDocument(self):
        return False  # another command's transaction would end this one

    def isAllowedAlterSelection(self):
        return True

    def isAllowedAlterView(self):
        return True

    def needsFullSpace(self):
        return True
