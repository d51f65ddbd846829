"""What happens to the document while a panel constructs: one object, one transaction, steps."""

from contextlib import contextmanager

import FreeCAD

from osculate.features.constructed import refuse_loop
from osculate.features.edge_link import LinkError
from osculate.gui.qt import QtCore, Signal, translate


class Session(QtCore.QObject):
    """The object of a panel, made here or given, and all that is done to it.

    Everything lies in one transaction, which `commit` keeps as one step of undo and `cancel` takes
    back. Within it the panel has steps of its own, `back` and `forward`. `changed` follows every
    change of the object, of its edges, and its deletion by undo.
    """

    changed = Signal()

    def __init__(self, document, title, obj=None):
        super().__init__()
        self.document_name = document.Name
        self.is_new = obj is None    #: the object is made here, and goes with `cancel`
        self.is_busy = False         #: what happens now is done here
        self._name = obj.Name if obj else None
        self._steps, self._place = [], -1  # settings after each step; which of them holds
        self._energies = []
        self._fresh = _fresh(obj)  # names of what needed no recompute before anything was done
        self._title = title
        document.openTransaction(title)
        if obj is not None:
            self._begin()

    @property
    def document(self):
        """The App.Document; None once it is closed."""
        return FreeCAD.listDocuments().get(self.document_name)

    @property
    def obj(self):
        """The document object; None before it is made and after its deletion."""
        document = self.document
        return document.getObject(self._name) if document and self._name else None

    def require_linkable(self, link):
        """Raises LinkError for an edge in another document, or one that depends on the object."""
        if link.document != self.document_name:
            raise LinkError(translate("Osculate", "The edges must be in one document, {}.")
                            .format(self.document.Label))
        if self.obj is not None:
            refuse_loop(self.obj, link)

    @property
    def was_made(self):
        """Whether there is or was an object."""
        return self._name is not None

    @property
    def result(self):
        """What the last recompute made, an osculate.Construction mostly, or None."""
        return self.obj.Proxy.result if self.obj else None

    @property
    def error(self):
        """Why there is none, or an empty text."""
        return self.obj.Proxy.error if self.obj else ""

    @property
    def energies(self):
        """(before, now): the energies of the steps before the last and of the curve that is seen;
        None where there is none.
        """
        known = [energy for energy in self._energies[:self._place + 1] if energy]
        now = self._energy()
        before = known[-1] if known else None
        if now and before == now:
            before = known[-2] if len(known) > 1 else None
        return before, now

    # Changes

    def create(self, make, **settings):
        """Makes the object, `make(document, **settings)`; returns it."""
        with self._own_work():
            obj = make(self.document, **settings)
            self._name = obj.Name
        self._begin()
        self.changed.emit()
        return obj

    def set(self, **settings):
        """Sets properties and shows what comes out, as part of a step that `settle` ends."""
        obj = self.obj
        if obj is None:
            return
        with self._own_work():
            self._apply(obj, settings)
            obj.Proxy.preview(obj)
        self.changed.emit()

    def settle(self):
        """Ends a step: what depends on the object follows."""
        if self.obj is None:
            return
        self._recompute()
        self._remember()
        self.changed.emit()

    def give_up(self):
        """Takes back what was changed since the last step."""
        self._go(self._place)

    def do(self, **settings):
        """A whole step."""
        self.set(**settings)
        self.settle()

    def follow_model(self):
        """Looks at the edges again after a change of the model."""
        obj = self.obj
        self._require_transaction()
        if obj is not None and any("Touched" in other.State for other in (obj, *obj.OutList)):
            with self._own_work():
                obj.Proxy.preview(obj)
        self.changed.emit()

    # Steps

    @property
    def can_go_back(self):
        return self._place > 0

    @property
    def can_go_forward(self):
        return self._place + 1 < len(self._steps)

    def back(self):
        """Takes the last step back."""
        self._go(self._place - 1)

    def forward(self):
        """Takes the next step again."""
        self._go(self._place + 1)

    def _go(self, place):
        if not 0 <= place < len(self._steps) or self.obj is None:
            return
        self._place = place
        self.set(**self._steps[place])
        self._recompute()
        self.changed.emit()

    # The end

    def commit(self):
        """Keeps all as one step of undo."""
        if self.document is not None:
            self.document.commitTransaction()

    def cancel(self):
        """Leaves the document as it was."""
        document = self.document
        if document is None:
            return
        with self._own_work():
            document.abortTransaction()
            self._undo_the_rest()
            for obj in filter(None, map(document.getObject, self._fresh)):
                obj.purgeTouched()

    def _undo_the_rest(self):
        """Another transaction may have ended this one, and kept what was done until then."""
        obj = self.obj
        if obj is None:
            return
        if self.is_new:
            self.document.removeObject(obj.Name)
        elif self._settings(obj) != self._steps[0]:
            self._apply(obj, self._steps[0])
            self.document.recompute([obj, *obj.InListRecursive])

    # Within

    def _begin(self):
        obj = self.obj
        if obj.Proxy.result is None:  # it was loaded, or its last recompute failed
            with self._own_work():
                was_touched = "Touched" in obj.State
                obj.Proxy.refresh(obj)
                if not was_touched:
                    obj.purgeTouched()
        self._remember()

    def _remember(self):
        settings = self._settings(self.obj)
        if self._steps and settings == self._steps[self._place]:
            return
        self._place += 1
        self._steps[self._place:] = [settings]
        self._energies[self._place:] = [self._energy()]

    def _energy(self):
        return getattr(self.result, "energy", None)  # a solid has none

    def _require_transaction(self):
        """Undo while the panel is open has ended the transaction: what follows is another one."""
        document = self.document
        if document is not None and not document.HasPendingTransaction:
            document.openTransaction(self._title)

    @staticmethod
    def _settings(obj):
        return {name: getattr(obj, name) for name in obj.Proxy.inputs()}

    @staticmethod
    def _apply(obj, settings):
        for name, value in settings.items():
            if getattr(obj, name) != value:
                setattr(obj, name, value)

    def _recompute(self):
        obj = self.obj
        if self.error or obj is None:
            return  # a recompute would only print it
        with self._own_work():
            self.document.recompute([obj, *obj.InListRecursive])

    @contextmanager
    def _own_work(self):
        was_busy, self.is_busy = self.is_busy, True
        try:
            yield
        finally:
            self.is_busy = was_busy


def _fresh(obj):
    """The names of those of an object and of what depends on it that wait for no recompute."""
    affected = [] if obj is None else [obj, *obj.InListRecursive]
    return [other.Name for other in affected if "Touched" not in other.State]
