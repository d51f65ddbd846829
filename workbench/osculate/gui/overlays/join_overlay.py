"""All that is drawn at a join, from its report."""

from osculate.gui import colors
from osculate.gui.overlays import nodes, sprites
from osculate.gui.overlays.frenet_frame import frames_node
from osculate.gui.overlays.placement import CORNERS, in_freest_corner
from osculate.gui.overlays.segment import polygon_node, segment_node
from osculate.gui.verdict import look_of, missing_text


def join_overlay(report, preferences, labelled=True):
    """Curves with arrows, control polygons, frames, the gap; a ring and the label."""
    parts = []
    for index, side in enumerate(report.sides):
        color = preferences.side_colors[index]
        if preferences.show_polygons:
            parts.append(polygon_node(side, color))
        parts.append(segment_node(side, index == 0, color, str(index + 1)))
    if preferences.show_frames:
        parts.append(frames_node(report.sides, preferences.frame_pixels, preferences.label_points))
    points = [side.point for side in report.sides]
    if report.order < 0:
        parts.append(nodes.colored_polyline(points, colors.GAP, 3.0))
    if labelled:
        verdict = report.order, report.verdicts, report.residuals
        surroundings = [(side.tangent, side.normal, side.segment.poles if side.segment else ())
                        for side in report.sides]
        parts.append(label_node(points[0], verdict, preferences, surroundings))
    return nodes.untouchable(*parts)


def label_node(point, verdict, preferences, surroundings):
    """A ring at the join and, beside it, the order always and by how much it misses the next one.

    `verdict` is (order, verdicts, residuals), `surroundings` (tangent, normal, poles) of both
    sides, axes None where they do not exist; the label keeps off the curves.
    """
    order, verdicts, residuals = verdict
    look = look_of(order, verdicts)
    text = missing_text(order, verdicts, residuals)
    labels = [sprites.callout(look.name, text, look.color, preferences.label_points, corner)
              for corner in CORNERS]
    return nodes.at(point, sprites.ring(look.color),
                    in_freest_corner(labels, list(_occupied(point, *surroundings))))


def _occupied(point, arriving, leaving):
    """Directions in which the curves lie and to which they bend."""
    for sign, (tangent, normal, poles) in ((-1, arriving), (1, leaving)):
        if tangent is not None:
            yield [sign * x for x in tangent]
        if normal is not None:
            yield normal
        for pole in poles:
            yield [x - origin for x, origin in zip(pole, point)]
