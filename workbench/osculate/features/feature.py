"""What the document objects that are recomputed have in common."""

import functools

import FreeCAD

from osculate import _core
from osculate.features import properties, views
from osculate.features.edge_link import LinkError
from osculate.features.properties import HIDDEN, READ_ONLY, set_if_changed

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

#: What is raised where the properties ask for what cannot be made; the message is a sentence for
#: the user.
FAILURES = (LinkError, ValueError, TypeError, RuntimeError)

#: Results that every such object has.
STATUS = (
    ("Status", "App::PropertyString", QT_TRANSLATE_NOOP(
        "App::Property", "OK, or why there is no new result")),
    ("SchemaVersion", "App::PropertyInteger", QT_TRANSLATE_NOOP(
        "App::Property", "Version of this object's properties")),
)


class Feature:
    """Base of the proxies of objects that are made anew from their properties.

    A subclass says which properties it has (`groups`, `result_groups`, `starts`) and what follows
    from them (`construct`, `show`). Documents name the subclass: keep its module and name, and
    migrate by SchemaVersion.
    """

    SCHEMA_VERSION = 1
    type_id = "App::FeaturePython"  #: of the document object
    groups = ()  #: of what the user sets, as in properties.add_properties
    result_groups = (("Result", STATUS),)
    never_shown = ("SchemaVersion",)
    starts = {}  #: what properties begin with

    result = None  #: of the last recompute or preview, None if it failed or was before loading
    error = ""     #: why it failed

    def __init__(self, obj):
        self.complete(obj)
        obj.SchemaVersion = self.SCHEMA_VERSION
        obj.Proxy = self
        self.set_editors(obj)

    # What a subclass does

    def construct(self, obj):
        """What the properties ask for. Raises one of FAILURES."""
        raise NotImplementedError

    def put(self, obj, result):
        """Sets what changes with the result under the user's hand."""

    def show(self, obj, result):
        """Sets the other properties that say what came out."""

    def set_editors(self, obj):
        """Sets which properties can be edited and which are seen."""
        for name in properties.names_in(self.result_groups):
            obj.setEditorMode(name, HIDDEN if name in self.never_shown else READ_ONLY)

    # What FreeCAD calls

    @property
    def execute(self):
        return functools.partial(_core.raise_returned, self.refresh)

    def onDocumentRestored(self, obj):
        self.complete(obj)
        if obj.SchemaVersion != self.SCHEMA_VERSION:
            obj.SchemaVersion = self.SCHEMA_VERSION
        self.set_editors(obj)
        views.give_view(obj)  # one from a script without a GUI has none yet

    def dumps(self):
        return None

    def loads(self, _state):
        return None

    __getstate__ = dumps
    __setstate__ = loads

    # What all do

    def refresh(self, obj):
        """Makes the results anew; returns why it cannot, or None. Never raises for what the user
        can mend.
        """
        self.preview(obj)
        if self.result is not None:
            self.show(obj, self.result)
            self.set_editors(obj)
        return self.error or None

    def restore(self, obj):
        """The result; of an object that was just loaded it is made here, and nothing else of the
        object changes. None if there is none.
        """
        if self.result is None and not self.error:
            try:
                self.result = self.construct(obj)
            except FAILURES as error:
                self.error = str(error)
        return self.result

    def preview(self, obj):
        """Makes anew only what changes under the user's hand; the rest follows with `refresh`.

        `result` or `error` say what came of it.
        """
        self.result, self.error = None, ""
        try:
            self.result = self.construct(obj)
        except FAILURES as error:
            self.error = str(error)
        else:
            self.put(obj, self.result)
        set_if_changed(obj, "Status", self.error or "OK")

    @classmethod
    def inputs(cls):
        """The names of the properties that the user sets."""
        return properties.names_in(cls.groups)

    def complete(self, obj):
        """Adds the properties that the object does not have yet."""
        properties.add_properties(obj, (*self.groups, *self.result_groups), self.starts)


def make(doc, kind, name, **settings):
    """Adds an object with a proxy of class `kind`, sets its properties and recomputes it."""
    obj = doc.addObject(kind.type_id, name)
    kind(obj)
    views.give_view(obj)
    for setting, value in settings.items():
        setattr(obj, setting, value)
    doc.recompute([obj])
    return obj
