"""Where a construction leaves an edge: at an end, or at a place inside it."""

import numpy

from osculate import shapes
from osculate.features.joins import END_NAMES

NEAREST = "nearest"
INSIDE = {"inside-forward": "forward", "inside-backward": "backward"}

#: What a property offers: the end that lies nearest, an end, or a place inside the edge, from which
#: the construction goes on in the direction of the edge (forward) or against it (backward).
CHOICES = (NEAREST, *END_NAMES, *INSIDE)

#: The same departure, taken the other way.
FLIPPED = {"start": "end", "end": "start", "inside-forward": "inside-backward",
           "inside-backward": "inside-forward"}


def ends_of(edges, choices, positions):
    """The `ends` that osculate.blend takes, for two edges.

    choices: of CHOICES, one for each edge. positions: the places inside, as a share of the edge's
    length from its start, 0 to 1.
    """
    if tuple(choices) == (NEAREST, NEAREST):
        return None
    curves = [shapes.curve_from_edge(edge) for edge in edges]
    ends = [None if choice == NEAREST else _given(curve, choice, position)
            for curve, choice, position in zip(curves, choices, positions)]
    for this, other in ((0, 1), (1, 0)):
        if ends[this] is None:
            ends[this] = _nearest_end(curves[this], _point(curves[other], ends[other]))
    return tuple(ends)


def _given(curve, choice, position):
    if choice not in INSIDE:
        return choice
    return float(curve.parameter_at_length(position * curve.length())), INSIDE[choice]


def _point(curve, end):
    first, last = curve.parameter_range
    return curve.evaluate({"start": first, "end": last}.get(end) if isinstance(end, str)
                          else end[0])[0]


def _nearest_end(curve, point):
    distances = {end: numpy.linalg.norm(_point(curve, end) - point) for end in END_NAMES}
    return min(("end", "start"), key=distances.get)
