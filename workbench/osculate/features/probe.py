"""The document object Probe: a point on curves, with frame, circle, planes and construction."""

import FreeCAD

from osculate.features.edge_overlay import (
    EDGE_COUNT, SOURCES, WARNINGS, EdgeOverlay, sources_from)
from osculate.features.feature import STATUS, make
from osculate.features.properties import LOOK, set_if_changed
from osculate.probing import CurveProbe

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

#: What can be drawn at the point: the name of its property.
PARTS = {
    "frame": "Frame", "circle": "Circle", "osculating plane": "OsculatingPlane",
    "normal plane": "NormalPlane", "rectifying plane": "RectifyingPlane",
    "de Casteljau": "DeCasteljau", "read-out": "ReadOut", "marks": "Marks", "legend": "Legend"}

_SHOWN = ("frame", "circle", "read-out", "marks", "legend")  # of a new one

_CURVES = ("Curves", (
    SOURCES,
    ("Position", "App::PropertyFloatConstraint", QT_TRANSLATE_NOOP(
        "App::Property", "Where the point is, as a share of the length of all edges, 0 to 1")),
))
_LOOK = ("Look", (
    ("Frame", "App::PropertyBool", QT_TRANSLATE_NOOP(
        "App::Property", "Whether tangent, normal and binormal are drawn"), LOOK),
    ("Circle", "App::PropertyBool", QT_TRANSLATE_NOOP(
        "App::Property", "Whether the osculating circle and its centre are drawn"), LOOK),
    ("OsculatingPlane", "App::PropertyBool", QT_TRANSLATE_NOOP(
        "App::Property", "Whether the plane of tangent and normal is drawn"), LOOK),
    ("NormalPlane", "App::PropertyBool", QT_TRANSLATE_NOOP(
        "App::Property", "Whether the plane of normal and binormal is drawn"), LOOK),
    ("RectifyingPlane", "App::PropertyBool", QT_TRANSLATE_NOOP(
        "App::Property", "Whether the plane of tangent and binormal is drawn"), LOOK),
    ("DeCasteljau", "App::PropertyBool", QT_TRANSLATE_NOOP(
        "App::Property", "Whether the construction of de Casteljau is drawn"), LOOK),
    ("ReadOut", "App::PropertyBool", QT_TRANSLATE_NOOP(
        "App::Property", "Whether curvature, radius and torsion stand beside the point"), LOOK),
    ("Marks", "App::PropertyBool", QT_TRANSLATE_NOOP(
        "App::Property", "Whether joins, knots, inflections and vertices are marked"), LOOK),
    ("Legend", "App::PropertyBool", QT_TRANSLATE_NOOP(
        "App::Property", "Whether the view explains what is drawn"), LOOK),
))
_RESULT = ("Result", (
    STATUS[0],
    EDGE_COUNT,
    ("TotalLength", "App::PropertyLength", QT_TRANSLATE_NOOP(
        "App::Property", "Length of all edges")),
    ("ArcLength", "App::PropertyLength", QT_TRANSLATE_NOOP(
        "App::Property", "Where the point is, along the edges")),
    ("Edge", "App::PropertyInteger", QT_TRANSLATE_NOOP(
        "App::Property", "The number of its edge among all of them, from 1")),
    ("Parameter", "App::PropertyFloat", QT_TRANSLATE_NOOP(
        "App::Property", "Where it is, as a parameter of the edge in its own direction")),
    ("At", "App::PropertyStringList", QT_TRANSLATE_NOOP(
        "App::Property", "What is special about the point: end, join, knot, inflection, ...")),
    ("Point", "App::PropertyVector", QT_TRANSLATE_NOOP("App::Property", "The point")),
    ("Tangent", "App::PropertyVector", QT_TRANSLATE_NOOP(
        "App::Property", "Tangent; zero where Missing names it")),
    ("Normal", "App::PropertyVector", QT_TRANSLATE_NOOP(
        "App::Property", "Normal, towards the centre of curvature; zero where Missing names it")),
    ("Binormal", "App::PropertyVector", QT_TRANSLATE_NOOP(
        "App::Property", "Binormal; zero where Missing names it")),
    ("Curvature", "App::PropertyFloat", QT_TRANSLATE_NOOP(
        "App::Property", "Curvature, 1/mm; 0 where Missing names it")),
    ("Radius", "App::PropertyLength", QT_TRANSLATE_NOOP(
        "App::Property", "Radius of curvature; 0 where Missing names it")),
    ("Torsion", "App::PropertyFloat", QT_TRANSLATE_NOOP(
        "App::Property", "Torsion, 1/mm; 0 where Missing names it")),
    ("Missing", "App::PropertyStringList", QT_TRANSLATE_NOOP(
        "App::Property", "Which of these do not exist at the point")),
    WARNINGS,
    STATUS[1],
))


