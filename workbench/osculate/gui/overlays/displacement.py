"""How far the points of a curve moved by a change of it."""

import numpy

from osculate.gui import colors, numbers
from osculate.gui.overlays import nodes, sprites
from osculate.gui.overlays.placement import CORNERS, in_freest_corner

_LINES = 33  # that are drawn from before to after
_NEUTRAL = "#7c8794"


def displacement_marks(original, result, text_points):
    """Nodes of lines between points of the same parameters of a Curve before and after a change,
    and of a label where it moved farthest; none where nothing moved.

    result: the osculate.Construction that changed it.
    """
    if not result.max_displacement_mm:
        return []
    parameters = numpy.linspace(*result.change["range"], _LINES)
    before = original.evaluate(numpy.clip(parameters, *original.parameter_range))[:, 0]
    after = result.curve.evaluate(parameters)[:, 0]
    return [nodes.plain_lines(list(zip(before, after)), _NEUTRAL, 1.0),
            _label(result, after, text_points)]


def _label(result, after, text_points):
    """Where the curve moved farthest, from a dot to a dot, and by how much."""
    point, moved, color = result.change["point"], result.change["moved"], colors.MADE
    name = numbers.quantity(result.max_displacement_mm, "mm", 3)
    labels = [sprites.callout(name, "", color, text_points, corner) for corner in CORNERS]
    around = [point - moved, *(place - moved for place in _neighbours(after, moved))]
    return nodes.separator(
        nodes.colored_polyline([point, moved], color, 2.0),
        nodes.at(point, sprites.dot(_NEUTRAL)),
        nodes.at(moved, sprites.dot(color), in_freest_corner(labels, around)))


def _neighbours(points, point):
    """Two of the points that lie before and after another one on a curve."""
    place = numpy.linalg.norm(points - point, axis=1).argmin()
    return points[max(place - 1, 0)], points[min(place + 1, len(points) - 1)]
