"""The analysis of joins: of two curves, of one curve with itself, of arrays of segments."""

from typing import NamedTuple

import numpy

from osculate import _core, shapes

#: What the numbers in JoinBatch.verdicts stand for.
VERDICTS = ("pass", "fail", "undecided")


def analyze(a, b, *, order=4, ends=None, tolerances=None, scale_mm=None):
    """The continuity of the join of two curves, as a JoinReport.

    a, b: Part.Edge (any curve type, trimmed, reversed, placed, rational, periodic) or Curve. The
        first arrives at the join, the second leaves it. One closed edge as both gives its closing
        join.
    order: the highest order of contact that is analysed, 0 to 8.
    ends: which end of a and of b meet, e.g. ("end", "start"); None takes the nearest ends, and
        ("end", "start") where several pairs are equally near within the gap tolerance (with the
        warning `touches-at-both-ends` if the curves meet at both ends).
    tolerances: Tolerances, the name of a preset, or None for the preset `osculate`.
    scale_mm: the length L that residuals from order 2 on refer to, in mm; None takes the smaller
        of the two curves' reaches (from the join to the other end or to the point at the middle
        of the parameter range, whichever is farther).

    Raises TypeError for what is no curve, and ValueError that names the argument and the rule, also
    for the same open edge twice and for an edge that is degenerated or of zero length.
    """
    first = shapes.curve_from(a, "a")
    second = first if a is b else shapes.curve_from(b, "b")
    if shapes.are_same(a, b):
        return _analyze_closing(first, order, ends, tolerances, scale_mm)
    return _core.analyze_pair(first, second, order, ends, tolerances, scale_mm)


def analyze_edge(a, *, order=4, tolerances=None, progress=None):
    """The joins within one curve: a list with a JoinReport for each inner knot, in the order of the
    parameter, and at its end one for the closing join (without `parameter`) if the curve is closed.

    a: Part.Edge or Curve. order, tolerances: as for analyze.
    progress: called with the share done, 0 to 1; where it returns False the analysis stops, and
        the reports made so far are returned. The analysis runs without the GIL.

    Raises as analyze does; an exception from `progress` ends the analysis and is raised.
    """
    return _core.analyze_inner(shapes.curve_from(a, "a"), order, tolerances, progress)


class JoinBatch(NamedTuple):
    """Arrays over N joins; K is the order asked for."""

    order: numpy.ndarray            #: (N,) int8: highest m with orders 0..m passing, -1: a gap
    parametric_order: numpy.ndarray  #: (N,) int8: the same for C^m
    verdicts: numpy.ndarray         #: (N, K+1) uint8: indices into VERDICTS
    residuals: numpy.ndarray        #: (N, K+1): mm, degrees, then dimensionless; infinite: none
    uncertainties: numpy.ndarray    #: (N, K+1): bounds of the errors of the residuals


def analyze_joins(first_poles, second_poles, first_weights=None, second_weights=None, order=4,
                  tolerances=None, progress=None):
    """Many joins of Bézier segments at once: the end of each first one against the start of the
    second. Returns a JoinBatch.

    first_poles, second_poles: (N, n+1, 3) finite coordinates in mm; the degree n, 1 to 25, may
        differ between the two. first_weights, second_weights: (N, n+1) finite and > 0, or None.
    order, tolerances: as for analyze. The scale L is taken from the segments.
    progress: called now and then with the share done; where it returns False the analysis stops,
        and the arrays have the rows of the joins done. The analysis runs without the GIL.

    Raises ValueError that names the argument and the rule, TypeError for what is no array of
    numbers; an exception from `progress` ends the analysis and is raised.
    """
    return JoinBatch(*_core.analyze_arrays(first_poles, second_poles, first_weights, second_weights,
                                           order, tolerances, progress))


def _analyze_closing(curve, order, ends, tolerances, scale_mm):
    if not _core.is_closed(curve, tolerances):
        raise ValueError("b: is the same curve as a, which is open; give two curves, or one closed "
                         "curve for its closing join")
    ends = ("end", "start") if ends is None else ends
    report = _core.analyze_pair(curve, curve, order, ends, tolerances, scale_mm)
    if report.ends[0] == report.ends[1]:
        raise ValueError('ends: a closed curve meets itself with ("end", "start") or '
                         '("start", "end")')
    return report
