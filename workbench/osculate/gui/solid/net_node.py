"""The control net of a Bézier solid in the 3D view: legs, points, labels."""

import functools

import numpy
from pivy import coin

from osculate.features.control_net import indices_of, name_of
from osculate.gui import numbers
from osculate.gui.overlays import nodes, sprites
from osculate.gui.overlays.markers import disk
from osculate.gui.qt import QtGui
from osculate.gui.solid.surface_node import LinesNode, fill, through_everything

_LEG_WIDTH = 1.5
_FAINT = 0.75  # transparency of what lies behind the faces
_DIGITS = 4    # of weights
_SAME = 1e-6   # share of the net's size within which points have one label


class NetNode:
    """Draws a net; `node` goes into the scene and stays there while the points move.

    Points keep their size on the screen. What lies behind a face is seen faintly.
    """

    def __init__(self):
        self._legs, self._far_legs = LinesNode(), LinesNode(through_everything())
        self._coordinates = coin.SoCoordinate3()
        self._color, self._markers = coin.SoMaterial(), coin.SoMarkerSet()
        self._depth = coin.SoDepthBuffer()
        points = nodes.separator(nodes.unpickable(), self._depth, nodes.unlit(), self._color,
                                 self._coordinates, self._markers)
        self._labels = coin.SoSeparator()
        self._places, self._labelled = [], None
        self.node = nodes.separator(self._far_legs.node, self._legs.node,
                                    points, self._labels)

    def show(self, solid, *, indices, weights, text_points):
        """Draws the net of a solid, with labels where indices or weights are wanted."""
        points = solid.points
        for legs in (self._legs, self._far_legs):
            legs.show_legs(points, legs_of(solid.degree))
        fill(self._coordinates.point, points.tolist())
        texts = _texts(solid, indices, weights)
        if (tuple(texts.values()), text_points) != self._labelled:
            self._labelled = tuple(texts.values()), text_points
            self._label(*self._labelled)
        for place, number in zip(self._places, texts):
            place.translation = tuple(map(float, points[number]))

    def paint(self, color, point_size, in_front):
        """in_front: nothing hides the points."""
        self._legs.paint(color, _LEG_WIDTH)
        self._far_legs.paint(color, _LEG_WIDTH, _FAINT)
        self._color.diffuseColor = tuple(color[:3])
        density = QtGui.QGuiApplication.primaryScreen().devicePixelRatio()
        self._markers.markerIndex = disk(max(round(point_size * density), 1))
        self._depth.test = not in_front

    def _label(self, texts, text_points):
        self._labels.removeAllChildren()
        self._places = []
        if not texts:
            return
        labels = []
        for text in texts:
            place = coin.SoTranslation()
            self._places.append(place)
            labels.append(nodes.separator(place, sprites.note(text, text_points)))
        self._labels.addChild(nodes.untouchable(*labels))


@functools.lru_cache(maxsize=None)
def legs_of(degree):
    """Pairs of positions in the net of a degree whose indices are neighbours."""
    indices = indices_of(degree)
    position = {index: place for place, index in enumerate(indices)}
    legs = []
    for index in indices:
        for a in range(4):
            for b in range(a + 1, 4):
                if index[a] > 0:
                    moved = list(index)
                    moved[a] -= 1
                    moved[b] += 1
                    legs.append((position[index], position[tuple(moved)]))
    return tuple(legs)


def weight_of(solid, place):
    """The weight of a control point, 1 in a polynomial solid."""
    weights = solid.weights
    return 1.0 if weights is None else float(weights[place])


def _texts(solid, with_indices, with_weights):
    """{number of a control point: its label}; of points in one place the last, which is a corner
    if one is, says how many others there are.
    """
    if not (with_indices or with_weights):
        return {}
    texts = {}
    for numbers_here in together(solid.points):
        last = numbers_here[-1]
        parts = [name_of(solid.degree, last)] if with_indices else []
        if with_weights:
            weight = numbers.number(weight_of(solid, last), _DIGITS)
            parts.append(f"w = {weight}" if with_indices else weight)
        if len(numbers_here) > 1:
            parts.append(f"(+{len(numbers_here) - 1})")
        texts[last] = "  ".join(parts)
    return texts


def together(points):
    """The numbers of the points, those in one place together."""
    places = {}
    scale = _SAME * max(float(numpy.ptp(points, axis=0).max()), 1e-300)
    for number, place in enumerate(numpy.rint(points / scale).tolist()):
        places.setdefault(tuple(place), []).append(number)
    return places.values()
