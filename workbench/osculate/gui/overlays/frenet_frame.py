"""The Frenet frames of one or both sides: arrows of a fixed length on the screen, with letters."""

import math

from osculate.gui import colors
from osculate.gui.overlays import nodes, sprites
from osculate.gui.overlays.pixel_scale import in_pixels

#: How the frame of each side is drawn: the second longer and dashed, to be seen beside the first.
_STRETCH = (1.0, 1.35)
_WIDTH = (3.0, 2.0)
_PATTERN = (nodes.SOLID, nodes.DASHED)

#: Axes of the two frames that agree better carry one letter, not two over each other.
_SAME_AXIS = math.cos(math.radians(8.0))


def frames_node(sides, length, text_points):
    """Arrows of `length` pixels at the points of one or two sides, which have the attributes of a
    PointGeometry; an axis that a side does not have is not drawn.
    """
    arrows = ([], [])
    second = _axes(sides[1]) if len(sides) > 1 else (None, None, None)
    for letter, color, *axes in zip("tnb", colors.FRAME, _axes(sides[0]), second):
        for index, (axis, text) in enumerate(zip(axes, _letters(letter, *axes))):
            if axis is not None:
                arrows[index].extend(_arrow(axis, index, length, color, text, text_points))
    return nodes.separator(*(in_pixels(side.point, *arrows[index])
                             for index, side in enumerate(sides)))


def _axes(side):
    return side.tangent, side.normal, side.binormal


def _letters(letter, first, second):
    """The texts at an axis of the first and of the second frame."""
    if first is not None and second is not None and float(first @ second) > _SAME_AXIS:
        return "", letter
    return letter, letter + "′"


def _arrow(axis, index, length, color, text, text_points):
    length *= _STRETCH[index]
    tip, base, beyond = ([(length + more) * float(x) for x in axis] for more in (0.0, -8.0, 12.0))
    yield nodes.colored_polyline([(0.0, 0.0, 0.0), base], color, _WIDTH[index], _PATTERN[index])
    yield nodes.arrow_head(tip, axis, color, 11.0, 4.0)
    if text:
        yield nodes.at(beyond, sprites.letter(text, color, text_points))
