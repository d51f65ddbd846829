"""The properties by which a document object holds its tolerances: a preset, or five own values."""

from FreeCAD import Qt

from osculate.features.properties import READ_ONLY, SHOWN
from osculate.features.tolerance_choice import (
    CUSTOM, PRESETS, ToleranceValues, tolerances_of, values_of)

QT_TRANSLATE_NOOP = Qt.QT_TRANSLATE_NOOP

_VALUES = (
    ("GapTolerance", "App::PropertyLength", QT_TRANSLATE_NOOP(
        "App::Property", "Largest distance of the ends that passes G0")),
    ("AngleTolerance", "App::PropertyAngle", QT_TRANSLATE_NOOP(
        "App::Property", "Largest angle between the tangents that passes G1")),
    ("CurvatureTolerance", "App::PropertyFloat", QT_TRANSLATE_NOOP(
        "App::Property", "Largest relative deviation of curvature that passes G2")),
    ("ThirdTolerance", "App::PropertyFloat", QT_TRANSLATE_NOOP(
        "App::Property", "Largest relative deviation of the third derivative that passes G3")),
    ("FourthTolerance", "App::PropertyFloat", QT_TRANSLATE_NOOP(
        "App::Property", "Largest relative deviation that passes G4 and above")),
)

#: A group as in properties.add_properties, and what its properties begin with.
TOLERANCES = ("Tolerances", (
    ("OrderAsked", "App::PropertyIntegerConstraint", QT_TRANSLATE_NOOP(
        "App::Property", "Highest order analysed, 0 to 8")),
    ("Preset", "App::PropertyEnumeration", QT_TRANSLATE_NOOP(
        "App::Property", "Tolerances of Osculate, of another system, or custom")),
    *_VALUES,
))
STARTS = {"OrderAsked": (4, 0, 8, 1), "Preset": [*PRESETS, CUSTOM]}


def take_preset(obj):
    """Shows the values of the object's preset, unless they are its own."""
    if obj.Preset != CUSTOM:
        set_tolerance_values(obj, values_of(obj.Preset))
    set_tolerance_editors(obj)


def set_tolerance_values(obj, values):
    for name, value in tolerance_settings(values).items():
        setattr(obj, name, value)


def tolerance_settings(values):
    """The properties that hold ToleranceValues, as a dict."""
    return {"GapTolerance": values.gap_mm, "AngleTolerance": values.angle_deg,
            "CurvatureTolerance": values.curvature, "ThirdTolerance": values.third,
            "FourthTolerance": values.fourth}


def set_tolerance_editors(obj):
    """Only own values can be edited."""
    for name, _, _ in _VALUES:
        obj.setEditorMode(name, SHOWN if obj.Preset == CUSTOM else READ_ONLY)


def tolerances_in(obj):
    """The Tolerances of an object. Raises ValueError if one of its own values is unfit."""
    return tolerances_of(obj.Preset, tolerance_values_in(obj))


def tolerance_values_in(obj):
    """The five tolerances that an object shows."""
    return ToleranceValues(obj.GapTolerance.Value, obj.AngleTolerance.Value,
                           obj.CurvatureTolerance, obj.ThirdTolerance, obj.FourthTolerance)
