"""The document object InterpolatedCurve: a G2 cubic through points, with a tension at each."""

import math
from dataclasses import dataclass

import FreeCAD

import osculate
from osculate.features.constructed import Constructed
from osculate.features.edge_link import VertexLink
from osculate.features.feature import make
from osculate.features.properties import HIDDEN, SHOWN

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

NATURAL, BESSEL, TANGENTS, CLOSED = "natural", "bessel", "tangents", "closed"
ENDS = (NATURAL, BESSEL, TANGENTS, CLOSED)
SPACINGS = ("centripetal", "chordal", "uniform")

_POINTS = ("Points", (
    ("Vertices", "App::PropertyLinkSubListGlobal", QT_TRANSLATE_NOOP(
        "App::Property", "The vertices that the curve runs through, in this order")),
    ("Points", "App::PropertyVectorList", QT_TRANSLATE_NOOP(
        "App::Property", "The points that it runs through where no vertices are linked")),
))
_SHAPE = ("Interpolation", (
    ("Tension", "App::PropertyFloat", QT_TRANSLATE_NOOP(
        "App::Property", "The tension at all points that have none of their own; 0 for the C2 "
                         "cubic spline, large for a polygon with round corners")),
    ("Tensions", "App::PropertyFloatList", QT_TRANSLATE_NOOP(
        "App::Property", "The tension of each point; a negative one stands for Tension")),
    ("Ends", "App::PropertyEnumeration", QT_TRANSLATE_NOOP(
        "App::Property", "Natural ends, those of a parabola, given tangents, or a closed curve")),
    ("StartTangent", "App::PropertyVector", QT_TRANSLATE_NOOP(
        "App::Property", "The direction in which the curve begins; a unit vector has a "
                         "neutral speed")),
    ("EndTangent", "App::PropertyVector", QT_TRANSLATE_NOOP(
        "App::Property", "The direction in which it ends, likewise")),
    ("Spacing", "App::PropertyEnumeration", QT_TRANSLATE_NOOP(
        "App::Property", "How the parameter's steps follow from the distances of the points")),
))


@dataclass(frozen=True)
class Interpolation:
    """What a recompute made; as much of an osculate.Construction as all objects show."""

    curve: osculate.Curve
    reports: tuple        #: JoinReports of the inner knots, and of the closing
    energy: dict
    warnings: tuple = ()

    @property
    def edge(self):
        return self.curve.to_edge()


class InterpolatedCurve(Constructed):
    """Proxy of a Part::FeaturePython; documents name this class."""

    groups = (_POINTS, _SHAPE)
    starts = {"Ends": list(ENDS), "Spacing": list(SPACINGS),
              **dict.fromkeys(("StartTangent", "EndTangent"), FreeCAD.Vector(1, 0, 0))}

    def construct(self, obj):
        points = points_of(obj)
        curve = osculate.nu_spline(
            [tuple(point) for point in points], tension=tensions_of(obj, len(points)),
            parameters=obj.Spacing, ends=_ends_of(obj), closed=obj.Ends == CLOSED)
        reports = osculate.analyze_edge(curve, order=2, tolerances="exact")
        return Interpolation(curve, tuple(reports), osculate.energies(curve))

    def set_editors(self, obj):
        super().set_editors(obj)
        obj.setEditorMode("Points", HIDDEN if obj.Vertices else SHOWN)
        for name in ("StartTangent", "EndTangent"):
            obj.setEditorMode(name, SHOWN if obj.Ends == TANGENTS else HIDDEN)

    def onChanged(self, obj, name):
        if name in ("Ends", "Vertices") and not FreeCAD.isRestoring() \
                and hasattr(obj, "SchemaVersion"):
            self.set_editors(obj)


def make_interpolated_curve(doc, *, points=(), vertices=(), tension=0.0, tensions=(),
                            ends=NATURAL, tangents=None, spacing=SPACINGS[0],
                            name="InterpolatedCurve"):
    """Adds an InterpolatedCurve to a document and recomputes it.

    doc:      the App.Document
    points:   App.Vectors, or triples of numbers in mm
    vertices: in their place (object, "Vertex1") pairs, which are followed when they move; the path
              may lead down an App::Part ("Sketch.Vertex1")
    tension:  at all points, >= 0
    tensions: of each point, None for `tension`; or empty
    ends:     "natural", "bessel", "tangents" with `tangents`, a pair of directions, or "closed"
    spacing:  "centripetal", "chordal" or "uniform", as for osculate.nu_spline

    Raises ValueError before anything is changed. A link that leads to no vertex, and points through
    which there is no curve, are no error here: the object says so in its Status.
    """
    _check(points, vertices, tension, tensions)
    _check_choices(ends, tangents, spacing)
    settings = {}
    if tangents is not None:
        settings = dict(zip(("StartTangent", "EndTangent"), map(FreeCAD.Vector, tangents)))
    return make_object(doc, name=name, Points=[FreeCAD.Vector(*point) for point in points],
                       Vertices=property_of(vertices), Tension=tension,
                       Tensions=[-1.0 if own is None else own for own in tensions],
                       Ends=ends, Spacing=spacing, **settings)


def make_object(doc, *, name="InterpolatedCurve", **properties):
    """Adds an InterpolatedCurve with some of its properties set, and recomputes it."""
    return make(doc, InterpolatedCurve, name, **properties)


def property_of(vertices):
    """(object, "Vertex1") pairs as the property Vertices takes them, in their order."""
    return [(obj, (sub,)) for obj, sub in vertices]


def links_of(obj):
    """The VertexLinks of an InterpolatedCurve, in their order."""
    return [VertexLink.of(source, sub) for source, subs in obj.Vertices for sub in subs if sub]


def points_of(obj):
    """The points that it runs through. Raises LinkError for a link that leads to no vertex."""
    links = links_of(obj)
    return [link.resolve().Point for link in links] if links else list(obj.Points)


def tensions_of(obj, count):
    """The tension of each of so many points."""
    return [obj.Tension if own < 0.0 else own for own in own_tensions(obj, count)]


def own_tensions(obj, count):
    """The numbers of Tensions for so many points, -1 for each beyond them."""
    return (list(obj.Tensions) + [-1.0] * count)[:count]


def _ends_of(obj):
    if obj.Ends != TANGENTS:
        return BESSEL if obj.Ends == BESSEL else NATURAL
    return tuple(obj.StartTangent), tuple(obj.EndTangent)


def _check(points, vertices, tension, tensions):
    if points and vertices:
        raise ValueError("points: give points or vertices, not both")
    for number in (tension, *(own for own in tensions if own is not None)):
        if not (math.isfinite(number) and number >= 0.0):
            raise ValueError(f"tension: must be finite and >= 0, not {number}")


def _check_choices(ends, tangents, spacing):
    if spacing not in SPACINGS:
        raise ValueError(f"spacing: must be one of {', '.join(SPACINGS)}, not {spacing!r}")
    if ends not in ENDS:
        raise ValueError(f"ends: must be one of {', '.join(ENDS)}, not {ends!r}")
    if (ends == TANGENTS) != (tangents is not None):
        raise ValueError("tangents: a pair of directions is needed with ends=\"tangents\", and "
                         "only there")
