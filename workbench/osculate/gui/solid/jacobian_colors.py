"""Colours of the Jacobian determinant: blue where the solid is right, orange where it folds.

Blue and orange are told apart by people who see no red or no green. Next to 0 both sides are far
apart, so that a fold shows however small its Jacobian is.
"""

import numpy

from osculate.gui.overlays.nodes import rgb

#: (share of the largest magnitude, colour), between which colours are interpolated.
NEGATIVE = ((0.0, "#f7941d"), (1.0, "#8f2d04"))
POSITIVE = ((0.0, "#fbfaf3"), (0.35, "#a9cbe6"), (1.0, "#15508f"))

_ROUNDING = 1e-9  # share of the largest magnitude that is 0


def colors_of(values, largest):
    """(N, 3) colours in 0..1 of Jacobians whose largest magnitude is `largest`."""
    shares = numpy.asarray(values, float) / largest if largest > 0.0 else numpy.zeros(len(values))
    is_negative = shares < -_ROUNDING
    return numpy.where(is_negative[:, None], _mixed(NEGATIVE, -shares), _mixed(POSITIVE, shares))


def _mixed(stops, shares):
    places = [place for place, _ in stops]
    channels = zip(*(rgb(name) for _, name in stops))
    return numpy.column_stack([numpy.interp(shares, places, channel) for channel in channels])
