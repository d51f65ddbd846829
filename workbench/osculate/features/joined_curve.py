"""The document object JoinedCurve: one B-spline through a chain of edges."""

import re

import FreeCAD

import osculate
from osculate.features.constructed import RESULT, Constructed, show_result
from osculate.features.edge_link import EdgeLink, LinkError, resolve_each
from osculate.features.feature import make
from osculate.features.join_check import continuity_name
from osculate.features.properties import set_if_changed

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP
translate = FreeCAD.Qt.translate

_EDGES = ("Edges", (
    ("Edges", "App::PropertyLinkSubListGlobal", QT_TRANSLATE_NOOP(
        "App::Property", "The edges of the chain; the first gives the direction")),
))
_JOIN = ("Join", (
    ("Tolerance", "App::PropertyLength", QT_TRANSLATE_NOOP(
        "App::Property", "How far the curve may leave the edges to close gaps and to have fewer "
                         "knots; 0 for not at all")),
))
_MADE = ("Result", (
    ("Deviation", "App::PropertyLength", QT_TRANSLATE_NOOP(
        "App::Property", "How far the curve leaves the edges at most")),
    ("EdgesContinuity", "App::PropertyStringList", QT_TRANSLATE_NOOP(
        "App::Property", "G0 to G8, or gap, of the edges at each join, as they were")),
    ("Knots", "App::PropertyFloatList", QT_TRANSLATE_NOOP(
        "App::Property", "The knots of the curve")),
    ("Multiplicities", "App::PropertyIntegerList", QT_TRANSLATE_NOOP(
        "App::Property", "The multiplicities of the knots")),
))


class JoinedCurve(Constructed):
    """Proxy of a Part::FeaturePython; documents name this class."""

    groups = (_EDGES, _JOIN)
    result_groups = (_MADE, RESULT)

    def construct(self, obj):
        links = links_of(obj)
        if not links:
            raise LinkError(translate("Osculate", "No edges are linked."))
        try:
            return osculate.join(resolve_each(links), tolerance=obj.Tolerance.Value)
        except ValueError as error:
            raise LinkError(in_words(str(error), links)) from error

    def show(self, obj, result):
        show_result(obj, result)
        obj.Warnings = [in_words(warning, links_of(obj)) for warning in result.warnings]
        obj.Deviation = result.max_displacement_mm
        obj.EdgesContinuity = [continuity_name(report.order) for report in result.input_reports]
        obj.Knots = result.curve.knots.tolist()
        set_if_changed(obj, "Multiplicities", result.curve.multiplicities.tolist())


def make_object(doc, *, name="JoinedCurve", **properties):
    """Adds a JoinedCurve with some of its properties set, and recomputes it."""
    return make(doc, JoinedCurve, name, **properties)


def make_joined_curve(doc, edges, *, tolerance_mm=0.0, name="JoinedCurve"):
    """Adds a JoinedCurve to a document and recomputes it.

    doc:     the App.Document
    edges:   (object, "Edge1") pairs; the path may lead down an App::Part ("Sketch.Edge1")
    tolerance_mm: as for osculate.join

    Raises ValueError before anything is changed. A link that leads to no edge, and edges that make
    no chain, are no error here: the object says so in its Status.
    """
    if not tolerance_mm >= 0.0:
        raise ValueError(f"tolerance_mm: must be >= 0, not {tolerance_mm}")
    return make_object(doc, name=name, Edges=property_of(edges), Tolerance=tolerance_mm)


def property_of(edges):
    """(object, "Edge1") pairs as the property Edges takes them, in their order."""
    return [(obj, (sub,)) for obj, sub in edges]


def links_of(obj):
    """The EdgeLinks of a JoinedCurve, in their order."""
    return [EdgeLink.of(source, sub) for source, subs in obj.Edges for sub in subs if sub]


def in_words(sentence, links):
    """A sentence of osculate.join with the names of edges for "curves[2]"."""
    def name(match):
        number = int(match[1])
        return links[number].label() if number < len(links) else match[0]
    return re.sub(r"curves\[(\d+)\]", name, sentence.removeprefix("curves: "))
