"""SVG from points: paths with few characters, dots, and the frame around them."""

import numpy

from osculate.page.markup import tag

#: Coordinates are whole numbers of this many to the unit of a picture.
FINE = 10


def svg(view, label, *children):
    """A picture with its description, `FINE` steps to the unit of the view."""
    width, height = view.size
    return tag("svg", tag("title", label), *children, viewBox=f"0 0 {width * FINE} {height * FINE}",
               width=width, height=height, role="img")


def path(pieces, **attributes):
    """A path through some (n, 2) arrays of places; None where there is nothing to draw."""
    pieces = [piece for piece in pieces if len(piece) > 1]
    text = "".join(dict.fromkeys(_polylines(pieces))) if pieces else ""
    return tag("path", d=text, **attributes) if text else None


def segments(first, second, **attributes):
    """A path of straight pieces between two (n, 2) arrays of places."""
    return path(numpy.stack((first, second), axis=1), **attributes)


def dots(places, grid=1, **attributes):
    """A path of points, drawn by the round ends of its lines; each place once, to a multiple of
    `grid` steps.
    """
    whole = numpy.unique(_whole(places) // grid, axis=0) * grid
    text = "".join(f"M{x} {y}h0" for x, y in whole.tolist())
    return tag("path", d=text, stroke_linecap="round", **attributes) if text else None


def _whole(places):
    limit = 1e6  # far outside every picture; larger numbers are no coordinates for a renderer
    return numpy.rint(FINE * numpy.clip(places, -limit, limit)).astype(int)


def _polylines(pieces):
    """The texts of pieces, by relative steps: these are shorter than places. Steps to the same
    place are left out, and pieces smaller than can be seen.
    """
    ends = numpy.cumsum([len(piece) for piece in pieces])
    places = _whole(numpy.concatenate(pieces))
    steps = numpy.diff(places, axis=0, prepend=places[:1])
    moves = steps.any(axis=1)
    moves[ends[:-1]] = False  # from one piece to the next
    indices = numpy.flatnonzero(moves)
    steps = [f"{x} {y}" for x, y in steps[indices].tolist()]
    bounds = numpy.searchsorted(indices, ends).tolist()
    begins = places[numpy.append(0, ends[:-1])].tolist()
    for (x, y), first, last in zip(begins, [0, *bounds], bounds):
        if first < last:
            yield f"M{x} {y}l" + " ".join(steps[first:last])
