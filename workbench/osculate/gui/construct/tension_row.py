"""A tension, of all points or of one."""

import math

from osculate.gui.construct.number_row import NumberRow
from osculate.gui.qt import translate

_DECADES = 2.0  # to the left and to the right of the middle of the slider
_MOST = 1e9


class TensionRow(NumberRow):
    """A tension >= 0; without a lock it is always given."""

    def __init__(self, name, meaning, has_lock):
        super().__init__(0, name, meaning, (0.0, _MOST))
        self._has_lock = has_lock

    def free_tip(self):
        return translate("Osculate", "That of all points: click to give the point its own")

    def number_at(self, place):
        return 10.0 ** (_DECADES * (place + 1.0)) - 1.0

    def place_of(self, value):
        return math.log10(max(value, 0.0) + 1.0) / _DECADES - 1.0

    def set_visible(self, is_visible):
        super().set_visible(is_visible)
        self.lock.setVisible(is_visible and self._has_lock)
