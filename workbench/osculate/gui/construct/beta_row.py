"""One free number β: its name, whether it is fixed, a slider, a spin box."""

import math

from osculate.gui.construct.number_row import NumberRow
from osculate.gui.qt import translate

_SUBSCRIPTS = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")
_LEAST, _MOST = 1e-6, 1e6          # of beta_1, which is positive
_DECADES = 1.0                     # a slider of beta_1 goes from 0.1 to 10
_REACH = {2: 4.0, 3: 5.5, 4: 7.5}  # of the others: to ±sinh of it, about 27, 120, 900


class BetaRow(NumberRow):
    """The widgets of β of order k at one end: even in its logarithm, or nearly so."""

    def __init__(self, k):
        super().__init__(k, with_subscript("β", k), _meaning(k),
                         (_LEAST, _MOST) if k == 1 else (-1e9, 1e9))

    def number_at(self, place):
        if self._k == 1:
            return 10.0 ** (_DECADES * place)
        return math.sinh(_reach(self._k) * place)

    def place_of(self, value):
        return math.log10(value) / _DECADES if self._k == 1 else math.asinh(value) / _reach(self._k)


def with_subscript(letter, k):
    """E.g. "β₁"."""
    return letter + str(k).translate(_SUBSCRIPTS)


def _reach(k):
    return _REACH.get(k, 2.0 * k)


def _meaning(k):
    if k == 1:
        return translate("Osculate", "The speed at this end, as a share of the chord; it has a "
                                     "handle in the 3D view")
    if k == 2:
        return translate("Osculate", "The change of speed at this end, as a share of the chord; it "
                                     "has a handle in the 3D view")
    return translate("Osculate", "The derivative of order {} of arc length at this end, as a share "
                                 "of the chord").format(k)
