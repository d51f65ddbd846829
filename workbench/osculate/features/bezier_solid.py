"""The document object BezierSolid: a rational Bézier tetrahedron, by its control net."""

import math

import FreeCAD

import osculate
from osculate.features import control_net
from osculate.features.feature import STATUS, Feature, make
from osculate.features.properties import HIDDEN, READ_ONLY, SHOWN, set_if_changed

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

#: Up to this degree the validity is checked at each recompute (mostly 1 ms), above it only by
#: `check_validity`: degree 12 takes half a second.
CHECKED_DEGREE = 4

_NET = ("Net", (
    ("Points", "App::PropertyVectorList", QT_TRANSLATE_NOOP(
        "App::Property", "The control points in the order of their indices, from (n, 0, 0, 0) "
                         "to (0, 0, 0, n)")),
    ("Weights", "App::PropertyFloatList", QT_TRANSLATE_NOOP(
        "App::Property", "The weight of each control point; none where all are 1")),
    ("FourthCoordinates", "App::PropertyFloatList", QT_TRANSLATE_NOOP(
        "App::Property", "The fourth coordinate of each control point in four dimensions, in mm; "
                         "none in three")),
))
_MADE = ("Result", (
    STATUS[0],
    ("Degree", "App::PropertyInteger", QT_TRANSLATE_NOOP(
        "App::Property", "The degree, which follows from the number of points")),
    ("Volume", "App::PropertyVolume", QT_TRANSLATE_NOOP(
        "App::Property", "The volume; where the solid folds, parts covered inside out are taken "
                         "off")),
    ("Centroid", "App::PropertyVector", QT_TRANSLATE_NOOP(
        "App::Property", "The centre of mass")),
    ("Validity", "App::PropertyString", QT_TRANSLATE_NOOP(
        "App::Property", "valid, singular or inverted and where, undecided, or nothing where it "
                         "was not checked")),
    ("Warnings", "App::PropertyStringList", QT_TRANSLATE_NOOP(
        "App::Property", "What is not as it should be, in sentences")),
    STATUS[1],
))


class BezierSolid(Feature):
    """Proxy of an App::FeaturePython; documents name this class.

    Its points are in the coordinates of the App::Part that it is in. `Degree` is the last property
    that is set when there is a new value.
    """

    groups = (_NET,)
    result_groups = (_MADE,)

    validity = None  #: the osculate.ValidityReport of `value`, None where it was not checked

    @property
    def value(self):
        """The osculate.BezierTetrahedron of the last recompute; None if there was none or the net
        was changed since: `restore` makes it then.
        """
        return self.result

    def construct(self, obj):
        self.validity = None
        return control_net.value_of(obj.Points, obj.Weights, obj.FourthCoordinates)

    def put(self, obj, value):
        obj.Degree = value.degree

    def show(self, obj, value):
        if value.dimension == 3 and value.degree <= CHECKED_DEGREE:
            self.validity = value.validity()
        volume = value.volume() if value.dimension == 3 else math.nan
        centroid = value.centroid() if value.dimension == 3 else (math.nan,) * 3
        obj.Volume, obj.Centroid = abs(volume), FreeCAD.Vector(*centroid)
        obj.Warnings = warnings_of(value, volume)
        obj.Validity = "" if self.validity is None else str(self.validity)

    def set_editors(self, obj):
        super().set_editors(obj)
        mode = HIDDEN if obj.FourthCoordinates else READ_ONLY
        for name in ("Volume", "Centroid", "Validity"):
            obj.setEditorMode(name, mode)
        obj.setEditorMode("FourthCoordinates", SHOWN if obj.FourthCoordinates else HIDDEN)

    def onChanged(self, _obj, name):
        if name in self.inputs():  # by undo too, which recomputes nothing
            self.result, self.error, self.validity = None, "", None

    def onDocumentRestored(self, obj):
        self.restore(obj)
        super().onDocumentRestored(obj)


def make_bezier_solid(doc, points, weights=None, *, name="BezierSolid"):
    """Adds a BezierSolid to a document and recomputes it.

    doc:     the App.Document
    points:  an osculate.BezierTetrahedron; or the control points, rows of 3 or 4 coordinates in mm,
             in the order of the net
    weights: of each point, >= 0; None where all are 1 or the solid is given

    Raises ValueError before anything is changed.
    """
    if not isinstance(points, osculate.BezierTetrahedron):
        points = _value_of_rows([tuple(point) for point in points], weights)
    elif weights is not None:
        raise ValueError("weights: the solid that is given has its own")
    return make_object(doc, name=name, **settings_of(points))


def make_object(doc, *, name="BezierSolid", **properties):
    """Adds a BezierSolid with some of its properties set, and recomputes it."""
    return make(doc, BezierSolid, name, **properties)


def settings_of(value):
    """The properties that make a BezierSolid a BezierTetrahedron, as a dict."""
    points, weights, fourth = control_net.lists_of(value)
    return {"Points": [FreeCAD.Vector(*point) for point in points], "Weights": weights,
            "FourthCoordinates": fourth}


def is_solid(obj):
    """Whether a document object is a BezierSolid."""
    return isinstance(getattr(obj, "Proxy", None), BezierSolid)


def value_in_document(obj):
    """The value of a BezierSolid in global coordinates. Raises ValueError if there is none, or one
    in four dimensions inside an App::Part that is placed.
    """
    value = obj.Proxy.restore(obj)
    if value is None:
        raise ValueError(f"{obj.Label}: {obj.Proxy.error}")
    container = obj.getParentGeoFeatureGroup()
    placement = container.getGlobalPlacement() if container else FreeCAD.Placement()
    if placement.isIdentity():
        return value
    matrix = placement.toMatrix().A
    return value.transformed([matrix[row:row + 4] for row in range(0, 16, 4)])


def check_validity(obj):
    """Decides whether a BezierSolid folds over itself, keeps the answer in its Validity and returns
    the osculate.ValidityReport. Raises ValueError where there is no value in three dimensions.
    """
    proxy = obj.Proxy
    if proxy.restore(obj) is None:
        raise ValueError(f"{obj.Label}: {proxy.error}")
    if proxy.validity is None:
        proxy.validity = proxy.value.validity()
    set_if_changed(obj, "Validity", str(proxy.validity))
    return proxy.validity


def warnings_of(value, volume):
    """What of a value with this volume is legal but not as it should be, in sentences."""
    warnings = list(value.warnings)
    if volume < 0.0:
        warnings.append("the solid is a mirror image: its Jacobian is mostly negative")
    return warnings


def _value_of_rows(rows, weights):
    lengths = {len(row) for row in rows}
    if lengths not in ({3}, {4}):
        raise ValueError("points: each must have 3 coordinates, or each 4")
    fourth = [row[3] for row in rows] if lengths == {4} else []
    weights = [] if weights is None else [float(weight) for weight in weights]
    return control_net.value_of([row[:3] for row in rows], weights, fourth)
