"""Control polygons in the 3D view: legs, poles, weights, differences."""

from dataclasses import dataclass

from pivy import coin

from osculate.features.control_polygons import PLAIN, arrows_of, size_of_poles
from osculate.gui import colors, numbers
from osculate.gui.overlays import nodes, sprites
from osculate.gui.overlays.arrows import Arrows
from osculate.gui.overlays.markers import Points, disk, square
from osculate.gui.solid.net_node import together

_LEG_WIDTH, _POLE, _END = 1.5, 6.0, 8.0
_HEAD = 0.025       # of an arrow, at most, as a share of the size of the polygons
_MOST_WEIGHTS = 300  # more would be a carpet
_DIGITS = 4


@dataclass(frozen=True)
class PolygonLook:
    """What of control polygons is drawn."""

    weights: bool = False
    differences: tuple = (False, False)  #: of first, of second order
    scaling: str = PLAIN


class PolygonNodes:
    """What is drawn of ControlPolygons; `node` goes into the scene."""

    hidden_weights = 0    #: weights that are not shown, for there are too many
    factors = (1.0, 1.0)  #: what first and second differences are multiplied by

    def __init__(self):
        self._legs = nodes.Polylines(colors.POLYGON, _LEG_WIDTH, has_rim=True)
        self._poles = Points(disk, colors.POLYGON, _POLE)
        self._ends = Points(square, colors.POLYGON_ENDS, _END)
        self._arrows = [Arrows(color) for color in colors.DIFFERENCES]
        self._labels = nodes.separator()
        self._labelled = None
        self._all = nodes.separator(self._legs.node, *(arrows.node for arrows in self._arrows),
                                    self._poles.node, self._ends.node, self._labels)
        self.node = coin.SoSwitch()
        self.node.addChild(self._all)

    def show(self, polygons, look, text_points):
        self.node.whichChild = coin.SO_SWITCH_ALL
        self._legs.show(polygons.poles, polygons.counts)
        self._poles.show(polygons.poles[~polygons.ends])
        self._ends.show(polygons.poles[polygons.ends])
        self.factors = tuple(self._show_differences(polygons, look, order) for order in (1, 2))
        self._show_weights(polygons if look.weights else None, text_points)

    def clear(self):
        """Draws nothing."""
        self.node.whichChild = coin.SO_SWITCH_NONE

    def _show_differences(self, polygons, look, order):
        found, factor = arrows_of(polygons, order, look.scaling)
        count = len(found.poles) if look.differences[order - 1] else 0
        self._arrows[order - 1].show(found.poles[:count], factor * found.vectors[:count],
                                     _HEAD * size_of_poles(polygons))
        return factor

    def _show_weights(self, polygons, text_points):
        labels = _weight_labels(polygons) if polygons is not None else []
        self.hidden_weights = max(len(labels) - _MOST_WEIGHTS, 0)
        labels = labels[:_MOST_WEIGHTS]
        if (labels, text_points) == self._labelled:
            return
        self._labelled = labels, text_points
        self._labels.removeAllChildren()
        for point, text in labels:
            self._labels.addChild(nodes.at(point, sprites.note(text, text_points)))


def _weight_labels(polygons):
    """[(point, text)] of the poles of rational segments; where poles lie in one place, all weights
    that differ there.
    """
    of_rational = polygons.is_rational.repeat(polygons.counts)
    poles, weights = polygons.poles[of_rational], polygons.weights[of_rational]
    if not len(poles):
        return []
    labels = []
    for members in together(poles):
        texts = dict.fromkeys(numbers.number(float(weights[member]), _DIGITS) for member in members)
        labels.append((tuple(poles[members[0]].tolist()), "w = " + " | ".join(texts)))
    return labels
