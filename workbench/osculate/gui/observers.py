"""Tells a panel, from the event loop, that the model or the selection changed.

FreeCAD calls observers in the middle of its own work, often many times for one step of the user.
Here every call only starts a timer, so that the panel acts once, afterwards.
"""

import time

import FreeCAD
import FreeCADGui

from osculate.gui.qt import QtCore

_QUICK = 0.1  # seconds that nobody notices


class Later:
    """Calls a function once, when the event loop is reached; a slow one only after a pause as long
    as it last took, so that it does not hold up the user's work. With a `parent`, a Qt object, it
    ends as that does.
    """

    def __init__(self, function, parent=None):
        self._function = function
        self._pause = 0.0
        self._timer = QtCore.QTimer(parent)
        self._timer.setSingleShot(True)
        self._timer.timeout.connect(self._call)

    def start(self, *_args):
        self._timer.start(0 if self._pause < _QUICK else round(1000 * self._pause))

    def stop(self):
        self._timer.stop()

    def _call(self):
        started = time.monotonic()
        self._function()
        self._pause = time.monotonic() - started


class ModelObserver:
    """Calls `changed()` after edits of any document, `closed(name)` when a document goes.

    Edits during which `ignores()` is true are not told: those of the caller itself.
    """

    def __init__(self, changed, closed, ignores=lambda: False):
        self._later = Later(changed)
        self._closed = closed
        self._ignores = ignores
        self.slotChangedObject = self._tell
        self.slotDeletedObject = self._tell
        self.slotRecomputedDocument = self._tell
        self.slotUndoDocument = self._tell
        self.slotRedoDocument = self._tell
        FreeCAD.addDocumentObserver(self)

    def _tell(self, *_args):
        if not self._ignores():
            self._later.start()

    def slotDeletedDocument(self, document):
        self._closed(document.Name)

    def stop(self):
        FreeCAD.removeDocumentObserver(self)
        self._later.stop()


class UndoObserver:
    """Calls `undone()` after undo and redo in a document, until that is closed."""

    def __init__(self, document_name, undone):
        self._name = document_name
        self._later = Later(undone)
        FreeCAD.addDocumentObserver(self)

    def slotUndoDocument(self, document):
        if document.Name == self._name:
            self._later.start()

    slotRedoDocument = slotUndoDocument

    def slotDeletedDocument(self, document):
        if document.Name == self._name:
            FreeCAD.removeDocumentObserver(self)
            self._later.stop()


class SelectionObserver:
    """Calls `changed()` after something was selected or everything deselected.

    What is only taken out of the selection, as by its deletion, is nothing new to look at.
    """

    def __init__(self, changed):
        self._later = Later(changed)
        self.addSelection = self._later.start
        self.setSelection = self._later.start
        self.clearSelection = self._later.start
        FreeCADGui.Selection.addObserver(self)

    def stop(self):
        FreeCADGui.Selection.removeObserver(self)
        self._later.stop()
