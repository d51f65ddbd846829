"""The document object SolidBRep: a Part solid with the exact faces of a Bézier solid."""

import FreeCAD

from osculate.features.bezier_solid import is_solid, value_in_document
from osculate.features.constructed import place
from osculate.features.edge_link import LinkError
from osculate.features.feature import STATUS, Feature, make
from osculate.features.properties import HIDDEN

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP
translate = FreeCAD.Qt.translate

_SOURCE = ("Solid", (
    ("Source", "App::PropertyLinkGlobal", QT_TRANSLATE_NOOP(
        "App::Property", "The Bézier solid that this one follows")),
))


_MADE = ("Result", (
    STATUS[0],
    ("Warnings", "App::PropertyStringList", QT_TRANSLATE_NOOP(
        "App::Property", "What is not as it should be, in sentences")),
    STATUS[1],
))


class SolidBRep(Feature):
    """Proxy of a Part::FeaturePython; documents name this class."""

    type_id = "Part::FeaturePython"
    groups = (_SOURCE,)
    result_groups = (_MADE,)

    def construct(self, obj):
        return value_in_document(source_of(obj, "Source")).to_solid()

    def put(self, obj, shape):
        place(obj, shape)

    def show(self, obj, _shape):
        report = obj.Source.Proxy.validity  # None where it was not checked
        folds = report is not None and report.verdict == "inverted" and not report.is_mirrored
        obj.Warnings = [translate("Osculate", "{} folds over itself: faces may pass through each "
                                              "other.").format(obj.Source.Label)] if folds else []

    def set_editors(self, obj):
        super().set_editors(obj)
        obj.setEditorMode("Placement", HIDDEN)  # follows the solid


def make_solid_brep(doc, source, *, name="SolidBRep"):
    """Adds a SolidBRep of a BezierSolid to a document and recomputes it.

    Raises ValueError before anything is changed if `source` is no BezierSolid of the document. One
    without volume, in four dimensions or with a corner of weight 0 bounds no solid: the object says
    so in its Status.
    """
    require_solid(doc, source, "source")
    return make(doc, SolidBRep, name, Source=source)


def source_of(obj, link):
    """The BezierSolid that a property links to. Raises LinkError."""
    source = getattr(obj, link)
    if source is None:
        raise LinkError(translate("Osculate", "No Bézier solid is linked."))
    if not is_solid(source):
        raise LinkError(translate("Osculate", "{} is no Bézier solid.").format(source.Label))
    return source


def require_solid(doc, source, name):
    """Raises ValueError unless `source` is a BezierSolid of the document."""
    if not is_solid(source):
        raise ValueError(f"{name}: must be a BezierSolid")
    if source.Document != doc:
        raise ValueError(f"{name}: must be in the document {doc.Name}")
