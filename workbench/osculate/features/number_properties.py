"""Numbers of an end, one for each order from 1 to the order of contact, as properties: each has a
companion that says whether it is fixed.

A fixed number is the user's; one that is not is chosen at each recompute and shown.
"""

import FreeCAD

from osculate import MAX_ORDER
from osculate.features.properties import HIDDEN, READ_ONLY, SHOWN, set_if_changed

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

_FIXED_MEANING = QT_TRANSLATE_NOOP(
    "App::Property", "Whether the number is given; else it is chosen at each recompute")


class NumberProperties:
    """The properties "<prefix>1", "<prefix>1Fixed", "<prefix>2", ... of one end."""

    def __init__(self, prefix, group_name, kind, meaning):
        self._prefix = prefix
        self._group_name = group_name
        self._kind = kind
        self._meaning = meaning

    def number_name(self, k):
        """The property with the number of order k, e.g. "FirstBeta1"."""
        return f"{self._prefix}{k}"

    def fixed_name(self, k):
        """The property that says whether it is fixed, e.g. "FirstBeta1Fixed"."""
        return f"{self._prefix}{k}Fixed"

    @property
    def group(self):
        """The properties, for properties.add_properties."""
        rows = []
        for k in range(1, MAX_ORDER + 1):
            rows.append((self.number_name(k), self._kind, self._meaning))
            rows.append((self.fixed_name(k), "App::PropertyBool", _FIXED_MEANING))
        return self._group_name, tuple(rows)

    def number(self, obj, k):
        """The number of order k without its unit."""
        value = getattr(obj, self.number_name(k))
        return getattr(value, "Value", value)

    def is_fixed(self, obj, k):
        return getattr(obj, self.fixed_name(k))

    def given(self, obj, order):
        """The numbers up to an order as osculate takes them: None for those that are chosen."""
        return tuple(self.number(obj, k) if self.is_fixed(obj, k) else None
                     for k in range(1, order + 1))

    def settings(self, numbers):
        """The properties that fix the given numbers and free those that are None, as a dict."""
        result = {}
        for k, number in enumerate(numbers, start=1):
            result[self.fixed_name(k)] = number is not None
            if number is not None:
                result[self.number_name(k)] = number
        return result

    def freed(self):
        """The properties that free all numbers, as a dict."""
        return {self.fixed_name(k): False for k in range(1, MAX_ORDER + 1)}

    def show(self, obj, numbers):
        """Shows the numbers that came out."""
        for k, number in enumerate(numbers, start=1):
            if not self.is_fixed(obj, k):
                set_if_changed(obj, self.number_name(k), number)

    def set_editors(self, obj, order):
        """Free numbers cannot be edited, those above the order of contact are not seen."""
        for k in range(1, MAX_ORDER + 1):
            is_used = k <= order
            obj.setEditorMode(self.number_name(k), HIDDEN if not is_used else
                              SHOWN if self.is_fixed(obj, k) else READ_ONLY)
            obj.setEditorMode(self.fixed_name(k), SHOWN if is_used else HIDDEN)
