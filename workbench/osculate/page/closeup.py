"""A join from near: both sides with their curvature combs, and the edges around it."""

from typing import NamedTuple, Optional
from xml.etree.ElementTree import Element

import numpy

from osculate import comb_drawing
from osculate.combs import comb
from osculate.page import drawing, style
from osculate.page.drawing import FINE
from osculate.page.strokes import samples
from osculate.page.view import close

_SIZE = (220, 150)

#: How much of the shorter side is seen, and how many gaps the picture is high at least.
_SHARE, _GAPS = 0.75, 8.0

#: The longest tooth, in radii of what is seen.
_TOOTH = 0.8


class CloseUp(NamedTuple):
    """The picture of a join and what there is to say of it."""

    picture: Element
    width_mm: float
    scale: Optional[float]  #: of the combs: mm of a tooth for a curvature of 1/mm; None: all flat


def close_up(strokes, row, report):
    """The CloseUp of an AuditRow; None where no side can be drawn.

    report: its JoinReport. strokes: the Strokes of the model.
    """
    sides = [side for side in report.sides if side.segment is not None]
    if not sides:
        return None
    radius = _radius(row, sides)
    center = numpy.mean([side.point for side in sides], axis=0)
    parts = [_near_end(side.segment, side.point, 1.6 * radius) for side in sides]
    combs = [comb(part, density=20, quantities="curvature") for part in parts]
    view = close(_within([found.point for found in combs], center, radius), center, radius, _SIZE)
    scale = comb_drawing.automatic_scale(combs, "curvature", 2.0 * radius)
    picture = drawing.svg(view, "The join and the curvature of both sides",
                          drawing.path(_around(view, strokes.near(center, 1.6 * radius)),
                                       class_="around"),
                          *_combs(view, combs, scale, radius), *_curves(view, combs),
                          _join(view, [side.point for side in sides], style.look_of(row)))
    return CloseUp(picture, _SIZE[0] * view.unit, scale)


def _radius(row, sides):
    """Half the height of the picture, mm."""
    shorter = min(side.segment.length() for side in sides)
    gap = row.residuals[0]
    if row.order >= 0 or not numpy.isfinite(gap) or gap == 0.0:
        return _SHARE * shorter
    return max(min(0.5 * _GAPS * gap, _SHARE * shorter), 0.75 * gap)


def _near_end(curve, point, length):
    """The part of a segment that begins or ends at a point and has at most a length."""
    whole = curve.length()
    if whole <= length:
        return curve
    first, last = curve.parameter_range
    ends = numpy.linalg.norm(curve.evaluate([first, last])[:, 0] - point, axis=1)
    if ends[0] <= ends[1]:
        return curve.trimmed(first, float(curve.parameter_at_length(length)))
    return curve.trimmed(float(curve.parameter_at_length(whole - length)), last)


def _within(parts, center, radius):
    points = numpy.concatenate(parts)
    near = points[numpy.linalg.norm(points - center, axis=1) <= 1.2 * radius]
    return near if len(near) > 2 else points


def _around(view, strokes):
    """The lines of Strokes, of each what may be in the picture."""
    for stroke in strokes:
        places = view.project(samples(stroke, view.unit))
        low, high = numpy.minimum(places[:-1], places[1:]), numpy.maximum(places[:-1], places[1:])
        seen = numpy.flatnonzero(((high > 0.0) & (low < view.size)).all(axis=1))
        for run in numpy.split(seen, numpy.flatnonzero(numpy.diff(seen) > 1) + 1):
            yield places[run[0]:run[-1] + 2] if len(run) else places[:0]


def _combs(view, combs, scale, radius):
    for i, found in enumerate(combs if scale is not None else ()):
        drawn = comb_drawing.CombDrawing(found, "curvature")
        tips, _ = drawn.tips(scale, _TOOTH * radius)
        tips = view.project(tips)
        yield drawing.segments(view.project(found.point)[drawn.teeth], tips[drawn.teeth],
                               class_=f"teeth{i}")
        members, counts = drawn.lines()
        lines = numpy.split(tips[members], numpy.cumsum(counts)[:-1]) if len(counts) else []
        yield drawing.path(lines, class_=f"tips{i}")


def _curves(view, combs):
    for i, found in enumerate(combs):
        yield drawing.path([view.project(found.point)], class_=f"curve{i}")


def _join(view, points, look):
    return drawing.dots(view.project(points), stroke=look.color, stroke_width=6 * FINE)
