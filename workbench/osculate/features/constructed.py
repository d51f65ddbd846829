"""What the document objects that construct a curve have in common."""

import json

import FreeCAD

from osculate.features.edge_link import LinkError
from osculate.features.feature import FAILURES, STATUS, Feature
from osculate.features.properties import HIDDEN, set_if_changed

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP
translate = FreeCAD.Qt.translate

RESULT = ("Result", (
    STATUS[0],
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
    STATUS[1],
))
_NEVER_SHOWN = ("Reports", "SchemaVersion")


class Constructed(Feature):
    """Base of the proxies of Part::FeaturePython objects whose shape is constructed.

    A subclass says which properties it has (`groups`, `starts`) and how they become a curve
    (`construct`); a recompute that fails keeps the last good shape, and says why in Status and in
    the tree. Documents name the subclass: keep its module and name, and migrate by SchemaVersion.
    """

    type_id = "Part::FeaturePython"
    never_shown = _NEVER_SHOWN
    result_groups = (RESULT,)   #: a subclass with more has them in front of RESULT

    # What a subclass does

    #: construct(obj) gives the osculate.Construction that the properties ask for

    def show_choices(self, obj, result):
        """Sets the properties that the user left to be chosen."""

    def shape(self, _obj, result):
        """The shape of a construction, in global coordinates. Raises one of FAILURES."""
        return result.edge

    def show(self, obj, result):
        show_result(obj, result)

    def set_editors(self, obj):
        super().set_editors(obj)
        obj.setEditorMode("Placement", HIDDEN)  # follows the edges

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


def place(obj, shape):
    """Gives the object a shape that is in global coordinates, inside its App::Part or not."""
    container = obj.getGlobalPlacement().multiply(obj.Placement.inverse())
    shape.Placement = container.inverse().multiply(shape.Placement)
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
