"""The properties of the document object Audit: names, types, groups, what they mean."""

import FreeCAD

from osculate import MAX_ORDER
from osculate.features.feature import STATUS
from osculate.features.properties import LOOK
from osculate.features.tolerance_properties import STARTS as TOLERANCE_STARTS
from osculate.features.tolerance_properties import TOLERANCES

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

PAIRS = ("tangent", "wire", "all")
DRAWN = ("all", "out of tolerance", "none")

_MODEL = ("Model", (
    ("Sources", "App::PropertyLinkSubListGlobal", QT_TRANSLATE_NOOP(
        "App::Property", "The objects whose joins are audited; of each all edges count")),
    ("Fixes", "App::PropertyLinkListGlobal", QT_TRANSLATE_NOOP(
        "App::Property", "Matched curves that stand for the edges that they change")),
    ("Pairs", "App::PropertyEnumeration", QT_TRANSLATE_NOOP(
        "App::Property", "Which edges at a vertex are a join: all but corners, those that follow "
                         "each other in a wire, or all")),
    ("CornerAngle", "App::PropertyAngle", QT_TRANSLATE_NOOP(
        "App::Property", "Tangents that turn by more than this are a corner")),
    ("TouchDistance", "App::PropertyLength", QT_TRANSLATE_NOOP(
        "App::Property", "How far ends of edges in no wire may be apart to be a join; 0: only "
                         "where they share a vertex")),
    ("Required", "App::PropertyIntegerConstraint", QT_TRANSLATE_NOOP(
        "App::Property", "The order that joins must have; those below are out of tolerance")),
))
_LOOK = ("Look", (
    ("Drawn", "App::PropertyEnumeration", QT_TRANSLATE_NOOP(
        "App::Property", "Which joins are drawn, in the colour of their order"), LOOK),
    ("MostLabels", "App::PropertyIntegerConstraint", QT_TRANSLATE_NOOP(
        "App::Property", "How many joins that are out of tolerance have a number, the worst first"),
     LOOK),
    ("Legend", "App::PropertyBool", QT_TRANSLATE_NOOP(
        "App::Property", "Whether the view explains the colours"), LOOK),
))
_ORDERS = tuple((f"G{order}", "App::PropertyInteger", QT_TRANSLATE_NOOP(
    "App::Property", "Number of joins of this order")) for order in range(MAX_ORDER + 1))
_RESULT = ("Result", (
    STATUS[0],
    ("Joins", "App::PropertyInteger", QT_TRANSLATE_NOOP("App::Property", "Number of joins")),
    ("OutOfTolerance", "App::PropertyInteger", QT_TRANSLATE_NOOP(
        "App::Property", "Number of joins below the order that they must have")),
    ("Gaps", "App::PropertyInteger", QT_TRANSLATE_NOOP(
        "App::Property", "Number of joins that are not even G0")),
    *_ORDERS,
    ("Undecided", "App::PropertyInteger", QT_TRANSLATE_NOOP(
        "App::Property", "Number of joins with an order that rounding leaves undecided")),
    ("Corners", "App::PropertyInteger", QT_TRANSLATE_NOOP(
        "App::Property", "Number of pairs of edges that were left out as corners")),
    ("EdgeCount", "App::PropertyInteger", QT_TRANSLATE_NOOP("App::Property", "Number of edges")),
    ("WorstOrder", "App::PropertyInteger", QT_TRANSLATE_NOOP(
        "App::Property", "Order of the worst join, -1 for a gap")),
    ("Worst", "App::PropertyString", QT_TRANSLATE_NOOP(
        "App::Property", "The worst join, and what it misses")),
    ("WorstPosition", "App::PropertyVector", QT_TRANSLATE_NOOP(
        "App::Property", "Where the worst join is")),
    ("Warnings", "App::PropertyStringList", QT_TRANSLATE_NOOP(
        "App::Property", "What was not audited, in sentences")),
    STATUS[1],
))

GROUPS = (_MODEL, TOLERANCES, _LOOK)
RESULT_GROUPS = (_RESULT,)
STARTS = {**TOLERANCE_STARTS, "Pairs": list(PAIRS), "CornerAngle": 15.0, "TouchDistance": 0.01,
          "Required": (1, 0, MAX_ORDER, 1), "Drawn": list(DRAWN), "MostLabels": (50, 0, 1000, 10),
          "Legend": True}
