"""The free numbers β1, β2, … of the ends of a curve as properties: each a number, fixed or not.

A fixed number is the user's; one that is not is chosen at each recompute and shown.
"""

import FreeCAD

from osculate import MAX_ORDER
from osculate.features.properties import HIDDEN, READ_ONLY, SHOWN, set_if_changed

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

_MEANING = QT_TRANSLATE_NOOP(
    "App::Property", "The derivative of arc length of this order at the end, by the parameter, as "
                     "a share of the chord; β1 is the speed")
_FIXED_MEANING = QT_TRANSLATE_NOOP(
    "App::Property", "Whether the number is given; else it is chosen at each recompute")


def number_name(side, k):
    """The property with β of order k, e.g. "FirstBeta1"."""
    return f"{side}Beta{k}"


def fixed_name(side, k):
    """The property that says whether it is fixed, e.g. "FirstBeta1Fixed"."""
    return f"{side}Beta{k}Fixed"


def group(side):
    """The properties of one end, for properties.add_properties."""
    rows = []
    for k in range(1, MAX_ORDER + 1):
        rows.append((number_name(side, k), "App::PropertyFloat", _MEANING))
        rows.append((fixed_name(side, k), "App::PropertyBool", _FIXED_MEANING))
    return f"{side} beta", tuple(rows)


def given(obj, side, order):
    """The numbers up to an order as osculate takes them: None for those that are chosen."""
    return tuple(getattr(obj, number_name(side, k)) if getattr(obj, fixed_name(side, k)) else None
                 for k in range(1, order + 1))


def settings(side, numbers):
    """The properties that fix the given numbers and leave those that are None free, as a dict."""
    result = {}
    for k, number in enumerate(numbers, start=1):
        result[fixed_name(side, k)] = number is not None
        if number is not None:
            result[number_name(side, k)] = number
    return result


def show(obj, side, numbers):
    """Shows the numbers that came out."""
    for k, number in enumerate(numbers, start=1):
        if not getattr(obj, fixed_name(side, k)):
            set_if_changed(obj, number_name(side, k), number)


def set_editors(obj, side, order):
    """Free numbers cannot be edited, those above the order of contact are not seen."""
    for k in range(1, MAX_ORDER + 1):
        is_used = k <= order
        is_fixed = getattr(obj, fixed_name(side, k))
        obj.setEditorMode(number_name(side, k),
                          HIDDEN if not is_used else SHOWN if is_fixed else READ_ONLY)
        obj.setEditorMode(fixed_name(side, k), SHOWN if is_used else HIDDEN)
