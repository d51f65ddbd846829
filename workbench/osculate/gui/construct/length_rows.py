"""Numbers in mm that may be fixed: the length of a curve, coordinates along its tangent."""

import math

from osculate.features.extended_curve_properties import LEAST_PARAMETER, MOST_PARAMETER
from osculate.gui.construct.beta_row import with_subscript
from osculate.gui.construct.number_row import NumberRow
from osculate.gui.qt import translate

_LEAST, _MOST = 1e-6, 1e9
_DECADES = 1.5  # a slider of a length goes to a thirtieth of the scale and to thirty times as much


class LengthRow(NumberRow):
    """A length, > 0."""

    def __init__(self):
        super().__init__(0, translate("Osculate", "Length"),
                         translate("Osculate", "The length of the curve that is made"),
                         (_LEAST, _MOST), " mm")
        self.scale = 1.0  #: mm, in the middle of the slider

    def free_tip(self):
        return translate("Osculate", "Follows from all else: click to fix it as it is")

    def number_at(self, place):
        return self.scale * 10.0 ** (_DECADES * place)

    def place_of(self, value):
        return math.log10(max(value, _LEAST) / self.scale) / _DECADES


class TangentialRow(NumberRow):
    """The tangential coordinate of the pole C_k."""

    def __init__(self, k):
        super().__init__(k, with_subscript("C", k), translate(
            "Osculate", "How far pole {} lies ahead of the end along the tangent").format(k),
            (_LEAST if k == 1 else -_MOST, _MOST), " mm")
        self.scale = 1.0  #: mm, at the right end of the slider

    def number_at(self, place):
        if self._k == 1:
            return self.scale * 10.0 ** (_DECADES * (place - 1.0))
        return self.scale * place

    def place_of(self, value):
        if self._k == 1:
            return 1.0 + math.log10(max(value, _LEAST) / self.scale) / _DECADES
        return value / self.scale


class ParameterRow(NumberRow):
    """Which part of a parametric continuation is taken; it is always given."""

    def __init__(self):
        super().__init__(0, translate("Osculate", "Up to"), translate(
            "Osculate", "Which part of the parametric continuation over 0 to 1 is taken; more than "
                        "1 lets it go on"), (LEAST_PARAMETER, MOST_PARAMETER))

    def number_at(self, place):
        return 10.0 ** place

    def place_of(self, value):
        return math.log10(value)

    def set_visible(self, is_visible):
        super().set_visible(is_visible)
        self.lock.hide()
