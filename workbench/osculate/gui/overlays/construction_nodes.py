"""The construction of de Casteljau in the 3D view: the polygons of all levels."""

import numpy

from osculate.gui import colors
from osculate.gui.overlays import nodes
from osculate.gui.overlays.markers import Points, disk

_WIDTH, _POINT = 1.6, 6.0


def construction_node(levels):
    """Nodes of the polygons that osculate.polygons.de_casteljau gives; each level has its colour.
    """
    parts = []
    for number, points in enumerate(levels):
        color = color_of_level(number)
        lines = nodes.Polylines(color, _WIDTH, has_rim=True)
        lines.show(points, (len(points),) if len(points) > 1 else ())
        marks = Points(disk, color, _POINT)
        marks.show(numpy.asarray(points))
        parts += [lines.node, marks.node]
    return nodes.separator(*parts)


def color_of_level(number):
    """The colour of a level; level 0 is the control polygon."""
    return colors.LEVELS[0] if number == 0 else (
        colors.LEVELS[1 + (number - 1) % (len(colors.LEVELS) - 1)])
