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
    text = "".join(dict.fromkeys(filter(None, map(_polyline, pieces))))
    return tag("path", d=text, **attributes) if text else None


def segments(first, second, **attributes):
    """A path of straight pieces between two (n, 2) arrays of places."""
    return path(numpy.stack((first, second), axis=1), **attributes)


def dots(places, **attributes):
    """A path of points, drawn by the round ends of its lines; each place once."""
    whole = numpy.unique(_whole(places), axis=0)
    text = "".join(f"M{x} {y}h0" for x, y in whole.tolist())
    return tag("path", d=text, stroke_linecap="round", **attributes) if text else None


def _whole(places):
    limit = 1e6  # far outside every picture; larger numbers are no coordinates for a renderer
    return numpy.rint(FINE * numpy.clip(places, -limit, limit)).astype(int)


def _polyline(places):
    """Relative steps: shorter than places. Steps to the same place are left out."""
    whole = _whole(places)
    steps = numpy.diff(whole, axis=0)
    steps = steps[steps.any(axis=1)].tolist()
    if not steps:
        return ""  # nothing, or smaller than can be seen
    return "M{} {}l".format(*whole[0].tolist()) + " ".join(f"{x} {y}" for x, y in steps)
