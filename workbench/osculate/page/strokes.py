"""The curves of an audited model as Bézier segments that can be drawn."""

import functools
import math
from typing import NamedTuple

import numpy

from osculate import _core, shapes

#: A drawn segment departs from its curve by at most this much, in the unit of the picture.
_FLATNESS = 0.2

_MOST_STEPS = 256


class Stroke(NamedTuple):
    """A Bézier segment of an edge, over [0, 1]."""

    edge: int             #: its number
    curve: _core.Curve    #: one segment
    poles: numpy.ndarray  #: (n, 3): mm


def strokes_of(report, shape):
    """The Strokes of an AuditReport: the segments beside its joins and, where there is a shape,
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
    return Strokes(found), report.edge_count - len(drawn)


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


class Strokes:
    """Some Strokes with what is asked of all of them at once, in arrays."""

    def __init__(self, strokes):
        self.all = list(strokes)
        counts = numpy.array([len(stroke.poles) for stroke in self.all], dtype=int)
        starts = numpy.cumsum(counts) - counts
        poles = numpy.concatenate([numpy.empty((0, 3)), *(stroke.poles for stroke in self.all)])
        self.least = _reduced(numpy.minimum, poles, starts)  #: (n, 3): boxes of the poles
        self.most = _reduced(numpy.maximum, poles, starts)
        self.middles = _reduced(numpy.add, poles, starts) / counts[:, None]  #: (n, 3)
        self.ends = poles[numpy.concatenate((starts, starts + counts - 1))]  #: (2 n, 3)

    def __len__(self):
        return len(self.all)

    def sizes(self):
        """(n,): bounds of their extents, mm."""
        return numpy.linalg.norm(self.most - self.least, axis=1)

    def near(self, center, radius):
        """The Strokes whose boxes reach a ball."""
        apart = numpy.maximum(numpy.maximum(self.least - center, center - self.most), 0.0)
        found = numpy.flatnonzero(numpy.linalg.norm(apart, axis=1) <= radius)
        return [self.all[i] for i in found]


def _reduced(function, poles, starts):
    return function.reduceat(poles, starts) if len(starts) else poles


def samples(stroke, unit):
    """(n, 3) points of a Stroke: enough that the polygon is flat to a fraction of `unit`, the size
    in mm of what can be seen.
    """
    if len(stroke.poles) == 2:
        return stroke.poles
    return stroke.curve.evaluate(_parameters(_steps(stroke.poles, _FLATNESS * unit)))[:, 0]


@functools.cache
def _parameters(steps):
    return numpy.linspace(0.0, 1.0, steps + 1)


def _steps(poles, flatness):
    """How many equal steps bring the chords of a segment so near to it.

    Of a polynomial segment of degree n the distance is at most n (n - 1) / 8 / steps² times the
    largest second difference of the poles (e.g. Filip, Magedson, Markot 1986, theorem 4).
    """
    degree = len(poles) - 1
    bend = float(abs(poles[2:] - 2.0 * poles[1:-1] + poles[:-2]).max())
    wanted = math.sqrt(degree * (degree - 1) * bend / (8.0 * flatness))
    return min(max(math.ceil(wanted), 2), _MOST_STEPS)
