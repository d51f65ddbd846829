"""Colours of the Jacobian determinant: blue where the solid is right, orange where it folds.

Blue and orange are told apart by people who see no red or no green. Next to 0 both sides are far
apart, so that a fold shows however small its Jacobian is.
"""

import functools

import numpy
from pivy import coin

from osculate.gui.overlays.nodes import rgb

#: (share of the largest magnitude, colour), between which colours are interpolated.
NEGATIVE = ((0.0, "#f7941d"), (1.0, "#8f2d04"))
POSITIVE = ((0.0, "#fbfaf3"), (0.35, "#a9cbe6"), (1.0, "#15508f"))

#: The share of the largest magnitude up to which a Jacobian is 0.
ROUNDING = 1e-9

_TEXELS = 2048


def colors_of(values, largest):
    """(N, 3) colours in 0..1 of Jacobians whose largest magnitude is `largest`."""
    shares = numpy.asarray(values, float) / largest if largest > 0.0 else numpy.zeros(len(values))
    is_negative = shares < -ROUNDING
    return numpy.where(is_negative[:, None], _mixed(NEGATIVE, -shares), _mixed(POSITIVE, shares))


def places_of(values, largest):
    """Places (N, 2) in the `texture` of Jacobians; no rounding of a 0 leads to the wrong side."""
    shares = numpy.asarray(values, float) / largest if largest > 0.0 else numpy.zeros(len(values))
    places = 0.5 + 0.5 * shares
    places = numpy.where(shares < -ROUNDING, numpy.minimum(places, 0.5 - 2.0 / _TEXELS),
                         numpy.maximum(places, 0.5 + 1.0 / _TEXELS))
    return numpy.column_stack([places, numpy.full(len(places), 0.5)])


@functools.lru_cache(maxsize=None)
def texture():
    """The colours of -1 to 1 as a Coin node. Colours at the points of a mesh would be mixed across
    0, and the rim of a fold be jagged.
    """
    shares = (2.0 * numpy.arange(_TEXELS) + 1.0) / _TEXELS - 1.0
    pixels = numpy.rint(255.0 * colors_of(shares, 1.0)).astype(numpy.uint8)
    node = coin.SoTexture2()
    node.image.setValue(coin.SbVec2s(_TEXELS, 1), 3, pixels.tobytes())
    node.wrapS = node.wrapT = coin.SoTexture2.CLAMP
    node.ref()  # Python's reference alone is none for Coin
    return node


def _mixed(stops, shares):
    places = [place for place, _ in stops]
    channels = zip(*(rgb(name) for _, name in stops))
    return numpy.column_stack([numpy.interp(shares, places, channel) for channel in channels])
