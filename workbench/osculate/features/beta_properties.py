"""The free numbers β1, β2, … of the ends of a curve as properties (see number_properties)."""

import functools

import FreeCAD

from osculate.features.number_properties import NumberProperties

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

_MEANING = QT_TRANSLATE_NOOP(
    "App::Property", "The derivative of arc length of this order at the end, by the parameter, as "
                     "a share of the chord; β1 is the speed")


@functools.cache
def of_side(side=""):
    """The NumberProperties of one end of several, e.g. "First"; of the only one without a name."""
    return NumberProperties(f"{side}Beta", f"{side} beta" if side else "Beta", "App::PropertyFloat",
                            _MEANING)


def number_name(side, k):
    """The property with β of order k, e.g. "FirstBeta1"."""
    return of_side(side).number_name(k)


def fixed_name(side, k):
    """The property that says whether it is fixed, e.g. "FirstBeta1Fixed"."""
    return of_side(side).fixed_name(k)


def group(side):
    """The properties of one end, for properties.add_properties."""
    return of_side(side).group


def given(obj, side, order):
    """The numbers up to an order as osculate takes them: None for those that are chosen."""
    return of_side(side).given(obj, order)


def settings(side, numbers):
    """The properties that fix the given numbers and leave those that are None free, as a dict."""
    return of_side(side).settings(numbers)


def show(obj, side, numbers):
    """Shows the numbers that came out."""
    of_side(side).show(obj, numbers)


def set_editors(obj, side, order):
    """Free numbers cannot be edited, those above the order of contact are not seen."""
    of_side(side).set_editors(obj, order)
