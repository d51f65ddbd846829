"""The properties of an ExtendedCurve."""

import FreeCAD

import osculate
from osculate.features import beta_properties
from osculate.features.blend_curve import FAIRNESS, MOST_DEGREE
from osculate.features.number_properties import NumberProperties
from osculate.features.properties import LINK

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

#: What of the edge goes on: its shape, its parameter too, likewise but cut, the curve itself.
GEOMETRIC, PARAMETRIC, REPARAMETRISED, NATURAL = CONTINUATIONS = (
    "geometric", "parametric", "re-parametrised", "natural")
NONE = "none"
#: Where it ends.
_, VERTEX, POSITION = POINTS = (NONE, "vertex", "position")
#: With which curvature it ends.
_, MAGNITUDE, VECTOR = CURVATURES = (NONE, "magnitude", "vector")
#: Which numbers the user gives.
BETA, TANGENTIAL = NUMBERS = ("beta", "tangential coordinates")
LEAST_PARAMETER, MOST_PARAMETER = 1e-3, 1e3

beta_numbers = beta_properties.of_side()
tangential_numbers = NumberProperties(
    "Tangential", "Tangential coordinates", "App::PropertyDistance", QT_TRANSLATE_NOOP(
        "App::Property", "How far the pole of this number lies ahead of the end along the tangent"))

_EDGE = ("Edge", (
    ("Source", LINK, QT_TRANSLATE_NOOP("App::Property", "The edge that is continued")),
    ("End", "App::PropertyEnumeration", QT_TRANSLATE_NOOP(
        "App::Property", "The end at which it is continued")),
    ("IncludeSource", "App::PropertyBool", QT_TRANSLATE_NOOP(
        "App::Property", "Whether the shape is a wire of the edge and its continuation, not the "
                         "continuation alone")),
))
_EXTENSION = ("Extension", (
    ("Continuation", "App::PropertyEnumeration", QT_TRANSLATE_NOOP(
        "App::Property", "Geometric: the shape goes on; parametric: its parameter too; "
                         "re-parametrised: likewise, and cut at Parameter; natural: the curve "
                         "itself goes on")),
    ("Order", "App::PropertyIntegerConstraint", QT_TRANSLATE_NOOP(
        "App::Property", "Order of contact with the edge, 0 to 8")),
    ("Parameter", "App::PropertyFloatConstraint", QT_TRANSLATE_NOOP(
        "App::Property", "Which part of the parametric continuation over 0 to 1 is taken")),
    ("Degree", "App::PropertyIntegerConstraint", QT_TRANSLATE_NOOP(
        "App::Property", "The degree; 0 for the least that can")),
    ("WantedLength", "App::PropertyLength", QT_TRANSLATE_NOOP(
        "App::Property", "The length of the continuation")),
    ("WantedLengthFixed", "App::PropertyBool", QT_TRANSLATE_NOOP(
        "App::Property", "Whether the length is given; else it follows from all else")),
    ("Fairness", "App::PropertyEnumeration", QT_TRANSLATE_NOOP(
        "App::Property", "What chooses the free numbers: least variation of curvature, least "
                         "bending, or none (there must be no free ones)")),
    ("Numbers", "App::PropertyEnumeration", QT_TRANSLATE_NOOP(
        "App::Property", "Which numbers are given: beta, or tangential coordinates of the poles")),
))
_TARGETS = ("Targets", (
    ("PointTarget", "App::PropertyEnumeration", QT_TRANSLATE_NOOP(
        "App::Property", "Whether the continuation ends at a vertex or a position")),
    ("PointVertex", LINK, QT_TRANSLATE_NOOP("App::Property", "The vertex at which it ends")),
    ("PointPosition", "App::PropertyVectorDistance", QT_TRANSLATE_NOOP(
        "App::Property", "The point at which it ends")),
    ("DirectionTarget", "App::PropertyBool", QT_TRANSLATE_NOOP(
        "App::Property", "Whether it arrives there in a given direction")),
    ("Direction", "App::PropertyVector", QT_TRANSLATE_NOOP(
        "App::Property", "The direction of the tangent at its far end")),
    ("CurvatureTarget", "App::PropertyEnumeration", QT_TRANSLATE_NOOP(
        "App::Property", "Whether it arrives with a given curvature, its magnitude or its vector")),
    ("Curvature", "App::PropertyFloatConstraint", QT_TRANSLATE_NOOP(
        "App::Property", "The curvature at its far end in 1/mm, 0 for straight")),
    ("CurvatureVector", "App::PropertyVector", QT_TRANSLATE_NOOP(
        "App::Property", "The curvature vector at its far end in 1/mm, towards the centre")),
))
_FREE = ("Result", (
    ("FreeNumbers", "App::PropertyInteger", QT_TRANSLATE_NOOP(
        "App::Property", "How many numbers were left free, so that fairness chose them")),
))

GROUPS = (_EDGE, _EXTENSION, _TARGETS, beta_numbers.group, tangential_numbers.group)
RESULT_GROUPS = (_FREE,)
STARTS = {
    "End": ["end", "start"],
    "Continuation": list(CONTINUATIONS),
    "Order": (4, 0, osculate.MAX_ORDER, 1),
    "Parameter": (1.0, LEAST_PARAMETER, MOST_PARAMETER, 0.05),
    "Degree": (0, 0, MOST_DEGREE, 1),
    "Fairness": list(FAIRNESS),
    "Numbers": list(NUMBERS),
    "PointTarget": list(POINTS),
    "Direction": FreeCAD.Vector(1, 0, 0),
    "CurvatureTarget": list(CURVATURES),
    "Curvature": (0.0, 0.0, 1e9, 0.01),
    beta_numbers.number_name(1): 1.0,
}
