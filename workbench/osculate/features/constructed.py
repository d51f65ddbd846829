"""What the document objects that construct a curve have in common."""

import functools
import json

import FreeCAD

from osculate import _core
from osculate.features import properties, views
from osculate.features.edge_link import LinkError
from osculate.features.properties import HIDDEN, READ_ONLY, set_if_changed

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP
translate = FreeCAD.Qt.translate

#: What a construction raises where it cannot be made; the message is a sentence for the user.
FAILURES = (LinkError, ValueError, TypeError, RuntimeError)

_RESULT = ("Result", (
    ("Status", "App::PropertyString", QT_TRANSLATE_NOOP(
        "App::Property", "OK, or why there is no new result")),
    ("Continuity", "App::PropertyStringList", QT_TRANSLATE_NOOP(
        "App::Property", "G0 to G8, or gap, of each join that was made")),
    ("Orders", "App::PropertyIntegerList", QT_TRANSLATE_NOOP(
        "App::Property", "Order of geometric continuity of each join, -1 for a gap")),
    ("Warnings", "App::PropertyStringList", QT_TRANSLATE_NOOP(
        "App::Property", "What is not as it should be, in sentences")),
    ("CurveDegree", "App::PropertyInteger", QT_TRANSLATE_NOOP(
        "App::Property", "The degree of the curve")),
    ("Length", "App::PropertyLength", QT_TRANSLATE_NOOP(
        "App::Property", "The length of the curve")),
    ("Bending", "App::PropertyFloat", QT_TRANSLATE_NOOP(
        "App::Property", "Bending energy, length times the integral of curvature squared")),
    ("Variation", "App::PropertyFloat", QT_TRANSLATE_NOOP(
        "App::Property", "Variation of curvature: length cubed times the integral of the square of "
                         "the rate of the curvature vector")),
    ("Speed", "App::PropertyFloat", QT_TRANSLATE_NOOP(
        "App::Property", "Unevenness of the parameter's speed, 0 for an even one")),
    ("Reports", "App::PropertyString", QT_TRANSLATE_NOOP(
        "App::Property", "The reports of the joins as a JSON list, schema osculate.join/1")),
    ("SchemaVersion", "App::PropertyInteger", QT_TRANSLATE_NOOP(
        "App::Property", "Version of this object's properties")),
))
_NEVER_SHOWN = ("Reports", "SchemaVersion")


class Constructed:
    """Base of the proxies of Part::FeaturePython objects whose shape is constructed.

    A subclass says which properties it has (`groups`, `starts`) and how they become a curve
    (`construct`); a recompute that fails keeps the last good shape, and says why in Status and in
    the tree. Documents name the subclass: keep its module and name, and migrate by SchemaVersion.
    """

    SCHEMA_VERSION = 1
    groups = ()        #: of the properties that the user sets, as in properties.add_properties
    result_groups = ()  #: of results beyond those that all constructions have
    starts = {}        #: what properties begin with

    result = None  #: of the last recompute or preview, None if it failed or was before loading
    error = ""     #: why it failed

    def __init__(self, obj):
        self.complete(obj)
        obj.SchemaVersion = self.SCHEMA_VERSION
        obj.Proxy = self
        self.set_editors(obj)

    # What a subclass does

    def construct(self, obj):
        """The osculate.Construction that the properties ask for. Raises one of FAILURES."""
        raise NotImplementedError

    def show_choices(self, obj, result):
        """Sets the properties that the user left to be chosen."""

    def shape(self, _obj, result):
        """The shape of a construction, in global coordinates. Raises one of FAILURES."""
        return result.edge

    def show(self, obj, result):
        """Sets the properties that say what came out."""
        show_result(obj, result)

    def set_editors(self, obj):
        """Sets which properties can be edited and which are seen."""
        for name in properties.names_in(self._results()):
            obj.setEditorMode(name, HIDDEN if name in _NEVER_SHOWN else READ_ONLY)
        obj.setEditorMode("Placement", HIDDEN)  # follows the edges

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

    @classmethod
    def inputs(cls):
        """The names of the properties that the user sets."""
        return properties.names_in(cls.groups)

    def complete(self, obj):
        """Adds the properties that the object does not have yet."""
        properties.add_properties(obj, (*self.groups, *self._results()), self.starts)

    def refresh(self, obj):
        """Makes the shape and the results anew; returns why it cannot, or None. Never raises for
        what the user can mend.
        """
        self.preview(obj)
        if self.result is not None:
            self.show(obj, self.result)
            self.set_editors(obj)
        return self.error or None

    def preview(self, obj):
        """Makes the shape anew, and of the results only what changes with it under the user's hand.

        `result` or `error` say what came of it; the rest follows with `refresh`.
        """
        self.result, self.error = None, ""
        try:
            result = self.construct(obj)
            shape = self.shape(obj, result)
        except FAILURES as error:
            self.error = str(error)
        else:
            self.result = result
            place(obj, shape)
            self.show_choices(obj, result)
        set_if_changed(obj, "Status", self.error or "OK")

    def _results(self):
        return (*self.result_groups, _RESULT)


def make(doc, kind, name, **settings):
    """Adds an object with a proxy of class `kind`, sets its properties and recomputes it."""
    obj = doc.addObject("Part::FeaturePython", name)
    kind(obj)
    views.give_view(obj)
    for setting, value in settings.items():
        setattr(obj, setting, value)
    doc.recompute([obj])
    return obj


def place(obj, shape):
    """Gives the object a shape that is in global coordinates, inside its App::Part or not."""
    container = obj.getGlobalPlacement().multiply(obj.Placement.inverse())
    shape.Placement = container.inverse()
    set_if_changed(obj, "Placement", shape.Placement)  # a recompute takes this, not the shape's
    obj.Shape = shape


def show_result(obj, result, reports=None):
    """Sets the results that all constructions have from an osculate.Construction; `reports` where
    there are more than its own.
    """
    reports = result.reports if reports is None else reports
    obj.Orders = [report.order for report in reports]
    obj.Continuity = [f"G{report.order}" if report.order >= 0 else "gap" for report in reports]
    obj.Reports = json.dumps([report.to_dict() for report in reports])
    obj.Warnings = list(result.warnings)
    obj.CurveDegree = result.curve.degree
    energy = result.energy
    obj.Length = energy["length_mm"]
    obj.Bending, obj.Variation, obj.Speed = energy["bending"], energy["mvc"], energy["speed"]


def refuse_loop(obj, link):
    """Raises LinkError if an object would depend on itself by linking to an edge."""
    source = link.resolve_object()
    if source == obj or source in obj.InListRecursive:
        raise LinkError(translate("Osculate", "{} depends on {}, which therefore cannot use its "
                                              "edges.").format(source.Label, obj.Label))
