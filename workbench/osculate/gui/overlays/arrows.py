"""Many arrows of one colour in the model's own scale, fast to change."""

import math

import numpy
from pivy import coin

from osculate.gui.overlays import nodes

_SIDES = 8          # of the pyramid that is the head
_SHARE = 0.3        # of the length of an arrow, the most that its head takes
_SLENDER = 0.38     # radius of a head over its length
_WIDTH = 2.0


class Arrows:
    """Arrows in space; `node` goes into the scene."""

    def __init__(self, color):
        self._shafts = nodes.Polylines(color, _WIDTH, has_rim=True)
        self._coordinates, self._faces = coin.SoCoordinate3(), coin.SoIndexedFaceSet()
        self.node = nodes.separator(
            self._shafts.node, *nodes.flat_color(nodes.rgb(color)), self._coordinates, self._faces)

    def show(self, starts, vectors, head):
        """Draws arrows from (n, 3) starts along (n, 3) vectors, with heads of up to `head` mm;
        those without a length are left out.
        """
        lengths = numpy.linalg.norm(vectors, axis=1)
        exists = lengths > 0.0
        starts, vectors, lengths = starts[exists], vectors[exists], lengths[exists]
        heads = numpy.minimum(_SHARE * lengths, head)
        directions = vectors / lengths[:, None]
        tips = starts + vectors
        bases = tips - heads[:, None] * directions
        self._shafts.show(numpy.stack((starts, bases), axis=1).reshape(-1, 3), (2,) * len(starts))
        points, faces = _pyramids(tips, bases, directions, _SLENDER * heads)
        nodes.set_points(self._coordinates, points)
        self._faces.coordIndex.setNum(len(faces))
        self._faces.coordIndex.setValues(0, len(faces), faces.tolist())


def _pyramids(tips, bases, directions, radii):
    """(points, indices of faces as Coin has them)"""
    across = numpy.zeros_like(directions)
    least = numpy.abs(directions).argmin(axis=1)
    across[numpy.arange(len(across)), least] = 1.0
    first = numpy.cross(directions, across)
    first /= numpy.linalg.norm(first, axis=1)[:, None]
    second = numpy.cross(directions, first)
    angles = numpy.arange(_SIDES) * (2.0 * math.pi / _SIDES)
    rims = bases[:, None] + radii[:, None, None] * (
        numpy.cos(angles)[None, :, None] * first[:, None]
        + numpy.sin(angles)[None, :, None] * second[:, None])
    points = numpy.concatenate((tips[:, None], rims), axis=1).reshape(-1, 3)
    sides = [(0, 1 + side, 1 + (side + 1) % _SIDES) for side in range(_SIDES)]
    indices = numpy.array([*sides, (1, _SIDES // 3 + 1, 2 * _SIDES // 3 + 1)])
    each = numpy.arange(len(tips))[:, None, None] * (1 + _SIDES) + indices
    ends = numpy.full((*each.shape[:2], 1), -1)
    return points, numpy.concatenate((each, ends), axis=2).ravel()
