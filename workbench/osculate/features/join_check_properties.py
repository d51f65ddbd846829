"""The properties of the document object JoinCheck: names, types, groups, what they mean."""

import math

from FreeCAD import Qt

from osculate.features import properties
from osculate.features.joins import ENDS
from osculate.features.properties import HIDDEN, LINK, READ_ONLY
from osculate.features.tolerance_properties import STARTS, TOLERANCES, set_tolerance_editors

QT_TRANSLATE_NOOP = Qt.QT_TRANSLATE_NOOP

_STARTS = {"Ends": list(ENDS), **STARTS}

_JOIN = (
    ("First", LINK, QT_TRANSLATE_NOOP(
        "App::Property", "The edge that arrives at the join")),
    ("Second", LINK, QT_TRANSLATE_NOOP(
        "App::Property", "The edge that leaves the join")),
    ("Ends", "App::PropertyEnumeration", QT_TRANSLATE_NOOP(
        "App::Property", "Which end of the first and of the second edge meet")),
    ("Knot", "App::PropertyInteger", QT_TRANSLATE_NOOP(
        "App::Property", "Number of an inner knot of the first edge, 0 for a join at ends")),
)
_RESULT = (
    ("Status", "App::PropertyString", QT_TRANSLATE_NOOP(
        "App::Property", "OK, or why there is no result")),
    ("Continuity", "App::PropertyString", QT_TRANSLATE_NOOP(
        "App::Property", "G0 to G8, gap, or error")),
    ("Order", "App::PropertyInteger", QT_TRANSLATE_NOOP(
        "App::Property", "Order of geometric continuity, -1 for a gap")),
    ("ParametricOrder", "App::PropertyInteger", QT_TRANSLATE_NOOP(
        "App::Property", "Order of parametric continuity, -1 for a gap")),
    ("Headline", "App::PropertyString", QT_TRANSLATE_NOOP(
        "App::Property", "The verdict in one line")),
    ("Verdicts", "App::PropertyStringList", QT_TRANSLATE_NOOP(
        "App::Property", "pass, fail or undecided for each order from 0")),
    ("Residuals", "App::PropertyFloatList", QT_TRANSLATE_NOOP(
        "App::Property", "Deviation of each order from 0: mm, degrees, then relative")),
    ("Position", "App::PropertyVector", QT_TRANSLATE_NOOP(
        "App::Property", "The end of the first edge at the join")),
    ("SchemaVersion", "App::PropertyInteger", QT_TRANSLATE_NOOP(
        "App::Property", "Version of this object's properties")),
    ("Report", "App::PropertyString", QT_TRANSLATE_NOOP(
        "App::Property", "The whole report as JSON, schema osculate.join/1")),
)
#: Key in the report's deviation (or of a side) -> property. NaN and hidden where it does not exist.
_NUMBERS = {
    "gap_mm": ("Gap", "App::PropertyDistance", QT_TRANSLATE_NOOP(
        "App::Property", "Distance of the two ends")),
    "tangent_angle_deg": ("TangentAngle", "App::PropertyAngle", QT_TRANSLATE_NOOP(
        "App::Property", "Angle between the tangents in the direction of travel")),
    "osculating_plane_angle_deg": ("OsculatingPlaneAngle", "App::PropertyAngle", QT_TRANSLATE_NOOP(
        "App::Property", "Angle between the binormals")),
    "radius_first": ("RadiusFirst", "App::PropertyDistance", QT_TRANSLATE_NOOP(
        "App::Property", "Radius of curvature of the first edge at the join")),
    "radius_second": ("RadiusSecond", "App::PropertyDistance", QT_TRANSLATE_NOOP(
        "App::Property", "Radius of curvature of the second edge at the join")),
    "curvature_first": ("CurvatureFirst", "App::PropertyFloat", QT_TRANSLATE_NOOP(
        "App::Property", "Curvature of the first edge at the join, 1/mm")),
    "curvature_second": ("CurvatureSecond", "App::PropertyFloat", QT_TRANSLATE_NOOP(
        "App::Property", "Curvature of the second edge at the join, 1/mm")),
    "curvature_vector_per_mm": ("CurvatureDeviation", "App::PropertyFloat", QT_TRANSLATE_NOOP(
        "App::Property", "Length of the difference of the curvature vectors, 1/mm")),
    "torsion_per_mm": ("TorsionDeviation", "App::PropertyFloat", QT_TRANSLATE_NOOP(
        "App::Property", "Difference of the torsions, 1/mm")),
    "curvature_rate_per_mm2": ("CurvatureRateDeviation", "App::PropertyFloat", QT_TRANSLATE_NOOP(
        "App::Property", "Difference of the rates of curvature by arc length, 1/mm²")),
}
_GROUPS = (("Join", _JOIN), TOLERANCES, ("Result", _RESULT),
           ("Deviations", tuple(_NUMBERS.values())))
_NEVER_SHOWN = ("SchemaVersion", "Report")


def add_properties(obj):
    """Adds what the object does not have yet."""
    properties.add_properties(obj, _GROUPS, _STARTS)


def set_numbers(obj, numbers):
    """Sets the numbers of the result; those missing or None become NaN."""
    for key, (name, _, _) in _NUMBERS.items():
        number = numbers.get(key)
        setattr(obj, name, math.nan if number is None else number)


def set_editors(obj):
    """Results cannot be edited, tolerances of a preset neither; what does not exist is hidden."""
    for name, _, _ in _RESULT:
        obj.setEditorMode(name, HIDDEN if name in _NEVER_SHOWN else READ_ONLY)
    for name, _, _ in _NUMBERS.values():
        exists = not math.isnan(float(getattr(obj, name)))
        obj.setEditorMode(name, READ_ONLY if exists else HIDDEN)
    set_tolerance_editors(obj)
