"""All that is drawn at a join, from its report."""

import math

from osculate.gui.overlays import nodes, sprites
from osculate.gui.overlays.frenet_frame import frame_node
from osculate.gui.overlays.placement import CORNERS, in_freest_corner
from osculate.gui.overlays.segment import polygon_node, segment_node
from osculate.gui.verdict import look_of, missing_text

#: Frames whose axes differ less (degrees) carry one set of letters, which else would overlap.
_DISTINCT_DEGREES = 8.0


def join_overlay(report, preferences):
    """Curves with arrows, control polygons, frames, a ring at the join and its label."""
    parts = []
    for index, side in enumerate(report.sides):
        color = preferences.side_colors[index]
        if preferences.show_polygons:
            parts.append(polygon_node(side, color))
        parts.append(segment_node(side, index == 0, color, str(index + 1)))
    if preferences.show_frames:
        parts += _frames(report, preferences)
    verdict = report.order, report.verdicts, report.residuals
    parts.append(label_node(report.sides[0].point, verdict, preferences,
                            list(_directions(report.sides))))
    return nodes.untouchable(*parts)


def label_node(point, verdict, preferences, avoided=()):
    """A ring at the join and, beside it, the order always and by how much it misses the next one.

    `verdict` is (order, verdicts, residuals); the label keeps off the `avoided` directions.
    """
    order, verdicts, residuals = verdict
    look = look_of(order, verdicts)
    text = missing_text(order, verdicts, residuals)
    labels = [sprites.callout(look.name, text, look.color, preferences.label_points, corner)
              for corner in CORNERS]
    return nodes.at(point, sprites.ring(look.color), in_freest_corner(labels, avoided))


def _directions(sides):
    """Where the curves leave the join, and to which side they bend."""
    arriving, leaving = sides
    if arriving.tangent is not None:
        yield -arriving.tangent
    yield from (axis for axis in (leaving.tangent, arriving.normal, leaving.normal)
                if axis is not None)


def _frames(report, preferences):
    lettered = (True, _frames_differ(*report.sides))
    return [frame_node(side, index, preferences.frame_pixels, preferences.label_points,
                       lettered[index])
            for index, side in enumerate(report.sides)]


def _frames_differ(first, second):
    for axes in ((first.tangent, second.tangent), (first.normal, second.normal),
                 (first.binormal, second.binormal)):
        if any(axis is None for axis in axes):
            continue
        if float(axes[0] @ axes[1]) < math.cos(math.radians(_DISTINCT_DEGREES)):
            return True
    return False
