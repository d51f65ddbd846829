"""The joins of edges in a document: where they are, and their analysis."""

from collections import defaultdict
from dataclasses import dataclass
from itertools import product
from math import floor
from operator import add
from typing import Optional, Tuple

import FreeCAD

import osculate
from osculate.features.edge_link import EdgeLink, LinkError

translate = FreeCAD.Qt.translate

#: Ends as the document stores them; None lets the analysis take the nearest.
ENDS = {
    "nearest": None,
    "end-start": ("end", "start"),
    "end-end": ("end", "end"),
    "start-start": ("start", "start"),
    "start-end": ("start", "end"),
}

#: Ends of edges that lie within this multiple of the gap tolerance are taken to be meant as a join.
NEARNESS = 100.0


@dataclass(frozen=True)
class JoinPlace:
    """Where a join is: two edges at given ends (None: the nearest), or inner knot `knot` of one.

    `knot` counts from 1; 0 says that the join lies at ends. One closed edge as both, without a
    knot, is its closing join.
    """

    first: EdgeLink
    second: EdgeLink
    ends: Optional[Tuple[str, str]] = None
    knot: int = 0

    def analyze(self, order, tolerances):
        """The JoinReport. Raises LinkError, or what osculate.analyze raises."""
        first = self.first.resolve()
        if self.knot:
            return self._analyze_knot(first, order, tolerances)
        second = first if self.second == self.first else self.second.resolve()
        return osculate.analyze(first, second, order=order, ends=self.ends, tolerances=tolerances)

    def _analyze_knot(self, edge, order, tolerances):
        inner = [report for report in
                 osculate.analyze_edge(edge, order=order, tolerances=tolerances)
                 if report.parameter is not None]
        if self.knot > len(inner):
            raise LinkError(translate("Osculate", "{} has no inner knot {} (it has {}).")
                            .format(self.first.label(), self.knot, len(inner)))
        return inner[self.knot - 1]

    def label(self):
        """What the user calls the join, e.g. "Sketch.Edge1 – Edge2"."""
        if self.knot:
            return translate("Osculate", "{}, knot {}").format(self.first.label(), self.knot)
        if self.first == self.second:
            return translate("Osculate", "{}, closing").format(self.first.label())
        first, second = self.first.label(), self.second.label()
        owner, _, edge = second.rpartition(".")
        return f"{first} – {edge if first.startswith(owner + '.') else second}"


def analyze_links(links, order, tolerances):
    """The joins of some edges as (JoinPlace, JoinReport): of two edges their join, of one its own
    joins, of more all joins between and within them.

    Raises LinkError, or what osculate.analyze raises.
    """
    if len(links) == 2:
        place = JoinPlace(*links)
        return [(place, place.analyze(order, tolerances))]
    edges = {link: link.resolve() for link in links}
    curves = {link: osculate.Curve.from_edge(edge) for link, edge in edges.items()}
    joins = []
    for link, curve in curves.items():
        joins += _inner_joins(link, curve, order, tolerances)
    for place in touching_ends(edges, NEARNESS * tolerances.gap_mm):
        report = osculate.analyze(curves[place.first], curves[place.second], order=order,
                                  ends=place.ends, tolerances=tolerances)
        joins.append((place, report))
    return joins


def _inner_joins(link, curve, order, tolerances):
    reports = osculate.analyze_edge(curve, order=order, tolerances=tolerances)
    return [(JoinPlace(link, link, knot=0 if report.parameter is None else number), report)
            for number, report in enumerate(reports, start=1)]


def touching_ends(edges, reach):
    """A JoinPlace for each pair of ends of different edges that lie within `reach` mm.

    `edges` maps EdgeLink to Part.Edge. Ends are sorted into cells of the size `reach`, so that
    the cost grows with the number of ends and not with its square.
    """
    places = []
    cells = defaultdict(list)
    for link, edge in edges.items():
        for name, point in _end_points(edge):
            cell = tuple(floor(coordinate / reach) for coordinate in point)
            for other_link, other_name, other_point in _neighbours(cells, cell):
                if other_link != link and point.distanceToPoint(other_point) <= reach:
                    places.append(_travel(other_link, other_name, link, name))
            cells[cell].append((link, name, point))
    return places


def _end_points(edge):
    """(name, point) of both ends, named in the direction of the edge."""
    points = [edge.valueAt(parameter) for parameter in edge.ParameterRange]
    if edge.Orientation == "Reversed":
        points.reverse()
    return zip(("start", "end"), points)


def _neighbours(cells, cell):
    for step in product((-1, 0, 1), repeat=3):
        yield from cells.get(tuple(map(add, cell, step)), ())


def _travel(first, first_end, second, second_end):
    """The join of two ends, travelled from an edge's end to the other's start where possible."""
    if (first_end, second_end) == ("start", "end"):
        return JoinPlace(second, first, ("end", "start"))
    return JoinPlace(first, second, (first_end, second_end))
