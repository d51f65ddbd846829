"""The Frenet frame of one side: three arrows of a fixed length on the screen, with letters."""

from osculate.gui import colors
from osculate.gui.overlays import nodes, sprites
from osculate.gui.overlays.pixel_scale import in_pixels

#: How the frame of each side is drawn. The second is longer and dashed, so that both are seen where they agree.
_STRETCH = (1.0, 1.35)
_WIDTH = (3.0, 2.0)
_PATTERN = (nodes.SOLID, nodes.DASHED)
_PRIME = ("", "′")


def frame_node(side, index, length, text_points, lettered=True):
    """Arrows of `length` pixels at the point of a SideReport; `index` 0: arriving, 1: leaving.

    An axis that does not exist is not drawn.
    """
    arrows = []
    for letter, color, axis in zip("tnb", colors.FRAME, (side.tangent, side.normal, side.binormal)):
        if axis is not None:
            text = letter + _PRIME[index] if lettered else ""
            arrows += _arrow(axis, index, length * _STRETCH[index], color, text, text_points)
    return in_pixels(side.point, *arrows)


def _arrow(axis, index, length, color, text, text_points):
    tip = [length * float(x) for x in axis]
    base = [(length - 8.0) * float(x) for x in axis]
    yield nodes.colored_polyline([(0.0, 0.0, 0.0), base], color, _WIDTH[index], _PATTERN[index])
    yield nodes.arrow_head(tip, axis, color, 11.0, 4.0)
    if text:
        beyond = [(length + 12.0) * float(x) for x in axis]
        yield nodes.at(beyond, sprites.letter(text, color, text_points))
