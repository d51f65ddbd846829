"""The end of a task panel: for panels in one transaction."""

import FreeCADGui

from osculate.gui.observers import ModelObserver
from osculate.gui.panel.transaction_answers import TransactionAnswers


class TaskPanel(TransactionAnswers):
    """Base of panels of Bézier solids. OK keeps all as one step of undo, Cancel leaves the document
    as it was; a subclass says what that takes (`keep`, `take_back`) and begins the transaction.
    """

    def __init__(self, document, form, ends_well=False):
        """ends_well: whether all is kept where the panel ends without a button."""
        self.form = form
        self.document_name = document.Name
        self.is_busy = False
        self._ends_well = ends_well
        form.panel = self  # as long as there is a form, there is a panel
        form.destroyed.connect(lambda *_: self._end())  # FreeCAD may close a dialog without asking
        self._observers = [ModelObserver(self.model_changed, self._document_closed,
                                         self.works)]

    # What a subclass does

    def problem(self):
        """Why there is nothing to keep, in a sentence; empty if there is."""
        return ""

    def keep(self):
        """OK was pressed."""

    def take_back(self):
        """Cancel was pressed, or the panel went."""

    def works(self):
        """Whether what happens in the document now is done by the panel."""
        return self.is_busy

    def model_changed(self):
        """Another one changed a document."""

    def close(self):
        """Takes the panel away."""
        FreeCADGui.Control.closeDialog()

    # The end

    def finish(self):
        """The edit mode ends, by a button of the panel or otherwise."""
        self._end()
        FreeCADGui.Control.closeDialog()

    def accept(self):
        problem = self.problem()
        if problem:
            self.form.advice.say(problem, "error")
            return False
        self._ends_well = True
        return self.leave()

    def reject(self):
        self._ends_well = False
        return self.leave()

    def leave(self):
        """Ends the panel."""
        self._end()
        self.close()
        return True

    def _end(self):
        if not self.stop():
            return
        self.is_busy = True
        if self._ends_well:
            self.keep()
        else:
            self.take_back()

    def _document_closed(self, name):
        if name == self.document_name and self.stop(document_closes=True):
            FreeCADGui.Control.closeDialog()

    def stop(self, document_closes=False):
        """Ends the observers; False if that was done before. Where the document closes its views
        are gone or going.
        """
        observers, self._observers = self._observers, []
        for observer in observers:
            observer.stop()
        return bool(observers)
