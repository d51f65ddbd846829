"""The Bézier segment of one side: its curve in the direction of travel, and its control polygon."""

from osculate.gui.overlays import nodes, sprites
from osculate.gui.overlays.pixel_scale import in_pixels

_STEPS = 48
_HEAD_LENGTH, _HEAD_RADIUS = 15.0, 6.0


def segment_node(side, arriving, color, number):
    """The curve of a SideReport's segment with an arrow head and the number of the side;
    nothing if the segment is a single point."""
    if side.segment is None:
        return nodes.separator()
    points = _points_in_travel(side, arriving)
    middle = len(points) // 2
    direction = points[middle + 1] - points[middle]
    marks = [nodes.colored_polyline(points, color, 3.5)]
    if direction.any():
        head = nodes.arrow_head((0, 0, 0), direction, color, _HEAD_LENGTH, _HEAD_RADIUS)
        marks.append(in_pixels(points[middle], head))
    marks.append(nodes.at(points[len(points) // 4 if arriving else -len(points) // 4],
                          sprites.tag(number, color)))
    return nodes.separator(*marks)


def polygon_node(side, color):
    """The control polygon of a SideReport's segment: dashed legs, a dot at each pole;
    nothing if it is a single point."""
    if side.segment is None:
        return nodes.separator()
    poles = side.segment.poles
    dots = [nodes.at(pole, sprites.dot(color)) for pole in poles]
    return nodes.separator(nodes.colored_polyline(poles, color, 1.5, nodes.DASHED), *dots)


def _points_in_travel(side, arriving):
    points = [side.segment.evaluate(step / _STEPS)[0] for step in range(_STEPS + 1)]
    if arriving != (side.end == "end"):
        points.reverse()
    return points
