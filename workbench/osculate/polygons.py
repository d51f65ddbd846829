"""Control polygons of Bézier segments: their differences, and the construction of de Casteljau."""

import math
from typing import NamedTuple

import numpy


class ControlPolygons(NamedTuple):
    """The control polygons of Bézier segments, one after the other."""

    poles: numpy.ndarray    #: (n, 3): mm
    weights: numpy.ndarray  #: (n,): 1 in polynomial segments
    counts: numpy.ndarray   #: (m,): poles of each segment
    is_rational: numpy.ndarray  #: (m,): which segments are
    curves: numpy.ndarray   #: (m,): the number of the curve of each segment

    @property
    def degrees(self):
        """(m,) the degree of each segment."""
        return self.counts - 1

    @property
    def starts(self):
        """(m,) where in `poles` each segment begins."""
        return numpy.cumsum(self.counts) - self.counts

    @property
    def ends(self):
        """(n,) True for the poles at the ends of segments, which lie on the curve."""
        result = numpy.zeros(len(self.poles), bool)
        result[self.starts] = result[self.starts + self.counts - 1] = True
        return result


class Differences(NamedTuple):
    """Differences of poles within segments: Δb_i = b_(i+1) − b_i, Δ²b_i = Δb_(i+1) − Δb_i."""

    poles: numpy.ndarray    #: (k, 3): b_i
    vectors: numpy.ndarray  #: (k, 3): the difference, mm
    segments: numpy.ndarray  #: (k,): the number of the segment


def control_polygons(curves):
    """The ControlPolygons of all Bézier segments of some osculate.Curves."""
    segments = [(number, segment) for number, curve in enumerate(curves)
                for segment in curve.segments()]
    return ControlPolygons(
        poles=numpy.concatenate([segment.poles for _, segment in segments] or [_none()]),
        weights=numpy.concatenate([_weights(segment) for _, segment in segments]
                                  or [_none()[:, 0]]),
        counts=numpy.array([len(segment.poles) for _, segment in segments], int),
        is_rational=numpy.array([segment.is_rational for _, segment in segments], bool),
        curves=numpy.array([number for number, _ in segments], int))


def differences(polygons, order):
    """The Differences of an order, 1 or higher; segments of a lower degree have none."""
    segments = numpy.repeat(numpy.arange(len(polygons.counts)), polygons.counts)
    vectors = polygons.poles
    for _ in range(order):
        vectors = numpy.diff(vectors, axis=0)
    first, last = segments[:len(vectors)], segments[order:]
    inside = first == last[:len(first)]  # none leads from one segment into the next
    return Differences(polygons.poles[:len(vectors)][inside], vectors[inside], first[inside])


def derivatives(polygons, order):
    """The same times n (n−1) ... (n−order+1): the poles of the derivative of each segment of degree
    n over [0, 1]. Rational segments have none: their derivatives are no such polygons.

    Source: G. Farin, Curves and Surfaces for CAGD, 5th ed., section 5.3.
    """
    found = differences(polygons, order)
    counts = [0 if is_rational else math.perm(int(degree), order)
              for degree, is_rational in zip(polygons.degrees, polygons.is_rational)]
    factors = numpy.array(counts, float)[found.segments]
    exists = ~polygons.is_rational[found.segments]
    return Differences(found.poles[exists], (factors[:, None] * found.vectors)[exists],
                       found.segments[exists])


def de_casteljau(segment, t):
    """The nested polygons of the construction of de Casteljau: a list of arrays (n+1, 3), (n, 3),
    ..., (1, 3), of which the first is the control polygon and the last the point of the curve at t.

    segment: an osculate.Curve that is one Bézier segment over [0, 1]. One that is rational is
    constructed in homogeneous coordinates, and its polygons are projected.

    V_i^j = (1 − t) V_i^(j−1) + t V_(i+1)^(j−1).
    Source: G. Farin, Curves and Surfaces for CAGD, 5th ed., sections 4.2 and 13.2.
    """
    weights = _weights(segment)[:, None]
    level = numpy.hstack([weights * segment.poles, weights])
    levels = [level]
    while len(level) > 1:
        level = (1.0 - t) * level[:-1] + t * level[1:]
        levels.append(level)
    return [level[:, :3] / level[:, 3:] for level in levels]


def _weights(segment):
    return segment.weights if segment.is_rational else numpy.ones(len(segment.poles))


def _none():
    return numpy.empty((0, 3))
