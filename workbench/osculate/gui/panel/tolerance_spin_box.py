"""A spin box for tolerances: any size of number, steps of 1, 2, 5."""

import math

from osculate.gui.panel.number_spin_box import NumberSpinBox

_LEAST, _MOST = 1e-12, 1e6


class ToleranceSpinBox(NumberSpinBox):
    """A positive number of up to 6 significant digits."""

    def __init__(self, suffix):
        super().__init__(suffix, _LEAST, _MOST)

    def is_allowed(self, value):
        return value > 0.0

    def next_step(self, value, up):
        return _next_step(value, up)

    def sizeHint(self):
        hint = super().sizeHint()
        hint.setWidth(self.fontMetrics().horizontalAdvance("0.000000001 mm") + 30)
        return hint

    def minimumSizeHint(self):
        return self.sizeHint()


def _next_step(value, up):
    """The next number of the series ..., 1, 2, 5, 10, ... above or below."""
    series = [step * 10.0 ** power for power in range(math.floor(math.log10(value)) - 1,
                                                      math.floor(math.log10(value)) + 3)
              for step in (1, 2, 5)]
    if up:
        return min(step for step in series if step > value * (1 + 1e-9))
    return max(step for step in series if step < value * (1 - 1e-9))
