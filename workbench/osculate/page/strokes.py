"""The curves of an audited model as Bézier segments that can be drawn."""

import math
from typing import NamedTuple

import numpy

from osculate import _core, shapes

#: A drawn segment departs from its curve by at most this much, in the unit of the picture.
_FLATNESS = 0.2

_MOST_STEPS = 256


class Stroke(NamedTuple):
    """A Bézier segment of an edge."""

    edge: int             #: its number
    curve: _core.Curve    #: one segment
    poles: numpy.ndarray  #: (n, 3): mm


def strokes_of(report, shape):
    """All Strokes of an AuditReport: the segments beside its joins and, where there is a shape,
    the edges without a join. Returns also how many edges there are that cannot be drawn.
    """
    strokes = {}
    for row in report.rows:
        for edge, side in zip(row.edges, report.analyze(row).sides):
            if side.segment is not None:
                stroke = Stroke(edge, side.segment, side.segment.poles)
                strokes.setdefault(_key(stroke), stroke)
    found = list(strokes.values())
    drawn = {stroke.edge for stroke in found} | {entry.edge for entry in report.skipped}
    if shape is not None:
        found += _rest(shape, drawn)
        drawn |= {stroke.edge for stroke in found}
    return found, report.edge_count - len(drawn)


def _key(stroke):
    """The same for a segment and its reverse: an edge's segments are met from both ends."""
    poles = stroke.poles
    return stroke.edge, min(poles.tobytes(), poles[::-1].tobytes())


def _rest(shape, drawn):
    strokes = []
    for number, edge in enumerate(shape.Edges, start=1):
        if number in drawn:
            continue
        try:
            curve = shapes.curve_from_edge(edge)
        except (ValueError, RuntimeError):
            continue  # the audit has left it out too
        strokes += [Stroke(number, part, part.poles) for part in curve.segments()]
    return strokes


def samples(curve, poles, unit):
    """(n, 3) points of a Bézier segment: enough that the polygon is flat to a fraction of `unit`,
    the size in mm of what can be seen.
    """
    steps = _steps(poles, _FLATNESS * unit)
    return curve.evaluate(numpy.linspace(*curve.parameter_range, steps + 1))[:, 0]


def _steps(poles, flatness):
    """How many equal steps bring the chords of a segment so near to it.

    Of a polynomial segment of degree n the distance is at most n (n - 1) / 8 / steps² times the
    largest second difference of the poles (e.g. Filip, Magedson, Markot 1986, theorem 4).
    """
    degree = len(poles) - 1
    if degree < 2:
        return 1
    bend = float(numpy.abs(numpy.diff(poles, 2, axis=0)).max())
    wanted = math.sqrt(degree * (degree - 1) * bend / (8.0 * flatness))
    return min(max(math.ceil(wanted), 2), _MOST_STEPS)


class StrokeIndex:
    """Finds the Strokes near a place."""

    def __init__(self, strokes):
        self._strokes = strokes
        self._least = numpy.array([s.poles.min(axis=0) for s in strokes]).reshape(-1, 3)
        self._most = numpy.array([s.poles.max(axis=0) for s in strokes]).reshape(-1, 3)

    def near(self, center, radius):
        """The Strokes whose boxes reach a ball."""
        apart = numpy.maximum(numpy.maximum(self._least - center, center - self._most), 0.0)
        found = numpy.flatnonzero(numpy.linalg.norm(apart, axis=1) <= radius)
        return [self._strokes[i] for i in found]