class Probe(EdgeOverlay):
    """Proxy of an App::FeaturePython; documents name this class.

    Its result is an osculate.probing.ProbeReading; the edges are chained, as far as they meet.
    """

    groups = (_CURVES, _LOOK)
    result_groups = (_RESULT,)
    starts = {"Position": (0.5, 0.0, 1.0, 0.01),
              **{name: part in _SHOWN for part, name in PARTS.items()}}

    probe = None  #: the osculate.probing.CurveProbe along the edges
    _probed = None

    def options(self, obj):
        return (obj.Position,)

    def make_from(self, obj, curves):
        if self._probed is not curves:
            self._probed, self.probe = curves, CurveProbe(curves)
        return self.probe.at(obj.Position * self.probe.length)

    def show(self, obj, reading):
        super().show(obj, reading)
        side, geometry = reading.sides[-1], reading.geometry
        values = {"Tangent": geometry.tangent, "Normal": geometry.normal,
                  "Binormal": geometry.binormal, "Curvature": geometry.curvature,
                  "Radius": radius_of(geometry), "Torsion": geometry.torsion}
        obj.TotalLength, obj.ArcLength = self.probe.length, reading.s
        obj.Edge, obj.Parameter = side.curve + 1, side.parameter
        obj.Point = FreeCAD.Vector(*reading.point)
        for name, value in values.items():
            if name in ("Tangent", "Normal", "Binormal"):
                setattr(obj, name, FreeCAD.Vector(*(() if value is None else value)))
            else:
                setattr(obj, name, value or 0.0)
        set_if_changed(obj, "At", list(reading.kinds))
        set_if_changed(obj, "Missing", [name for name, value in values.items() if value is None])


def make_probe(doc, sources, *, position=0.5, parts=_SHOWN, name="Probe"):
    """Adds a Probe to a document and recomputes it.

    doc, sources: as those of make_curvature_comb; edges whose ends meet are put one behind the
        other, and the first gives the direction
    position: a share of the length of all edges, 0 to 1
    parts: what is drawn, some of PARTS

    Raises ValueError before anything is changed. A link that leads to no edge is no error here: the
    object says so in its Warnings, or in its Status if none is left.
    """
    if not 0.0 <= position <= 1.0:
        raise ValueError(f"position: must be from 0 to 1, not {position}")
    parts = [parts] if isinstance(parts, str) else list(parts)
    for part in parts:
        if part not in PARTS:
            raise ValueError(f"parts: {part!r} is none of {', '.join(PARTS)}")
    return make_object(doc, name=name, Sources=sources_from(sources), Position=float(position),
                       **{name: part in parts for part, name in PARTS.items()})


def make_object(doc, *, name="Probe", **settings):
    """Adds a Probe with some of its properties set, and recomputes it."""
    return make(doc, Probe, name, **settings)


def radius_of(geometry):
    """The radius of the osculating circle, mm; None where there is none."""
    return 1.0 / geometry.curvature if geometry.normal is not None else None
