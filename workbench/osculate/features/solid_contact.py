"""The document object SolidContact: with which C^s two Bézier solids meet over a face."""

import FreeCAD

from osculate.features.bezier_solid import value_in_document
from osculate.features.edge_link import LinkError
from osculate.features.feature import STATUS, Feature, make
from osculate.features.properties import HIDDEN, READ_ONLY
from osculate.features.solid_brep import require_solid, source_of

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP
translate = FreeCAD.Qt.translate

DEFAULT_TOLERANCE_MM = 1e-7  #: that of osculate.BezierTetrahedron.contact

_SOLIDS = ("Contact", (
    ("First", "App::PropertyLinkGlobal", QT_TRANSLATE_NOOP(
        "App::Property", "The first Bézier solid")),
    ("Second", "App::PropertyLinkGlobal", QT_TRANSLATE_NOOP(
        "App::Property", "The second Bézier solid")),
    ("Tolerance", "App::PropertyLength", QT_TRANSLATE_NOOP(
        "App::Property", "How far control points of the shared face may be apart; those of deeper "
                         "layers correspondingly more")),
))
_FOUND = ("Result", (
    STATUS[0],
    ("Contact", "App::PropertyString", QT_TRANSLATE_NOOP(
        "App::Property", "C0, C1, … or none where no faces meet")),
    ("Order", "App::PropertyInteger", QT_TRANSLATE_NOOP(
        "App::Property", "The highest s with C^s contact of the solids in space, -1 for none")),
    ("HomogeneousOrder", "App::PropertyInteger", QT_TRANSLATE_NOOP(
        "App::Property", "The same of points and weights together, which is sufficient but not "
                         "necessary")),
    ("Faces", "App::PropertyIntegerList", QT_TRANSLATE_NOOP(
        "App::Property", "The face of the first and of the second solid that meet or come nearest, "
                         "by the numbers of the opposite corners")),
    ("Gap", "App::PropertyDistance", QT_TRANSLATE_NOOP(
        "App::Property", "The largest distance of corresponding points of the two faces")),
    ("Residuals", "App::PropertyFloatList", QT_TRANSLATE_NOOP(
        "App::Property", "For each order from 0 the largest difference, as a displacement of "
                         "control points in mm")),
    ("HomogeneousResiduals", "App::PropertyFloatList", QT_TRANSLATE_NOOP(
        "App::Property", "The same of points and weights together")),
    ("Overlaps", "App::PropertyBool", QT_TRANSLATE_NOOP(
        "App::Property", "Whether both solids lie on the same side of the face")),
    STATUS[1],
))


class SolidContact(Feature):
    """Proxy of an App::FeaturePython; documents name this class. `Contact` is the last property
    that is set when there is a new report.
    """

    groups = (_SOLIDS,)
    result_groups = (_FOUND,)
    starts = {"Tolerance": DEFAULT_TOLERANCE_MM}

    @property
    def report(self):
        """The osculate.ContactReport of the last recompute; None if there was none."""
        return self.result

    def construct(self, obj):
        first, second = source_of(obj, "First"), source_of(obj, "Second")
        if first == second:
            raise LinkError(translate("Osculate", "A contact needs two different solids."))
        return value_in_document(first).contact(value_in_document(second),
                                                tolerance_mm=obj.Tolerance.Value)

    def show(self, obj, report):
        obj.Order, obj.HomogeneousOrder = report.order, report.homogeneous_order
        obj.Faces = list(report.faces)
        obj.Gap = report.gap_mm
        obj.Residuals = list(report.residuals_mm)
        obj.HomogeneousResiduals = list(report.homogeneous_residuals_mm)
        obj.Overlaps = report.overlaps
        obj.Contact = f"C{report.order}" if report.meets else "none"

    def set_editors(self, obj):
        super().set_editors(obj)
        obj.setEditorMode("Overlaps", READ_ONLY if obj.Order >= 0 else HIDDEN)

    def onDocumentRestored(self, obj):
        self.restore(obj)
        super().onDocumentRestored(obj)


def make_object(doc, *, name="SolidContact", **properties):
    """Adds a SolidContact with some of its properties set, and recomputes it."""
    return make(doc, SolidContact, name, **properties)


def make_solid_contact(doc, first, second, *, tolerance_mm=DEFAULT_TOLERANCE_MM,
                       name="SolidContact"):
    """Adds a SolidContact of two BezierSolids to a document and recomputes it.

    Raises ValueError before anything is changed. Faces that do not meet are no error: the object
    says so in its Contact.
    """
    require_solid(doc, first, "first")
    require_solid(doc, second, "second")
    if first == second:
        raise ValueError("second: must be another solid than first")
    if not 0.0 < tolerance_mm < float("inf"):
        raise ValueError(f"tolerance_mm: must be finite and > 0, not {tolerance_mm}")
    return make_object(doc, name=name, First=first, Second=second, Tolerance=tolerance_mm)
